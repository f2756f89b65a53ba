// The page in WebKitGTK, whose engine is Safari's: that it starts, and that a slider follows keyboard and mouse. By WebDriver itself, which
// is four requests, in Debian's MiniBrowser.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createServer } from "node:net";
import { test } from "node:test";
import { until } from "../page.mjs";
import { open as openScreen } from "../screen.mjs";
import { serve } from "../server.mjs";

const BROWSER = process.env.MINIBROWSER ?? "/usr/lib/x86_64-linux-gnu/webkit2gtk-4.1/MiniBrowser";
const PITCH_STIFFNESS = "pitch stiffness C_mα";
// No request takes as long.
const LONGEST = 120_000;

async function freePort() {
  const server = createServer().listen(0, "127.0.0.1");
  await once(server, "listening");
  const { port } = server.address();
  server.close();
  await once(server, "close");
  return port;
}

// Asks the driver, and ends what was begun with the test.
async function begin(t) {
  const screen = await openScreen();
  // As root, as in a container, WebKit can't shut itself off.
  const environment = { ...screen.environment, WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS: "1" };
  const port = await freePort();
  const driver = spawn("WebKitWebDriver", [`--port=${port}`], { env: environment, stdio: "ignore" });
  const ask = async (method, path, body) => {
    const signal = AbortSignal.timeout(LONGEST);
    const response = await fetch(`http://127.0.0.1:${port}${path}`, { method, signal, body: body && JSON.stringify(body) });
    const { value } = await response.json();
    if (!response.ok) throw new Error(value.message);
    return value;
  };
  let session;
  t.after(async () => {
    // With the session ends the browser.
    if (session) await ask("DELETE", session).catch(() => {});
    driver.kill();
    screen.close();
  });
  await until(() => ask("GET", "/status"), ({ ready }) => ready, "the driver", LONGEST);
  const options = { binary: BROWSER, args: ["--automation"] };
  const { sessionId } = await ask("POST", "/session", { capabilities: { alwaysMatch: { "webkitgtk:browserOptions": options } } });
  session = `/session/${sessionId}`;
  return (method, path, body) => ask(method, session + path, body);
}

test("in WebKitGTK the page starts, and a slider follows keyboard and mouse into the address", async (t) => {
  const ask = await begin(t);
  const server = await serve();
  t.after(() => server.close());
  const run = (script, ...args) => ask("POST", "/execute/sync", { script, args });
  await ask("POST", "/timeouts", { script: LONGEST, pageLoad: LONGEST });
  await ask("POST", "/window/rect", { width: 1440, height: 900 });
  await ask("POST", "/url", { url: server.url });
  // Without a graphics card it is the slowest of the three.
  await until(() => run("return document.getElementById('welcome').hidden"), Boolean, "the first frame", 2 * LONGEST);
  assert.equal(await run("return location.pathname"), new URL(server.url).pathname, "not the page without graphics");

  const stiffness = async () => JSON.parse(await run("return eigenwing.state()")).parameters.cm_alpha;
  const before = await stiffness();
  const slider = "document.querySelector(`#mirror input[type=range][aria-label='${arguments[0]}']`)";
  await run(`${slider}.focus()`, PITCH_STIFFNESS);
  // Each by itself, in a frame of its own.
  const act = async (type, id, action) => {
    await ask("POST", "/actions", { actions: [{ type, id, actions: [action] }] });
    await ask("POST", "/execute/async", { script: "requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(arguments[0])))", args: [] });
  };
  for (const type of ["keyDown", "keyUp"]) await act("key", "keyboard", { type, value: "\uE014" });
  const stepped = await until(stiffness, (now) => now > before, "a step by keyboard", LONGEST);

  const { x, y, width } = await run(`const { x, y, width, height } = ${slider}.getBoundingClientRect(); return { x: x + width / 2, y: y + height / 2, width }`, PITCH_STIFFNESS);
  const move = (dx) => ({ type: "pointerMove", x: Math.round(x + dx), y: Math.round(y), duration: 0 });
  const drag = [move(0), { type: "pointerDown", button: 0 }, ...[1, 2, 3, 4].map((i) => move((i * width) / 16)), { type: "pointerUp", button: 0 }];
  for (const action of drag) await act("pointer", "mouse", action);
  await until(stiffness, (now) => now > stepped, "drawn along by mouse", LONGEST);
  await until(() => run("return location.hash"), (hash) => hash.includes("cm_alpha"), "in the address", LONGEST);
});
