// The page around a frame of Eigenwing: it listens to what the frame tells, and asks for a few things.

const VERSION = 1;
const SCENE =
  "#v=1&ac=navion&lon.source=vertical-gust&stage=derivatives.poles&offer=cm_alpha.cm_q&lock=aircraft.plane";
const LESSON = "#v=1&lesson=longitudinal&step=1";

const frame = document.getElementById("frame");
const log = document.getElementById("log");

addEventListener("message", ({ source, data }) => {
  // Any window may send messages here.
  if (source !== frame.contentWindow || data?.eigenwing !== VERSION) return;
  if (data.type === "height") frame.height = data.height;
  const line = document.createElement("li");
  line.textContent = JSON.stringify(data);
  log.append(line);
});

const ask = (request) => frame.contentWindow.postMessage({ eigenwing: VERSION, ...request }, "*");

for (const [id, request] of [
  ["scene", { type: "open", link: SCENE }],
  ["lesson", { type: "open", link: LESSON }],
  ["dark", { type: "look", look: "dark" }],
  ["system", { type: "look", look: "system" }],
  ["report", { type: "ask-report" }],
]) {
  document.getElementById(id).addEventListener("click", () => ask(request));
}
