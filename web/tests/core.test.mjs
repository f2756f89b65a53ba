// The core as a JavaScript module: the example page, and numbers equal to those of the command line.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { open } from "./page.mjs";

const run = promisify(execFile);
const ROOT = fileURLToPath(new URL("../../", import.meta.url));
const MATLAB = "tests/data/matrices/navion.m";

// The answer of the program compiled for this machine.
async function native(...command) {
  const cargo = ["run", "--quiet", "--locked", "--no-default-features", "--features=cli", "--bin=eigenwing-cli", "--"];
  const { stdout } = await run("cargo", [...cargo, ...command, "--json"], {
    cwd: ROOT,
    maxBuffer: 1 << 26,
  });
  return JSON.parse(stdout);
}

// The module's answer in the browser. Page and module come from the page's own host, as its policy asks.
async function inBrowser(page, name, request) {
  return page.evaluate(
    async ([name, request]) => {
      const core = await import(new URL("../core/eigenwing-core.js", location));
      await core.default();
      return core[name](request);
    },
    [name, request],
  );
}

// Equal names and words, and numbers equal to 1e-12 of the largest in their list: the libraries of sin, exp and √(x² + y²) may
// differ in the last bit, and a number that is a difference of larger ones inherits their rounding.
function assertEqual(found, expected, scale = 0, path = "", tolerance = 1e-12) {
  if (typeof expected === "number") {
    const difference = Math.abs(found - expected);
    assert.ok(difference <= tolerance * Math.max(Math.abs(expected), scale), `${path}: ${found} is not ${expected}`);
  } else if (expected !== null && typeof expected === "object") {
    assert.deepEqual(Object.keys(found), Object.keys(expected), path);
    const numbers = Array.isArray(expected) ? expected.flat(2).filter((x) => typeof x === "number") : [];
    const size = numbers.reduce((size, x) => Math.max(size, Math.abs(x)), scale);
    for (const key of Object.keys(expected)) {
      assertEqual(found[key], expected[key], Array.isArray(expected) ? size : 0, `${path}.${key}`, tolerance);
    }
  } else {
    assert.equal(found, expected, path);
  }
}

// A motion: its samples likewise, and to 1e-9 what amplifies a last bit. A figure is read where a curve crosses a level, between
// samples that differ by little; a flight that isn't linear is integrated in steps whose length depends on every digit; the parts
// of the modes cancel each other, so they are compared beside the largest of the same output.
function assertSameMotion(found, expected) {
  const { figures, split, nonlinear, ...samples } = expected;
  const { figures: foundFigures, split: foundSplit, nonlinear: foundNonlinear, ...foundSamples } = found;
  assertEqual(foundSamples, samples);
  assertEqual(foundFigures, figures, 0, "figures", 1e-9);
  const all = (split) => split && split.map(({ parts, rest, ...of }) => ({ of, values: [...parts.map(({ values }) => values), rest] }));
  assertEqual(all(foundSplit), all(split), 0, "split", 1e-9);
  assertEqual(foundNonlinear, nonlinear, 0, "nonlinear", 1e-9);
}

// A frequency response: the place of a peak is where the gain changes by less than its last bit, and so known to half the digits.
function assertSameFrequencies(found, expected) {
  const { peaks, ...samples } = expected;
  const { peaks: foundPeaks, ...foundSamples } = found;
  assertEqual(foundSamples, samples);
  assertEqual(foundPeaks, peaks, 0, "peaks", 1e-7);
}

