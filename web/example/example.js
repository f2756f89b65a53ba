// Eigenwing's core in a page: a list of aircraft, the modes of one, and its motion after a disturbance.
// The requests and answers are described in ../core/eigenwing-core.d.ts.

import init, { analyse, list, respond } from "../core/eigenwing-core.js";

// What disturbs each plane of motion, and in which shape.
const DISTURBANCES = {
  longitudinal: ["elevator step", "elevator doublet", "throttle step", "vertical-gust 1-cosine"],
  lateral: ["rudder pulse", "aileron doublet", "side-gust 1-cosine"],
};
const PLOT = { width: 640, height: 240, margin: 16 };

const element = (id) => document.getElementById(id);
const shown = (x, digits = 3) => (x === null ? "" : Number(x.toPrecision(digits)).toString().replace("-", "−"));

function option(value, text = value) {
  const option = document.createElement("option");
  [option.value, option.textContent] = [value, text];
  return option;
}

// Offers the disturbances of the planes of motion that the aircraft has data of.
function showDisturbances({ planes }) {
  const before = element("disturbance").value;
  const names = planes.flatMap((plane) => DISTURBANCES[plane]);
  element("disturbance").replaceChildren(...names.map((name) => option(name)));
  element("disturbance").value = names.includes(before) ? before : names[0];
}

function showModes({ modes, dynamic_stability, static_stability }, plane) {
  element("verdict").textContent =
    `${plane} motion: dynamically ${dynamic_stability}, statically ${static_stability.verdict}`;
  element("modes").replaceChildren(
    ...modes.map((mode) => {
      const row = document.createElement("tr");
      row.title = mode.reason;
      const { name, re, im, damping_ratio, period, time_to_half, time_to_double } = mode;
      const lambda = im > 0 ? `${shown(re)} ± ${shown(im)}j` : shown(re);
      for (const text of [name, lambda, ...[damping_ratio, period, time_to_half, time_to_double].map((x) => shown(x))]) {
        row.insertCell().textContent = text;
      }
      return row;
    }),
  );
}

// The attitude: pitch angle, or bank angle, in degrees.
function showMotion({ time, inputs, outputs }) {
  const { name, values } = outputs.find(({ name }) => name === "theta" || name === "phi");
  const degrees = values.map((x) => (x * 180) / Math.PI);
  const [low, high] = [Math.min(...degrees, 0), Math.max(...degrees, 0)];
  const { width, height, margin } = PLOT;
  const y = (value) => height - margin - ((value - low) / (high - low || 1)) * (height - 2 * margin);
  const points = degrees.map((value, k) => `${(width * time[k]) / time.at(-1)},${y(value)}`);
  element("line").setAttribute("points", points.join(" "));
  for (const end of ["y1", "y2"]) element("zero").setAttribute(end, y(0));
  const [input] = inputs;
  const size = input.values.reduce((a, b) => (Math.abs(b) > Math.abs(a) ? b : a), 0);
  element("plot-text").textContent =
    `${name === "phi" ? "Bank angle φ" : "Pitch angle θ"} over ${shown(time.at(-1))} s, from ${shown(low)}° to ` +
    `${shown(high)}°, after ${input.name.replace("_", " ")} ${shown(size)} ${input.unit}`;
}

function show() {
  element("problem").textContent = "";
  try {
    const aircraft = element("aircraft").value;
    const [disturbance, shape] = element("disturbance").value.split(" ");
    const motion = respond({ aircraft, disturbance, shape });
    const analysis = analyse({ aircraft });
    showModes(analysis[motion.plane], motion.plane === "lateral" ? "Lateral–directional" : "Longitudinal");
    showMotion(motion);
  } catch (error) {
    // What can't be answered is an Error with one sentence.
    element("problem").textContent = error.message;
  }
}

await init();
const aircraft = list();
element("aircraft").replaceChildren(...aircraft.map(({ key, name, condition }) => option(key, `${name}: ${condition}`)));
element("aircraft").addEventListener("change", () => {
  showDisturbances(aircraft.find(({ key }) => key === element("aircraft").value));
  show();
});
element("disturbance").addEventListener("change", show);
showDisturbances(aircraft[0]);
show();
