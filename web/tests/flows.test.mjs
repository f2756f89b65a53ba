// What a person does one thing after another: by keyboard, by mouse, by finger. Each page serves a whole row of flows.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { open } from "./page.mjs";

const PITCH_STIFFNESS = "pitch stiffness C_mα";
const PLAYBACK = "Time of the playback in s";

// Waits until something that the page says satisfies a condition; the page draws when it has time.
async function until(found, condition, what) {
  let last;
  for (let i = 0; i < 100; i += 1) {
    last = await found();
    if (condition(last)) return last;
    await sleep(50);
  }
  return assert.fail(`not within 5 s: ${what}; ${JSON.stringify(last)?.slice(0, 300)}`);
}

async function middle(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2, width };
}

const hands = (page) => ({
  button: (name) => page.getByRole("button", { name, exact: true }),
  heading: (name) => page.getByRole("heading", { name, exact: true }),
  // With the mouse, where it is drawn.
  click: async (locator) => {
    const { x, y } = await middle(locator);
    await page.mouse.click(x, y);
  },
  tap: async (locator) => {
    const { x, y } = await middle(locator);
    await page.touchscreen.tap(x, y);
  },
  // How many there are, in the end.
  counts: (locator, count, what) => until(() => locator.count(), (now) => now === count, what),
  playback: async () => Number(await page.getByRole("slider", { name: PLAYBACK }).inputValue()),
});

function assertClean(seen) {
  assert.deepEqual({ console: seen.console, errors: seen.errors }, { console: [], errors: [] });
}

test("by keyboard: play, scrub, maximise, help, search, pin and compare", async (t) => {
  const { page, ready, state, slider, seen, rest, drawCallsIn } = await open(t);
  const { button, heading, counts, playback } = hands(page);
  await ready();
  const press = (keys) => page.keyboard.press(keys);

  await t.test("Space plays and pauses, and a paused page draws nothing", async () => {
    assert.equal(await playback(), 0);
    await press("Space");
    const first = await until(playback, (time) => time > 0.2, "time goes on");
    await until(playback, (time) => time > first, "and on");
    await counts(button("Pause"), 1, "playing");
    await press("Space");
    await counts(button("Play"), 1, "paused");
    await rest();
    const time = await playback();
    assert.equal(await drawCallsIn(1000), 0);
    assert.equal(await playback(), time);
  });

  await t.test("Tab finds the playback, and an arrow key scrubs it", async () => {
    const told = () => page.locator("#announcements").textContent();
    for (let i = 0; i < 60 && !(await told()).startsWith(PLAYBACK); i += 1) {
      // What is announced comes a little after what is reached.
      const before = await told();
      await press("Shift+Tab");
      await until(told, (now) => now !== before, "the next control is announced");
    }
    assert.match(await told(), new RegExp(`^${PLAYBACK}`));
    const before = await playback();
    await press("ArrowRight");
    await until(playback, (time) => time > before, "forward");
    await rest();
    await press("Escape");
  });

  await t.test("P, A and R take a pane over the page and Esc puts it back", async () => {
    const panes = ["Pole map", "Aircraft"];
    for (const [key, name] of [["p", "Pole map"], ["a", "Aircraft"]]) {
      await press(key);
      for (const pane of panes) await counts(heading(pane), pane === name ? 1 : 0, `${pane} while ${name} is large`);
      await press("Escape");
      for (const pane of panes) await counts(heading(pane), 1, `${pane} in its place`);
    }
    await press("r");
    await counts(heading("Pole map"), 0, "only the response");
    await press("r");
    await counts(heading("Pole map"), 1, "the same key is the way back");
  });

  await t.test("? shows the sheet of keys, and Esc or its button closes it", async () => {
    await press("?");
    await counts(heading("Keys"), 1, "the sheet");
    await press("Escape");
    await counts(heading("Keys"), 0, "closed by Esc");
    await press("?");
    await counts(heading("Keys"), 1, "the sheet again");
    await hands(page).click(button("Close"));
    await counts(heading("Keys"), 0, "closed by its button");
  });

  await t.test("/ finds a derivative", async () => {
    const sliders = page.getByRole("slider");
    const all = await sliders.count();
    await press("/");
    const told = () => page.locator("#announcements").textContent();
    await until(told, (now) => now.startsWith("Find a derivative"), "the field has the focus");
    await page.keyboard.type("C_mq");
    // It, and the time of the playback.
    await counts(sliders, 2, "one derivative");
    await counts(page.getByRole("slider", { name: "pitch damping C_mq" }), 1, "the one that was wanted");
    await press("Escape");
    await rest();
    await hands(page).click(button("Show all sliders"));
    await counts(sliders, all, "all again");
  });

  await t.test("G pins, what comes next is compared with it, and G unpins", async () => {
    await press("g");
    await counts(page.getByText("○ pinned: Navion"), 1, "pinned");
    const before = await state();
    const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
    await page.mouse.click(x - width / 4, y);
    await until(state, (now) => now.parameters.cm_alpha < before.parameters.cm_alpha, "stiffer");
    await until(() => page.getByText(/Pinned → now/).count(), (count) => count >= 1, "before and after on the cards");
    await page.keyboard.press("g");
    await counts(page.getByText(/Pinned → now/), 0, "compared no more");
  });

  assertClean(seen);
});

