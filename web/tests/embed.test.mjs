// The page in a frame of another page: keyboard, wheel and colours of its host, messages both ways, and locks that hold.

import assert from "node:assert/strict";
import { test } from "node:test";
import { click, frames, open, pass, rest, tap, until } from "./page.mjs";

const LOCKED = "../#v=1&ac=navion&stage=derivatives.poles&lock=aircraft.plane.disturbance.view.all";

// The sentence of a page that stays with what was opened on it.
const KEPT = "In this frame no other lesson can be opened";

// The example page of a course.
async function hosted(t, options = {}) {
  const opened = await open(t, { path: "example/embed.html", ...options });
  const { page } = opened;
  const frame = page.frameLocator("#frame");
  await frame.locator("#welcome").waitFor({ state: "hidden" });
  const messages = async () => {
    const lines = await page.locator("#log li").allTextContents();
    return lines.map((line) => JSON.parse(line));
  };
  const told = (type, fits = () => true) => {
    const found = async () => (await messages()).filter((message) => message.type === type).findLast(fits);
    return until(found, Boolean, `a message ${type}`);
  };
  const post = (message) => page.evaluate((message) => document.getElementById("frame").contentWindow.postMessage(message, "*"), message);
  const inside = () => page.frames()[1];
  const state = async () => JSON.parse(await inside().evaluate(() => window.eigenwing.state()));
  return { ...opened, frame, messages, told, post, state, inside };
}

// Whether a frame has heard an event since, once the program has had it.
async function heardInside(inside, type) {
  await inside.evaluate((type) => {
    window.heard = false;
    addEventListener(type, () => (window.heard = true), { once: true, capture: true });
  }, type);
  return async () => {
    await frames(inside);
    return inside.evaluate(() => window.heard);
  };
}

test("the host keeps its keyboard while the frame starts, and its wheel until the frame is used", async (t) => {
  const { page, frame, told, inside } = await hosted(t);
  await told("ready");
  await rest(inside());
  assert.equal(await page.evaluate(() => document.activeElement.id), "answer");
  await page.keyboard.type("4");
  assert.equal(await page.locator("#answer").inputValue(), "4");

  const scrolled = () => page.evaluate(() => scrollY);
  const { x, y, width } = await page.locator("#frame").boundingBox();
  const [across, down] = [x + 0.75 * width, y + 150];
  await page.mouse.move(across, down);
  await page.mouse.wheel(0, 60);
  await until(scrolled, (now) => now === 60, "the host scrolls");

  await click(page, { x: across, y: down }, inside());
  const turned = await heardInside(inside(), "wheel");
  await page.mouse.wheel(0, 60);
  await until(turned, Boolean, "the frame hears the wheel");
  await pass(page, 200);
  assert.equal(await scrolled(), 60, "the frame has the wheel");

  await page.mouse.move(20, 20);
  await page.mouse.move(across, down);
  await page.mouse.wheel(0, 40);
  await until(scrolled, (now) => now === 100, "the host scrolls again");
  await frame.locator("#eigenwing").waitFor();
});

test("a scene, a step, an answer, a goal and a report are told", async (t) => {
  const { page, frame, told, post, inside } = await hosted(t);
  const ready = await told("ready");
  assert.equal(ready.eigenwing, 1);
  assert.match(ready.link, /^v=1&ac=navion/);
  await told("height");
  await rest(inside());
  const { height } = await told("height");
  assert.ok(height >= 300 && height <= 1200, String(height));
  assert.equal(await page.locator("#frame").getAttribute("height"), String(height));

  await frame.getByRole("slider", { name: "pitch damping C_mq", exact: true }).fill("-12.5");
  await told("scene", ({ link }) => /cm_q=-12\.5/.test(link));

  await post({ eigenwing: 1, type: "open", link: "#v=1&lesson=longitudinal&step=1" });
  const opened = await told("step-opened");
  assert.deepEqual([opened.lesson, opened.step], ["longitudinal", 1]);
  await frame.getByRole("button", { name: "I don’t know" }).dispatchEvent("click");
  const answered = await told("answered");
  assert.deepEqual([answered.step, answered.answer, answered.right], [1, "dont_know", false]);
  await post({ eigenwing: 1, type: "ask-report" });
  const { records } = await told("report");
  assert.deepEqual(Object.keys(records.lessons), ["longitudinal"]);
});

