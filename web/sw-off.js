// The worker that takes itself away, with all that was kept: copied over `sw.js` on a host, it turns the offline page off at everyone's
// next start (docs/HOSTING.md). A page that is built to be looked at has it as its `sw.js`.

addEventListener("install", () => skipWaiting());
addEventListener("activate", (event) =>
  event.waitUntil(
    (async () => {
      const own = (await caches.keys()).filter((name) => name.startsWith(`eigenwing ${registration.scope} `));
      await Promise.all(own.map((name) => caches.delete(name)));
      await registration.unregister();
    })(),
  ),
);
