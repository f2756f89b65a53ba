// The page for people who can't see it, or not as it is drawn: what a screen reader finds, hears and does; without findings of axe-core,
// enlarged, in few colours, without motion, and never in the way of a finger.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";
import { frames, middle, open, rest, until } from "./page.mjs";

const require = createRequire(import.meta.url);
const AXE = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const READER = readFileSync(require.resolve("@guidepup/virtual-screen-reader/browser.js"), "utf8");

const DAMPING = "pitch damping C_mq";
const STIFFNESS = "pitch stiffness C_mα";

// What axe-core finds, a line for each rule.
async function findings(page) {
  await page.evaluate(AXE);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  return violations.map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ html }) => html.slice(0, 160)).join(" | ")}`);
}

const press = (page, name) => page.getByRole("button", { name, exact: true }).first().dispatchEvent("click");

// What is there once it is shown.
for (const [what, options, act, there] of [
  ["the workbench", {}, async () => {}, (page) => page.getByRole("heading", { name: "Pole map", exact: true })],
  ["the workbench on a phone", { viewport: { width: 390, height: 844 }, touch: true }, async () => {}, (page) => page.getByRole("button", { name: "Derivatives", exact: true })],
  ["lateral motion", { fragment: "#v=1&ac=b747-fc8&plane=lat" }, async () => {}, (page) => page.getByRole("heading", { name: "Dutch roll", exact: true })],
  [
    "the list of aircraft",
    {},
    (page) => page.getByRole("combobox", { name: "Aircraft", exact: true }).dispatchEvent("click"),
    (page) => page.getByRole("option"),
  ],
  ["the quantities that are shown", {}, (page) => press(page, "Quantities shown"), (page) => page.getByRole("checkbox", { name: /pitch angle$/ })],
  ["the sheet of keys", {}, (page) => page.keyboard.press("?"), (page) => page.getByRole("heading", { name: "Keys", exact: true })],
  ["the sheet of embedding", {}, (page) => page.keyboard.press("m"), (page) => page.getByRole("heading", { name: /^Embed/ })],
  [
    "the sheet of lessons",
    {},
    (page) => press(page, "Lessons: begin with a question"),
    (page) => page.getByRole("button", { name: "A lecture from links …", exact: true }),
  ],
  ["the equations", { fragment: "#v=1&ac=navion&stage=equations.modes" }, async () => {}, (page) => page.getByRole("region", { name: "Matrices", exact: true })],
  ["a step of a lesson", { fragment: "#v=1&lesson=longitudinal" }, async () => {}, (page) => page.getByRole("button", { name: /^Step 1 of/ })],
  ["a slide", { fragment: "#v=1&lesson=lecture-modes&present=on" }, async () => {}, (page) => page.getByRole("heading", { name: "Count the motions" })],
]) {
  test(`axe-core finds nothing in ${what}`, async (t) => {
    const { page, ready } = await open(t, options);
    await ready();
    await rest(page);
    await act(page);
    await there(page).first().waitFor({ state: "attached" });
    await rest(page);
    assert.deepEqual(await findings(page), []);
  });
}

// guidepup's virtual screen reader, which reads the page as one would: in its order, by roles, names and values, with live regions.
test("a screen reader walks to a slider, moves it, hears what follows, and finds the verdict and the modes", async (t) => {
  const { page, ready, state, slider } = await open(t, { server: { files: { "reader.js": READER } } });
  await ready();
  await rest(page);
  await page.evaluate(async () => {
    const { virtual } = await import(new URL("reader.js", document.baseURI).href);
    window.reader = virtual;
    await virtual.start({ container: document.body });
  });
  const said = () => page.evaluate(() => window.reader.spokenPhraseLog());
  const walk = async (to, most = 400) => {
    for (let i = 0; i < most; i += 1) {
      const phrase = await page.evaluate(async () => {
        await window.reader.next();
        return window.reader.lastSpokenPhrase();
      });
      if (to.test(phrase)) return phrase;
    }
    return assert.fail(`not on the way: ${to}; ${(await said()).slice(0, 40).join(" / ")}`);
  };
  await walk(/^heading, Eigenwing, level 1/);
  await walk(/^region, Sliders/);
  assert.match(await walk(new RegExp(`^slider, ${STIFFNESS}`)), /current value −0\.683/);
  const before = (await state()).parameters.cm_alpha;
  // It only reads: to move something, a reader goes there with the focus.
  await slider(STIFFNESS).focus();
  for (let i = 0; i < 3; i += 1) await page.keyboard.press("ArrowRight");
  await until(state, ({ parameters }) => parameters.cm_alpha > before, "moved by the keys of the reader");
  // The element says what follows as soon as it is there.
  const value = () => page.getByRole("slider", { name: STIFFNESS, exact: true }).getAttribute("aria-valuetext");
  await until(value, (text) => /: Short period .* radians a second, damping ratio .*, Dynamically stable$/.test(text), "what follows");
  await walk(/^Dynamically stable/);
  await walk(/^heading, Short period, level/);
  await walk(/^region, Map/);
  await walk(/^image, Pole map, All modes/);
  await page.evaluate(() => window.reader.stop());
});

test("the pole map is told as it is seen, with where the poles have gone", async (t) => {
  const { page, ready, slider } = await open(t);
  await ready();
  const map = () => page.getByRole("img", { name: /^Pole map, All modes/ }).first().getAttribute("aria-label");
  await until(map, (text) => /Two pairs, one quick and well damped at .*i, one slow and lightly damped at .*i$/.test(text), "as it lies");
  await slider(STIFFNESS).focus();
  for (let i = 0; i < 40; i += 1) await page.keyboard.press("ArrowLeft");
  await until(map, (text) => /Short period has moved up/.test(text), "moved");
});

test("a verdict that becomes another is said once", async (t) => {
  const { page, ready, slider, state } = await open(t);
  await ready();
  await page.evaluate(() => {
    window.said = [];
    const region = document.getElementById("announcements");
    new MutationObserver(() => window.said.push(region.textContent.trim())).observe(region, { childList: true, characterData: true, subtree: true });
  });
  const verdicts = async () => (await page.evaluate(() => window.said)).filter((text) => text.startsWith("Dynamically"));
  await slider(STIFFNESS).fill("0.2");
  await until(verdicts, (said) => said.length === 1 && said[0].startsWith("Dynamically unstable"), "it grows");
  await slider(STIFFNESS).fill("0.25");
  await until(state, ({ parameters }) => parameters.cm_alpha === 0.25, "set");
  await slider(STIFFNESS).fill("-0.5");
  const said = await until(verdicts, (said) => said.some((text) => text.startsWith("Dynamically stable")), "it decays");
  assert.equal(said.length, 2, `still unstable, which had been said: ${said.join(" / ")}`);
});

test("a key that is held and a drag are told by where they have led, not by each step of the way", async (t) => {
  const { page, ready, slider, state } = await open(t);
  await ready();
  await page.evaluate(() => {
    window.said = [];
    const region = document.getElementById("announcements");
    new MutationObserver(() => window.said.push(region.textContent.trim())).observe(region, { childList: true, characterData: true, subtree: true });
  });
  const said = () => page.evaluate(() => window.said);
  const { x, y, width } = await middle(slider(DAMPING));
  const before = (await state()).parameters.cm_q;
  await page.mouse.move(x, y);
  const value = () => slider(DAMPING).getAttribute("aria-valuetext");
  const valueBefore = await value();
  await page.mouse.down();
  await frames(page);
  for (let i = 1; i <= 20; i += 1) {
    await page.mouse.move(x - (i * width) / 80, y);
    await frames(page);
  }
  await until(value, (now) => now !== valueBefore, "the element follows");
  await rest(page);
  assert.deepEqual(await said(), [], "nothing while it is dragged");
  await page.mouse.up();
  await until(state, ({ parameters }) => parameters.cm_q !== before, "dragged");
  await until(said, (all) => all.some((text) => text.includes(DAMPING)), "where the drag has led");
  const dragged = (await said()).length;
  assert.ok(dragged <= 2, JSON.stringify(await said()));
  const began = performance.now();
  for (let i = 0; i < 30; i += 1) await page.keyboard.press("ArrowRight");
  await until(async () => [await said(), await value()], ([all, now]) => all.at(-1).startsWith(now.split(":")[0]), "where the keys have led");
  const steps = (await said()).length - dragged;
  // A value is said every 0.7 s at most, and where the focus has gone at once.
  const most = (performance.now() - began) / 700 + 2;
  assert.ok(steps >= 1 && steps <= most, `${steps} announcements of 30 steps, where at most ${most} have had time`);
});

test("the response is heard when that is asked for: what it is in words, then pitch for value", async (t) => {
  const { page, ready, seen } = await open(t, {
    before: () => {
      window.curves = [];
      const { prototype } = AudioParam;
      const { setValueCurveAtTime } = prototype;
      prototype.setValueCurveAtTime = function (values, ...rest) {
        window.curves.push([...values]);
        return setValueCurveAtTime.call(this, values, ...rest);
      };
      // It sounds until it is silenced, however long that takes.
      AudioScheduledSourceNode.prototype.stop = () => {};
    },
    fragment: "#v=1&ac=navion&lon.source=gust&lon.show=theta.u",
  });
  await ready();
  assert.deepEqual(await page.evaluate(() => window.curves), []);
  const hear = page.getByRole("button", { name: "Hear the response, or fall silent" });
  await hear.dispatchEvent("click");
  const said = () => page.locator("#announcements").textContent();
  await until(said, (text) => /pitch.* over \d+ seconds, in 5: the higher the tone/i.test(text), "what is heard");
  const [pitches] = await page.evaluate(() => window.curves);
  assert.ok(pitches.length > 100 && Math.min(...pitches) >= 219 && Math.max(...pitches) <= 881);
  assert.ok(pitches.some((pitch) => Math.abs(Math.log2(pitch / 440)) > 0.999), "an octave");
  await hear.dispatchEvent("click");
  await until(said, (text) => text === "Silent.", "silent");
  await page.evaluate(() => (location.hash = "#v=1&ac=navion&hide=curves"));
  await hear.dispatchEvent("click");
  await until(said, (text) => text.startsWith("The curves are hidden"), "what is hidden is not told");
  assert.equal((await page.evaluate(() => window.curves)).length, 1);
  assert.deepEqual(seen.errors, []);
});

test("no element of the mirror stands between a finger and the canvas", async (t) => {
  for (const options of [{}, { viewport: { width: 390, height: 844 }, touch: true }]) {
    const { page, ready, slider } = await open(t, options);
    await ready();
    await rest(page);
    const swallowed = () =>
      page.evaluate(() => {
        const elements = [...document.querySelectorAll("#mirror [data-id]")];
        const places = elements.map((element) => element.getBoundingClientRect()).filter(({ width, height }) => width > 0 && height > 0);
        const hits = places.map(({ x, y, width, height }) => document.elementFromPoint(x + width / 2, y + height / 2));
        return [places.length, hits.filter((hit) => hit && hit.id !== "eigenwing").map((hit) => hit.outerHTML.slice(0, 100))];
      });
    const [, at] = await until(swallowed, ([count]) => count > 50, "all elements");
    assert.deepEqual(at, []);
    // Nor one that has the browser's focus.
    await slider(/centre of gravity|C_mq/).first().focus();
    await rest(page);
    assert.deepEqual((await swallowed())[1], []);
  }
});

test("enlarged four times, everything is reached by scrolling one way only", async (t) => {
  // 1280 × 1024 pixels at 400 %.
  const { page, ready, state } = await open(t, { viewport: { width: 320, height: 256 }, fragment: "#v=1&ac=navion" });
  const isOn = (tab) => page.getByRole("button", { name: tab, exact: true }).first().evaluate((button) => button.ariaPressed === "true");
  await ready();
  await rest(page);
  for (const tab of ["Derivatives", "Poles", "Modes", "Response", "Aircraft"]) {
    await press(page, tab);
    await until(() => isOn(tab), Boolean, tab);
    await rest(page);
    const beyond = await page.evaluate(() =>
      [...document.querySelectorAll("#mirror [data-id]:not([data-holds])")]
        .filter((element) => ["BUTTON", "INPUT", "P", "H1", "H2", "H3"].includes(element.tagName))
        .filter((element) => element.getBoundingClientRect().right > 321)
        .map((element) => element.outerHTML.slice(0, 120)),
    );
    assert.deepEqual(beyond, [], tab);
  }
  await press(page, "Derivatives");
  await page.getByRole("slider", { name: DAMPING, exact: true }).fill("-20");
  await until(state, ({ parameters }) => parameters.cm_q === -20, "a slider is at hand");
  assert.ok(await page.evaluate(() => document.scrollingElement.scrollWidth <= innerWidth));
});

test("type twice as large in the browser is twice as large on the page", async (t) => {
  const height = async (flags) => {
    const { page, ready } = await open(t, { flags });
    await ready();
    const title = page.getByRole("heading", { name: "Pole map", exact: true });
    return (await until(() => title.boundingBox(), (box) => box.height > 0, "drawn")).height;
  };
  const [usual, large] = [await height([]), await height(["--blink-settings=defaultFontSize=32"])];
  assert.ok(large > 1.8 * usual, `${usual} and ${large}`);
});

test("few colours or strong contrasts are drawn in the look of a projector, and nothing moves where motion is unwanted", async (t) => {
  const { page, ready, rest } = await open(t, { media: { forcedColors: "active", reducedMotion: "reduce" } });
  await ready();
  await rest();
  // The button is named by the look that comes next.
  await page.getByRole("button", { name: /^Light theme/ }).first().waitFor({ state: "attached" });
  assert.deepEqual(await findings(page), []);
});
