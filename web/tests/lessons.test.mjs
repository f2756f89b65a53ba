// Lessons as a student meets them: greeted, asked, told; by mouse, by finger, from a file of their own, and after a reload.

import assert from "node:assert/strict";
import { test } from "node:test";
import { click, drop, middle, open, place, tap, until } from "./page.mjs";

const CHAPTER = "Longitudinal modes";

// What a person does with buttons: by mouse or by finger, after scrolling to where they are.
function hands(page, { touch = false } = {}) {
  const button = (name) => page.getByRole("button", { name, exact: true });
  const reach = async (locator) => {
    const { height } = page.viewportSize();
    let { x, y } = await middle(locator);
    for (let i = 0; (y > height - 12 || y < 60) && i < 60; i += 1) {
      // The pane with the lesson scrolls under the pointer.
      await page.mouse.move(x, height - 60);
      await page.mouse.wheel(0, Math.max(-240, Math.min(240, y - height / 2)));
      const before = y;
      await until(() => place(locator), (now) => Math.abs(now.y - before) > 1, "it scrolls");
      ({ x, y } = await middle(locator));
    }
    return { x, y };
  };
  const press = async (locator) => {
    await (touch ? tap : click)(page, await reach(locator));
  };
  return { button, press, counts: (locator, count, what) => until(() => locator.count(), (now) => now === count, what) };
}

function assertClean(seen) {
  assert.deepEqual({ console: seen.console, errors: seen.errors }, { console: [], errors: [] });
}

// Text on the page, wherever it stands.
const told = (page, text) => page.locator("#mirror").getByText(text);

// Goes through the lesson that is open, and knows nothing; every question is answered before the next step. Gives the number of steps.
async function goThrough(page, { button, press }) {
  const place = async () => Number(/Step (\d+) of/.exec(await page.getByRole("button", { name: /^Step \d+ of \d+$/ }).textContent())?.[1]);
  for (let step = await place(); ; step += 1) {
    const open = page.getByRole("button", { name: "I don’t know", exact: true });
    for (let left = await open.count(); left > 0; left -= 1) {
      await press(open.first());
      await until(() => open.count(), (now) => now === left - 1, `step ${step}: answered`);
    }
    assert.equal(await button("Skip →").count(), 0, `step ${step}: nothing is left to be answered`);
    if ((await button("To the lessons").count()) === 1) return step;
    await press(button("Next →"));
    await until(place, (now) => now === step + 1, `step ${step + 1}`);
  }
}

test("a first visit is greeted, and a chapter is done by mouse; a reload in the middle loses nothing", async (t) => {
  const { page, ready, seen } = await open(t, { firstVisit: true });
  const hand = hands(page);
  const { button, press, counts } = hand;
  await ready();
  assert.ok(!seen.requests.some((request) => request.includes("lessons/")), "no lesson is loaded before it is wanted");
  await press(button("The course"));
  await press(button(CHAPTER));
  await counts(page.getByRole("button", { name: /^Step 1 of/ }), 1, "the first step");
  await press(button("It swings for minutes."));
  await press(button("Answer"));
  await counts(told(page, "Not so."), 1, "told");
  await press(button("Next →"));
  await until(() => page.evaluate(() => location.hash), (hash) => hash.endsWith("lesson=longitudinal&step=2"), "in the address");
  await page.reload();
  await counts(page.getByRole("button", { name: /^Step 2 of/ }), 1, "the step again");
  await counts(button("The course"), 0, "greeted once only");
  await press(button("← Back"));
  await counts(told(page, "Not so."), 1, "the answer is still there");
  const steps = await goThrough(page, hand);
  assert.ok(steps >= 6, `${steps} steps`);
  await press(button("To the lessons"));
  await counts(button("Save my report"), 1, "the sheet");
  const saved = page.waitForEvent("download");
  await press(button("Save my report"));
  assert.equal((await saved).suggestedFilename(), "eigenwing-report.html");
  assertClean(seen);
});

test("a chapter is done by finger on a phone", async (t) => {
  const { page, ready, seen } = await open(t, {
    viewport: { width: 390, height: 844 },
    touch: true,
    fragment: "#v=1&lesson=longitudinal",
  });
  const hand = hands(page, { touch: true });
  await ready();
  await hand.counts(page.getByRole("button", { name: /^Step 1 of/ }), 1, "the first step");
  assert.ok((await goThrough(page, hand)) >= 6);
  assertClean(seen);
});

const OWN = `+++
title = "Week 3"
+++
## One question
\`\`\`scene
link = "#v=1&ac=x15&hide=names.numbers"
\`\`\`
A [word](glossary:phugoid).
\`\`\`predict
kind = "choose"
ask = "Is it fast?"
[[choice]]
says = "Yes"
right = true
[[choice]]
says = "No"
because = "It is."
\`\`\`
`;

test("a lesson is opened by drop and by a link to a file beside the page; a faulty one says where", async (t) => {
  const { page, ready, seen } = await open(t, {
    fragment: "#v=1&lesson=class/week-3.md",
    server: { files: { "class/week-3.md": OWN, "class/glossary.toml": "", "class/references.toml": "" } },
  });
  const { button, press, counts } = hands(page);
  await ready();
  await counts(told(page, "Is it fast?"), 1, "from beside the page");
  await press(button("Close the lesson"));
  await drop(page, "bad.md", OWN.replace('says = "No"', 'sais = "No"'));
  await counts(told(page, /bad\.md, line 15/), 1, "where the fault is");
  await drop(page, "good.md", OWN);
  await counts(told(page, "Is it fast?"), 1, "a file of one's own");
  await until(() => page.evaluate(() => location.hash), (hash) => hash.endsWith("lesson=good.md&step=1"), "in the address");
  await page.reload();
  await counts(told(page, "Is it fast?"), 1, "kept on this device");
  // What is hidden is nowhere, until the question has its answer.
  const everything = () => page.evaluate(() => document.getElementById("mirror").innerHTML);
  assert.doesNotMatch(await everything(), /short period|Dutch roll/i);
  await press(button("Yes"));
  await press(button("Answer"));
  await until(everything, (now) => /short period/i.test(now), "shown once it is answered");
  assertClean(seen);
});

test("a lesson that isn't there is told where it would stand", async (t) => {
  const { page, ready } = await open(t, { fragment: "#v=1&ac=navion&lesson=class/week-4.md" });
  const { counts } = hands(page);
  await ready();
  await counts(told(page, /There is no file “class\/week-4\.md” beside this page/), 1, "why");
});
