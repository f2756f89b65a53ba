// From the address to the first frame, and everything that can go wrong on the way.

import assert from "node:assert/strict";
import { test } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { open } from "./page.mjs";

test("the page becomes ready, without a complaint and without asking any other host", async (t) => {
  const { page, ready, state, seen, foreignRequests } = await open(t);
  t.diagnostic(`ready after ${Math.round(await ready())} ms`);
  assert.equal(await page.locator("#welcome").isVisible(), false);
  assert.equal(typeof (await state()), "object");
  assert.deepEqual(seen.console, []);
  assert.deepEqual(seen.errors, []);
  assert.deepEqual(foreignRequests(), []);
});

test("the canvas fills the window", async (t) => {
  const { page, ready } = await open(t, { viewport: { width: 1024, height: 768 } });
  await ready();
  const box = await page.locator("#eigenwing").boundingBox();
  assert.deepEqual(box, { x: 0, y: 0, width: 1024, height: 768 });
});

test("nothing is drawn while nothing moves", async (t) => {
  const { ready, drawCallsIn } = await open(t);
  await ready();
  // The first frames settle sizes and ranges; on a busy machine without a graphics card each takes a while.
  for (let i = 0; i < 20 && (await drawCallsIn(500)) > 0; i += 1);
  assert.equal(await drawCallsIn(2000), 0);
});

test("the heading can be read and the bar moves before the program has arrived", async (t) => {
  const { page, ready, screenshot, progress } = await open(t, { server: { slowly: 60 }, waitUntil: "commit" });
  assert.equal(await page.getByRole("heading", { level: 1 }).innerText(), "Eigenwing");
  assert.equal(await page.getByRole("progressbar").isVisible(), true);
  await screenshot("loading");
  await ready();
  const values = await progress();
  assert.ok(values.length > 5, `the bar showed only ${values}`);
  assert.deepEqual(values, values.toSorted((a, b) => a - b));
  assert.equal(values.at(-1), 1);
});

test("a program that is not found is reported", async (t) => {
  const { page, screenshot } = await open(t, { server: { missing: /\.wasm$/ } });
  await page.getByRole("heading", { name: "Eigenwing could not be loaded" }).waitFor();
  await screenshot("not-loaded");
  assert.equal(await page.getByRole("button", { name: "Reload" }).isVisible(), true);
  assert.equal(await page.getByRole("progressbar").isVisible(), false);
});

test("a script that is not found is reported", async (t) => {
  const { page } = await open(t, { server: { missing: /^eigenwing-.*\.js$/ } });
  await page.getByRole("heading", { name: "Eigenwing could not be loaded" }).waitFor();
});

test("missing WebGL is explained", async (t) => {
  const { page, screenshot } = await open(t, { flags: ["--disable-3d-apis"], colorScheme: "dark" });
  await page.getByRole("heading", { name: "This browser cannot show the graphics" }).waitFor();
  assert.match(await page.getByRole("alert").innerText(), /WebGL/);
  await screenshot("no-webgl");
});

test("a program that stops says so, and Reload starts it again", async (t) => {
  const { page, ready, screenshot } = await open(t);
  await ready();
  const detail = "The response could not be computed.";
  await page.evaluate((detail) => dispatchEvent(new CustomEvent("eigenwing-failed", { detail })), detail);
  await page.getByRole("heading", { name: "Eigenwing has stopped" }).waitFor();
  assert.match(await page.getByRole("alert").innerText(), new RegExp(detail));
  await screenshot("stopped");
  await page.getByRole("button", { name: "Reload" }).click();
  await page.locator("#welcome").waitFor({ state: "hidden" });
});

test("lost graphics are reported", async (t) => {
  const { page, ready } = await open(t);
  await ready();
  await page.evaluate(() => {
    const canvas = document.getElementById("eigenwing");
    (canvas.getContext("webgl2") ?? canvas.getContext("webgl")).getExtension("WEBGL_lose_context").loseContext();
  });
  await page.getByRole("heading", { name: "The graphics were interrupted" }).waitFor();
});

test("without JavaScript the page says what it needs", async (t) => {
  const { page, url } = await open(t);
  const context = await page.context().browser().newContext({ javaScriptEnabled: false });
  t.after(() => context.close());
  const plain = await context.newPage();
  await plain.goto(url);
  assert.match(await plain.locator("noscript").innerText(), /needs JavaScript/);
  assert.equal(await plain.getByRole("heading", { level: 1 }).innerText(), "Eigenwing");
  assert.equal(await plain.getByRole("progressbar").isVisible(), false);
});

test("the content security policy lets nothing else in or out", async (t) => {
  const { page, ready } = await open(t);
  await ready();
  const outcome = await page.evaluate(async () => {
    const script = document.createElement("script");
    script.textContent = "window.intruded = true";
    document.body.append(script);
    const fetched = await fetch("https://example.org/").then(
      () => "fetched",
      () => "refused",
    );
    return { intruded: window.intruded ?? false, fetched };
  });
  assert.deepEqual(outcome, { intruded: false, fetched: "refused" });
});

// A page of a course with a field for an answer, and the program in a frame below it.
async function hosted(t, attributes = "") {
  const { page, url } = await open(t);
  const host = await page.context().newPage();
  await host.setContent(
    `<input id="answer" autofocus><iframe id="frame" width="900" height="600" ${attributes} src="${url}"></iframe>`,
  );
  return { host, frame: host.frameLocator("#frame") };
}

test("in a frame the page takes the keyboard only once it is used", async (t) => {
  const { host, frame } = await hosted(t);
  await frame.locator("#welcome").waitFor({ state: "hidden" });
  await sleep(500);
  const active = () => host.evaluate(() => document.activeElement.id);
  assert.equal(await active(), "answer");
  await host.keyboard.type("42");
  assert.equal(await host.locator("#answer").inputValue(), "42");
  await frame.locator("#eigenwing").click({ position: { x: 450, y: 20 } });
  assert.equal(await active(), "frame");
});

test("in a frame without an origin the page says why it can’t start", async (t) => {
  const { frame } = await hosted(t, 'sandbox="allow-scripts"');
  await frame.getByText("add allow-same-origin to its sandbox").waitFor();
});
