// From the address to the first frame, and everything that can go wrong on the way.

import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";
import { frames, open, rest, until } from "./page.mjs";

test("the page becomes ready, without a complaint and without asking any other host", async (t) => {
  const { page, ready, state, seen, foreignRequests } = await open(t);
  t.diagnostic(`ready after ${Math.round(await ready())} ms`);
  assert.equal(await page.locator("#welcome").isVisible(), false);
  assert.equal(typeof (await state()), "object");
  assert.deepEqual(seen.console, []);
  assert.deepEqual(seen.errors, []);
  assert.deepEqual(foreignRequests(), []);
});

test("the canvas fills the window", async (t) => {
  const { page, ready } = await open(t, { viewport: { width: 1024, height: 768 } });
  await ready();
  const box = await page.locator("#eigenwing").boundingBox();
  assert.deepEqual(box, { x: 0, y: 0, width: 1024, height: 768 });
});

test("nothing is drawn while nothing moves", async (t) => {
  const { ready, rest, drawCallsIn } = await open(t);
  await ready();
  // The first frames settle sizes and ranges.
  await rest();
  assert.equal(await drawCallsIn(2000), 0);
});

test("the heading can be read and the bar moves before the program has arrived", async (t) => {
  let watch;
  const watched = new Promise((resolve) => (watch = resolve));
  // Each piece comes once the bar has moved with those before it; where it doesn't move, the values tell.
  const sent = async (piece) => {
    const progress = await watched;
    await until(progress, (values) => values.length >= piece - 1, `the bar before piece ${piece}`).catch(() => {});
  };
  const { page, ready, screenshot, progress } = await open(t, { server: { slowly: 12, sent }, waitUntil: "commit" });
  assert.equal(await page.getByRole("heading", { level: 1 }).innerText(), "Eigenwing");
  assert.equal(await page.getByRole("progressbar").isVisible(), true);
  await screenshot("loading");
  watch(progress);
  await ready();
  const values = await progress();
  assert.ok(values.length > 5, `the bar showed only ${values}`);
  assert.deepEqual(values, values.toSorted((a, b) => a - b));
  assert.equal(values.at(-1), 1);
});

test("a program that is not found is reported", async (t) => {
  const { page, screenshot } = await open(t, { server: { missing: /\.wasm$/ } });
  await page.getByRole("heading", { name: "Eigenwing could not be loaded" }).waitFor();
  await screenshot("not-loaded");
  assert.equal(await page.getByRole("button", { name: "Reload" }).isVisible(), true);
  assert.equal(await page.getByRole("progressbar").isVisible(), false);
});

test("a browser that can’t read the program is told which one can", async (t) => {
  const program = readdirSync(new URL("../../dist/", import.meta.url)).find((name) => name.endsWith(".wasm"));
  const ofAnotherVersion = Buffer.from([0, 0x61, 0x73, 0x6d, 2, 0, 0, 0]);
  const { page } = await open(t, { server: { files: { [program]: ofAnotherVersion } } });
  await page.getByRole("heading", { name: "Eigenwing could not start" }).waitFor();
  assert.match(await page.getByRole("alert").innerText(), /a browser of 2023 or later/);
});

test("a script that is not found is reported", async (t) => {
  const { page } = await open(t, { server: { missing: /^eigenwing-.*\.js$/ } });
  await page.getByRole("heading", { name: "Eigenwing could not be loaded" }).waitFor();
});

test("a program that stops says so, and Reload starts it again", async (t) => {
  const { page, ready, screenshot } = await open(t);
  await ready();
  const detail = "The response could not be computed.";
  await page.evaluate((detail) => dispatchEvent(new CustomEvent("eigenwing-failed", { detail })), detail);
  await page.getByRole("heading", { name: "Eigenwing has stopped" }).waitFor();
  assert.match(await page.getByRole("alert").innerText(), new RegExp(detail));
  await screenshot("stopped");
  await page.getByRole("button", { name: "Reload" }).click();
  await page.locator("#welcome").waitFor({ state: "hidden" });
});

