// Keeps whole versions of the page on the device, so that it opens without a network. `cargo xtask build` puts a line in front:
// VERSION, a hash of everything, and FILES, the hash of each file by its path below the page. docs/HOSTING.md tells how it is meant.
//
// A page and the files that it asks for later are always of one version: each version has a cache of its own, which is filled before
// it is used, and it is remembered which version each open page has begun with. So a new version needs no new worker to be shown:
// the worker that is there shows it. The new one takes its place when no page is open, as browsers do it by themselves. To hasten that
// by `skipWaiting` isn't safe: a page that is just being opened may be shown the old version under the new worker, or never load.

const OWN = `eigenwing ${registration.scope} `;
const CACHE = OWN + VERSION;
// Lies in the cache of a version that came after another, until a page has said so.
const NEW = "is-new";
// What else is remembered: the "newest" version, the "current" one, with which pages begin, and that of each open page by its identity.
const MEMORY = `${OWN}pages`;

async function recall(what) {
  const found = await caches.match(what, { cacheName: MEMORY });
  return found?.text();
}

async function remember(what, version) {
  await (await caches.open(MEMORY)).put(what, new Response(version));
}

// A file of this very version. The browser compares its hash, so nothing is kept of a version that is still being copied to the host.
async function fetched(path) {
  const fetchFrom = (cache) => fetch(path, { integrity: FILES[path], cache });
  const response = await fetchFrom("default").catch(() => fetchFrom("reload"));
  // Without the mark of a redirection, with which a browser refuses a page: some hosts send `notes.html` to `notes`.
  return new Response(response.body, { headers: response.headers });
}

// The page itself comes last: a cache that has it is whole, and may be in use.
const isWhole = (version) => caches.match("./", { cacheName: OWN + version }).then(Boolean);

async function keep() {
  if (!(await isWhole(VERSION))) {
    const cache = await caches.open(CACHE);
    try {
      const { "./": _, ...beside } = FILES;
      await Promise.all(Object.keys(beside).map(async (path) => cache.put(path, await fetched(path))));
      await cache.put("./", await fetched("./"));
    } catch (error) {
      await caches.delete(CACHE);
      throw error;
    }
  }
  await remember("newest", VERSION);
}

// Pages begin with this version from now on.
async function begin(version) {
  const before = await recall("current");
  if (before && before !== version) await (await caches.open(OWN + version)).put(NEW, new Response());
  await remember("current", version);
}

async function forgetAllBut(versions) {
  const kept = [MEMORY, ...versions.map((version) => OWN + version)];
  const others = (await caches.keys()).filter((name) => name.startsWith(OWN) && !kept.includes(name));
  // What is being filled now will be needed.
  if (!registration.installing) await Promise.all(others.map((name) => caches.delete(name)));
  const memory = await caches.open(MEMORY);
  const pages = (await memory.keys()).filter(({ url }) => !/\/(newest|current)$/.test(url));
  await Promise.all(pages.map((page) => memory.delete(page)));
}

// Pages that are just being opened.
const coming = new Set();

async function isAlone() {
  if (coming.size > 0) return false;
  const pages = await clients.matchAll({ includeUncontrolled: true });
  return pages.filter(({ url }) => url.startsWith(registration.scope)).length === 1;
}

// A page has just begun. Where it is the only one and a newer version is kept, it is to begin again with that.
async function renew(version, page) {
  // A page that was reloaded, or a tab that was closed, may take a moment to go.
  for (let i = 0; i < 20; i += 1) {
    const newest = await recall("newest");
    if (!newest || newest === version || !(await isWhole(newest))) return;
    if (await isAlone()) {
      await begin(newest);
      return page.postMessage("again");
    }
    await new Promise((passed) => setTimeout(passed, 100));
  }
}

// A page runs.
async function serve(version, page) {
  if (!(await isWhole(version))) return;
  const newest = (await recall("newest")) ?? VERSION;
  if (await isAlone()) await forgetAllBut([version, newest]);
  await remember(page.id, version);
  // It may be that of a first visit, which began without a worker.
  await clients.claim();
  if (newest !== version) page.postMessage("newer");
  if (await (await caches.open(OWN + version)).delete(NEW)) page.postMessage("new");
}

// What is kept of a page, or of one of its files.
async function kept(path, { request, clientId, resultingClientId: page }) {
  const isPage = request.mode === "navigate";
  if (isPage) {
    coming.add(page);
    // Waits until the page is there, or is known not to come.
    clients.get(page).finally(() => coming.delete(page));
  }
  const current = (await recall("current")) ?? VERSION;
  // Where the storage is full, the page will do with what is current.
  if (isPage) await remember(page, current).catch(() => {});
  const version = isPage ? current : ((await recall(clientId)) ?? current);
  return caches.match(path, { cacheName: OWN + version });
}

addEventListener("install", (event) => event.waitUntil(keep()));
// Browsers do it when no page is open.
addEventListener("activate", (event) => event.waitUntil(begin(VERSION).finally(() => forgetAllBut([VERSION]))));
// A page says its version twice: as it begins, and when it runs.
addEventListener("message", (event) => {
  const { data, source } = event;
  if (data.begins) event.waitUntil(renew(data.begins, source));
  if (data.runs) event.waitUntil(serve(data.runs, source));
});
addEventListener("fetch", (event) => {
  const { method, url } = event.request;
  const { href, pathname } = new URL(url);
  if (method !== "GET" || !href.startsWith(registration.scope)) return;
  const below = pathname.slice(new URL(registration.scope).pathname.length);
  const path = below.replace(/(^|\/)index\.html$/, "$1") || "./";
  // Other files beside the page, such as an instructor's lessons, come from the host.
  const found = kept(path, event).catch(() => undefined);
  event.respondWith(found.then((response) => response ?? fetch(event.request)));
});
