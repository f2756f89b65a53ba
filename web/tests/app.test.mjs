// The application in the page, as a person uses it: by keyboard, mouse, finger and screen reader.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { open } from "./page.mjs";

const PITCH_STIFFNESS = "pitch stiffness M_w";

// Python-control's poles of the lesson's model, as printed and with gravity in the same unit, and SciPy's of the
// Navion in SI: real and imaginary part, the fast mode first.
const POLES = {
  "navion": [[-2.5104866, 2.5918793], [-0.017133432, 0.21297038]],
  "lesson": [[-2.50542007706, 2.59489339542], [-0.0170799229418, 0.213122623619]],
  "lesson-printed": [[-2.69094411674, 2.54533171306], [0.168444116741, 1.13679885221]],
};

function assertPoles(state, expected) {
  const found = state.analysis.modes.map(({ re, im }) => [re, im]);
  assert.equal(found.length, expected.length);
  found.flat().forEach((value, i) => {
    const wanted = expected.flat()[i];
    assert.ok(Math.abs(value - wanted) < 1e-7 * Math.hypot(...expected[i >> 1]), `${value} is not ${wanted}`);
  });
}

// Waits until the state satisfies a condition; the page draws when it has time.
async function until(state, condition, what) {
  for (let i = 0; i < 100; i += 1) {
    const now = await state();
    if (condition(now)) return now;
    await sleep(50);
  }
  return assert.fail(`not within 5 s: ${what}`);
}

async function choose(page, chooser, choice) {
  await page.getByRole("combobox", { name: chooser }).dispatchEvent("click");
  const option = page.getByRole("option", { name: choice });
  await option.dispatchEvent("click");
  await option.waitFor({ state: "detached" });
}

async function middle(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2, width };
}

test("the page opens on the Navion with both modes named and at home", async (t) => {
  const { ready, state } = await open(t);
  await ready();
  const now = await state();
  assert.equal(now.aircraft, "navion");
  assertPoles(now, POLES.navion);
  assert.deepEqual(now.analysis.modes.map((mode) => mode.name), ["Short period", "Phugoid"]);
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
    assert.equal(now.analysis.dynamic_stability, stability);
    assert.equal(now.analysis.static_stability, "stable");
    assert.equal(now.analysis.gravity_is_plausible, key === "lesson");
  });
}

test("a slider moved by keyboard moves poles and response, and undo takes it back", async (t) => {
  const { page, ready, state, slider, seen } = await open(t);
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  // A click beside the handle moves it and gives focus; Delete goes back to the reference.
  await page.mouse.click(x + width / 4, y);
  await until(state, (now) => now.parameters.mw !== before.parameters.mw, "moved by the click");
  await page.keyboard.press("Delete");
  await until(state, (now) => now.parameters.mw === before.parameters.mw, "the reference again");
  await page.keyboard.press("Shift+ArrowLeft");
  const after = await until(state, (now) => now.parameters.mw < before.parameters.mw, "a stiffer aircraft");
  assert.ok(after.analysis.modes[0].im > before.analysis.modes[0].im);
  assert.notDeepEqual(after.analysis.response.last, before.analysis.response.last);
  await page.keyboard.press("Control+z");
  await until(state, (now) => now.parameters.mw !== after.parameters.mw, "undone");
  assert.deepEqual(seen.errors, []);
});

test("a slider dragged by mouse moves poles and response, and a double click resets it", async (t) => {
  const { page, ready, state, slider } = await open(t);
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  await page.mouse.move(x + width / 6, y);
  await page.mouse.down();
  for (let i = 1; i <= 10; i += 1) await page.mouse.move(x + width / 6 + i * (width / 40), y);
  await page.mouse.up();
  const after = await until(state, (now) => now.analysis.static_stability === "unstable", "statically unstable");
  assert.ok(after.analysis.modes.some((mode) => mode.name === "Divergence" && mode.time_to_double > 0));
  await page.mouse.dblclick(x, y);
  await until(state, (now) => now.parameters.mw === before.parameters.mw, "the reference again");
});

test("the wheel over sliders and numbers edits nothing", async (t) => {
  const { page, ready, state, slider, drawCallsIn } = await open(t);
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  for (const over of [x, x + width / 2 + 40]) {
    await page.mouse.move(over, y);
    await page.mouse.wheel(0, 120);
    await drawCallsIn(200);
  }
  assert.deepEqual((await state()).parameters, before.parameters);
});

test("a finger moves a slider on a phone", async (t) => {
  const { page, ready, state, slider } = await open(t, { viewport: { width: 390, height: 844 }, touch: true });
  await ready();
  const before = await state();
  const { x, y, width } = await middle(slider("lift due to speed Z_u"));
  await page.touchscreen.tap(x - width / 4, y);
  const after = await until(state, (now) => now.parameters.zu !== before.parameters.zu, "moved");
  assert.ok(after.parameters.zu < before.parameters.zu);
});

test("a screen reader finds every slider by name, sets one, and hears the verdict and the modes", async (t) => {
  const { page, ready, state, slider } = await open(t);
  await ready();
  assert.equal(await page.getByRole("slider").count(), 11);
  for (const name of ["Derivatives", "Pole map", "Short period", "Phugoid"]) {
    assert.equal(await page.getByRole("heading", { name, exact: true }).count(), 1, name);
  }
  assert.equal(await page.getByRole("img", { name: /^Pole map, All modes: Short period ζ 0.70/ }).count(), 1);
  assert.equal(await page.getByText(/^Dynamically stable/).count(), 1);
  await slider("pitch damping M_q").fill("-1");
  await until(state, (now) => now.parameters.mq === -1, "set");
});

test("an absurd number is refused with a sentence beside the field and nothing is lost", async (t) => {
  const { page, ready, state } = await open(t);
  await ready();
  const before = await state();
  const field = page.getByRole("textbox", { name: "pitch stiffness M_w, typed" });
  const { x, y } = await middle(field);
  await page.mouse.click(x, y);
  await page.keyboard.press("Control+a");
  await page.keyboard.type("1e300");
  await page.keyboard.press("Enter");
  await page.getByText(/is beyond anything meaningful here/).first().waitFor({ state: "attached" });
  assert.deepEqual((await state()).parameters, before.parameters);
});

test("each disturbance has its own response, and a gust is not an elevator pulse", async (t) => {
  const { page, ready, state } = await open(t);
  await ready();
  const ends = [];
  for (const choice of ["Elevator step", "Elevator pulse", "Vertical gust"]) {
    await choose(page, "Disturbance", choice);
    const now = await until(state, (now) => now.disturbance === choice, choice);
    ends.push(JSON.stringify(now.analysis.response.last));
  }
  assert.equal(new Set(ends).size, 3);
});
