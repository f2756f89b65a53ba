// A lecture as a room sees it, and as the person in front of it does: stepped by a clicker, followed by the notes in a second window, made
// of links; and letters that the last row can read.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open, until } from "./page.mjs";

const SCREENS = [
  { width: 1920, height: 1080 },
  { width: 1024, height: 768 },
];
const LECTURES = ["lecture-modes", "lecture-matrix"];
// Least height of a capital letter over the height of the screen.
const LEAST = 0.0175;

const LECTURE = `+++
title = "Week 3"
lecture = true
+++
## First of all
\`\`\`scene
link = "#v=1&ac=navion&stage=aircraft"
\`\`\`
\`\`\`predict
kind = "choose"
ask = "Up or down?"
[[choice]]
says = "Up"
because = "No."
[[choice]]
says = "Down"
right = true
\`\`\`
\`\`\`notes 2 min
Wait *before* you go on: &lt;b&gt;.
\`\`\`
## And then
\`\`\`predict
kind = "choose"
ask = "What now?"
[[choice]]
says = "Left"
because = "No."
[[choice]]
says = "Right"
right = true
\`\`\`
`;

const files = { "class/week-3.md": LECTURE, "class/glossary.toml": "", "class/references.toml": "" };
const PRESENTED = "#v=1&ac=navion&stage=aircraft&lesson=class/week-3.md&present=on";

function assertClean(seen) {
  assert.deepEqual({ console: seen.console, errors: seen.errors }, { console: [], errors: [] });
}

const told = (page, text) => page.locator("#mirror").getByText(text);
const counts = (locator, count, what) => until(() => locator.count(), (now) => now === count, what);

// The heading of the slide on screen.
const heading = (page, text, what) => until(() => page.getByRole("heading", { name: text }).count(), (now) => now > 0, what);

test("a lecture is stepped by Page Down alone: asked, answered, black, on, and back", async (t) => {
  const { page, ready, seen } = await open(t, { viewport: SCREENS[0], fragment: PRESENTED, server: { files } });
  await ready();
  await heading(page, /First of all/, "the first slide");
  await page.keyboard.press("PageDown");
  await page.keyboard.press("PageDown");
  await heading(page, /And then/, "the second slide, once the first was answered");
  await page.keyboard.press("b");
  await until(() => page.getByRole("heading", { name: /And then/ }).count(), (now) => now === 0, "black");
  await page.keyboard.press("PageDown");
  await heading(page, /And then/, "any key brings it back, and does nothing else");
  await page.keyboard.press("PageUp");
  await heading(page, /First of all/, "back");
  await page.keyboard.press("Escape");
  await counts(page.getByRole("button", { name: "Lessons: begin with a question", exact: true }), 1, "the workbench");
  assertClean(seen);
});

test("the notes follow in a window of their own, and turn the slides", async (t) => {
  const { page, ready, seen } = await open(t, { viewport: SCREENS[1], fragment: PRESENTED, server: { files } });
  await ready();
  await heading(page, /First of all/, "the first slide");
  const opened = page.waitForEvent("popup");
  await page.keyboard.press("n");
  const notes = await opened;
  const text = (id) => notes.locator(`#${id}`).textContent();
  await until(() => text("title"), (now) => now === "First of all", "the title");
  assert.equal(await text("place"), "Slide 1 of 2");
  assert.match(await text("notes"), /Wait before you go on: <b>\./, "text, never HTML");
  assert.equal(await text("next-question"), "What now?");
  assert.match(await text("plan"), /slide 2 min/);
  await counts(told(page, /Wait before/), 0, "the room sees no notes");
  await page.keyboard.press("2");
  await page.keyboard.press("2");
  await until(() => text("hands"), (now) => now.includes("Down ✓: 2"), "hands that were counted");
  await notes.getByRole("button", { name: "Next" }).click();
  await until(() => text("question"), (now) => now.endsWith("(answered)"), "revealed from the notes");
  await notes.keyboard.press("PageDown");
  await until(() => text("title"), (now) => now === "And then", "turned from the notes");
  await heading(page, /And then/, "on the page as well");
  await notes.reload();
  await until(() => text("title"), (now) => now === "And then", "loaded again, it asks how the lecture stands");
  await page.bringToFront();
  await page.keyboard.press("Escape");
  await until(() => notes.locator("#lecture").isHidden(), (hidden) => hidden, "the lecture is over");
  assertClean(seen);
});

