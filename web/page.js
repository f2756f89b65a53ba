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
  // Name in the session's storage of when the page last started again with the graphics.
  const RESTORED = "eigenwing.restored";

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

  // What may help to mend a mistake: the version, what the program said, the scene, the browser and its window. An aircraft of a
  // person's own stays out of it, and so do their name and where the page is.
  function report(text) {
    const { content: version } = document.querySelector('meta[name="eigenwing-version"]');
    return [
      `Eigenwing ${/^\d/.test(version) ? version : "as built from its sources"}`,
      text,
      `scene: ${location.hash.replace(/((?:^#|[&.;])(?:own|by)=)[^&]*/g, "$1…") || "none"}`,
      `browser: ${navigator.userAgent}`,
      `window: ${innerWidth} × ${innerHeight} points, ${devicePixelRatio} pixels each`,
    ].join("\n");
  }

  function offerReport(text) {
    element("report").hidden = false;
    element("report-text").value = report(text);
  }

  function canDrawWithWebGl() {
    const canvas = document.createElement("canvas");
    return Boolean(canvas.getContext("webgl2") ?? canvas.getContext("webgl"));
  }

  function failWith(detail) {
    if (ready) {
      const text = detail || "The program met a mistake of its own and cannot go on.";
      fail("Eigenwing has stopped", text, "The scene is kept: reload to go on with it. If it stops again, start without it.");
      element("afresh").hidden = false;
      offerReport(text);
    } else if (!canDrawWithWebGl()) {
      // The same numbers as a plain page; the single-file edition has none beside it.
      if (document.querySelector('link[rel="manifest"]')) return location.replace(`plain.html${location.hash}`);
      fail(
        "This browser cannot show the graphics",
        "Eigenwing draws with WebGL, and this browser doesn’t offer it here.",
        "Turning on hardware acceleration in the browser’s settings, updating the browser, or using another one usually helps.",
      );
    } else {
      const text = detail || "The program could not be started in this browser.";
      fail("Eigenwing could not start", text, "Reload to try again. If it stays like this, a newer browser may help.");
      // It may be the scene that it starts with.
      element("afresh").hidden = false;
      offerReport(text);
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
  // from a field that is being typed in. So do the wheel and a finger that goes up or down: they scroll the page around the frame
  // until a person presses in here, and again once they have left.
  if (window.parent !== window) {
    const { focus } = HTMLElement.prototype;
    const canvas = element("eigenwing");
    let isUsed = false;
    let isPressed = false;
    const press = (is) => {
      isPressed = is;
      canvas.style.touchAction = is ? "none" : "pan-y";
    };
    press(false);
    const hear = (names, heard) => {
      for (const name of names) window.addEventListener(name, heard, { capture: true });
    };
    hear(["pointerdown", "keydown"], () => (isUsed = true));
    HTMLElement.prototype.focus = function (...rest) {
      if (isUsed || document.hasFocus()) focus.apply(this, rest);
    };
    // A finger has pressed when it has gone without scrolling.
    hear(["pointerdown"], ({ pointerType }) => pointerType === "touch" || press(true));
    hear(["pointerup"], () => press(true));
    document.documentElement.addEventListener("pointerleave", ({ pointerType }) => pointerType === "touch" || press(false));
    window.addEventListener("blur", () => {
      isUsed = false;
      press(false);
    });
    hear(["wheel"], (event) => isPressed || event.stopImmediatePropagation());
    // The program forbids what a browser does with fingers, which is here to scroll.
    hear(["touchstart", "touchmove"], (event) => isPressed || (event.preventDefault = () => {}));
  }

  // What the program draws grows with the size of type that a person has asked the browser for.
  const { documentElement: root } = document;
  root.dataset.type = String(parseFloat(getComputedStyle(root).fontSize) / 16);

  element("reload").addEventListener("click", () => location.reload());
  element("afresh").addEventListener("click", () => {
    try {
      localStorage.removeItem("eigenwing.last-scene");
    } catch {
      // Then none is kept there.
    }
    history.replaceState(null, "", location.pathname + location.search);
    location.reload();
  });
  element("copy-report").addEventListener("click", async () => {
    element("report-text").select();
    try {
      await navigator.clipboard.writeText(element("report-text").value);
      element("copy-report").textContent = "Copied";
    } catch {
      // Not granted: it is selected, for the person to copy.
    }
  });

  window.addEventListener("eigenwing-ready", () => {
    ready = true;
    // The single-file edition has nothing to hear it with.
    element("hear").hidden = failed || element("files") !== null;
    // The program's own field, which hears the keyboard while the canvas is worked.
    document.querySelector("#eigenwing + input")?.setAttribute("aria-label", "Keys for the drawn page");
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

  // Phones take the graphics away from pages in the background, and give them back later: the page then starts again by itself, with
  // the scene of its address. Not twice within a minute, for where they don't last.
  element("eigenwing").addEventListener("webglcontextlost", (event) => {
    event.preventDefault();
    fail(
      "The graphics were interrupted",
      "The browser took the graphics away from this page, perhaps to save memory.",
      "The scene is kept. The page goes on when the browser gives the graphics back, or when you reload.",
    );
  });
  element("eigenwing").addEventListener("webglcontextrestored", () => {
    try {
      const now = Date.now();
      const before = Number(sessionStorage.getItem(RESTORED));
      sessionStorage.setItem(RESTORED, now);
      if (Math.abs(now - before) > 60_000) location.reload();
    } catch {
      // Without a memory of it the person decides.
    }
  });

  if (typeof WebAssembly !== "object" || !("noModule" in HTMLScriptElement.prototype)) {
    fail(
      "This browser is too old",
      "Eigenwing needs WebAssembly and JavaScript modules, which this browser doesn’t have.",
      "Please open this page in a current browser.",
    );
  }

  // The core as a module of its own: readers and writers of files, loaded when the first is asked for. A function of it by its name;
  // the answer comes as JSON.
  let core;
  window.eigenwingCore = async (name, ...args) => {
    core ??= import(new URL("core/eigenwing-core.js", document.baseURI)).then(async (module) => {
      await module.default();
      return module;
    });
    let module;
    try {
      module = await core;
    } catch {
      // Another try may have a connection.
      core = undefined;
      throw new Error("The part of the page that reads and writes files can’t be fetched. Is there a connection?");
    }
    return JSON.stringify(module[name](...args));
  };

  function save(name, blob) {
    const anchor = document.createElement("a");
    anchor.href = URL.createObjectURL(blob);
    anchor.download = name;
    anchor.click();
    URL.revokeObjectURL(anchor.href);
  }

  // A figure as a picture of 300 dots an inch, saved or copied; says what came of it. One that can't be copied is saved.
  window.eigenwingPicture = async (name, svg, copies) => {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
    await image.decode();
    const canvas = document.createElement("canvas");
    const scale = 300 / 96;
    canvas.width = Math.round(scale * image.naturalWidth);
    canvas.height = Math.round(scale * image.naturalHeight);
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    const blob = await new Promise((done) => canvas.toBlob(done, "image/png"));
    if (copies) {
      try {
        await navigator.clipboard.write([new ClipboardItem({ "image/png": blob })]);
        return `Copied: ${name}`;
      } catch {
        // Not every browser lets a page do that.
      }
    }
    save(name, blob);
    return `Saved: ${name}`;
  };

  // A page on paper, out of a frame that nobody sees. Its style goes in as a sheet, since the policy of this page allows no other.
  window.eigenwingPrint = (html) => {
    const page = new DOMParser().parseFromString(html, "text/html");
    const frame = document.createElement("iframe");
    frame.className = "paper";
    frame.setAttribute("aria-hidden", "true");
    frame.tabIndex = -1;
    document.body.append(frame);
    const { contentWindow: inside, contentDocument: paper } = frame;
    const sheet = new inside.CSSStyleSheet();
    sheet.replaceSync([...page.querySelectorAll("style")].map((style) => style.textContent).join(""));
    paper.adoptedStyleSheets = [sheet];
    paper.documentElement.lang = page.documentElement.lang;
    paper.title = page.title;
    paper.body.replaceChildren(...[...page.body.childNodes].map((node) => paper.importNode(node, true)));
    // A browser names the file of a print after the page itself.
    const title = document.title;
    document.title = page.title;
    const done = () => {
      document.title = title;
      frame.remove();
      element("eigenwing").focus();
    };
    inside.addEventListener("afterprint", done, { once: true });
    inside.print();
  };

  // The response as a tone.
  element("hear").addEventListener("click", async () => {
    let sentence;
    try {
      const { hear } = await import(new URL("sound.js", document.baseURI));
      sentence = await hear(location.hash, window.eigenwingCore);
    } catch (reason) {
      sentence = reason.message;
    }
    element("announcements").textContent = sentence;
  });
})();