test("a program that stops keeps the scene, and offers a report in which nobody is named", async (t) => {
  const scene = "#v=1&ac=navion&cm_alpha=-0.5&own=c2VjcmV0&pin.own=c2VjcmV0&by=Ada%20Lovelace";
  const { page, ready, url } = await open(t, { fragment: scene });
  await ready();
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await page.evaluate(() => dispatchEvent(new CustomEvent("eigenwing-failed", { detail: "index out of bounds" })));
  await page.getByText("A report for who mends it").click();
  const report = await page.getByRole("textbox", { name: "Report" }).inputValue();
  assert.match(report, /^Eigenwing \d+\.\d+\.\d+-[0-9a-f]{16}\nindex out of bounds\nscene: #v=1&ac=navion&cm_alpha=-0\.5&own=…&pin\.own=…&by=…\nbrowser: /);
  assert.ok(!report.includes(new URL(url).host), "where the page is");
  await page.getByRole("button", { name: "Copy the report" }).click();
  await until(() => page.evaluate(() => navigator.clipboard.readText()), (text) => text === report, "the report on the clipboard");
  await page.getByRole("button", { name: "Start without this scene" }).click();
  await page.locator("#welcome").waitFor({ state: "hidden" });
  await until(async () => new URL(page.url()).hash, (hash) => !hash.includes("cm_alpha"), "another scene");
});

test("graphics that are lost and given back bring the scene back", async (t) => {
  // How often the page has begun again by itself.
  const before = () => {
    const again = () => sessionStorage.setItem("again", Number(sessionStorage.getItem("again")) + 1);
    navigation.addEventListener("navigate", ({ navigationType }) => navigationType === "reload" && again());
  };
  const { page, ready, state } = await open(t, { before });
  const again = () => page.evaluate(() => Number(sessionStorage.getItem("again")));
  await ready();
  await page.getByRole("slider", { name: "pitch stiffness C_mα" }).fill("-0.5");
  await until(async () => page.url(), (url) => url.includes("cm_alpha=-0.5"), "the scene in the address");
  const graphics = (what) =>
    page.evaluate((what) => {
      const canvas = document.getElementById("eigenwing");
      window.lost ??= (canvas.getContext("webgl2") ?? canvas.getContext("webgl")).getExtension("WEBGL_lose_context");
      window.lost[what]();
    }, what);
  await graphics("loseContext");
  await page.getByRole("heading", { name: "The graphics were interrupted" }).waitFor();
  await graphics("restoreContext");
  await page.locator("#welcome").waitFor({ state: "hidden" });
  assert.match(JSON.stringify(await until(state, Boolean, "the program")), /-0\.5/);
  // Where they don't last the page doesn't begin again and again.
  assert.equal(await again(), 1);
  await page.evaluate(() => {
    window.lost = undefined;
    // However long ago that was by now.
    sessionStorage.setItem("eigenwing.restored", Date.now());
    document.getElementById("eigenwing").addEventListener("webglcontextrestored", () => (window.restored = true));
  });
  await graphics("loseContext");
  await page.getByRole("heading", { name: "The graphics were interrupted" }).waitFor();
  await graphics("restoreContext");
  await until(() => page.evaluate(() => window.restored), Boolean, "they are given back");
  await frames(page);
  assert.equal(await again(), 1);
  assert.ok(await page.getByRole("heading", { name: "The graphics were interrupted" }).isVisible());
});

test("without JavaScript the page says what it needs", async (t) => {
  const { page, url } = await open(t);
  const context = await page.context().browser().newContext({ javaScriptEnabled: false });
  t.after(() => context.close());
  const plain = await context.newPage();
  await plain.goto(url);
  assert.match(await plain.locator("noscript").innerText(), /needs JavaScript/);
  assert.equal(await plain.getByRole("heading", { level: 1 }).innerText(), "Eigenwing");
  assert.equal(await plain.getByRole("progressbar").isVisible(), false);
});

test("the content security policy lets nothing else in or out", async (t) => {
  const { page, ready } = await open(t);
  await ready();
  const outcome = await page.evaluate(async () => {
    const script = document.createElement("script");
    script.textContent = "window.intruded = true";
    document.body.append(script);
    const fetched = await fetch("https://example.org/").then(
      () => "fetched",
      () => "refused",
    );
    return { intruded: window.intruded ?? false, fetched };
  });
  assert.deepEqual(outcome, { intruded: false, fetched: "refused" });
});

// A page of a course with a field for an answer, and the program in a frame below it.
async function hosted(t, attributes = "") {
  const { page, url } = await open(t);
  const host = await page.context().newPage();
  await host.setContent(
    `<input id="answer" autofocus><iframe id="frame" width="900" height="600" ${attributes} src="${url}"></iframe>`,
  );
  return { host, frame: host.frameLocator("#frame") };
}

test("in a frame the page takes the keyboard only once it is used", async (t) => {
  const { host, frame } = await hosted(t);
  await frame.locator("#welcome").waitFor({ state: "hidden" });
  await rest(host.frames()[1]);
  const active = () => host.evaluate(() => document.activeElement.id);
  assert.equal(await active(), "answer");
  await host.keyboard.type("42");
  assert.equal(await host.locator("#answer").inputValue(), "42");
  await frame.locator("#eigenwing").click({ position: { x: 450, y: 20 } });
  await until(active, (id) => id === "frame", "the frame has the keyboard");
});

test("in a frame without an origin the page says why it can’t start", async (t) => {
  const { frame } = await hosted(t, 'sandbox="allow-scripts"');
  await frame.getByText("add allow-same-origin to its sandbox").waitFor();
});
