// Files in and numbers out: a matrix is dropped on the page and flown, and the scene is taken along as a script. The core as a
// module is loaded when the first file is asked for, and not before.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { drop, open, until } from "./page.mjs";

// Lateral, with a header of states: what a spreadsheet saves.
const TABLE = `,v,p,r,phi,aileron,rudder
v,-0.254,0,-176,32.2,0,12.4
p,-0.0909,-8.40,2.19,0,28.98,2.55
r,0.0255,-0.35,-0.760,0,-0.22,-4.6
phi,0,1,0,0,0,0
`;

const CORE = /\/core\/eigenwing-core/;

test("a table that is dropped becomes an aircraft with named modes, in the link and after a reload", async (t) => {
  const { page, ready, state, seen } = await open(t);
  await ready();
  assert.ok(!seen.requests.some((request) => CORE.test(request)), "nobody has asked for it");
  await drop(page, "mine.csv", TABLE);
  const use = page.getByRole("button", { name: "Use this aircraft", exact: true });
  await use.waitFor({ state: "attached" });
  assert.ok(seen.requests.some((request) => CORE.test(request)));
  const offers = page.getByRole("button", { name: /^Take (?!the scene|along)/ });
  const told = () => offers.evaluateAll((all) => all.map((offer) => offer.textContent + offer.ariaLabel).join());
  for (let i = 0; i < 12 && (await offers.count()) > 0; i += 1) {
    const before = await told();
    await offers.first().dispatchEvent("click");
    // What is taken makes room for what is asked next.
    await until(told, (now) => now !== before, `${before} is taken`);
  }
  await use.dispatchEvent("click");
  const key = (await until(state, (now) => now.aircraft.startsWith("own-"), "it is studied")).aircraft;
  const { analysis } = await state();
  const names = analysis.lateral.modes.map((mode) => mode.key).sort();
  assert.deepEqual(names, ["dutch-roll", "roll-subsidence", "spiral"]);
  await until(() => page.evaluate(() => location.hash), (hash) => hash.includes("own="), "it is in the link");
  assert.ok((await page.evaluate(() => location.href)).length < 2000);
  await page.evaluate(() => history.replaceState(null, "", location.pathname));
  await page.reload();
  await until(state, (now) => now.aircraft === key, "the last scene");
  assert.ok((await page.evaluate(() => localStorage.getItem("eigenwing.aircraft"))).includes(key), "it is kept");
  assert.deepEqual(seen.errors, []);
});

test("the scene is saved as a Python script", async (t) => {
  const { page, ready, seen } = await open(t, { fragment: "#v=1&ac=x15" });
  await ready();
  await page.getByRole("button", { name: "Take the scene along", exact: true }).dispatchEvent("click");
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Python", exact: true }).dispatchEvent("click");
  const download = await saved;
  assert.equal(download.suggestedFilename(), "x15-python.py");
  assert.match(readFileSync(await download.path(), "utf8"), /import control/);
  assert.deepEqual({ console: seen.console, errors: seen.errors }, { console: [], errors: [] });
});
