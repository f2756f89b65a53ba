// Opens the built page in Chromium for a test, and notes everything that it does.
//
//   test("…", async (t) => {
//     const { page, ready, state, slider } = await open(t);
//     await ready();
//     await slider("Mass").fill("1200");
//     assert.equal((await state()).mass, 1200);
//   });

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { after } from "node:test";
import { setTimeout as sleep } from "node:timers/promises";
import { fileURLToPath } from "node:url";
import { chromium } from "playwright-core";
import { FLAGS } from "./flags.mjs";
import { serve } from "./server.mjs";

const HARMLESS = [
  // Reading a software-drawn canvas for a screenshot.
  "GL Driver Message",
];
// How long what is expected may take. It measures nothing: a shared machine without a graphics card is many times slower than a person's.
const PATIENCE = 60_000;
// A page that answers nothing for so long would otherwise stop all tests without a word.
const SILENCE = 300_000;
// In so many animation frames in a row a page draws what waits to be drawn.
const FRAMES = 12;
const SCREENSHOTS = fileURLToPath(new URL("../screenshots/", import.meta.url));

// One browser for each set of extra flags, kept until the test file ends.
const browsers = new Map();

function browserWith(flags) {
  const key = flags.join(" ");
  if (!browsers.has(key)) {
    browsers.set(
      key,
      chromium.launch({
        executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
        args: [...FLAGS, ...flags],
        timeout: SILENCE,
      }),
    );
  }
  return browsers.get(key);
}

after(async () => {
  for (const browser of browsers.values()) await (await browser).close();
});

// A browser that doesn't answer can't be closed either; it ends with the tests of this file.
function giveUp(what) {
  console.error(what);
  process.exit(1);
}

// One for each open page; it gives up the tests unless a page answers in time.
const watches = new Set();

function heard() {
  for (const watch of watches) watch.refresh();
}

// A page that has greeted the person before. In a frame without an origin there is no storage.
function greeted() {
  try {
    localStorage.setItem("eigenwing.greeted", "yes");
  } catch {}
}

// Options: `viewport`, `colorScheme`, `touch`; `media`, more of what a system asks for, as in Playwright's `newContext`; `scale`, pixels a point of a real screen, for a play-acted one tells the
// canvas other sizes than a real one; `flags` for the browser; `path` of another page ("example/") and `fragment` of the
// address ("#v=1&ac=navion"); `before`, a function run in the page before its scripts; `server`, as in server.mjs;
// `waitUntil`, as in Playwright's `goto`; `firstVisit`, for the line that greets who hasn't been here; `prepare`, which is given page and
// server before the address is opened.
// Closes itself when the test ends.
export async function open(t, options = {}) {
  const { viewport = { width: 1440, height: 900 }, colorScheme = "light", touch = false, scale } = options;
  const screen = scale ? [`--force-device-scale-factor=${scale}`, `--window-size=${viewport.width},${viewport.height}`] : [];
  const browser = await browserWith([...screen, ...(options.flags ?? [])]);
  const server = await serve(options.server);
  const acted = scale ? { viewport: null } : { viewport, hasTouch: touch, isMobile: touch };
  const context = await browser.newContext({ colorScheme, ...acted, ...options.media });
  context.setDefaultTimeout(PATIENCE);
  const watch = setTimeout(() => giveUp(`no page has answered for ${SILENCE / 1000} s: ${t.name}`), SILENCE);
  watches.add(watch);
  t.after(async () => {
    const stuck = setTimeout(() => giveUp(`a page could not be closed: ${t.name}`), PATIENCE);
    await context.close();
    watches.delete(watch);
    clearTimeout(watch);
    clearTimeout(stuck);
    server.close();
  });

  // What the page has done: text of console errors and warnings, uncaught errors, addresses asked for.
  const seen = { console: [], errors: [], requests: [] };
  const page = await context.newPage();
  page.on("console", (message) => {
    const text = message.text();
    const complaint = ["error", "warning"].includes(message.type());
    if (complaint && !HARMLESS.some((start) => text.includes(start))) seen.console.push(text);
  });
  page.on("pageerror", (error) => seen.errors.push(error.message));
  page.on("request", (request) => seen.requests.push(request.url()));

  // The page's own two events, the values of its progress bar, and in all windows a count of what is drawn.
  let hearReady, hearFailed;
  const readyAt = new Promise((resolve) => (hearReady = resolve));
  const failedWith = new Promise((resolve) => (hearFailed = resolve));
  await page.exposeFunction("reportReady", (time) => hearReady(time));
  await page.exposeFunction("reportFailed", (detail) => hearFailed(detail));
  await page.addInitScript(() => {
    addEventListener("eigenwing-ready", () => reportReady(performance.now()));
    addEventListener("eigenwing-failed", (event) => reportFailed(event.detail));
    window.progressValues = [];
    new MutationObserver((changes) => {
      for (const { target } of changes) {
        if (target.id === "progress") window.progressValues.push(target.value);
      }
    }).observe(document, { subtree: true, attributes: true, attributeFilter: ["value"] });
  });
  await context.addInitScript(() => {
    window.drawCalls = 0;
    for (const { prototype } of [WebGLRenderingContext, WebGL2RenderingContext]) {
      for (const name of ["drawElements", "drawArrays"]) {
        const draw = prototype[name];
        prototype[name] = function (...rest) {
          window.drawCalls += 1;
          return draw.apply(this, rest);
        };
      }
    }
  });

  if (!options.firstVisit) await page.addInitScript(greeted);
  if (options.before) await page.addInitScript(options.before);

  await options.prepare?.(page, server);
  const url = server.url + (options.path ?? "") + (options.fragment ?? "");
  await page.goto(url, { waitUntil: options.waitUntil ?? "load" });

  return {
    page,
    url,
    seen,
    server,
    // Waits for the first frame; milliseconds since the page was asked for.
    ready: async () => {
      const late = sleep(PATIENCE, undefined, { ref: false }).then(() => {
        throw new Error(`not ready after ${PATIENCE} ms; ${JSON.stringify(seen)}`);
      });
      const failed = failedWith.then((detail) => {
        throw new Error(`the program failed: ${detail}; ${JSON.stringify(seen)}`);
      });
      return Promise.race([readyAt, failed, late]);
    },
    // What the program says about itself.
    state: async () => JSON.parse(await page.evaluate(() => window.eigenwing.state())),
    // A slider by its accessible name (whole, or a pattern).
    slider: (name) => page.getByRole("slider", { name, exact: true }),
    // What the progress bar has shown, each value once.
    progress: async () => [...new Set(await page.evaluate(() => window.progressValues))],
    rest: () => rest(page),
    // How often the page draws in this time.
    drawCallsIn: (milliseconds) => pass(page, milliseconds),
    // A picture in web/screenshots/.
    screenshot: async (name) => {
      mkdirSync(SCREENSHOTS, { recursive: true });
      await page.screenshot({ path: `${SCREENSHOTS}${name}.png` });
    },
    // Requests to anywhere but the page's own host.
    foreignRequests: () =>
      seen.requests.filter((request) => !request.startsWith(new URL(url).origin) && !/^(data|blob):/.test(request)),
  };
}