test("a goal that is reached is told with its scene", async (t) => {
  const lesson = `+++
title = "A goal"
+++

## Softer

\`\`\`scene
link = "#v=1&ac=navion&stage=poles.derivatives"
\`\`\`

\`\`\`task
goal = "Make it softer."
offer = ["cm_alpha"]
solution = "#v=1&ac=navion&cm_alpha=-0.3"
[[until]]
measure = "parameter.cm_alpha"
at_least = "-0.4"
\`\`\`
`;
  const { frame, told, post, inside } = await hosted(t, { server: { files: { "goal.md": lesson } } });
  await told("ready");
  await post({ eigenwing: 1, type: "open", link: "#v=1&lesson=goal.md" });
  await told("step-opened");
  // The slider of the step, not the one that stood there before.
  await frame.getByText("Make it softer.").first().waitFor({ state: "attached" });
  await rest(inside());
  await frame.getByRole("slider", { name: "pitch stiffness C_mα", exact: true }).fill("-0.3");
  const reached = await told("goal-reached");
  assert.deepEqual([reached.lesson, reached.unaided, reached.done], ["goal.md", true, 1]);
  assert.match(reached.link, /cm_alpha=-0\.3/);
});

test("a damaged message is answered by a sentence, one of others or from elsewhere by nothing", async (t) => {
  const { told, post, messages, inside, state, frame } = await hosted(t);
  await told("ready");
  await post({ eigenwing: 1, type: "opne", link: "#v=1&ac=lesson" });
  assert.match((await told("error")).sentence, /open/);
  const before = (await messages()).length;
  await post({ type: "open", link: "#v=1&ac=lesson" });
  await post("hello");
  // From the frame to itself: not from its host.
  await inside().evaluate(() => window.postMessage({ eigenwing: 1, type: "open", link: "#v=1&ac=lesson" }, "*"));
  // What is asked for and done afterwards is told, and nothing else; how high the frame would like to be may come at any time.
  await post({ eigenwing: 1, type: "ask-report" });
  await told("report");
  assert.equal((await state()).aircraft, "navion");
  await frame.getByRole("slider", { name: "pitch damping C_mq", exact: true }).fill("-12.5");
  await told("scene", ({ link }) => /^v=1&ac=navion&cm_q=-12\.5/.test(link));
  const types = (await messages()).slice(before).map(({ type }) => type);
  assert.deepEqual(types.filter((type) => type !== "height"), ["report", "scene"]);
});

test("what is locked stays, whatever keys, elements and files try, and there is no way to other lessons", async (t) => {
  const { page, frame, told, post, state, inside } = await hosted(t);
  await told("ready");
  await page.evaluate((src) => (document.getElementById("frame").src = src), LOCKED.replace("../#", "../?again#"));
  await told("ready", ({ link }) => link.includes("lock=aircraft.plane.disturbance"));
  await rest(inside());
  const before = await state();
  // The scene and how it is looked at.
  const link = () => inside().evaluate(() => location.hash);
  const linked = await link();
  assert.equal(await frame.getByRole("button", { name: /^Lessons/ }).count(), 0);
  await page.locator("#frame").click({ position: { x: 500, y: 20 } });
  for (const key of ["g", "p", "Control+z", "Control+y", "Delete", "End", "PageDown", "m", "Escape"]) {
    await page.keyboard.press(key);
    await page.keyboard.press("Tab");
    await page.keyboard.press("ArrowRight");
  }
  await inside().evaluate(() => {
    for (const element of document.querySelectorAll("#mirror button, #mirror input, #mirror select")) {
      element.value = "1";
      for (const name of ["input", "change", "click"]) element.dispatchEvent(new Event(name, { bubbles: true }));
    }
  });
  await post({ eigenwing: 1, type: "ask-report" });
  await told("report");
  await rest(inside());
  assert.deepEqual(await state(), before);
  assert.equal(await link(), linked);
});

