// The application in the page, as a person uses it: by keyboard, mouse, finger and screen reader.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { click, doubleClick, frames, middle, open, rest, tap, until } from "./page.mjs";

const PITCH_STIFFNESS = "pitch stiffness C_mα";

// Python-control's poles of the lesson's model, as printed and with gravity in the same unit: real and imaginary
// part, the fast mode first.
const POLES = {
  "lesson": [[-2.50542007706, 2.59489339542], [-0.0170799229418, 0.213122623619]],
  "lesson-printed": [[-2.69094411674, 2.54533171306], [0.168444116741, 1.13679885221]],
};

function assertPoles(state, expected) {
  const found = state.analysis.longitudinal.modes.map(({ re, im }) => [re, im]);
  assert.equal(found.length, expected.length);
  found.flat().forEach((value, i) => {
    const wanted = expected.flat()[i];
    assert.ok(Math.abs(value - wanted) < 1e-7 * Math.hypot(...expected[i >> 1]), `${value} is not ${wanted}`);
  });
}

async function choose(page, chooser, choice) {
  await page.getByRole("combobox", { name: chooser, exact: true }).dispatchEvent("click");
  const option = page.getByRole("option", { name: choice });
  await option.dispatchEvent("click");
  await option.waitFor({ state: "detached" });
}

test("the page opens on the Navion with both modes named and at home", async (t) => {
  const { ready, state } = await open(t);
  await ready();
  const now = await state();
  assert.equal(now.aircraft, "navion");
  // Teper, NASA CR-96008, from coefficients of two or three digits.
  const [shortPeriod, phugoid] = now.analysis.longitudinal.modes;
  assert.deepEqual([shortPeriod.key, phugoid.key], ["short-period", "phugoid"]);
  for (const [value, published] of [
    [shortPeriod.natural_frequency, 3.6083],
    [shortPeriod.damping_ratio, 0.6957],
    [phugoid.natural_frequency, 0.2137],
    [phugoid.damping_ratio, 0.0801],
  ]) {
    assert.ok(Math.abs(value / published - 1) < 1e-3, `${value} is not ${published}`);
  }
  assert.equal(now.analysis.response.samples, 1201);
});

for (const [key, choice, stability] of [
  ["lesson", "Lesson 4, gravity in the same unit", "stable"],
  ["lesson-printed", "Lesson 4, as printed", "unstable"],
]) {
  test(`${choice}: the poles of python-control, dynamically ${stability}, statically stable`, async (t) => {
    const { page, ready, state } = await open(t);
    await ready();
    await choose(page, "Aircraft", choice);
    const now = await until(state, (state) => state.aircraft === key, `${key} on screen`);
    assertPoles(now, POLES[key]);
    assert.equal(now.analysis.longitudinal.dynamic_stability, stability);
    assert.equal(now.analysis.longitudinal.static_stability, "stable");
    assert.equal(now.analysis.gravity_is_plausible, key === "lesson");
  });
}

test("a slider moved by keyboard moves poles and response, and undo takes it back", async (t) => {
  const { page, ready, state, slider, seen } = await open(t);
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  // A click beside the handle moves it and gives focus; Delete goes back to the reference.
  await click(page, { x: x + width / 4, y });
  await until(state, (now) => now.parameters.cm_alpha !== before.parameters.cm_alpha, "moved by the click");
  await page.keyboard.press("Delete");
  await until(state, (now) => now.parameters.cm_alpha === before.parameters.cm_alpha, "the reference again");
  await page.keyboard.press("Shift+ArrowLeft");
  const after = await until(state, (now) => now.parameters.cm_alpha < before.parameters.cm_alpha, "a stiffer aircraft");
  assert.ok(after.analysis.longitudinal.modes[0].im > before.analysis.longitudinal.modes[0].im);
  assert.notDeepEqual(after.analysis.response.last, before.analysis.response.last);
  await page.keyboard.press("Control+z");
  await until(state, (now) => now.parameters.cm_alpha !== after.parameters.cm_alpha, "undone");
  assert.deepEqual(seen.errors, []);
});

