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
const PATIENCE = 30_000;
// No test takes as long. A page that never answers would otherwise stop all tests without a word.
const LONGEST = 300_000;
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

// A page that has greeted the person before. In a frame without an origin there is no storage.
function greeted() {
  try {
    localStorage.setItem("eigenwing.greeted", "yes");
  } catch {}
}

// Options: `viewport`, `colorScheme`, `touch`; `media`, more of what a system asks for, as in Playwright's `newContext`; `scale`, pixels a point of a real screen, for a play-acted one tells the
// canvas other sizes than a real one; `flags` for the browser; `path` of another page ("example/") and `fragment` of the
// address ("#v=1&ac=navion"); `before`, a function run in the page before its scripts; `server`, as in server.mjs;
// `waitUntil`, as in Playwright's `goto`; `firstVisit`, for the line that greets who hasn't been here.
// Closes itself when the test ends.
export async function open(t, options = {}) {
  const { viewport = { width: 1440, height: 900 }, colorScheme = "light", touch = false, scale } = options;
  const screen = scale ? [`--force-device-scale-factor=${scale}`, `--window-size=${viewport.width},${viewport.height}`] : [];
  const browser = await browserWith([...screen, ...(options.flags ?? [])]);
  const server = await serve(options.server);
  const acted = scale ? { viewport: null } : { viewport, hasTouch: touch, isMobile: touch };
  const context = await browser.newContext({ colorScheme, ...acted, ...options.media });
  const late = setTimeout(() => giveUp(`a page was still open after ${LONGEST / 1000} s: ${t.name}`), LONGEST);
  t.after(async () => {
    const stuck = setTimeout(() => giveUp(`a page could not be closed: ${t.name}`), PATIENCE);
    await context.close();
    clearTimeout(late);
    clearTimeout(stuck);
    server.close();
  });

  // What the page has done: text of console errors and warnings, uncaught errors, addresses asked for.
  const seen = { console: [], errors: [], requests: [] };
  const page = await context.newPage();
  page.setDefaultTimeout(PATIENCE);
  page.on("console", (message) => {
    const text = message.text();
    const complaint = ["error", "warning"].includes(message.type());
    if (complaint && !HARMLESS.some((start) => text.includes(start))) seen.console.push(text);
  });
  page.on("pageerror", (error) => seen.errors.push(error.message));
  page.on("request", (request) => seen.requests.push(request.url()));

  // The page's own two events, the values of its progress bar, and a count of what it draws.
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
    // Waits until the page has drawn nothing for a while: a frame takes long where software draws it, and on a machine that is
    // shared now and then ten times as long. What never rests is found all the same.
    rest: async () => {
      for (let i = 0; i < 60; i += 1) {
        const before = await page.evaluate(() => window.drawCalls);
        await sleep(700);
        if ((await page.evaluate(() => window.drawCalls)) === before) return;
      }
      throw new Error("the page does not come to rest");
    },
    // How often the page draws in this time.
    drawCallsIn: async (milliseconds) => {
      const before = await page.evaluate(() => window.drawCalls);
      await sleep(milliseconds);
      return (await page.evaluate(() => window.drawCalls)) - before;
    },
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

// Waits until what is found satisfies a condition, and gives it; the page draws when it has time. What can't be read yet,
// such as a page that is being loaded again, is tried again.
export async function until(found, condition, what, patience = PATIENCE) {
  const end = performance.now() + patience;
  let last;
  while (performance.now() < end) {
    // A question to a page that is being loaded again is sometimes never answered.
    last = await Promise.race([found(), sleep(5000, undefined, { ref: false })]).catch(() => undefined);
    if (last != null && condition(last)) return last;
    await sleep(50);
  }
  return assert.fail(`not within ${patience / 1000} s: ${what}; ${JSON.stringify(last)?.slice(0, 300)}`);
}

// The middle of an element, and its width.
export async function middle(locator) {
  const { x, y, width, height } = await locator.boundingBox();
  return { x: x + width / 2, y: y + height / 2, width };
}
