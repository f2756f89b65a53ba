// The page without a network: registers `sw.js`, which keeps one whole version of everything, and says when there is a new one. Neither
// in a frame, which belongs to another page, nor in the single-file edition, which has this script not.
(() => {
  const workers = navigator.serviceWorker;
  if (!workers || window.parent !== window) return;
  const { content: version } = document.querySelector('meta[name="eigenwing-version"]');
  const hear = {
    again: () => location.reload(),
    newer: () => window.eigenwing.tell("A new version of Eigenwing has arrived. It begins when you next open the page."),
    new: () => window.eigenwing.tell("This is a new version of Eigenwing."),
  };

  // A newer version that is kept begins now, before anything is done here, unless another tab has the page open. The scene is in the
  // address and in the browser's storage.
  workers.onmessage = ({ data }) => hear[data]();
  const { controller } = workers;
  // A copy of the page in a folder above this one has a worker too, which is not ours.
  if (controller?.scriptURL === new URL("sw.js", document.baseURI).href) controller.postMessage({ begins: version });

  // Once the program is here nothing competes with it for the line.
  window.addEventListener("eigenwing-ready", async () => {
    try {
      const registration = await workers.register("sw.js", { updateViaCache: "none" });
      const follow = () => {
        const next = registration.installing;
        next?.addEventListener("statechange", () => {
          if (next.state === "installed" && registration.active) hear.newer();
        });
      };
      follow();
      registration.addEventListener("updatefound", follow);
      (await workers.ready).active.postMessage({ runs: version });
    } catch {
      // A private window, storage that is refused or full, a host without `sw.js`: then the page needs its network, as any other.
    }
  });
})();
