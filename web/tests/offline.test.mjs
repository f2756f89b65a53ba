// The page without a network: one visit keeps a whole version, the next start takes up a newer one, and never a mixture of two.

import assert from "node:assert/strict";
import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { frames, open, rest, until } from "./page.mjs";

const dist = (name) => readFileSync(new URL(`../../dist/${name}`, import.meta.url), "utf8");

// Another version of the page, as a host has it after a roll-out: the title of a chapter and the page's own title are its mark.
function version(mark) {
  const worker = dist("sw.js");
  const [line] = worker.split("\n", 1);
  const [, old, hashes] = line.match(/^const VERSION = "(.*?)", FILES = (.*);$/);
  const course = JSON.parse(hashes);
  const chapter = Object.keys(course).find((path) => path.endsWith(".md") && dist(path).includes("title = "));
  const files = {
    "index.html": dist("index.html").replaceAll(old, old + mark).replace("<title>", `<title>${mark} `),
    [chapter]: `${dist(chapter)}\n`.replace(/title = "/, `title = "${mark} `),
  };
  for (const [name, text] of Object.entries(files)) {
    course[name === "index.html" ? "./" : name] = `sha256-${createHash("sha256").update(text).digest("base64")}`;
  }
  const told = `const VERSION = "${old + mark}", FILES = ${JSON.stringify(course)};`;
  return { chapter, files: { ...files, "sw.js": worker.replace(line, () => told) } };
}

// The versions that are kept whole.
const wholes = (page) =>
  page.evaluate(async () => {
    const found = await Promise.all((await caches.keys()).map(async (name) => (await (await caches.open(name)).match("./")) && name));
    return found.filter(Boolean);
  });
// Waits until one version, and no other, is kept.
const kept = (page, what = "a whole version") => until(() => wholes(page), ({ length }) => length === 1, what);
const controlled = (page) => until(() => page.evaluate(() => Boolean(navigator.serviceWorker.controller)), Boolean, "a worker");
const waiting = (page) => until(() => page.evaluate(async () => Boolean((await navigator.serviceWorker.getRegistration())?.waiting)), Boolean, "a version that waits");
// Reloads a page that may just be doing so itself: then one of the two is refused, and the other is as good.
const reload = (page) => page.reload({ waitUntil: "commit" }).catch(() => {});

// Opens the page anew, and waits until it begins with a version. That takes until what was open before has gone; a worker that is kept
// waiting for it too long leaves it to the next start.
const AGAIN = 15_000;
async function begins(page, isMeant, what) {
  let next = 0;
  const title = async () => {
    if (performance.now() > next) {
      await reload(page);
      next = performance.now() + AGAIN;
    }
    return page.title();
  };
  await until(title, isMeant, what, 5 * AGAIN);
}

// Notes what the page says to its worker, and what becomes of a worker that it asks for.
function notesWorkers() {
  window.told = [];
  const { postMessage } = ServiceWorker.prototype;
  ServiceWorker.prototype.postMessage = function (message) {
    window.told.push(...Object.keys(message));
    return postMessage.call(this, message);
  };
  window.workers = [];
  const { register } = ServiceWorkerContainer.prototype;
  ServiceWorkerContainer.prototype.register = function (...all) {
    const registered = register.apply(this, all);
    registered.then(() => window.workers.push("taken"), () => window.workers.push("refused"));
    return registered;
  };
}

// Waits until the worker has heard that the page runs, has answered what was asked after it, and the page has said what there is to say.
async function heard(page) {
  await page.locator("#welcome").waitFor({ state: "hidden" });
  await until(() => page.evaluate(() => window.told.includes("runs")), Boolean, "the page says that it runs");
  for (let i = 0; i < 5; i += 1) await page.evaluate(async () => (await fetch("manifest.webmanifest")).text());
  await rest(page);
}

const said = (page, sentence) => page.locator("#announcements").getByText(sentence).waitFor({ state: "attached" });

test("after one visit the page, the lessons and the core module open without a network", async (t) => {
  const { page, ready, seen, server, screenshot } = await open(t);
  await ready();
  await controlled(page);
  server.isDown = true;
  // Even now, without a reload.
  const chapter = page.locator("#mirror").getByText(/Longitudinal modes/).first();
  await page.getByRole("button", { name: /^Lessons/ }).dispatchEvent("click");
  await chapter.waitFor({ state: "attached" });

  await page.reload();
  await page.locator("#welcome").waitFor({ state: "hidden" });
  await page.getByRole("button", { name: /^Lessons/ }).dispatchEvent("click");
  await chapter.waitFor({ state: "attached" });
  const list = await page.evaluate(() => eigenwingCore("list"));
  assert.ok(JSON.parse(list).length >= 18);
  await screenshot("offline");
  const folder = page.url().replace(/#.*/, "");
  for (const address of ["index.html", "?from=elsewhere", "notes.html", "example/"]) {
    const other = await page.context().newPage();
    await other.goto(folder + address);
    assert.ok((await other.title()).length > 0, address);
    await other.close();
  }
  assert.deepEqual(seen.errors, []);
});

test("a new version is told of, begins at the next start, and nothing of the scene is lost", async (t) => {
  const files = {};
  const next = version("Second");
  const { page, ready, seen } = await open(t, { server: { files }, before: notesWorkers });
  await ready();
  await controlled(page);
  await page.getByRole("slider", { name: "pitch stiffness C_mα" }).fill("-0.5");
  await until(async () => page.url(), (url) => url.includes("cm_alpha"), "the scene in the address");
  const scene = new URL(page.url()).hash;

  // The host has changed. The page that is there goes on as it began, with its own files.
  Object.assign(files, next.files);
  await page.reload();
  assert.doesNotMatch(await page.title(), /Second/);
  await page.locator("#welcome").waitFor({ state: "hidden" });
  await waiting(page);
  await said(page, "A new version of Eigenwing has arrived.");
  const text = () => page.evaluate(async (path) => (await fetch(path)).text(), next.chapter);
  assert.doesNotMatch(await text(), /title = "Second/);

  await begins(page, (title) => /^Second/.test(title), "the new version");
  await said(page, "This is a new version of Eigenwing.");
  assert.match(await text(), /title = "Second/);
  assert.equal(new URL(page.url()).hash, scene);
  assert.match(await page.evaluate(() => eigenwing.state()), /-0\.5/);
  const [name] = await kept(page, "the new version alone");
  assert.match(name, /Second$/);

  // It is said once.
  await page.reload();
  await heard(page);
  assert.doesNotMatch(await page.locator("#announcements").innerText(), /version/);
  assert.deepEqual(seen.errors, []);
});

test("while the page is open in another tab it stays as it is in both", async (t) => {
  const files = {};
  const { page, ready } = await open(t, { server: { files }, before: notesWorkers });
  await ready();
  await controlled(page);
  const other = await page.context().newPage();
  await other.addInitScript(notesWorkers);
  await other.goto(page.url());
  await other.locator("#welcome").waitFor({ state: "hidden" });
  Object.assign(files, version("Second").files);
  await other.reload();
  await waiting(other);
  for (const tab of [other, page]) {
    await tab.reload();
    await heard(tab);
    assert.doesNotMatch(await tab.title(), /Second/);
  }
  await other.close();
  await begins(page, (title) => /^Second/.test(title), "the new version");
});

test("whatever is opened while a new version begins is shown, and is of one version", async (t) => {
  const files = {};
  const { page, ready } = await open(t, { server: { files } });
  await ready();
  await controlled(page);
  const marks = async (tab, chapter) => {
    await until(() => tab.locator("#welcome").isHidden(), Boolean, "the page");
    // Of one document: it may just be beginning again.
    const look = () => tab.evaluate(async (path) => [document.title, await (await fetch(path)).text()], chapter);
    const told = await until(look, ([, text]) => text, "a chapter");
    return told.map((text) => text.match(/Second|Third|Fourth/)?.[0]);
  };
  for (const mark of ["Second", "Third", "Fourth"]) {
    const { chapter, files: next } = version(mark);
    Object.assign(files, next);
    const other = await page.context().newPage();
    await other.goto(page.url());
    await page.reload();
    await said(page, "A new version of Eigenwing has arrived.");
    // The page has just begun with the old version, and would begin again as the only one; a hasty person reloads it, and opens another.
    await page.reload();
    await other.close();
    await reload(page);
    const third = await page.context().newPage();
    await third.goto(page.url(), { waitUntil: "commit" });
    for (const tab of [page, third]) {
      const [title, text] = await marks(tab, chapter);
      assert.equal(title, text);
    }
    await third.close();
    await begins(page, (title) => title.startsWith(mark), "the new version");
    assert.deepEqual(await marks(page, chapter), [mark, mark]);
  }
});

test("a version that is taken back is gone at the next start", async (t) => {
  const files = {};
  const { page, ready } = await open(t, { server: { files } });
  await ready();
  await controlled(page);
  Object.assign(files, version("Second").files);
  await page.reload();
  await waiting(page);
  await begins(page, (title) => /^Second/.test(title), "the new version");
  await page.locator("#welcome").waitFor({ state: "hidden" });

  for (const name of Object.keys(files)) delete files[name];
  await page.reload();
  await said(page, "A new version of Eigenwing has arrived.");
  await begins(page, (title) => /^Eigenwing/.test(title), "the version before");
  const [name] = await kept(page);
  assert.doesNotMatch(name, /Second$/);
});

test("nothing is kept of a version that is only half on the host", async (t) => {
  const files = {};
  const next = version("Second");
  const { page, ready, server } = await open(t, { server: { files } });
  await ready();
  await controlled(page);
  // The worker and the page have been copied, a chapter not yet.
  Object.assign(files, next.files);
  delete files[next.chapter];
  await page.reload();
  await page.locator("#welcome").waitFor({ state: "hidden" });
  const attempt = () =>
    page.evaluate(async () => {
      const registration = await navigator.serviceWorker.getRegistration();
      const outcome = new Promise((resolve) => {
        const follow = () => registration.installing?.addEventListener("statechange", ({ target }) => resolve(target.state));
        follow();
        registration.addEventListener("updatefound", follow);
      });
      await registration.update();
      return outcome;
    });
  assert.equal(await until(attempt, Boolean, "an attempt"), "redundant");
  assert.equal(await page.evaluate(async () => Boolean((await navigator.serviceWorker.getRegistration()).waiting)), false);
  const [name] = await kept(page, "the first version alone");
  assert.doesNotMatch(name, /Second$/);
  server.isDown = true;
  await page.reload();
  assert.doesNotMatch(await page.title(), /Second/);
  await page.locator("#welcome").waitFor({ state: "hidden" });
});

test("where storage is full or refused the page works as any other", async (t) => {
  await t.test("full", async (t) => {
    const prepare = async (page, server) => {
      const session = await page.context().newCDPSession(page);
      await session.send("Storage.overrideQuotaForOrigin", { origin: new URL(server.url).origin, quotaSize: 100_000 });
    };
    const { page, ready, seen } = await open(t, { prepare, before: notesWorkers });
    await ready();
    await until(() => page.evaluate(() => window.workers.length), (asked) => asked > 0, "a worker is asked for");
    await until(
      () => page.evaluate(async () => (await navigator.serviceWorker.getRegistration()) === undefined && (await caches.keys()).length),
      (caches) => caches === 0,
      "a worker that has given up",
    );
    await page.reload();
    await page.locator("#welcome").waitFor({ state: "hidden" });
    assert.deepEqual(seen.errors, []);
  });
  const ways = {
    "no workers, as in a private window of some browsers": () => Object.defineProperty(Navigator.prototype, "serviceWorker", { get: () => undefined }),
    "workers that are refused": () => {
      const refuse = async () => {
        throw new DOMException("The operation is insecure.", "SecurityError");
      };
      ServiceWorkerContainer.prototype.register = refuse;
      ServiceWorkerContainer.prototype.getRegistration = refuse;
    },
    "no storage at all": () => {
      const refuse = {
        get: () => {
          throw new DOMException("The operation is insecure.", "SecurityError");
        },
      };
      for (const name of ["localStorage", "sessionStorage", "caches"]) Object.defineProperty(window, name, refuse);
    },
  };
  for (const [way, before] of Object.entries(ways)) {
    await t.test(way, async (t) => {
      const { page, ready, seen } = await open(t, { before, firstVisit: true });
      await ready();
      await page.getByRole("slider", { name: "pitch stiffness C_mα" }).fill("-0.5");
      await until(async () => page.url(), (url) => url.includes("cm_alpha"), "the scene in the address");
      assert.deepEqual(seen, { ...seen, console: [], errors: [] });
    });
  }
});

test("neither a frame nor a page without a worker beside it keeps anything", async (t) => {
  const { page } = await open(t, { path: "example/embed.html", before: notesWorkers });
  await page.frameLocator("iframe").first().locator("#welcome").waitFor({ state: "hidden" });
  const inside = page.frames()[1];
  await rest(inside);
  assert.deepEqual(await inside.evaluate(() => window.workers), []);
  assert.equal(await page.evaluate(async () => (await navigator.serviceWorker.getRegistrations()).length), 0);
  const { page: bare, ready, seen } = await open(t, { server: { missing: /^sw\.js$/ }, before: notesWorkers });
  await ready();
  const asked = await until(() => bare.evaluate(() => window.workers), ({ length }) => length > 0, "a worker is asked for");
  assert.deepEqual(asked, ["refused"]);
  await frames(bare);
  assert.deepEqual(seen.errors, []);
});

test("the switch takes away what was kept", async (t) => {
  const files = {};
  const { page, ready } = await open(t, { server: { files } });
  await ready();
  await controlled(page);
  files["sw.js"] = dist("sw-off.js");
  await page.reload();
  await until(
    () => page.evaluate(async () => [(await navigator.serviceWorker.getRegistrations()).length, (await caches.keys()).length].join()),
    (left) => left === "0,0",
    "nothing that is left",
  );
  await page.reload();
  await page.locator("#welcome").waitFor({ state: "hidden" });
  assert.equal(await page.evaluate(() => Boolean(navigator.serviceWorker.controller)), false);
});

test("the page can be installed, and its pictures are as large as it says", async (t) => {
  const { page, ready } = await open(t);
  await ready();
  const session = await page.context().newCDPSession(page);
  const { url, errors, data } = await session.send("Page.getAppManifest");
  assert.deepEqual(errors, []);
  await controlled(page);
  // A window of its own, as Playwright opens them, is a private one: that is all the browser has against it.
  const { installabilityErrors } = await session.send("Page.getInstallabilityErrors");
  assert.deepEqual(installabilityErrors.map(({ errorId }) => errorId).filter((id) => id !== "in-incognito"), []);
  const { icons, screenshots } = JSON.parse(data);
  const found = await page.evaluate(
    async ([base, pictures]) =>
      Promise.all(
        pictures.map(async ({ src }) => {
          const image = new Image();
          image.src = new URL(src, base);
          await image.decode();
          return `${image.naturalWidth}x${image.naturalHeight}`;
        }),
      ),
    [url, [...icons, ...screenshots]],
  );
  assert.deepEqual(found, [...icons, ...screenshots].map(({ sizes }) => sizes));
});