test("the example page lists the aircraft, shows the modes of one and draws its motion", async (t) => {
  const { page, seen, screenshot, foreignRequests } = await open(t, { path: "example/", viewport: { width: 900, height: 800 } });
  await page.getByRole("cell", { name: "Phugoid" }).waitFor();
  assert.ok((await page.getByLabel("Aircraft").locator("option").count()) >= 16);
  assert.equal(await page.locator("tbody tr").count(), 2);
  await screenshot("example");
  const line = () => page.locator("#line").getAttribute("points");
  const before = await line();
  assert.equal(before.split(" ").length, 601);

  await page.getByLabel("Disturbance").selectOption("rudder pulse");
  await page.getByRole("cell", { name: "Dutch roll" }).waitFor();
  assert.notEqual(await line(), before);
  // An aircraft without lateral data has no rudder.
  await page.getByLabel("Aircraft").selectOption("lesson-printed");
  await page.getByText("Longitudinal motion: dynamically unstable, statically stable").waitFor();
  assert.equal(await page.getByLabel("Disturbance").inputValue(), "elevator step");
  assert.deepEqual(seen, { ...seen, console: [], errors: [] });
  assert.deepEqual(foreignRequests(), []);
});

test("the example page in the dark on a phone", async (t) => {
  const { page, seen, screenshot } = await open(t, { path: "example/", viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  await page.getByRole("cell", { name: "Phugoid" }).waitFor();
  await screenshot("example-phone-dark");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "wider than the window");
  assert.deepEqual(seen.console, []);
});

test("numbers in the browser are those of the command line, to 1e-12 or what becomes of it", async (t) => {
  const { page } = await open(t, { path: "example/" });
  for (const aircraft of ["navion", "b747-fc9", "lesson-printed"]) {
    assertEqual(await inBrowser(page, "analyse", { aircraft }), await native("analyse", aircraft));
    const motion = { aircraft, steps: 60, nonlinear: true };
    assertSameMotion(await inBrowser(page, "respond", motion), await native("respond", aircraft, "--steps=60", "--nonlinear"));
    assertSameFrequencies(await inBrowser(page, "frequency", { aircraft, output: "h" }), await native("frequency", aircraft, "--output=h"));
  }
  const gusts = { aircraft: "navion", disturbance: "turbulence", set: { time: 10 } };
  assertSameMotion(await inBrowser(page, "respond", gusts), await native("respond", "navion", "--disturbance=turbulence", "--set=time=10"));
  const doublet = { aircraft: "navion", disturbance: "rudder", shape: "doublet", steps: 60, split: true };
  const doubletTyped = ["respond", "navion", "--disturbance=rudder", "--shape=doublet", "--steps=60", "--split"];
  assertSameMotion(await inBrowser(page, "respond", doublet), await native(...doubletTyped));
  const sweep = { aircraft: "navion", set: { speed: 60 }, parameter: "cg", from: -0.2, to: 0.3, points: 7 };
  const typed = ["sweep", "navion", "--set=speed=60", "--parameter=cg", "--from=-0.2", "--to=0.3", "--points=7"];
  assertEqual(await inBrowser(page, "sweep", sweep), await native(...typed));
  assertEqual(await inBrowser(page, "parameters", { aircraft: "x15" }), await native("parameters", "x15"));
  assertEqual(await inBrowser(page, "list"), await native("list"));

  const link = "https://example.org/#v=1&ac=navion&plane=lateral&lat.source=side-gust&cg=16&oops=1";
  assertEqual(await inBrowser(page, "analyse", { link }), await native("analyse", link));
  assertSameMotion(await inBrowser(page, "respond", { link, steps: 60 }), await native("respond", link, "--steps=60"));
  assertEqual(await inBrowser(page, "link", { link, set: { speed: 60 } }), await native("link", link, "--set=speed=60"));

  const matrices = { matrices: readFileSync(ROOT + MATLAB, "utf8"), format: "m", file: MATLAB };
  // The command line tells of the file in the words of its review; the numbers are the same.
  const planes = ({ longitudinal, lateral }) => ({ longitudinal, lateral });
  assertEqual(planes(await inBrowser(page, "analyse", matrices)), planes(await native("analyse", `--matrix=${MATLAB}`)));
});

test("what can't be answered is an Error with the sentence of the command line", async (t) => {
  const { page } = await open(t, { path: "example/" });
  for (const [request, sentence] of [
    [undefined, 'expected a request such as { aircraft: "navion" }'],
    [{ aircraft: "navoin" }, 'there is no aircraft "navoin" in the list; did you mean "navion"?'],
    [{ aircraft: "navion", set: { speed: 25 } }, /^the wing would need C_L 1.89 at 25.0 m\/s/],
  ]) {
    await assert.rejects(inBrowser(page, "analyse", request), ({ message }) => {
      const [, said] = message.match(/Error: (.*)/);
      return sentence instanceof RegExp ? sentence.test(said) : said === sentence;
    });
  }
});

test("the TypeScript types are those of the answers, no field more and none less", async (t) => {
  const { page } = await open(t, { path: "example/" });
  const sweep = { aircraft: "navion", parameter: "speed", from: 20, to: 60, points: 3 };
  const answers = [
    ["Aircraft[]", "list"],
    ["Parameter[]", "parameters", { aircraft: "navion" }],
    ["Analysis", "analyse", { aircraft: "navion" }],
    ["Analysis", "analyse", { aircraft: "lesson", set: { a_qw: -0.1 } }],
    ["Motion", "respond", { aircraft: "navion", disturbance: "side-gust", steps: 2 }],
    ["Motion", "respond", { aircraft: "x15", disturbance: "mode", mode: "Phugoid", steps: 2 }],
    ["Motion", "respond", { aircraft: "navion", nonlinear: true, split: true, set: { elevator: -0.25 }, steps: 2 }],
    ["Motion", "respond", { aircraft: "lesson", nonlinear: true, split: true, set: { a_wu: 0, a_qu: 0 }, steps: 2 }],
    ["FrequencyResponse", "frequency", { aircraft: "navion", disturbance: "aileron", output: "phi", points: 2 }],
    ["Sweep", "sweep", sweep],
    ["Analysis", "analyse", { link: "#v=1&ac=x15&oops=1" }],
    ["TakenAlong", "takeAlong", { link: "#v=1&ac=navion", target: "poles-figure" }],
    ["Link", "link", { aircraft: "navion", disturbance: "rudder", shape: "doublet" }],
  ];
  const lines = [
    'import init, { analyse, frequency, link, list, parameters, respond, sweep, takeAlong } from "./eigenwing-core.js";',
    'import type { Aircraft, Analysis, FrequencyResponse, Link, Motion, Parameter, Sweep, TakenAlong } from "./eigenwing-core.js";',
    "await init();",
    "// @ts-expect-error: no aircraft has such a name",
    "analyse({ aircraft: 7 });",
    "// @ts-expect-error: a misspelt field",
    'respond({ aircraft: "navion", disturbence: "side-gust" });',
    "// @ts-expect-error: turbulence is no input of one channel",
    'frequency({ aircraft: "navion", disturbance: "turbulence" });',
  ];
  for (const [type, name, request] of answers) {
    const answer = await inBrowser(page, name, request);
    // The answer as a literal, of which the compiler checks every field.
    lines.push(`{ const answer: ${type} = ${JSON.stringify(answer)}; answer; }`);
    lines.push(`{ const answer: ${type} = ${name}(${request ? JSON.stringify(request) : ""}); answer; }`);
  }
  const folder = mkdtempSync(join(tmpdir(), "eigenwing-types-"));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(`${folder}/eigenwing-core.d.ts`, readFileSync(`${ROOT}dist/core/eigenwing-core.d.ts`));
  writeFileSync(`${folder}/use.mts`, lines.join("\n"));
  const tsc = `${ROOT}web/node_modules/typescript/bin/tsc`;
  const options = ["--noEmit", "--strict", "--target", "esnext", "--module", "esnext", "--moduleResolution", "bundler"];
  await run(process.execPath, [tsc, ...options, `${folder}/use.mts`]).catch(({ stdout }) => assert.fail(stdout));
});
