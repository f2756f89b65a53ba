// Opens the built page in Firefox for a test, by WebDriver BiDi; page.mjs of the folder above does so in Chromium.

import { mkdirSync } from "node:fs";
import { after } from "node:test";
import { fileURLToPath } from "node:url";
import puppeteer from "puppeteer-core";
import { frames, until } from "../page.mjs";
import { open as openScreen } from "../screen.mjs";
import { serve } from "../server.mjs";

// No test takes as long; a page that never answers fails then.
const LONGEST = 120_000;
const SCREENSHOTS = fileURLToPath(new URL("../../screenshots/", import.meta.url));

const screen = await openScreen();
const browser = await puppeteer.launch({
  browser: "firefox",
  executablePath: process.env.FIREFOX ?? "/usr/bin/firefox-esr",
  headless: false,
  env: screen.environment,
  timeout: LONGEST,
  protocolTimeout: LONGEST,
});

after(async () => {
  await browser.close();
  screen.close();
});

// Options: `viewport`, and `fragment` of the address. Closes itself when the test ends.
export async function open(t, { viewport = { width: 1440, height: 900 }, fragment = "" } = {}) {
  const server = await serve();
  const context = await browser.createBrowserContext();
  const page = await context.newPage();
  page.setDefaultTimeout(LONGEST);
  await page.setViewport(viewport);
  t.after(async () => {
    await context.close();
    server.close();
  });

  // Text of console errors and warnings, and of uncaught errors.
  const complaints = [];
  page.on("console", (message) => {
    if (["error", "warn"].includes(message.type())) complaints.push(message.text());
  });
  page.on("pageerror", (error) => complaints.push(error.message));
  // A page that has greeted the person before; the empty one has no storage.
  await page.evaluateOnNewDocument(() => {
    if (location.protocol === "http:") localStorage.setItem("eigenwing.greeted", "yes");
    // How often the page has heard of mouse and finger.
    window.heard = {};
    for (const type of ["mousedown", "mousemove", "mouseup", "touchstart", "touchmove", "touchend"]) {
      addEventListener(type, () => (window.heard[type] = (window.heard[type] ?? 0) + 1), { capture: true });
    }
  });

  const ready = () => until(() => page.evaluate(() => document.getElementById("welcome").hidden), Boolean, "the first frame", LONGEST);
  await page.goto(server.url + fragment);
  await ready();

  return {
    page,
    url: server.url,
    server,
    complaints,
    ready,
    // What the program says about itself.
    state: async () => JSON.parse(await page.evaluate(() => window.eigenwing.state())),
    // An element of the mirror by its role and accessible name: `role("slider", "airspeed V")`.
    role: (role, name) => page.waitForSelector(`::-p-aria([name="${name}"][role="${role}"])`),
    // Moves the mouse or a finger, and waits until the page has heard of it and has drawn: it may hear of it later than it is done.
    act: async (type, move) => {
      const heard = () => page.evaluate((type) => window.heard[type] ?? 0, type);
      const before = await heard();
      await move();
      await until(heard, (now) => now > before, `${type} is heard`, LONGEST);
      await frames(page);
    },
    // A picture in web/screenshots/.
    screenshot: async (name) => {
      mkdirSync(SCREENSHOTS, { recursive: true });
      await page.screenshot({ path: `${SCREENSHOTS}${name}.png` });
    },
  };
}