test("a reload in the middle of a lecture loses no hand, no answer and no minute", async (t) => {
  const { page, ready, seen } = await open(t, { viewport: SCREENS[1], fragment: PRESENTED, server: { files } });
  await ready();
  await heading(page, /First of all/, "the first slide");
  for (const key of ["2", "2", "1", "PageDown"]) await page.keyboard.press(key);
  await counts(told(page, /right; 2 hands/), 1, "counted and answered");
  const began = () => page.evaluate(() => sessionStorage.getItem("eigenwing.lecture-began"));
  const first = await until(began, Boolean, "when it began is kept");
  await page.reload();
  await counts(told(page, /right; 2 hands/), 1, "as before");
  await page.keyboard.press("PageDown");
  await heading(page, /And then/, "an answer isn't given twice");
  await page.keyboard.press("PageUp");
  await counts(told(page, /right; 2 hands/), 1, "still there");
  assert.ok(Math.abs((await began()) - first) < 1000, "by its own clock it has gone on");
  // A lecture that is begun anew begins anew.
  await page.keyboard.press("Escape");
  await until(() => page.evaluate(() => location.hash), (hash) => !hash.includes("present=on"), "the workbench");
  await page.reload();
  await page.getByRole("button", { name: "Present this lesson" }).dispatchEvent("click");
  await until(() => page.evaluate(() => location.hash), (hash) => hash.includes("present=on"), "presented again");
  await heading(page, /First of all/, "the first slide again");
  for (const key of ["2", "PageDown"]) await page.keyboard.press(key);
  await counts(told(page, /right; 1 hand\b/), 1, "no hands but the new one");
  assertClean(seen);
});

test("a clock that is set an hour back or forth in the middle of a lecture changes nothing", async (t) => {
  const { page, ready, seen } = await open(t, { viewport: SCREENS[1], fragment: PRESENTED, server: { files } });
  await ready();
  await heading(page, /First of all/, "the first slide");
  const opened = page.waitForEvent("popup");
  await page.keyboard.press("n");
  const notes = await opened;
  await until(() => notes.locator("#title").textContent(), (now) => now === "First of all", "the notes");
  const set = (tab, hours) =>
    tab.evaluate((hours) => {
      window.clock ??= Date.now;
      Date.now = () => window.clock.call(Date) + hours * 3_600_000;
    }, hours);
  const since = () => notes.locator("#since").textContent();
  const counted = () => page.evaluate(() => sessionStorage.getItem("eigenwing.lecture"));
  const stored = () => page.evaluate(() => Date.now() - Number(sessionStorage.getItem("eigenwing.lecture-began")));
  let hands = 0;
  for (const hours of [1, -1]) {
    await set(page, hours);
    await set(notes, hours);
    await page.keyboard.press("2");
    hands += 1;
    await until(counted, (kept) => kept?.endsWith(`0:0,${hands}`), "a hand is counted and kept");
    await until(() => notes.locator("#hands").textContent(), (now) => now.includes(`Down ✓: ${hands}`), "and shown");
    const shown = await since();
    const later = await until(since, (now) => now !== shown, "the clock of the notes goes on");
    assert.ok(Number(later.split(":")[0]) < 5, "the minutes of the notes");
    assert.ok((await stored()) >= 0 && (await stored()) < 300_000, "what a reload will go on with");
  }
  // Loaded again with a clock that was set back, the lecture begins now, and goes on.
  await page.addInitScript(() => {
    const now = Date.now;
    Date.now = () => now() - 7_200_000;
  });
  await page.reload();
  await counts(told(page, /2 hands/), 1, "the hands are still there");
  await page.keyboard.press("PageDown");
  await counts(told(page, /right; 2 hands/), 1, "and it goes on");
  assertClean(seen);
});

test("a lecture that a link has begun takes the whole screen with the first key", async (t) => {
  const { page, ready, seen } = await open(t, { viewport: SCREENS[0], fragment: PRESENTED, server: { files } });
  await ready();
  await heading(page, /First of all/, "the first slide");
  // Asked by a test, the page counts as touched, so nothing can be said of before the key.
  const isFull = () => page.evaluate(() => document.fullscreenElement !== null);
  await page.keyboard.press("c");
  await until(isFull, Boolean, "full");
  assertClean(seen);
});

test("a lecture that a link has begun, and that the first key ends, asks for no full screen", async (t) => {
  const { page, ready, seen } = await open(t, {
    fragment: "#v=1&ac=navion&present=on",
    before: () => {
      window.asked = 0;
      let isTouched = false;
      addEventListener("keydown", () => (isTouched = true), { capture: true });
      Object.defineProperty(Navigator.prototype, "userActivation", { get: () => ({ isActive: isTouched }) });
      Element.prototype.requestFullscreen = async () => (window.asked += 1);
    },
  });
  await ready();
  const isOn = () => page.evaluate(() => location.hash.includes("present=on"));
  assert.ok(await isOn());
  await page.keyboard.press("f");
  await until(isOn, (on) => !on, "the lecture is over");
  assert.equal(await page.evaluate(() => window.asked), 0);
  assertClean(seen);
});

