// The notes of a lecture: follows the page that presents it, and can turn its slides. A plain script without the program.
//
// Both speak on the BroadcastChannel whose name stands behind the # of this window's address, or is the window's own in the single-file
// edition, where it has no address; each page of a lecture has its own. There is one kind of message, a text of JSON,
// { "eigenwing": 1, "says": … }; what is of another version or says something else is passed over.
//
//   the page says
//     cue     how the lecture stands: `since`, how long ago it began [ms], and `cue`:
//             slide, slides            the slide on screen counted from 1, and how many there are
//             title, notes             its heading, and its notes as lines { kind, depth, mark, text }
//             question, hands          what it asks or null, and { says, count, right } for each choice
//             revealed                 how many of its questions have been answered, and how many there are
//             next                     { title, question } of the next slide, or null
//             minutes, until, total    what it is to take, when it is to be over since the start, the whole lecture [min]; or null
//             blank                    whether the screen is black
//     over    nothing is presented
//   this window says
//     hello   it is here and wants to know how the lecture stands
//     next, back, blank   what Page Down, Page Up and B do on the page
(() => {
  const VERSION = 1;
  const element = (id) => document.getElementById(id);
  const name = location.hash.slice(1) || window.name;
  if (!/^eigenwing-\d+$/.test(name) || typeof BroadcastChannel !== "function") {
    element("state").textContent = "These are the notes of a lecture. They are opened by the key N while Eigenwing presents.";
    element("back").disabled = element("next").disabled = element("blank").disabled = true;
    return;
  }

  const channel = new BroadcastChannel(name);
  const say = (says) => channel.postMessage(JSON.stringify({ eigenwing: VERSION, says }));
  // By the clock that nobody can set.
  let began = null;
  let cue = null;

  // Everything from the lesson is text, never HTML.
  function line({ kind, depth, mark, text }) {
    const made = document.createElement({ heading: "h3", code: "pre" }[kind] ?? "p");
    if (kind === "item") {
      made.className = `item depth-${Math.min(Number(depth) || 1, 3)}`;
      const before = document.createElement("span");
      before.textContent = mark;
      const words = document.createElement("span");
      words.textContent = text;
      made.append(before, words);
    } else {
      if (kind === "quote") made.className = "quote";
      made.textContent = text;
    }
    return made;
  }

  function hand({ says, count, right }) {
    const made = document.createElement("li");
    made.textContent = `${says}${right ? " ✓" : ""}: ${count}`;
    if (right) made.className = "right";
    return made;
  }

  function show() {
    element("place").textContent = `Slide ${cue.slide} of ${cue.slides}`;
    element("title").textContent = cue.title;
    const [answered, questions] = cue.revealed;
    const after = questions > 0 && answered >= questions ? " (answered)" : "";
    element("question").textContent = cue.question ? cue.question + after : "";
    element("question").hidden = !cue.question;
    element("hands").replaceChildren(...cue.hands.map(hand));
    element("hands").hidden = cue.hands.length === 0;
    element("notes").replaceChildren(...cue.notes.map(line));
    element("next-title").textContent = cue.next ? cue.next.title : "The last slide";
    element("next-question").textContent = cue.next?.question ?? "";
    element("state").textContent = cue.blank ? "The screen is black." : "";
    element("state").hidden = !cue.blank;
    element("lecture").hidden = false;
  }

  const clockOf = (seconds) => `${Math.floor(seconds / 60)}:${String(Math.floor(seconds % 60)).padStart(2, "0")}`;

  function tick() {
    element("clock").textContent = new Date().toLocaleTimeString([], { hour: "2-digit", minute: "2-digit" });
    if (began === null) return;
    const minutes = (performance.now() - began) / 60000;
    element("since").textContent = clockOf(Math.max(0, minutes * 60));
    const plan = element("plan");
    const words = [];
    if (cue?.minutes != null) words.push(`slide ${cue.minutes} min`);
    if (cue?.until != null) words.push(`to be over at ${clockOf(cue.until * 60)}`);
    if (cue?.total != null) words.push(`of ${clockOf(cue.total * 60)}`);
    plan.className = cue?.until != null && minutes > cue.until ? "late" : "";
    plan.textContent = words.join(", ") + (plan.className ? ": late" : "");
  }

  channel.onmessage = ({ data }) => {
    let message;
    try {
      message = JSON.parse(data);
    } catch {
      return;
    }
    if (message?.eigenwing !== VERSION) return;
    if (message.says === "cue") {
      began = performance.now() - message.since;
      ({ cue } = message);
      show();
    } else if (message.says === "over") {
      began = cue = null;
      element("state").textContent = "The lecture is not on the screen. The key F begins it, N on its page opens these notes again.";
      element("state").hidden = false;
      element("lecture").hidden = true;
    }
    tick();
  };

  const keys = { PageDown: "next", ArrowRight: "next", PageUp: "back", ArrowLeft: "back", b: "blank", B: "blank", ".": "blank" };
  addEventListener("keydown", (event) => {
    const says = event.repeat || event.ctrlKey || event.metaKey || event.altKey ? undefined : keys[event.key];
    if (!says) return;
    event.preventDefault();
    say(says);
  });
  for (const id of ["back", "next", "blank"]) element(id).addEventListener("click", () => say(id));

  setInterval(tick, 500);
  tick();
  say("hello");
})();
