// The response as a tone: pitch for value, from the left ear to the right for time. Off until its button is pressed, which a screen
// reader and the Tab key find and nobody else sees. Loaded when it is pressed first.

// The largest value is an octave above the middle, the opposite one an octave below [Hz].
const MIDDLE = 440;
// How long it takes [s], whatever the time of the motion.
const LASTS = 5;
// A tone that begins and ends at once would crack [s].
const EASE = 0.03;
// Before it, the sentence that says what is heard is read [s].
const BEFORE = 2.5;

// Outputs by their keys.
const NAMES = {
  u: "Change of speed",
  alpha: "Angle of attack",
  q: "Pitch rate",
  theta: "Pitch angle",
  gamma: "Path angle",
  h: "Height",
  beta: "Sideslip",
  p: "Roll rate",
  r: "Yaw rate",
  phi: "Bank angle",
  psi: "Heading",
};

let sounding;

// Falls silent. Says whether there was something to be heard.
function silence() {
  const was = sounding;
  sounding = undefined;
  was?.close();
  return was !== undefined;
}

function play(values, from) {
  const largest = values.reduce((most, value) => Math.max(most, Math.abs(value)), 0) || 1;
  const pitches = Float32Array.from(values, (value) => MIDDLE * 2 ** (value / largest));
  const context = new AudioContext();
  sounding = context;
  const begins = context.currentTime + from;
  const tone = new OscillatorNode(context, { type: "triangle", frequency: pitches[0] });
  const side = new StereoPannerNode(context, { pan: -0.9 });
  const level = new GainNode(context, { gain: 0 });
  tone.frequency.setValueCurveAtTime(pitches, begins, LASTS);
  side.pan.setValueAtTime(-0.9, begins).linearRampToValueAtTime(0.9, begins + LASTS);
  level.gain.setValueAtTime(0, begins).linearRampToValueAtTime(0.25, begins + EASE);
  level.gain.setValueAtTime(0.25, begins + LASTS).linearRampToValueAtTime(0, begins + LASTS + EASE);
  tone.connect(side).connect(level).connect(context.destination);
  tone.start(begins);
  tone.stop(begins + LASTS + 2 * EASE);
  tone.onended = () => sounding === context && silence();
}

// What is heard, in a sentence, or why nothing is. `link` is the scene, `core` asks the core as a module.
export async function hear(link, core) {
  if (silence()) return "Silent.";
  const words = Object.fromEntries(new URLSearchParams(link.replace(/^#/, "").replaceAll("+", "%2B")));
  if (words.hide?.split(".").includes("curves")) return "The curves are hidden here, so they can’t be heard either.";
  // A lesson beside it is no part of the scene.
  const scene = link.replace(/&(lesson|step|present|by|help)=[^&]*/g, "");
  const motion = JSON.parse(await core("respond", { link: scene }));
  const { time, outputs } = motion;
  const shown = words[motion.plane === "lateral" ? "lat.show" : "lon.show"]?.split(".")[0];
  // As it flies: under its law, where it has one.
  const flown = motion.closed_loop?.outputs ?? outputs;
  const { name, values } = flown.find((output) => output.name === shown) ?? flown[0];
  if (values.length < 2) return "There is nothing to be heard.";
  play(values, BEFORE);
  const last = Math.round(time[values.length - 1]);
  return `${NAMES[name] ?? name} over ${last} seconds, in ${LASTS}: the higher the tone, the larger the value. In the middle it is zero.`;
}
