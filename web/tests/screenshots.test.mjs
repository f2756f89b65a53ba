// Pictures of the page for people to look at, in web/screenshots/.

import { test } from "node:test";
import { open } from "./page.mjs";

const VIEWPORTS = [
  { width: 1440, height: 900 },
  { width: 1024, height: 768 },
  { width: 390, height: 844, touch: true },
];

for (const { touch, ...viewport } of VIEWPORTS) {
  for (const colorScheme of ["light", "dark"]) {
    const name = `${viewport.width}x${viewport.height}-${colorScheme}`;
    test(`the page at ${name}`, async (t) => {
      const { ready, rest, screenshot } = await open(t, { viewport, colorScheme, touch });
      await ready();
      await rest();
      await screenshot(name);
    });
  }
}
