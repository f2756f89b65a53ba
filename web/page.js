// What the page says before the program runs, and when it cannot. A plain script, not a module:
// it has to work where modules and WebAssembly don't.
//
// The program reports by two events on `window`:
//   eigenwing-ready    the first frame has been drawn
//   eigenwing-failed   it cannot start or has stopped; `detail` is a sentence that says why
(() => {
  const element = (id) => document.getElementById(id);
  let ready = false;
  let failed = false;

  function fail(title, text, advice) {
    // The first reason is the cause; what follows it is noise.
    if (failed) return;
    failed = true;
    element("failure-title").textContent = title;
    element("failure-text").textContent = text;
    element("failure-advice").textContent = advice;
    element("loading").hidden = true;
    element("failure").hidden = false;
    element("welcome").hidden = false;
    // A stopped program must not be reached behind the message, by keyboard or screen reader.
    element("eigenwing").inert = true;
    element("mirror").replaceChildren();
  }

  function canDrawWithWebGl() {
    const canvas = document.createElement("canvas");
    return Boolean(canvas.getContext("webgl2") ?? canvas.getContext("webgl"));
  }

  function failWith(detail) {
    if (ready) {
      fail(
        "Eigenwing has stopped",
        detail || "The program met a mistake of its own and cannot go on.",
        "Reload to start again.",
      );
    } else if (!canDrawWithWebGl()) {
      fail(
        "This browser cannot show the graphics",
        "Eigenwing draws with WebGL, and this browser doesn’t offer it here.",
        "Turning on hardware acceleration in the browser’s settings, updating the browser, or using another one usually helps.",
      );
    } else {
      fail(
        "Eigenwing could not start",
        detail || "The program could not be started in this browser.",
        "Reload to try again. If it stays like this, a newer browser may help.",
      );
    }
  }

  function failToLoad() {
    fail(
      "Eigenwing could not be loaded",
      "A part of the page did not arrive.",
      "Check the connection and reload. If it stays like this, a newer browser may help.",
    );
  }

  element("shut-off").remove();

  // In a frame the keyboard stays where it is until a person comes here: the program asks for it as it starts, and would take it
  // from a field that is being typed in.
  if (window.parent !== window) {
    const { focus } = HTMLElement.prototype;
    let isUsed = false;
    const use = () => (isUsed = true);
    for (const event of ["pointerdown", "keydown"]) window.addEventListener(event, use, { capture: true });
    HTMLElement.prototype.focus = function (...rest) {
      if (isUsed || document.hasFocus()) focus.apply(this, rest);
    };
  }

  element("reload").addEventListener("click", () => location.reload());

  window.addEventListener("eigenwing-ready", () => {
    ready = true;
    if (!failed) element("welcome").hidden = true;
  });

  window.addEventListener("eigenwing-failed", (event) => failWith(event.detail));
  window.addEventListener("eigenwing-not-loaded", failToLoad);

  window.addEventListener(
    "error",
    (event) => {
      if (event.target instanceof HTMLScriptElement) {
        // A script did not arrive. Such errors don't bubble, hence the capturing listener.
        failToLoad();
      } else if (typeof WebAssembly === "object" && event.error instanceof WebAssembly.RuntimeError) {
        // The program stopped without a word.
        failWith();
      }
    },
    true,
  );

  // Phones take the graphics away from pages in the background.
  element("eigenwing").addEventListener("webglcontextlost", () =>
    fail(
      "The graphics were interrupted",
      "The browser took the graphics away from this page, perhaps to save memory.",
      "Reload to go on.",
    ),
  );

  if (typeof WebAssembly !== "object" || !("noModule" in HTMLScriptElement.prototype)) {
    fail(
      "This browser is too old",
      "Eigenwing needs WebAssembly and JavaScript modules, which this browser doesn’t have.",
      "Please open this page in a current browser.",
    );
  }
})();
