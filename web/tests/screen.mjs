// A screen that nobody looks at, for browsers that have no WebGL without one: Xvfb, on a display that is free.

import { spawn } from "node:child_process";
import { once } from "node:events";

// `environment` is what a program needs to draw there, by software.
export async function open() {
  const screen = spawn("Xvfb", ["-displayfd", "3", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"], {
    stdio: ["ignore", "ignore", "ignore", "pipe"],
  });
  const [display] = await once(screen.stdio[3], "data");
  return {
    environment: { ...process.env, DISPLAY: `:${String(display).trim()}`, LIBGL_ALWAYS_SOFTWARE: "1" },
    close: () => screen.kill(),
  };
}