test("a slider dragged by mouse moves poles and response, and a double click resets it", async (t) => {
  const { page, ready, state, slider } = await open(t);
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  await page.mouse.move(x + width / 6, y);
  await page.mouse.down();
  await frames(page);
  for (let i = 1; i <= 10; i += 1) {
    await page.mouse.move(x + width / 6 + i * (width / 40), y);
    await frames(page);
  }
  await page.mouse.up();
  const after = await until(state, (now) => now.analysis.longitudinal.static_stability === "unstable", "statically unstable");
  assert.ok(after.analysis.longitudinal.modes.some((mode) => /divergence$/.test(mode.name) && mode.time_to_double > 0));
  await rest(page);
  await doubleClick(page, { x, y });
  await until(state, (now) => now.parameters.cm_alpha === before.parameters.cm_alpha, "the reference again");
});

test("a small page, which is drawn fast, comes to rest as a large one does", async (t) => {
  const { page, ready, slider, state } = await open(t, { viewport: { width: 390, height: 500 } });
  await ready();
  await rest(page);
  await slider(PITCH_STIFFNESS).fill("-0.5");
  await until(state, (now) => now.parameters.cm_alpha === -0.5, "set");
  await rest(page);
});

test("the wheel over sliders and numbers edits nothing", async (t) => {
  const { page, ready, state, slider } = await open(t);
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  for (const over of [x, x + width / 2 + 40]) {
    await page.mouse.move(over, y);
    const heard = page.evaluate(() => new Promise((heard) => addEventListener("wheel", () => heard(), { once: true, capture: true })));
    await frames(page);
    await page.mouse.wheel(0, 120);
    await heard;
    await rest(page);
  }
  assert.deepEqual((await state()).parameters, before.parameters);
});

test("a finger moves a slider on a phone", async (t) => {
  const { page, ready, state, slider } = await open(t, { viewport: { width: 390, height: 844 }, touch: true });
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider("shift of the centre of gravity Δx_cg/c"));
  await tap(page, { x: x - width / 4, y });
  const after = await until(state, (now) => now.parameters.cg !== before.parameters.cg, "moved");
  assert.ok(after.parameters.cg < before.parameters.cg);
});

test("a screen reader finds every slider by name, sets one, and hears the verdict and the modes", async (t) => {
  const { page, ready, state, slider } = await open(t);
  await ready();
  assert.ok((await page.getByRole("slider").count()) >= 15);
  for (const name of ["Pole map", "Short period", "Phugoid"]) {
    assert.equal(await page.getByRole("heading", { name, exact: true }).count(), 1, name);
  }
  assert.equal(await page.getByRole("img", { name: /^Pole map, All modes: Short period ζ 0.70/ }).count(), 1);
  assert.equal(await page.getByText(/^Dynamically stable/).count(), 1);
  await slider("pitch damping C_mq").fill("-1");
  await until(state, (now) => now.parameters.cm_q === -1, "set");
});

test("an absurd number is refused with a sentence beside the field and nothing is lost", async (t) => {
  const { page, ready, state } = await open(t);
  await ready();
  const before = await state();
  const field = page.getByRole("textbox", { name: "pitch stiffness C_mα, typed" });
  await click(page, await middle(field));
  await page.keyboard.press("Control+a");
  await page.keyboard.type("1e300");
  await page.keyboard.press("Enter");
  await page.getByText(/is beyond anything meaningful here/).first().waitFor({ state: "attached" });
  assert.deepEqual((await state()).parameters, before.parameters);
});