test("links that are pasted become a lecture, which is saved and opened again", async (t) => {
  const { page, ready, seen } = await open(t, { fragment: "#v=1&ac=navion" });
  await ready();
  const button = (name) => page.getByRole("button", { name, exact: true });
  await button("Lessons: begin with a question").dispatchEvent("click");
  await button("A lecture from links …").dispatchEvent("click");
  await page.getByRole("textbox", { name: "Links, one a line" }).fill("The phugoid: #v=1&ac=navion&lon.source=mode&lon.mode=2\n#v=1&ac=x15\n");
  await button("Add these links").dispatchEvent("click");
  await counts(button("Move up slide 2"), 1, "two slides");
  const saved = page.waitForEvent("download");
  await button("Save as a lesson file").dispatchEvent("click");
  const download = await saved;
  assert.equal(download.suggestedFilename(), "lecture.md");
  const stream = await download.createReadStream();
  const text = (await stream.toArray()).map(String).join("");
  assert.match(text, /lecture = true[^]*## The phugoid[^]*ac=x15/);
  await button("Present").dispatchEvent("click");
  await heading(page, /The phugoid/, "presented");
  const address = (is, what) => until(() => page.evaluate(() => location.hash), is, what);
  await address((hash) => hash.includes("lesson=lecture.md") && hash.includes("present=on"), "in the address");
  // Whoever reloads in the middle of a lecture goes on with it.
  await page.reload();
  await heading(page, /The phugoid/, "presented again");
  await page.keyboard.press("Escape");
  await address((hash) => hash.includes("lesson=lecture.md") && !hash.includes("present=on"), "the lecture is left");
  await page.reload();
  await counts(page.getByRole("button", { name: /^Step 1 of 2$/ }), 1, "kept on this device");
  assertClean(seen);
});

// Heights of the letters of each line of text, measured in the picture: for every element with words the runs of columns that have ink
// are its letters. In the page, since a picture has to be decoded.
async function letters(page, picture) {
  const data = picture.toString("base64");
  const boxes = await page.evaluate(() =>
    [...document.querySelectorAll("#mirror [data-id]:not([data-holds])")]
      .map((element) => ({ text: element.textContent.trim(), box: element.getBoundingClientRect().toJSON() }))
      .filter(({ text, box }) => /[A-Za-z0-9]{2}/.test(text) && box.width > 8 && box.height > 8),
  );
  const decoder = await page.context().newPage();
  try {
    return await decoder.evaluate(
      async ([data, boxes]) => {
        const bytes = Uint8Array.from(atob(data), (c) => c.charCodeAt(0));
        const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
        const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
        context.drawImage(bitmap, 0, 0);
        const measured = [];
        for (const { text, box } of boxes) {
          const x = Math.max(0, Math.floor(box.x));
          const y = Math.max(0, Math.floor(box.y));
          const width = Math.min(bitmap.width - x, Math.ceil(box.width));
          const height = Math.min(bitmap.height - y, Math.ceil(box.height));
          if (width < 8 || height < 8) continue;
          const { data: pixels } = context.getImageData(x, y, width, height);
          const at = (i) => pixels[4 * i] * 0.3 + pixels[4 * i + 1] * 0.6 + pixels[4 * i + 2] * 0.1;
          const ground = at(0);
          const inked = (column, row) => Math.abs(at(row * width + column) - ground) > 60;
          // Lines first, then letters in each.
          const rows = [...Array(height).keys()].filter((row) => [...Array(width).keys()].some((column) => inked(column, row)));
          const lines = rows.filter((row, i) => i === 0 || row !== rows[i - 1] + 1).map((first) => {
            let last = first;
            while (rows.includes(last + 1)) last += 1;
            return [first, last];
          });
          const heights = [];
          for (const [first, last] of lines) {
            let top = Infinity;
            let bottom = -1;
            for (let column = 0; column <= width; column += 1) {
              const own = column < width ? rows.filter((row) => row >= first && row <= last && inked(column, row)) : [];
              if (own.length > 0) {
                top = Math.min(top, own[0]);
                bottom = Math.max(bottom, own.at(-1));
              } else if (bottom >= 0) {
                heights.push(bottom - top + 1);
                top = Infinity;
                bottom = -1;
              }
            }
          }
          heights.sort((a, b) => a - b);
          // Of capitals and figures: the tallest quarter begins there.
          if (heights.length >= 3) measured.push({ text, height: heights[Math.floor(heights.length * 0.75)] });
        }
        return measured;
      },
      [data, boxes],
    );
  } finally {
    await decoder.close();
  }
}

for (const viewport of SCREENS) {
  for (const lecture of LECTURES) {
    test(`every slide of ${lecture} is read from the last row at ${viewport.width} × ${viewport.height}`, async (t) => {
      const { page, ready, rest, seen } = await open(t, { viewport, fragment: `#v=1&lesson=${lecture}&present=on` });
      await ready();
      const place = () => page.evaluate(() => Number(/&step=(\d+)/.exec(location.hash)?.[1]));
      await until(place, (step) => step === 1, "the first slide");
      const small = [];
      let measured = 0;
      await rest();
      for (let slide = 1; ; slide += 1) {
        const found = await letters(page, await page.screenshot());
        measured += found.length;
        small.push(...found.filter(({ height }) => height < LEAST * viewport.height - 1).map((line) => ({ slide, ...line })));
        // Through its answers to the next slide; the last one stays.
        let now = slide;
        for (let presses = 0; presses < 4 && now === slide; presses += 1) {
          await page.keyboard.press("PageDown");
          await rest();
          now = await place();
        }
        if (now === slide) break;
      }
      assert.ok(measured > 20, `${measured} lines of text`);
      assert.deepEqual(small, []);
      assertClean(seen);
    });
  }
}
