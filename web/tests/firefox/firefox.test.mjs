// The page in Firefox: that it starts without a complaint, and what a person does first, by keyboard, mouse and finger.

import assert from "node:assert/strict";
import { test } from "node:test";
import { pass, until } from "../page.mjs";
import { open } from "./page.mjs";

const PITCH_STIFFNESS = "pitch stiffness C_mα";

// The middle of an element once it stays where it is, and its width.
async function middle(page, element) {
  const looks = async () => {
    const before = await element.boundingBox();
    await pass(page, 200);
    return [before, await element.boundingBox()];
  };
  const [{ x, y, width, height }] = await until(looks, ([a, b]) => Math.hypot(a.x - b.x, a.y - b.y, a.width - b.width) < 0.5, "it stays where it is");
  return { x: x + width / 2, y: y + height / 2, width };
}

test("the page starts, and a slider follows keyboard and mouse into the address", async (t) => {
  const { page, url, state, role, act, complaints, screenshot } = await open(t);
  const before = await state();
  assert.equal(before.aircraft, "navion");
  await screenshot("firefox");

  const slider = await role("slider", PITCH_STIFFNESS);
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  const stepped = await until(state, (now) => now.parameters.cm_alpha > before.parameters.cm_alpha, "a step by keyboard");

  const { x, y, width } = await middle(page, slider);
  await act("mousemove", () => page.mouse.move(x, y));
  await act("mousedown", () => page.mouse.down());
  for (let i = 1; i <= 5; i += 1) await act("mousemove", () => page.mouse.move(x + (i * width) / 20, y));
  await act("mouseup", () => page.mouse.up());
  const drawn = await state();
  assert.ok(drawn.parameters.cm_alpha > stepped.parameters.cm_alpha, "drawn along by mouse");
  await until(() => page.evaluate(() => location.hash), (hash) => hash.includes(`cm_alpha=${drawn.parameters.cm_alpha}`), "in the address");
  assert.ok(page.url().startsWith(url));
  await page.reload();
  await until(state, (now) => now.parameters.cm_alpha === drawn.parameters.cm_alpha, "the same after a reload");
  assert.deepEqual(complaints, []);
});

test("a link opens its scene, a lesson is read, and a table that is dropped is an aircraft", async (t) => {
  const { page, state, role, complaints, screenshot } = await open(t, { fragment: "#v=1&ac=b747-cruise-etkin&cm_alpha=-0.5" });
  const { aircraft, parameters } = await state();
  assert.deepEqual([aircraft, parameters.cm_alpha], ["b747-cruise-etkin", -0.5]);

  const lessons = await page.waitForSelector('#mirror ::-p-xpath(//button[starts-with(normalize-space(), "Lessons") or starts-with(@aria-label, "Lessons")])');
  await lessons.evaluate((button) => button.click());
  const mirror = () => page.$eval("#mirror", (mirror) => mirror.textContent);
  await until(mirror, (text) => text.includes("Longitudinal modes"), "the course");
  await screenshot("firefox-lessons");
  await page.keyboard.press("Escape");

  // Lateral, with a header of states: what a spreadsheet saves.
  const table = ",v,p,r,phi\nv,-0.254,0,-176,32.2\np,-0.0909,-8.40,2.19,0\nr,0.0255,-0.35,-0.760,0\nphi,0,1,0,0\n";
  await page.$eval(
    "#eigenwing",
    (canvas, text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], "mine.csv"));
      for (const type of ["dragenter", "dragover", "drop"]) {
        canvas.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
      }
    },
    table,
  );
  await role("button", "Use this aircraft");
  assert.deepEqual(complaints, []);
});

test("by finger on a phone: a pane is tapped, and a slider drawn along", async (t) => {
  const { page, state, role, act, complaints, screenshot } = await open(t, { viewport: { width: 390, height: 844, hasTouch: true } });
  const tap = async (element) => {
    const { x, y } = await middle(page, element);
    await page.touchscreen.tap(x, y);
  };
  await tap(await role("button", "Response"));
  await role("combobox", "Disturbance");
  await tap(await role("button", "Derivatives"));
  const slider = await role("slider", "shift of the centre of gravity Δx_cg/c");
  const before = await state();
  const { x, y, width } = await middle(page, slider);
  // Each where it is heard by itself: a press, and what is drawn along, take a frame each.
  await act("touchstart", () => page.touchscreen.touchStart(x, y));
  for (let i = 1; i <= 6; i += 1) await act("touchmove", () => page.touchscreen.touchMove(x - (i * width) / 24, y + i));
  const drawn = await state();
  assert.ok(drawn.parameters.cg < before.parameters.cg, "drawn along");
  await act("touchend", () => page.touchscreen.touchEnd());
  await pass(page, 500);
  assert.equal((await state()).parameters.cg, drawn.parameters.cg, "it stays where the finger left it");
  await screenshot("firefox-phone");
  assert.deepEqual(complaints, []);
});

test("after one visit the page opens without a network", async (t) => {
  const { page, ready, server, complaints } = await open(t);
  await until(() => page.evaluate(() => Boolean(navigator.serviceWorker.controller)), Boolean, "a worker");
  server.isDown = true;
  await page.reload();
  await ready();
  assert.match(await page.evaluate(() => window.eigenwing.state()), /navion/);
  assert.deepEqual(complaints, []);
});
