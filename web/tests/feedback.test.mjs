// A law of feedback, as a person closes a loop in the page.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open, until } from "./page.mjs";

test("a yaw damper moves the Dutch roll, its washout has a pole of its own, and the loop opens again", async (t) => {
  const fragment = "#v=1&ac=b747-fc9&plane=lateral&washout=3&actuator=0.1&page=feedback";
  const { page, ready, state, seen } = await open(t, { fragment });
  await ready();
  const poles = (name) => page.getByRole("button", { name: new RegExp(`^${name} pole, `) }).count();
  assert.equal(await poles("Washout"), 0);
  await page.getByRole("slider", { name: /^gain of yaw rate to rudder/ }).fill("1.5");
  await until(state, (now) => Math.abs(now.parameters["k.r_dr"] - 1.5) < 1e-9, "fed back");
  await until(() => poles("Washout"), (count) => count === 1, "a pole of the washout");
  // Python-control: -0.19716 ± 0.78582j, without the law 0.0351 of damping.
  await until(() => page.getByText(/0\.243/).count(), (count) => count >= 1, "a damping ratio of 0.243");
  await page.getByRole("button", { name: "Open loop", exact: true }).dispatchEvent("click");
  await until(() => poles("Washout"), (count) => count === 0, "without the law");
  await page.getByRole("button", { name: "Closed loop", exact: true }).dispatchEvent("click");
  await until(() => poles("Washout"), (count) => count === 1, "under it again");
  assert.deepEqual([seen.errors, seen.console], [[], []]);
});
