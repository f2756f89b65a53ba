// Called by Trunk's start-up script while it fetches and starts the program.

const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

export default function initializer() {
  const bar = document.getElementById("progress");
  const text = document.getElementById("progress-text");

  return {
    // `total` is the size of the file itself, so the bar is right for compressed transfers too.
    onProgress: ({ current, total }) => {
      bar.value = Math.min(current / total, 1);
      text.textContent =
        current < total ? `Loading: ${megabytes(current)} of ${megabytes(total)} MB` : "Starting";
    },

    onFailure: (reason) => {
      // A program that arrived whole and then stopped, or that this browser can't read, is another matter than one that did
      // not arrive.
      if (reason instanceof WebAssembly.CompileError) {
        const detail = "Eigenwing needs a browser of 2023 or later.";
        window.dispatchEvent(new CustomEvent("eigenwing-failed", { detail }));
      } else {
        const stopped = reason instanceof WebAssembly.RuntimeError;
        window.dispatchEvent(new Event(stopped ? "eigenwing-failed" : "eigenwing-not-loaded"));
      }
    },
  };
}
