// Random use of the built page for a long time: `cargo xtask soak-browser --minutes 60`. It must not stop or complain, and its memory
// must come to rest.
//
//   node soak.mjs MINUTES SEED

import { chromium } from "playwright-core";
import { FLAGS } from "./tests/flags.mjs";
import { serve } from "./tests/server.mjs";

const [minutes, seed] = [Number(process.argv[2] ?? 5), Number(process.argv[3] ?? 1)];
const EVERY = 20_000;
// Growth of memory that counts as none, from the second third of the time to the last [bytes]: a browser collects when it likes.
const RESTS = 12e6;
const KEYS = "Z Y Space P A R Escape G L T Tab ArrowLeft ArrowRight ArrowUp ArrowDown Home End PageUp PageDown Delete Backspace Enter ? X M O U K 0 1 7 . - e +".split(" ");
const SIZES = [[1440, 900], [1024, 768], [390, 844], [844, 390], [3840, 2160], [240, 180], [60, 900]];
const SCENES = [
  "#v=1&ac=navion",
  "#v=1&ac=navion&cm_alpha=0.4",
  "#v=1&ac=b747-fc9&plane=lateral&lat.source=aileron&lat.shape=doublet",
  "#v=1&ac=x15&tab=frequency",
  "#v=1&ac=lesson-printed&pin.ac=lesson&tab=phase",
  "#v=1&ac=navion&flight=nonlinear&elevator=-5",
  "#v=1&ac=navion&lon.source=turbulence&tab=metrics",
  "#v=1&lesson=longitudinal",
  "#v=1&ac=navion&present=on",
  "#v=1&ac=nonsense&cm_alpha=nan&lon.show=&camera=1e99.1.1",
];

// Mulberry32: the same use again for the same seed.
let state = seed;
function random() {
  state = (state + 0x6d2b79f5) | 0;
  let t = Math.imul(state ^ (state >>> 15), 1 | state);
  t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
  return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
}
const below = (end) => Math.floor(random() * end);
const one = (list) => list[below(list.length)];

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: FLAGS });
const server = await serve();
const context = await browser.newContext({ viewport: { width: 1440, height: 900 }, acceptDownloads: false });
const page = await context.newPage();
const complaints = [];
page.on("pageerror", (error) => complaints.push(error.message));
page.on("filechooser", () => {});
page.on("dialog", (dialog) => dialog.dismiss());
context.on("page", (other) => other.close().catch(() => {}));
// The program's own memory, which only grows: the browser counts it nowhere.
await page.addInitScript(() => {
  for (const name of ["instantiate", "instantiateStreaming"]) {
    const start = WebAssembly[name];
    WebAssembly[name] = async (...rest) => {
      const started = await start.apply(WebAssembly, rest);
      window.programMemory ??= (started.instance ?? started).exports.memory;
      return started;
    };
  }
});
const session = await context.newCDPSession(page);
await page.goto(`${server.url}${SCENES[0]}`);
await page.locator("#welcome").waitFor({ state: "hidden", timeout: 60_000 });

const place = () => {
  const { width, height } = page.viewportSize();
  return [random() * width, random() * height];
};
const ACTIONS = [
  [8, async () => page.mouse.click(...place())],
  [6, async () => {
    await page.mouse.move(...place());
    await page.mouse.down();
    for (let i = 0; i < 6; i += 1) await page.mouse.move(...place());
    await page.mouse.up();
  }],
  [3, async () => {
    await page.mouse.move(...place());
    await page.mouse.wheel(0, (random() - 0.5) * 800);
  }],
  [8, async () => page.keyboard.press(`${one(["", "", "", "Shift+", "Control+"])}${one(KEYS)}`)],
  [4, async () => page.evaluate(([share, value]) => {
    // Sliders as a screen reader moves them.
    const sliders = document.querySelectorAll("#mirror input[type=range]");
    const slider = sliders[Math.floor(share * sliders.length)];
    if (!slider) return;
    slider.value = Number(slider.min) + value * (Number(slider.max) - Number(slider.min));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, [random(), random()])],
  [1, async () => page.evaluate((hash) => (location.hash = hash), one(SCENES))],
  [1, async () => {
    const [width, height] = one(SIZES);
    await page.setViewportSize({ width, height });
  }],
];
const WEIGHT = ACTIONS.reduce((sum, [weight]) => sum + weight, 0);
function action() {
  let rest = random() * WEIGHT;
  return ACTIONS.find(([weight]) => (rest -= weight) < 0)[1];
}

async function memory() {
  await session.send("HeapProfiler.collectGarbage");
  const { usedSize } = await session.send("Runtime.getHeapUsage");
  const program = await page.evaluate(() => window.programMemory?.buffer.byteLength ?? 0);
  const { metrics } = await session.send("Performance.getMetrics");
  const metric = (name) => metrics.find((metric) => metric.name === name)?.value;
  return { heap: usedSize, program, nodes: metric("Nodes"), listeners: metric("JSEventListeners") };
}

await session.send("Performance.enable");
// Everything once, for what the program takes for the largest window and the first lesson it never gives back.
for (const scene of SCENES) {
  await page.evaluate((hash) => (location.hash = hash), scene);
  await page.waitForTimeout(1000);
}
for (const [width, height] of SIZES) {
  await page.setViewportSize({ width, height });
  await page.waitForTimeout(2000);
}
const [start, samples] = [Date.now(), []];
let [actions, next] = [0, Date.now() + EVERY];
let stopped;
while (Date.now() - start < minutes * 60_000) {
  await action()().catch((error) => complaints.push(error.message.split("\n")[0]));
  actions += 1;
  if (await page.locator("#failure").isVisible()) {
    stopped = await page.locator("#failure").innerText();
    break;
  }
  if (Date.now() > next) {
    const now = await memory();
    samples.push(now);
    const mb = (bytes) => `${(bytes / 1e6).toFixed(1)} MB`;
    console.log(`${((Date.now() - start) / 60_000).toFixed(1)} min, ${actions} actions: heap ${mb(now.heap)}, program ${mb(now.program)}, ${now.nodes} nodes, ${now.listeners} listeners`);
    next = Date.now() + EVERY;
  }
}
const hash = await page.evaluate(() => location.hash).catch(() => "");
await browser.close();
server.close();

const least = (samples, name) => Math.min(...samples.map((sample) => sample[name]));
const third = Math.floor(samples.length / 3);
const growth = ["heap", "program"].map((name) => [name, least(samples.slice(-third), name) - least(samples.slice(third, 2 * third), name)]);
for (const [name, bytes] of growth) console.log(`${name} grew by ${(bytes / 1e6).toFixed(1)} MB from the second third of the time to the last`);
for (const complaint of new Set(complaints)) console.log(`complaint: ${complaint}`);
if (stopped) console.log(`stopped after ${actions} actions of seed ${seed} at ${hash}:\n${stopped}`);
if (stopped || complaints.length > 0 || (third > 0 && growth.some(([, bytes]) => bytes > RESTS))) process.exitCode = 1;