test("what a screen reader writes counts from Enter on, however soon it comes, and no number is refused", async (t) => {
  const { page, ready, state } = await open(t);
  await ready();
  const field = page.getByRole("textbox", { name: "pitch stiffness C_mα, typed" });
  for (const [text, pause] of [["-0.5", 0], ["-0.6", 0], ["-0.7", 30], ["-0.8", 300]]) {
    await field.fill(text);
    await sleep(pause);
    await field.press("Enter");
    await until(state, ({ parameters }) => parameters.cm_alpha === Number(text), `${text}, ${pause} ms before Enter`);
  }
  const before = await state();
  await field.fill("banana");
  await field.press("Enter");
  await page.getByText(/“banana” is not a number/).first().waitFor({ state: "attached" });
  assert.deepEqual((await state()).parameters, before.parameters);
});

test("each disturbance has its own response, and a gust is not an elevator pulse", async (t) => {
  const { page, ready, state } = await open(t);
  await ready();
  const ends = [];
  for (const [source, shape] of [
    ["Elevator", "step"],
    ["Elevator", "pulse"],
    ["Elevator", "3-2-1-1"],
    ["Vertical gust", "1 − cosine"],
    ["Turbulence", undefined],
    ["One mode", undefined],
  ]) {
    await choose(page, "Disturbance", source);
    if (shape) await choose(page, "Shape of the disturbance", shape);
    const choice = shape ? `${source} ${shape}` : source;
    const now = await until(state, (now) => now.disturbance === choice, choice);
    ends.push(JSON.stringify(now.analysis.response.last));
  }
  assert.equal(new Set(ends).size, 6);
});

test("lateral motion: Dutch roll, roll subsidence and spiral, as published", async (t) => {
  const { page, ready, state } = await open(t);
  await ready();
  await page.getByRole("button", { name: "Lateral–directional" }).dispatchEvent("click");
  const now = await until(state, (now) => now.plane === "lateral", "lateral on screen");
  const modes = Object.fromEntries(now.analysis.lateral.modes.map((mode) => [mode.key, mode]));
  // Teper, NASA CR-96008, from coefficients of two or three digits.
  for (const [value, published] of [
    [modes["dutch-roll"].natural_frequency, 2.385],
    [modes["dutch-roll"].damping_ratio, 0.204],
    [modes["roll-subsidence"].re, -8.435],
    [modes.spiral.re, -0.00876],
  ]) {
    assert.ok(Math.abs(value / published - 1) < 1e-2, `${value} is not ${published}`);
  }
  await page.getByRole("heading", { name: "Dutch roll", exact: true }).waitFor({ state: "attached" });
});

test("every aircraft of the list can be opened, in both planes where it has both", async (t) => {
  const { page, ready, state, seen } = await open(t);
  await ready();
  const [keys, lateral] = [new Set(), new Set()];
  await page.getByRole("combobox", { name: "Aircraft", exact: true }).dispatchEvent("click");
  await page.getByRole("option").first().waitFor({ state: "attached" });
  const listed = await page.getByRole("option").allInnerTexts();
  // The last leads to a file of one's own.
  const names = listed.filter((name) => !name.startsWith("Your own aircraft"));
  await page.getByRole("option").first().dispatchEvent("click");
  for (const name of names) {
    await choose(page, "Aircraft", name);
    const { aircraft, analysis } = await until(state, (now) => !keys.has(now.aircraft), name);
    keys.add(aircraft);
    if (analysis.lateral == null) continue;
    await page.getByRole("button", { name: "Lateral–directional", exact: true }).dispatchEvent("click");
    await until(state, (now) => now.plane === "lateral" && now.analysis.lateral.modes.length >= 2, `${name}, lateral`);
    lateral.add(aircraft);
    await page.getByRole("button", { name: "Longitudinal", exact: true }).dispatchEvent("click");
  }
  assert.equal(keys.size, names.length);
  assert.ok(lateral.size > keys.size / 2 && !lateral.has("lesson"), `${[...lateral]}`);
  assert.deepEqual(seen.errors, []);
});