// Waits until so much time has passed in a page or a frame [ms], and so many animation frames: where thread or renderer wait for a busy
// machine nothing happens either. Gives how often it has drawn meanwhile.
export async function pass(page, milliseconds, frames = FRAMES) {
  const drawn = await page.evaluate(
    ([milliseconds, frames]) =>
      new Promise((passed) => {
        const [began, before] = [performance.now(), window.drawCalls];
        let left = frames;
        const look = () => {
          left -= 1;
          if (left > 0 || performance.now() - began < milliseconds) requestAnimationFrame(look);
          else passed(window.drawCalls - before);
        };
        requestAnimationFrame(look);
      }),
    [milliseconds, frames],
  );
  heard();
  return drawn;
}

// Waits until what the page has heard so far is on its canvas: a frame may only show what an event has brought about, the next one runs
// the program.
export const frames = (page) => pass(page, 0, 3);

// Waits until nothing has been drawn for a while. What never rests is found all the same.
export async function rest(page) {
  for (let tries = 0; tries < 60; tries += 1) {
    if ((await pass(page, 700)) === 0) return;
  }
  throw new Error("the page does not come to rest");
}

// Waits until what is found satisfies a condition, and gives it; the page draws when it has time. What can't be read yet,
// such as a page that is being loaded again, is tried again.
export async function until(found, condition, what, patience = PATIENCE) {
  const end = performance.now() + patience;
  const late = Symbol("late");
  let asked = [];
  let last;
  while (performance.now() < end) {
    // A question to a page that is being loaded again is sometimes never answered. It is asked again, and the first answer counts.
    asked.push(Promise.resolve().then(found).catch(() => undefined));
    const answer = await Promise.race([...asked, sleep(5000, late, { ref: false })]);
    if (answer === late) continue;
    heard();
    asked = [];
    last = answer;
    if (last != null && condition(last)) return last;
    await sleep(50);
  }
  return assert.fail(`not within ${patience / 1000} s: ${what}; ${JSON.stringify(last)?.slice(0, 300)}`);
}

// Drops a file with this text on the page.
export async function drop(page, name, text) {
  const data = await page.evaluateHandle(
    ([name, text]) => {
      const data = new DataTransfer();
      data.items.add(new File([text], name));
      return data;
    },
    [name, text],
  );
  for (const type of ["dragenter", "dragover", "drop"]) {
    await page.dispatchEvent("#eigenwing", type, { dataTransfer: data });
  }
}

// The middle of an element as it is now, and its width.
export async function place(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2, width };
}

// The same once the element stays where it is: the first frames settle sizes, and what has just come may still move.
export async function middle(locator) {
  const looks = async () => {
    const before = await place(locator);
    await pass(locator.page(), 200);
    return [before, await place(locator)];
  };
  const [, now] = await until(looks, ([a, b]) => Math.hypot(a.x - b.x, a.y - b.y, a.width - b.width) < 0.5, "it stays where it is");
  return now;
}

// Does something while the clock of a page, or of a frame in it, stands still: what takes a slow machine long between press and release is no click to the
// program, and two clicks are no double click.
async function atOnce(page, act) {
  await page.evaluate(() => {
    const now = performance.now();
    performance.now = () => now;
  });
  await act();
  await frames(page);
  await page.evaluate(() => delete performance.now);
}

export const click = (page, { x, y }, frame = page) => atOnce(frame, () => page.mouse.click(x, y));
export const doubleClick = (page, { x, y }, frame = page) => atOnce(frame, () => page.mouse.dblclick(x, y));
export const tap = (page, { x, y }, frame = page) => atOnce(frame, () => page.touchscreen.tap(x, y));
