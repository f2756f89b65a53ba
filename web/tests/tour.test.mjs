// A newcomer's tour, from a file of another program to one: AVL's derivatives are dropped, what they don't say is typed in, the modes
// have names, and the script that is taken along runs in python-control and prints the poles that the page has.

import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { drop, open, until } from "./page.mjs";

const DERIVATIVES = readFileSync(new URL("../../tests/data/import/navion.st", import.meta.url), "utf8");

// What AVL's file of the Navion leaves open, as its owner knows it: 2750 lb, and inertias of its report.
const TYPED = {
  "mass [kg]": "1247",
  "moment of inertia in roll [kg m²]": "1421",
  "moment of inertia in pitch [kg m²]": "4068",
  "moment of inertia in yaw [kg m²]": "4786",
  "product of inertia ∫ x z dm [kg m²]": "0",
  "altitude [m]": "0",
  "true airspeed [m/s]": "53.4",
  "drag by angle of attack [1/rad]": "0.33",
};

// Real and imaginary part as Python prints a complex number: -0.0172+0.2136j.
const POLE = /^(.+): lambda = (-?[\d.]+(?:e-?\d+)?)([+-][\d.]+(?:e-?\d+)?)j/;

test("who drops AVL's derivatives flies them and takes a script along that has the same poles", async (t) => {
  const { page, ready, state, seen } = await open(t);
  await ready();
  await drop(page, "navion.st", DERIVATIVES);

  const unit = page.getByRole("combobox", { name: /^unit of length of the geometry/ });
  await unit.dispatchEvent("click");
  await page.getByRole("option", { name: "feet", exact: true }).dispatchEvent("click");
  const missing = page.getByRole("textbox", { name: / – missing$/ });
  const names = () => missing.evaluateAll((fields) => fields.map((field) => field.ariaLabel ?? field.labels?.[0]?.textContent));
  await until(names, (all) => all.some((name) => name.startsWith("altitude")), "asked for with the unit");
  const typed = [];
  for (let next = await names(); next.length > 0; next = await names()) {
    const name = next[0].replace(/ – missing$/, "");
    assert.ok(name in TYPED, `nobody knows ${name}`);
    const field = page.getByRole("textbox", { name: next[0], exact: true });
    await field.fill(TYPED[name]);
    await field.press("Enter");
    // It makes room for what is asked next.
    await until(names, (now) => !now.includes(next[0]), `${name} is taken`);
    typed.push(name);
  }
  assert.deepEqual(typed.sort(), Object.keys(TYPED).sort());

  await page.getByRole("button", { name: "Use this aircraft", exact: true }).dispatchEvent("click");
  const { analysis } = await until(state, (now) => now.aircraft.startsWith("own-"), "it is studied");
  const keys = (plane) => plane.modes.map((mode) => mode.key).sort();
  assert.deepEqual(keys(analysis.longitudinal), ["phugoid", "short-period"]);
  assert.deepEqual(keys(analysis.lateral), ["dutch-roll", "roll-subsidence", "spiral"]);
  for (const name of ["Short period", "Phugoid"]) {
    await page.getByRole("heading", { name, exact: true }).first().waitFor({ state: "attached" });
  }

  await page.getByRole("button", { name: "Take the scene along", exact: true }).dispatchEvent("click");
  const saved = page.waitForEvent("download");
  await page.getByRole("button", { name: "Python", exact: true }).dispatchEvent("click");
  const script = await (await saved).path();
  const environment = { ...process.env, MPLBACKEND: "Agg" };
  const ran = spawnSync(process.env.PYTHON ?? "python3", [script], { encoding: "utf8", env: environment });
  assert.equal(ran.status, 0, ran.stderr);
  const printed = ran.stdout.split("\n").map((line) => POLE.exec(line)).filter((found) => found);
  const poles = printed.map(([, name, re, im]) => [name, Number(re), Number(im)]);
  const four = (x) => Number(x.toPrecision(4));
  assert.deepEqual(poles, analysis.longitudinal.modes.map(({ name, re, im }) => [name, four(re), four(im)]));
  assert.match(ran.stdout, /The motion is that of Eigenwing/);
  assert.deepEqual({ console: seen.console, errors: seen.errors }, { console: [], errors: [] });
});
