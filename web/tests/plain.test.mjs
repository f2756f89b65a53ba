// Without WebGL: the same model as tables and plain inputs.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open, until } from "./page.mjs";

const NO_WEBGL = { flags: ["--disable-3d-apis"] };

test("without WebGL the scene of a link is a plain page with its modes, verdicts and pictures", async (t) => {
  const { page, seen, screenshot, foreignRequests } = await open(t, { ...NO_WEBGL, fragment: "#v=1&ac=navion&cm_alpha=0.3" });
  await page.getByRole("cell").first().waitFor();
  assert.match(page.url(), /plain\.html#v=1&ac=navion&cm_alpha=0\.3$/);
  assert.match(await page.locator("header").innerText(), /WebGL/);
  assert.match(await page.getByRole("status").innerText(), /Dynamically unstable: .* doubles every .* s; statically unstable/);
  assert.ok((await page.getByRole("row").count()) >= 4);
  assert.match(await page.getByRole("img").first().getAttribute("alt"), /^Pole map: /);
  assert.ok(await page.getByRole("img").first().evaluate((image) => image.decode().then(() => image.naturalWidth > 0)));
  await screenshot("plain");
  assert.deepEqual(seen.errors, []);
  assert.deepEqual(foreignRequests(), []);
});

test("a slider of the plain page moves the modes and the address, and what can't be flown is said and not done", async (t) => {
  const { page, seen } = await open(t, { path: "plain.html" });
  const verdict = () => page.getByRole("status").innerText();
  await until(verdict, (said) => said.startsWith("Dynamically stable"), "the Navion");
  const stiffness = page.getByRole("slider", { name: "Pitch stiffness cm_alpha" });
  await stiffness.fill("0.3");
  await until(verdict, (said) => said.startsWith("Dynamically unstable"), "another verdict");
  await until(async () => page.url(), (url) => /cm_alpha=0\.3/.test(url), "in the address");
  // A knob of the aircraft brings the coefficients along.
  await page.getByRole("button", { name: "Reset the aircraft" }).click();
  await until(verdict, (said) => said.startsWith("Dynamically stable"), "the Navion again");

  const speed = page.getByRole("spinbutton", { name: "Airspeed speed in numbers" });
  await speed.fill("20");
  await speed.press("Enter");
  await page.getByRole("alert").getByText(/C_L/).waitFor();
  assert.match(await verdict(), /^Dynamically stable/);

  await page.getByLabel("Motion").selectOption("lateral");
  await page.getByRole("rowheader", { name: "Dutch roll" }).waitFor();
  await page.getByLabel("Aircraft").selectOption("x15");
  await until(async () => page.url(), (url) => url.includes("ac=x15"), "the aircraft in the address");
  assert.deepEqual(seen, { ...seen, console: [], errors: [] });
});

test("the plain page opens no lesson and nothing that is hidden or locked, and says so to the page around it", async (t) => {
  const { page } = await open(t, { path: "plain.html", fragment: "#v=1&ac=navion&lock=aircraft" });
  const said = (page) => page.getByRole("alert").getByText(/lesson, or hides or locks/);
  const shown = (page) => page.getByRole("table").isVisible();
  for (const piece of ["lock=aircraft", "hide=numbers", "%68ide=numbers", "lesson=longitudinal&step=2", "cg=12&amp;lock=all"]) {
    await page.evaluate((piece) => (location.hash = `#v=1&ac=navion&${piece}`), piece);
    await said(page).waitFor();
    assert.ok(!(await shown(page)), piece);
  }
  await page.evaluate(() => (location.hash = "#v=1&ac=navion&stage=derivatives.poles"));
  await until(() => shown(page), Boolean, "a scene without them");
  assert.equal(await page.getByRole("alert").innerText(), "");

  const { page: host } = await open(t, { ...NO_WEBGL, path: "example/embed.html" });
  await said(host.frameLocator("#frame")).waitFor();
  const told = async () => (await host.locator("#log li").allTextContents()).map((line) => JSON.parse(line));
  await until(told, (messages) => messages.some(({ eigenwing, type, sentence }) => eigenwing === 1 && type === "error" && /WebGL/.test(sentence)), "an error");
});

test("the way to the whole page has the last edit, and an aircraft of one's own is reset to its file", async (t) => {
  const { page, seen } = await open(t, { path: "plain.html", fragment: "#v=1&ac=navion" });
  const verdict = () => page.getByRole("status").innerText();
  await until(verdict, (said) => said.startsWith("Dynamically stable"), "the Navion");
  const stiffness = page.getByRole("slider", { name: "Pitch stiffness cm_alpha" });
  const whole = () => page.getByRole("link", { name: "Try the whole page" }).getAttribute("href");
  await stiffness.fill("0.3");
  await until(whole, (href) => href.includes("cm_alpha=0.3"), "the edit in the link");
  const own = await page.evaluate(async () => {
    const { list, link, takeAlong } = await import("./core/eigenwing-core.js");
    const toml = takeAlong({ aircraft: list()[0].key, target: "toml" }).text.replace(/^key = .*/m, 'key = "own-mine"');
    return link({ toml }).link;
  });
  await page.evaluate((own) => (location.hash = `${own}&cm_alpha=0.3`), own);
  await until(verdict, (said) => said.startsWith("Dynamically unstable"), "one's own, edited");
  await page.getByRole("button", { name: "Reset the aircraft" }).click();
  await until(verdict, (said) => said.startsWith("Dynamically stable"), "one's own, as it was");
  assert.match(page.url(), /own=/);
  assert.doesNotMatch(page.url(), /cm_alpha/);
  assert.match(await whole(), /own=/);
  assert.deepEqual(seen, { ...seen, console: [], errors: [] });
});

test("the plain page on a phone in the dark is no wider than the window, and every input has a name", async (t) => {
  const { page, screenshot } = await open(t, { path: "plain.html", viewport: { width: 390, height: 844 }, colorScheme: "dark" });
  await page.getByRole("cell").first().waitFor();
  await screenshot("plain-phone-dark");
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), "wider than the window");
  const unnamed = await page.evaluate(() => [...document.querySelectorAll("input, select")].filter((input) => !input.labels.length && !input.ariaLabel).length);
  assert.equal(unnamed, 0);
});
