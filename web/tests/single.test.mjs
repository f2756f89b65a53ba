// The single-file edition, opened from a file: program, course and lesson are in it, and nothing is fetched.

import assert from "node:assert/strict";
import { copyFileSync, mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { pathToFileURL } from "node:url";
import { open } from "./page.mjs";

// A copy elsewhere, so that nothing beside it can be found.
function onAStick(t) {
  const folder = mkdtempSync(join(tmpdir(), "stick-"));
  t.after(() => rmSync(folder, { recursive: true }));
  const path = join(folder, "lesson.html");
  copyFileSync(process.env.SINGLE, path);
  return pathToFileURL(path).href;
}

test("a lesson opens from a stick, asks, and takes an answer", async (t) => {
  const { page: home } = await open(t);
  const page = await home.context().newPage();
  const [requests, complaints] = [[], []];
  page.on("request", (request) => requests.push(request.url().slice(0, 60)));
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  const address = onAStick(t);
  await page.goto(address);
  await page.locator("#welcome").waitFor({ state: "hidden" });
  const mirror = page.locator("#mirror");
  await mirror.getByText("Does the nose come back?").first().waitFor({ state: "attached" });
  await page.getByRole("button", { name: "Yes, it does." }).or(page.getByRole("radio", { name: "Yes, it does." })).first().dispatchEvent("click");
  await page.getByRole("button", { name: "Answer" }).dispatchEvent("click");
  await mirror.getByText(/Half of the swing is gone after/).first().waitFor({ state: "attached" });
  // The course came along.
  await page.getByRole("button", { name: /^Lessons/ }).dispatchEvent("click");
  await mirror.getByText("Longitudinal modes").first().waitFor({ state: "attached" });
  assert.deepEqual(complaints, []);
  assert.deepEqual(
    requests.filter((url) => !url.startsWith("file:") && !/^(data|blob):/.test(url)),
    [],
  );
  assert.equal(requests.filter((url) => url.startsWith("file:")).length, 1, "only itself");
});

test("the notes of a lecture open from a stick too, and turn its slides", async (t) => {
  const { page: home } = await open(t);
  const page = await home.context().newPage();
  await page.goto(`${onAStick(t)}#v=1&lesson=lecture-modes&present=on`);
  await page.locator("#welcome").waitFor({ state: "hidden" });
  await page.getByRole("heading", { name: "Count the motions" }).waitFor({ state: "attached" });
  const opened = page.waitForEvent("popup");
  await page.keyboard.press("n");
  const notes = await opened;
  await notes.getByText("Slide 1 of").waitFor();
  for (let i = 0; i < 2; i += 1) await notes.getByRole("button", { name: "Next" }).click();
  await page.getByRole("heading", { name: "The quick one alone" }).waitFor({ state: "attached" });
  await notes.getByRole("heading", { name: "The quick one alone" }).waitFor();
});

test("the single page runs in a frame without an origin too", async (t) => {
  const html = readFileSync(process.env.SINGLE, "utf8");
  const { page: home, url } = await open(t, { server: { files: { "single.html": html, "host.html": '<iframe id="frame" width="900" height="600" sandbox="allow-scripts" src="single.html"></iframe>' } } });
  const host = await home.context().newPage();
  await host.goto(`${url.split("#")[0]}host.html`);
  await host.frameLocator("#frame").getByText("Does the nose come back?").first().waitFor({ state: "attached" });
});
