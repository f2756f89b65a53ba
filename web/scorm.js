// Tells a learning platform, by SCORM 1.2, what is done in the lesson in the frame: the share of its steps that are done as score,
// completed once all are, and what was answered as a note to go on with.
(() => {
  const MOST = 4096; // characters of the note, by the standard
  const frame = document.getElementById("lesson");

  // The platform's object is in a window around this one, or around the one that has opened it.
  const search = (window) => {
    try {
      for (let around = window, i = 0; around && i < 10; around = around.parent, i += 1) {
        if (around.API) return around.API;
        if (around.parent === around) break;
      }
    } catch {
      // A window of another origin has nothing for this one.
    }
    return undefined;
  };
  const api = search(window) ?? search(window.opener);
  const get = (name) => api?.LMSGetValue(`cmi.${name}`) ?? "";
  const set = (name, value) => api?.LMSSetValue(`cmi.${name}`, String(value));
  const ask = (request) => frame.contentWindow.postMessage({ eigenwing: 1, ...request }, "*");

  // By the clock that nobody can set.
  const began = performance.now();
  api?.LMSInitialize("");
  if (["", "not attempted"].includes(get("core.lesson_status"))) set("core.lesson_status", "incomplete");
  set("core.score.min", 0);
  set("core.score.max", 100);

  function goOn() {
    try {
      ask({ type: "take-up", records: JSON.parse(get("suspend_data")) });
    } catch {
      // The first time, or a note of something else.
    }
  }

  function tell({ done, steps }) {
    const score = Math.round((100 * done) / steps);
    if (score > Number(get("core.score.raw"))) set("core.score.raw", score);
    if (done === steps) set("core.lesson_status", "completed");
    ask({ type: "ask-report" });
  }

  function keep({ lessons }) {
    // The platform knows who it is, and has the file.
    const bare = Object.entries(lessons).map(([key, { files, ...record }]) => [key, record]);
    const note = JSON.stringify({ lessons: Object.fromEntries(bare) });
    if (note.length <= MOST) set("suspend_data", note);
    api?.LMSCommit("");
  }

  addEventListener("message", ({ source, data }) => {
    if (source !== frame.contentWindow || data?.eigenwing !== 1) return;
    if (data.type === "ready") goOn();
    if (["step-opened", "answered", "goal-reached"].includes(data.type)) tell(data);
    if (data.type === "report") keep(data.records);
  });

  addEventListener("pagehide", () => {
    const seconds = Math.round((performance.now() - began) / 1000);
    const two = (number) => String(Math.floor(number)).padStart(2, "0");
    set("core.session_time", `${two(seconds / 3600)}:${two((seconds / 60) % 60)}:${two(seconds % 60)}`);
    set("core.exit", "suspend");
    api?.LMSFinish("");
  });

  frame.src = "lesson.html";
})();
