// What a person does one thing after another: by keyboard, by mouse, by finger. Each page serves a whole row of flows.

import assert from "node:assert/strict";
import { test } from "node:test";
import { click, doubleClick, frames, middle, open, pass, place, tap, until } from "./page.mjs";

const PITCH_STIFFNESS = "pitch stiffness C_mα";
const PLAYBACK = "Time of the playback in s";

const hands = (page) => ({
  button: (name) => page.getByRole("button", { name, exact: true }),
  heading: (name) => page.getByRole("heading", { name, exact: true }),
  // With the mouse, where it is drawn.
  press: async (locator) => click(page, await middle(locator)),
  tap: async (locator) => tap(page, await middle(locator)),
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

  await t.test("Tab finds the playback, and arrow keys scrub it both ways", async () => {
    const told = () => page.locator("#announcements").textContent();
    for (let i = 0; i < 60 && !(await told()).startsWith(PLAYBACK); i += 1) {
      // What is announced comes a little after what is reached.
      const before = await told();
      await press("Shift+Tab");
      await until(told, (now) => now !== before, "the next control is announced");
    }
    assert.match(await told(), new RegExp(`^${PLAYBACK}`));
    await press("Home");
    await until(playback, (time) => time === 0, "at the start");
    await press("ArrowRight");
    const step = await until(playback, (time) => time > 0, "forward");
    const at = (steps) => (time) => Math.abs(time - steps * step) < 1e-6;
    // One after the other as fast as they are heard: none of them takes the focus elsewhere.
    for (const key of ["ArrowRight", "ArrowRight", "ArrowUp", "ArrowRight", "ArrowLeft", "ArrowRight"]) await press(key);
    await until(playback, at(5), "five steps forward");
    for (const key of ["ArrowLeft", "ArrowDown", "ArrowLeft"]) await press(key);
    await until(playback, at(2), "three back");
    await press("End");
    const end = await until(playback, (time) => time > 20 * step, "to the end");
    await press("ArrowRight");
    // In one frame both would cancel out.
    await rest();
    assert.equal(await playback(), end, "it stops there");
    await press("ArrowLeft");
    await until(playback, (time) => time < end, "and comes back");
    await press("Escape");
    await rest();
  });

  await t.test("a letter key works after something was set by other means than the keyboard", async () => {
    const before = await state();
    const focused = () => page.evaluate(() => document.activeElement.ariaLabel);
    await slider(PITCH_STIFFNESS).fill("-0.5");
    await until(state, (now) => now.parameters.cm_alpha === -0.5, "set");
    assert.equal(await focused(), PITCH_STIFFNESS);
    await press("g");
    await counts(page.getByText("○ pinned: Navion, edited"), 1, "pinned");
    await press("g");
    await counts(page.getByText("○ pinned: Navion, edited"), 0, "unpinned");
    await press("a");
    await counts(heading("Pole map"), 0, "only the aircraft");
    await press("Escape");
    await counts(heading("Pole map"), 1, "and back");
    // The focus is still there, for a screen reader to go on from; Tab leads on from it, not from the start.
    assert.equal(await focused(), PITCH_STIFFNESS);
    await press("ArrowLeft");
    await until(state, (now) => now.parameters.cm_alpha < -0.5, "a step");
    await press("Tab");
    const told = () => page.locator("#announcements").textContent();
    await until(told, (now) => now.startsWith(`${PITCH_STIFFNESS}, typed`), "its number is next");
    await press("Tab");
    await until(told, (now) => now.startsWith(`Reset ${PITCH_STIFFNESS}`), "then the way back");
    // The button goes with what it undoes; keys are heard nonetheless.
    await button(`Reset ${PITCH_STIFFNESS}`).focus();
    await press("Enter");
    await until(state, (now) => now.parameters.cm_alpha === before.parameters.cm_alpha, "as before");
    await counts(button(`Reset ${PITCH_STIFFNESS}`), 0, "it is gone");
    // The canvas has the keyboard from the next frame on.
    await rest();
    await press("?");
    await counts(heading("Keys"), 1, "the sheet");
    await press("Escape");
    await counts(heading("Keys"), 0, "closed");
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
    await hands(page).press(button("Close"));
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
    await hands(page).press(button("Show all sliders"));
    await counts(sliders, all, "all again");
  });

  await t.test("G pins, what comes next is compared with it, and G unpins", async () => {
    await press("g");
    await counts(page.getByText("○ pinned: Navion"), 1, "pinned");
    const before = await state();
    const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
    await click(page, { x: x - width / 4, y });
    await until(state, (now) => now.parameters.cm_alpha < before.parameters.cm_alpha, "stiffer");
    await until(() => page.getByText(/Pinned → now/).count(), (count) => count >= 1, "before and after on the cards");
    await page.keyboard.press("g");
    await counts(page.getByText(/Pinned → now/), 0, "compared no more");
  });

  assertClean(seen);
});