test("a file that is dropped on a frame with a stage is refused with a sentence", async (t) => {
  const { frame, told, inside } = await hosted(t);
  const { link } = await told("ready");
  await inside().evaluate(() => {
    const dropped = new DataTransfer();
    dropped.items.add(new File(["+++\ntitle = \"Mine\"\n+++\n"], "mine.md", { type: "text/markdown" }));
    for (const type of ["dragenter", "dragover", "drop"]) {
      const event = new DragEvent(type, { dataTransfer: dropped, bubbles: true, cancelable: true });
      document.getElementById("eigenwing").dispatchEvent(event);
    }
  });
  await until(() => frame.locator("#announcements").textContent(), (text) => text.startsWith(KEPT), "refused");
  assert.match(await inside().evaluate(() => location.hash), new RegExp(`^#${link.split("&")[0]}&ac=navion`));
  assert.equal(await frame.getByRole("button", { name: "Close the lesson" }).count(), 0);
});

test("a finger that goes up over the frame scrolls its host until it has pressed in there", async (t) => {
  const { page, told, inside } = await hosted(t, { viewport: { width: 800, height: 700 }, touch: true });
  await told("ready");
  const scrolled = () => page.evaluate(() => scrollY);
  const { x, y, width } = await page.locator("#frame").boundingBox();
  const browser = await page.context().newCDPSession(page);
  const touch = (type, ...touchPoints) => browser.send("Input.dispatchTouchEvent", { type, touchPoints });
  const swipe = async () => {
    const [across, down] = [x + 0.75 * width, y + 200];
    await touch("touchStart", { x: across, y: down });
    for (let i = 1; i <= 8; i += 1) {
      await touch("touchMove", { x: across, y: down - 10 * i });
      await pass(page, 20, 1);
    }
    await touch("touchEnd");
  };
  await swipe();
  await until(scrolled, (now) => now > 30, "the host scrolls");
  let once;
  const stays = async () => {
    once = await scrolled();
    await pass(page, 300);
    return (await scrolled()) === once;
  };
  await until(stays, Boolean, "it has scrolled");
  await tap(page, { x: x + 0.75 * width, y: y + 150 - once }, inside());
  const action = () => inside().evaluate(() => document.getElementById("eigenwing").style.touchAction);
  await until(action, (now) => now === "none", "pressed");
  await pass(page, 200);
  const moved = await heardInside(inside(), "touchend");
  await swipe();
  await until(moved, Boolean, "the frame hears the finger");
  await pass(page, 300);
  assert.equal(await scrolled(), once, "the frame has the finger");
});

test("the frame is light or dark as its host says, or as the system has it", async (t) => {
  const { page, told, post, inside } = await hosted(t, { colorScheme: "dark" });
  await told("ready");
  const pixel = async () => {
    const { x, y } = await page.locator("#frame").boundingBox();
    const picture = await page.screenshot({ clip: { x: x + 2, y: y + 30, width: 1, height: 1 } });
    return page.evaluate(async (bytes) => {
      const bitmap = await createImageBitmap(new Blob([new Uint8Array(bytes)], { type: "image/png" }));
      const canvas = new OffscreenCanvas(1, 1);
      canvas.getContext("2d").drawImage(bitmap, 0, 0);
      return Math.max(...canvas.getContext("2d").getImageData(0, 0, 1, 1).data.slice(0, 3));
    }, [...picture]);
  };
  await until(pixel, (value) => value < 80, "dark as the system");
  await post({ eigenwing: 1, type: "look", look: "light" });
  await until(pixel, (value) => value > 200, "light as its host says");
  await post({ eigenwing: 1, type: "look", look: "system" });
  await until(pixel, (value) => value < 80, "dark again");
  assert.equal(await inside().evaluate(() => localStorage.getItem("eigenwing.look")), null, "nobody has chosen it");
});