test("by mouse: fly a mode, maximise by double click, drag a pole", async (t) => {
  const { page, ready, state, seen, rest, drawCallsIn } = await open(t);
  const { button, heading, click, counts, playback } = hands(page);
  await ready();

  await t.test("a mode flown from its card plays, pauses and is given up", async () => {
    const before = await state();
    await click(button("Fly the Short period alone"));
    await until(state, (now) => now.disturbance === "One mode", "flown alone");
    await click(button("Play"));
    await until(playback, (time) => time > 0.2, "time goes on");
    await click(button("Pause"));
    await counts(button("Play"), 1, "paused");
    await rest();
    assert.equal(await drawCallsIn(1000), 0);
    await click(button("Stop flying the Short period alone"));
    await until(state, (now) => now.disturbance === before.disturbance, "as before");
  });

  await t.test("a double click on a heading takes its pane over the page and back", async () => {
    for (const pane of ["Aircraft", "Pole map"]) {
      for (const panes of [1, 2]) {
        // The clicks of the last pair are over.
        await rest();
        const { x, y } = await middle(heading(pane));
        await page.mouse.dblclick(x, y);
        await counts(page.getByRole("heading", { name: /^(Aircraft|Pole map)$/ }), panes, `${panes} panes after ${pane}`);
      }
    }
  });

  await t.test("a pole dragged moves its two derivatives, and undo is one step", async () => {
    const before = await state();
    const { x, y } = await middle(page.getByRole("button", { name: /^Short period pole, / }));
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= 6; i += 1) {
      await page.mouse.move(x - 3 * i, y - 4 * i);
      await sleep(30);
    }
    await page.mouse.up();
    const [was, is] = [before, await until(state, (now) => now.parameters.cm_alpha !== before.parameters.cm_alpha, "moved")];
    const [from, to] = [was, is].map((now) => now.analysis.longitudinal.modes[0]);
    assert.ok(to.re < from.re && to.im > from.im, `${to.re}, ${to.im}`);
    // Dimensional derivatives and matrix follow from the coefficients.
    const moved = Object.keys(was.parameters).filter((key) => /^c._?/.test(key) && was.parameters[key] !== is.parameters[key]);
    assert.deepEqual(moved.sort(), ["cm_alpha", "cm_q"]);
    await page.keyboard.press("Control+z");
    const undone = await until(state, (now) => now.parameters.cm_alpha === before.parameters.cm_alpha, "undone");
    assert.deepEqual(undone.parameters, before.parameters);
  });

  assertClean(seen);
});

test("by finger on a phone: every pane, and a slider drawn along", async (t) => {
  const { page, ready, state, seen } = await open(t, { viewport: { width: 390, height: 844 }, touch: true });
  const { button, tap, counts } = hands(page);
  await ready();
  for (const [pane, something] of [
    ["Modes", page.getByRole("heading", { name: "Short period", exact: true })],
    ["Response", page.getByRole("combobox", { name: "Disturbance", exact: true })],
    ["Aircraft", button("Play")],
    ["Derivatives", page.getByRole("slider", { name: PITCH_STIFFNESS, exact: true })],
  ]) {
    await tap(button(pane));
    await counts(something, 1, pane);
  }
  const before = await state();
  const { x, y, width } = await middle(page.getByRole("slider", { name: "lift-curve slope C_Lα", exact: true }));
  const devtools = await page.context().newCDPSession(page);
  const finger = (type, points) => devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await finger("touchStart", [{ x, y }]);
  for (let i = 1; i <= 6; i += 1) {
    await finger("touchMove", [{ x: x + (i * width) / 24, y: y + i }]);
    await sleep(30);
  }
  await finger("touchEnd", []);
  const after = await until(state, (now) => now.parameters.cl_alpha > before.parameters.cl_alpha, "drawn along");
  await sleep(300);
  assert.deepEqual((await state()).parameters, after.parameters, "it stays where the finger left it");
  assertClean(seen);
});

