// Starts the program of the single-file edition. All that it needs is in this page: from a file nothing can be fetched.
(async () => {
  const unpacked = (id) => {
    const packed = Uint8Array.from(atob(document.getElementById(id).textContent), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip")));
  };
  try {
    const files = await unpacked("files").json();
    window.fetch = async (path) => (path in files ? new Response(files[path]) : new Response(null, { status: 404 }));
    // The notes of a lecture are written into their window, where they can't be fetched either.
    const { open } = window;
    window.open = (address, name, features) => {
      if (!address.startsWith("notes.html#")) return open.call(window, address, name, features);
      const notes = open.call(window, "", name, features);
      if (notes && !notes.document.getElementById("lecture")) {
        notes.document.write(files["notes.html"]);
        notes.document.close();
      }
      return notes;
    };
    // A person may have opened it with a scene of their own.
    if (location.hash.length < 2) location.replace(`#${document.getElementById("files").dataset.link}`);
    await wasm_bindgen({ module_or_path: await unpacked("program").arrayBuffer() });
  } catch (reason) {
    dispatchEvent(new CustomEvent("eigenwing-failed", { detail: reason instanceof WebAssembly.RuntimeError ? "" : String(reason) }));
  }
})();
