// The whole scene in the address bar: following edits, opening elsewhere, after a reload, damaged, and copied.

import assert from "node:assert/strict";
import { test } from "node:test";
import { click, frames, middle, open, pass, rest, until } from "./page.mjs";

const SHARE = /^Share link/;

const fragment = (page) => new URL(page.url()).hash;

const poles = (state) => ["longitudinal", "lateral"].flatMap((plane) =>
  (state.analysis[plane]?.modes ?? []).map(({ name, re, im }) => [name, re, im]),
);

async function addressBecomes(page, expected) {
  await until(async () => fragment(page), (now) => now === expected, expected);
}

test("the address follows an edit, and opened elsewhere it has the same poles to the last bit", async (t) => {
  const first = await open(t);
  await first.ready();
  await rest(first.page);
  assert.equal(fragment(first.page), "", "clean until something differs");
  await first.slider("pitch damping C_mq").fill("-12.5");
  await addressBecomes(first.page, "#v=1&ac=navion&cm_q=-12.5&elevator=-1");
  await first.slider("airspeed V").fill("61");
  await addressBecomes(first.page, "#v=1&ac=navion&cm_q=-12.5&speed=61&elevator=-1&follows=100");
  await first.page.getByRole("button", { name: "Lateral–directional" }).dispatchEvent("click");
  await addressBecomes(first.page, "#v=1&ac=navion&cm_q=-12.5&speed=61&plane=lateral&elevator=-1");

  const second = await open(t, { fragment: fragment(first.page) });
  await second.ready();
  const [one, other] = [await first.state(), await second.state()];
  assert.equal(other.plane, "lateral");
  assert.deepEqual(other.parameters, one.parameters);
  assert.deepEqual(poles(other), poles(one));
  assert.deepEqual([...first.seen.errors, ...second.seen.errors, ...first.seen.console, ...second.seen.console], []);
});

test("the address waits until a drag has ended", async (t) => {
  const { page, ready, state, slider } = await open(t);
  await ready();
  const { x, y, width } = await middle(slider("pitch stiffness C_mα"));
  await page.mouse.move(x, y);
  await page.mouse.down();
  await frames(page);
  let before = (await state()).parameters.cm_alpha;
  for (let i = 1; i <= 8; i += 1) {
    await page.mouse.move(x - i * (width / 60), y);
    const drawn = await until(state, ({ parameters }) => parameters.cm_alpha < before, "drawn along");
    before = drawn.parameters.cm_alpha;
    assert.equal(await page.evaluate(() => location.hash), "");
  }
  await rest(page);
  assert.equal(await page.evaluate(() => location.hash), "", "nor while it rests there");
  await page.mouse.up();
  await frames(page);
  const { cm_alpha } = (await state()).parameters;
  await addressBecomes(page, `#v=1&ac=navion&cm_alpha=${cm_alpha}&elevator=-1`);
});

test("a reload keeps the scene, and so does a visit without a link", async (t) => {
  const { page, ready, state, slider, url, seen } = await open(t, { fragment: "#v=1&ac=b747-approach&plane=lat" });
  await ready();
  await slider("weathercock stability C_nβ").fill("0.2");
  await until(state, (now) => now.parameters.cn_beta === 0.2, "set");
  await addressBecomes(page, "#v=1&ac=b747-approach&cn_beta=0.2&plane=lateral");
  const before = await state();
  const same = (now) => JSON.stringify([now.parameters, poles(now)]) === JSON.stringify([before.parameters, poles(before)]);
  await page.reload();
  await until(state, same, "the same scene after a reload");
  await page.goto("about:blank");
  await page.goto(url.split("#")[0]);
  await until(state, same, "the last scene without a link");
  await addressBecomes(page, "#v=1&ac=b747-approach&cn_beta=0.2&plane=lateral");
  assert.deepEqual([...seen.errors, ...seen.console], []);
});

