// Windows of sizes that nobody chooses: the page goes on in all of them.

import assert from "node:assert/strict";
import { test } from "node:test";
import { frames, open, until } from "./page.mjs";

test("the page goes on in tiny, narrow, low and huge windows", async (t) => {
  const { page, ready, state, seen, screenshot } = await open(t, { fragment: "#v=1&ac=navion&cm_alpha=-0.5" });
  await ready();
  for (const [width, height] of [[320, 240], [60, 900], [1400, 60], [1, 1], [5120, 2880], [1440, 900]]) {
    await page.setViewportSize({ width, height });
    const canvas = () => page.locator("#eigenwing").evaluate((canvas) => [canvas.width, canvas.height, ...[innerWidth, innerHeight].map((points) => points * devicePixelRatio)].join());
    await until(canvas, (sizes) => sizes === [width, height, width, height].join(), `as many pixels as ${width} × ${height}`);
    await frames(page);
    assert.equal(await page.locator("#failure").isVisible(), false, `${width} × ${height}`);
  }
  assert.equal((await state()).aircraft, "navion");
  await screenshot("after-all-windows");
  assert.deepEqual(seen, { ...seen, console: [], errors: [] });
});