test("by mouse: fly a mode, maximise by double click, drag a pole", async (t) => {
  const { page, ready, state, seen, rest, drawCallsIn } = await open(t);
  const { button, heading, press, counts, playback } = hands(page);
  await ready();

  await t.test("a mode flown from its card plays, pauses and is given up", async () => {
    const before = await state();
    await press(button("Fly the short period alone"));
    await until(state, (now) => now.disturbance === "One mode", "flown alone");
    await until(playback, (time) => time > 0.2, "it plays at once");
    await press(button("Pause"));
    await counts(button("Play"), 1, "paused");
    await rest();
    assert.equal(await drawCallsIn(1000), 0);
    await press(button("Stop flying the short period alone"));
    await until(state, (now) => now.disturbance === before.disturbance, "as before");
  });

  await t.test("a double click on a heading takes its pane over the page and back", async () => {
    for (const pane of ["Aircraft", "Pole map"]) {
      for (const panes of [1, 2]) {
        // The clicks of the last pair are over.
        await rest();
        await doubleClick(page, await middle(heading(pane)));
        await counts(page.getByRole("heading", { name: /^(Aircraft|Pole map)$/ }), panes, `${panes} panes after ${pane}`);
      }
    }
  });

  await t.test("a pole dragged moves its two derivatives, and undo is one step", async () => {
    const before = await state();
    const { x, y } = await middle(page.getByRole("button", { name: /^Short period pole, / }));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await frames(page);
    for (let i = 1; i <= 6; i += 1) {
      await page.mouse.move(x - 3 * i, y - 4 * i);
      await frames(page);
    }
    await page.mouse.up();
    await frames(page);
    const [was, is] = [before, await state()];
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
  const { page, ready, state, seen, rest } = await open(t, { viewport: { width: 390, height: 844 }, touch: true });
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
  const { x, y, width } = await middle(page.getByRole("slider", { name: "shift of the centre of gravity Δx_cg/c", exact: true }));
  const devtools = await page.context().newCDPSession(page);
  const finger = (type, points) => devtools.send("Input.dispatchTouchEvent", { type, touchPoints: points });
  await finger("touchStart", [{ x, y }]);
  await frames(page);
  for (let i = 1; i <= 6; i += 1) {
    await finger("touchMove", [{ x: x - (i * width) / 24, y: y + i }]);
    await frames(page);
  }
  const after = await state();
  assert.ok(after.parameters.cg < before.parameters.cg, "drawn along");
  await finger("touchEnd", []);
  await rest();
  assert.deepEqual((await state()).parameters, after.parameters, "it stays where the finger left it");

  // Draws fingers, which are points of the screen, along together.
  const swipe = async (fingers, dx, dy) => {
    const at = (i) => fingers.map((point, id) => ({ x: point.x + (i * dx) / 6, y: point.y + (i * dy) / 6, id }));
    await finger("touchStart", at(0));
    await frames(page);
    for (let i = 1; i <= 6; i += 1) {
      await finger("touchMove", at(i));
      await frames(page);
    }
    await finger("touchEnd", []);
    await rest();
  };
  const map = await page.getByRole("img", { name: /^Pole map, All modes/ }).boundingBox();
  const pole = () => place(page.getByRole("button", { name: /^Short period pole, / }));
  const row = () => place(page.getByRole("slider", { name: "airspeed V", exact: true }));
  const [poleBefore, rowBefore] = [await pole(), await row()];
  await swipe([{ x: map.x + 14, y: map.y + 24 }], 3, -60);
  await until(row, (now) => now.y < rowBefore.y - 30, "up on the map scrolls the sliders below it");
  const scrolled = await row();
  await swipe([scrolled], 3, 40);
  await until(row, (now) => now.y > scrolled.y + 20, "down on a slider scrolls too");
  assert.deepEqual((await state()).parameters, after.parameters, "and nothing is set");
  const poleAfter = await pole();
  assert.ok(Math.hypot(poleAfter.x - poleBefore.x, poleAfter.y - poleBefore.y) < 2, "nor is the map moved");
  await swipe([{ x: map.x + 50, y: map.y + 60 }, { x: map.x + 90, y: map.y + 80 }], -20, 25);
  await until(pole, (now) => now.x < poleBefore.x - 10 && now.y > poleBefore.y + 10, "two fingers move the map");
  await swipe([await pole()], -4, -20);
  await until(state, (now) => now.parameters.cm_alpha < after.parameters.cm_alpha, "one finger on a pole takes it");
  assertClean(seen);
});

test("on a screen of two pixels a point the page is sharp, whole, at rest, and where it is touched", async (t) => {
  const { page, ready, state, slider, seen, screenshot, rest } = await open(t, { scale: 2 });
  await ready();
  const [pixels, points] = await page.evaluate(() => [document.getElementById("eigenwing").width, innerWidth]);
  assert.equal(pixels, 2 * points, "as many pixels as the screen has");
  await rest();
  await screenshot("sharp");
  const right = await page.evaluate(() =>
    Math.max(...[...document.querySelectorAll("#mirror button")].map((button) => button.getBoundingClientRect().right)),
  );
  assert.ok(right <= points && right > 0.9 * points, `buttons reach to ${right} of ${points}`);
  const lift = slider("trim lift C_L");
  const { x, y, width } = await middle(lift);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await frames(page);
  for (let i = 1; i <= 4; i += 1) {
    await page.mouse.move(x + (i * width) / 16, y);
    await frames(page);
  }
  await page.mouse.up();
  const [least, most] = [Number(await lift.getAttribute("min")), Number(await lift.getAttribute("max"))];
  // Three quarters of the way along the slider, but for the ends of its rail.
  const wanted = least + (0.5 + (0.25 * width) / (width - 14)) * (most - least);
  await until(state, (now) => Math.abs(now.parameters.cl - wanted) < 0.03 * (most - least), `it is drawn to ${wanted}`);
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
  // A page that isn't seen goes on by timers: its own have had their turns between these.
  await page.evaluate(async () => {
    for (let turn = 0; turn < 30; turn += 1) await new Promise((passed) => setTimeout(passed, 50));
  });
  assert.equal(await page.locator("#failure").isVisible(), false);
  assert.equal(await page.locator("#welcome").isVisible(), true, "no frame has been drawn");
  await page.evaluate(() => window.comeToFront());
  await ready();
  assert.equal(await page.locator("#welcome").isVisible(), false);
  assert.equal((await state()).aircraft, "navion");
  assertClean(seen);
});

// Processor time of the page's thread in each frame that was drawn while `work` went on [ms], the shortest first, from the
// browser's own trace. Clocks on the wall would count what the software renderer takes from two cores, where a graphics card
// takes nothing, so nothing is rendered meanwhile.
async function frameTimes(page, work) {
  const session = await page.context().newCDPSession(page);
  const events = [];
  session.on("Tracing.dataCollected", ({ value }) => events.push(...value));
  const complete = new Promise((resolve) => session.once("Tracing.tracingComplete", resolve));
  await page.evaluate(() => {
    window.rendering = WebGL2RenderingContext.prototype.drawElements;
    WebGL2RenderingContext.prototype.drawElements = () => {};
  });
  await session.send("Tracing.start", { traceConfig: { includedCategories: ["devtools.timeline"] } });
  await work();
  await session.send("Tracing.end");
  await complete;
  await page.evaluate(() => (WebGL2RenderingContext.prototype.drawElements = window.rendering));
  await session.detach();
  const frames = events.filter(({ name, tdur }) => name === "FireAnimationFrame" && tdur !== undefined);
  // A frame in which nothing is drawn takes less than a tenth of this.
  return frames.map(({ tdur }) => tdur / 1000).filter((time) => time > 1).toSorted((a, b) => a - b);
}

test("with everything open an idle page draws nothing, and a drag is timed", async (t) => {
  const { page, ready, state, slider, seen, rest, drawCallsIn, screenshot } = await open(t);
  const { button, counts } = hands(page);
  await ready();
  const drag = async (what) => {
    const before = await state();
    const { x, y, width } = await middle(slider(PITCH_STIFFNESS));
    await page.mouse.move(x, y);
    await page.mouse.down();
    await frames(page);
    const times = await frameTimes(page, async () => {
      // To the left in the end, where the aircraft is stiffer and has all its modes.
      for (let i = 1; i <= 88; i += 1) {
        await page.mouse.move(x + (width / 5) * Math.sin(i / 8), y);
        await pass(page, 25, 1);
      }
    });
    await page.mouse.up();
    await frames(page);
    const at = (fraction) => times[Math.floor(fraction * (times.length - 1))].toFixed(1);
    t.diagnostic(`a frame of a drag ${what}: median ${at(0.5)} ms, p95 ${at(0.95)} ms of processor time, of ${times.length}`);
    assert.ok((await state()).parameters.cm_alpha < before.parameters.cm_alpha);
    await page.keyboard.press("Control+z");
    await until(state, ({ parameters }) => parameters.cm_alpha === before.parameters.cm_alpha, "the drag is one step");
  };
  await drag("as the page opens");

  const press = (locator) => locator.dispatchEvent("click");
  await page.keyboard.press("g");
  for (const mode of ["short period", "phugoid"]) {
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

  await drag("with everything open");
  await page.mouse.move(4, 4);
  await rest();
  assertClean(seen);
});