test("a link typed into the address bar opens at once, the one before it again, and undo goes back", async (t) => {
  const { page, ready, state, seen } = await open(t, { fragment: "#v=1&ac=navion&speed=60" });
  await ready();
  assert.equal((await state()).parameters.speed, 60);
  await page.evaluate(() => (location.hash = "#v=1&ac=lesson"));
  await until(state, (now) => now.aircraft === "lesson", "the lesson");
  await page.evaluate(() => (location.hash = "#v=1&ac=navion&speed=60"));
  await until(state, (now) => now.parameters.speed === 60, "the first again");
  await page.keyboard.press("Control+z");
  await until(state, (now) => now.aircraft === "lesson", "undone");
  await addressBecomes(page, "#v=1&ac=lesson");
  assert.deepEqual([...seen.errors, ...seen.console], []);
});

test("a damaged link opens what it can and says what it left out, in the page and to a screen reader", async (t) => {
  const damaged = "#v=2&ac=navion&speed=60&cm_q=st%zzep&wings=2";
  const { page, ready, state, slider, seen } = await open(t, { fragment: damaged });
  await ready();
  assert.equal((await state()).parameters.speed, 60);
  for (const sentence of [/made by a newer version/, /“wings” means nothing/, /\(cm_q\) was left out/]) {
    await page.locator("#mirror").getByText(sentence).first().waitFor({ state: "attached" });
  }
  assert.match(await page.locator("#announcements").textContent(), /newer version/);
  await rest(page);
  assert.equal(await page.evaluate(() => location.hash), damaged, "as the sender wrote it until the first edit");
  await page.getByRole("button", { name: "Dismiss" }).dispatchEvent("click");
  await page.locator("#mirror").getByText(/made by a newer version/).waitFor({ state: "detached" });
  await slider("pitch damping C_mq").fill("-12.5");
  await addressBecomes(page, "#v=1&ac=navion&cm_q=-12.5&speed=60&follows=100");
  assert.deepEqual([...seen.errors, ...seen.console], []);
});

test("button and key copy the whole address and say so; typing the letter into a field doesn’t", async (t) => {
  const { page, ready, url, seen } = await open(t, { fragment: "#v=1&ac=navion&cn_beta=0.09" });
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  await ready();
  const clipboard = () => page.evaluate(() => navigator.clipboard.readText());
  const clear = () => page.evaluate(() => navigator.clipboard.writeText("nothing"));
  const announced = () => page.locator("#announcements").textContent();
  await clear();
  await page.getByRole("button", { name: SHARE }).dispatchEvent("click");
  await until(clipboard, (text) => text === url, url);
  await until(announced, (text) => text.startsWith("Link copied"), "announced");
  await clear();
  await page.locator("#eigenwing").focus();
  await page.keyboard.press("l");
  await until(clipboard, (text) => text === url, `${url} by key`);
  await clear();
  const field = page.getByRole("textbox", { name: "pitch damping C_mq, typed" });
  await click(page, await middle(field));
  await page.keyboard.type("l");
  await until(() => field.inputValue(), (typed) => typed.includes("l"), "the letter stands in the field");
  // A field that is typed in never rests.
  await pass(page, 500);
  assert.equal(await clipboard(), "nothing");
  assert.deepEqual([...seen.errors, ...seen.console], []);
});

test("without storage the page and its address work the same", async (t) => {
  const { page, ready, state, slider, seen } = await open(t, {
    fragment: "#v=1&ac=navion",
    before: () => Object.defineProperty(window, "localStorage", { get: () => { throw new DOMException("no", "SecurityError"); } }),
  });
  await ready();
  await slider("pitch damping C_mq").fill("-12.5");
  await until(state, (now) => now.parameters.cm_q === -12.5, "set");
  await addressBecomes(page, "#v=1&ac=navion&cm_q=-12.5");
  assert.deepEqual([...seen.errors, ...seen.console], []);
});

test("the page rests once the address is written", async (t) => {
  const { page, ready, slider, drawCallsIn } = await open(t);
  await ready();
  await slider("pitch damping C_mq").fill("-12.5");
  await addressBecomes(page, "#v=1&ac=navion&cm_q=-12.5&elevator=-1");
  // Looking is all it may do from here on: a page that wakes itself to look would never be quiet for so long.
  for (let tries = 0; (await drawCallsIn(2000)) > 0; tries += 1) assert.ok(tries < 10, "never at rest");
});
