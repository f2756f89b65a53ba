// The page without graphics, for browsers without WebGL: the core computes, this page has only tables and inputs. Its address holds
// the scene as that of the whole page does, so that a link opens in either.

import init, { analyse, link, list, parameters, takeAlong } from "./core/eigenwing-core.js";

const element = (id) => document.getElementById(id);
const shown = (x, digits = 3) => (x === null ? "" : Number(x.toPrecision(digits)).toString().replace("-", "−"));
const begun = (text) => text.charAt(0).toUpperCase() + text.slice(1);
const FIRST = "navion";
// Keys of what an author shows, hides or locks, which this page can't do.
const KEPT = ["hide", "lock", "lesson"];
const REFUSED =
  "This link opens a lesson, or hides or locks something. The page without graphics can’t do that, so it doesn’t open it: it needs a browser with WebGL.";
// A unit of the core as a person reads it, and how many of these one of those is.
const UNITS = { rad: ["°", 180 / Math.PI], "": ["", 1] };
const unitOf = (unit) => UNITS[unit] ?? [unit, 1];

// What is on screen: an aircraft or a link, and what was moved since.
let subject = { aircraft: FIRST };
let set = {};

const request = () => ({ ...subject, set });
const plane = () => element("plane").value;

function made(name, properties = {}, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

// Groups of sliders by their keys. An aircraft starts with the page that its source starts with; all have entries of A and B.
const GROUPS = [
  ["Flight and aircraft", ({ plane }) => plane === null],
  ["Entries of A and B", ({ key }) => /^[ab]_/.test(key)],
  ["Derivatives", () => true],
];

function showSliders() {
  const open = new Set([...element("sliders").querySelectorAll("details[open]")].map(({ id }) => id));
  const groups = new Map(GROUPS.map(([name]) => [name, []]));
  for (const parameter of parameters(request())) {
    if (parameter.plane !== null && parameter.plane !== plane()) continue;
    groups.get(GROUPS.find(([, holds]) => holds(parameter))[0]).push(slider(parameter));
  }
  const isFirst = element("sliders").querySelector("details") === null;
  const details = [...groups].filter(([, sliders]) => sliders.length > 0).map(([name, sliders]) =>
    made("details", { id: name, open: isFirst ? name !== "Entries of A and B" : open.has(name) }, made("summary", { textContent: name }), ...sliders),
  );
  element("sliders").replaceChildren(element("sliders-title"), ...details);
}

function slider({ key, name, meaning, sign, unit, slider, accepted }) {
  const [shownUnit, per] = unitOf(unit);
  const hint = `${key}-hint`;
  const bar = made("input", { type: "range", id: key, min: slider[0] * per, max: slider[1] * per, step: "any" });
  const number = made("input", { type: "number", min: accepted[0] * per, max: accepted[1] * per, step: "any" });
  bar.setAttribute("aria-describedby", hint);
  number.setAttribute("aria-label", `${begun(name)} ${key} in numbers`);
  for (const input of [bar, number]) {
    input.dataset.key = key;
    input.dataset.per = per;
  }
  bar.addEventListener("input", () => move(key, bar.valueAsNumber / per));
  number.addEventListener("change", () => Number.isFinite(number.valueAsNumber) && move(key, number.valueAsNumber / per));
  return made(
    "div",
    { className: "slider", title: `${meaning} ${sign}`.trim() },
    made("label", { htmlFor: key, textContent: begun(name) }, made("code", { textContent: ` ${key}` })),
    bar,
    number,
    made("span", { textContent: shownUnit }),
    made("span", { id: hint, hidden: true, textContent: `${meaning} ${sign}` }),
  );
}

function move(key, value) {
  const before = set;
  set = { ...set, [key]: value };
  if (show()) {
    writeAddress();
  } else {
    // The sentence says why it can't be; the sliders stay where they were.
    set = before;
    showValues();
  }
}

// The scene in the address, and behind the way to the whole page.
function writeAddress() {
  history.replaceState(null, "", link(request()).link);
  leadToWhole();
}

function leadToWhole() {
  element("whole").href = `./${location.hash}`;
}

// The pieces of the address, each with its key as the core reads it.
function pieces() {
  return location.hash.slice(1).split("&").map((piece) => {
    const text = piece.replace(/^amp;/, "");
    try {
      return { text, key: decodeURIComponent(text.split("=")[0]) };
    } catch {
      return { text, key: "" };
    }
  });
}

// The value of every slider: a knob of the aircraft moves coefficients too.
function showValues() {
  for (const { key, value } of parameters(request())) {
    for (const input of document.querySelectorAll(`[data-key="${key}"]`)) {
      const text = String(Number((value * input.dataset.per).toPrecision(5)));
      if (input !== document.activeElement || input.type === "range") input.value = text;
      input.classList.toggle("changed", key in set);
    }
  }
}

function showModes({ modes, dynamic_stability, static_stability, levels }) {
  const worst = modes.find(({ stability }) => stability === dynamic_stability);
  const why =
    dynamic_stability === "unstable" ? `: the ${worst.name.toLowerCase()} doubles every ${shown(worst.time_to_double)} s` : "";
  element("verdict").textContent = `Dynamically ${dynamic_stability}${why}; statically ${static_stability.verdict}`;
  element("modes").replaceChildren(
    ...modes.map(({ name, stability, re, im, natural_frequency, damping_ratio, period, time_to_half, time_to_double }) => {
      const lambda = im > 0 ? `${shown(re)} ± ${shown(im)}j` : shown(re);
      const turns = time_to_half === null ? time_to_double && `doubles: ${shown(time_to_double)}` : `halves: ${shown(time_to_half)}`;
      const cells = [lambda, shown(natural_frequency), shown(damping_ratio), shown(period), turns ?? ""];
      return made("tr", { className: stability }, made("th", { scope: "row", textContent: name }), ...cells.map((textContent) => made("td", { textContent })));
    }),
  );
  const sentences = [...modes.map(({ name, reason }) => `${name}: ${reason}`), ...levels.map(({ sentence }) => sentence)];
  element("reasons").replaceChildren(...sentences.map((textContent) => made("li", { textContent })));
}

function showFigures({ modes }) {
  const texts = {
    poles: `Pole map: ${modes.map(({ name, re, im }) => `${name} at ${shown(re)}${im > 0 ? ` ± ${shown(im)}j` : ""}`).join(", ")}`,
    response: "Response over time after the disturbance of the scene",
  };
  for (const [name, alt] of Object.entries(texts)) {
    const { text } = takeAlong({ ...request(), plane: plane(), target: `${name}-figure` });
    Object.assign(element(name), { src: `data:image/svg+xml,${encodeURIComponent(text)}`, alt });
  }
}

// Shows everything as it is now, or the sentence that says why that can't be; then false.
function show() {
  try {
    const { aircraft, status_now, notices, ...planes } = analyse(request());
    const found = planes[plane()];
    if (found === null) throw new Error(`${aircraft.name} has no data of this motion.`);
    if (found.error) throw new Error(found.error);
    element("source").textContent = `${begun(status_now)}. Source: ${aircraft.source.replace(/\.*$/, "")}.`;
    showModes(found);
    showFigures(found);
    showValues();
    element("problem").textContent = notices.join(" ");
    return true;
  } catch ({ message }) {
    element("problem").textContent = message;
    return false;
  }
}

function open(wanted) {
  subject = wanted;
  set = {};
  try {
    const { aircraft, longitudinal } = analyse(subject);
    element("aircraft").value = aircraft.key;
    if (longitudinal === null) element("plane").value = "lateral";
  } catch {
    // What is wrong with a link is said by `show`.
  }
  element("sliders").replaceChildren(element("sliders-title"));
  begin();
}

function begin() {
  try {
    showSliders();
  } catch ({ message }) {
    element("problem").textContent = message;
    return;
  }
  show();
}

try {
  await init();
  const options = list().map(({ key, name, condition }) => made("option", { value: key, textContent: `${name}: ${condition}` }));
  element("aircraft").replaceChildren(...options);
  const fromAddress = () => {
    leadToWhole();
    const isRefused = pieces().some(({ key }) => KEPT.includes(key));
    for (const id of ["choice", "source", "columns"]) element(id).hidden = isRefused;
    if (isRefused) {
      element("problem").textContent = REFUSED;
      // The page around a frame may have something else to show.
      if (window.parent !== window) window.parent.postMessage({ eigenwing: 1, type: "error", sentence: REFUSED }, "*");
    } else {
      open(location.hash.length > 1 ? { link: location.hash } : { aircraft: FIRST });
    }
  };
  element("aircraft").addEventListener("change", ({ target }) => {
    open({ aircraft: target.value });
    writeAddress();
  });
  element("plane").addEventListener("change", begin);
  element("reset").addEventListener("click", () => {
    const key = element("aircraft").value;
    // One of a person's own is in no list: it is what the address says of it without its edits.
    const own = pieces().filter(({ key }) => key === "own" || key === "ac");
    open(key ? { aircraft: key } : { link: `#v=1&${own.map(({ text }) => text).join("&")}` });
    writeAddress();
  });
  window.addEventListener("hashchange", fromAddress);
  fromAddress();
} catch {
  element("problem").textContent = "The model could not be loaded. Check the connection and reload; if it stays like this, a newer browser may help.";
}