// As a browser treats a page behind another, which a headless one doesn't: hidden, and without animation frames until
// `comeToFront()`.
function stayBehind() {
  const request = window.requestAnimationFrame.bind(window);
  const waiting = [];
  let hidden = true;
  Object.defineProperty(document, "hidden", { get: () => hidden });
  Object.defineProperty(document, "visibilityState", { get: () => (hidden ? "hidden" : "visible") });
  window.requestAnimationFrame = (callback) => (hidden ? waiting.push(callback) : request(callback));
  window.comeToFront = () => {
    hidden = false;
    document.dispatchEvent(new Event("visibilitychange"));
    for (const callback of waiting.splice(0)) request(callback);
  };
}

test("a page loaded behind another becomes ready when it comes to the front", async (t) => {
  const { page, ready, seen, state } = await open(t, { before: stayBehind });
  await until(() => page.evaluate(() => typeof window.eigenwing), (type) => type === "object", "the program has begun");
  await sleep(1500);
  assert.equal(await page.locator("#failure").isVisible(), false);
  assert.equal(await page.locator("#welcome").isVisible(), true, "no frame has been drawn");
  await page.evaluate(() => window.comeToFront());
  await ready();
  assert.equal(await page.locator("#welcome").isVisible(), false);
  assert.equal((await state()).aircraft, "navion");
  assertClean(seen);
});

// Notes how long the program works in each frame that it draws.
function timeFrames() {
  window.frameTimes = [];
  const request = window.requestAnimationFrame.bind(window);
  window.requestAnimationFrame = (callback) =>
    request((time) => {
      const [begun, drawn] = [performance.now(), window.drawCalls];
      callback(time);
      if (window.drawCalls > drawn) window.frameTimes.push(performance.now() - begun);
    });
}

test("with everything open an idle page draws nothing, and a drag is timed", async (t) => {
  const { page, ready, state, slider, seen, rest, drawCallsIn, screenshot } = await open(t, { before: timeFrames });
  const { button, counts } = hands(page);
  await ready();
  const press = (locator) => locator.dispatchEvent("click");
  await page.keyboard.press("g");
  for (const mode of ["Short period", "Phugoid"]) {
    for (const name of [`Shape of the ${mode}`, `Level of the ${mode}`, `Approximations of the ${mode}`]) await press(button(name));
  }
  for (const name of ["Level boundaries", "Textbook approximations"]) await press(page.getByLabel(name, { exact: true }).or(button(name)).first());
  for (const name of ["Nonlinear", "Split into modes"]) {
    await page.getByRole("checkbox", { name, exact: true }).dispatchEvent("click");
    await until(() => page.getByRole("checkbox", { name, exact: true }).isChecked(), (is) => is, name);
  }
  await counts(page.getByText("○ pinned: Navion"), 1, "pinned");
  await rest();
  assert.equal(await drawCallsIn(3000), 0);
  await screenshot("everything");

  const before = await state();
  const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await sleep(300);
  await page.evaluate(() => (window.frameTimes.length = 0));
  for (let i = 1; i <= 60; i += 1) {
    await page.mouse.move(x + (width / 4) * Math.sin(i / 5), y);
    await sleep(20);
  }
  await page.mouse.up();
  const times = (await page.evaluate(() => window.frameTimes)).toSorted((a, b) => a - b);
  const at = (fraction) => times[Math.floor(fraction * (times.length - 1))].toFixed(1);
  t.diagnostic(`a frame of a drag with everything open: median ${at(0.5)} ms, p95 ${at(0.95)} ms of script, of ${times.length}`);
  assert.notEqual((await state()).parameters.cm_alpha, before.parameters.cm_alpha);
  await page.mouse.move(4, 4);
  await rest();
  assertClean(seen);
});
