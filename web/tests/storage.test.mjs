// What a browser keeps for the page: from two tabs at once, and where it has no room.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open, until } from "./page.mjs";

const records = (page) => page.evaluate(() => Object.keys(JSON.parse(localStorage.getItem("eigenwing.records") ?? '{"lessons":{}}').lessons).sort().join());

test("lessons that are done in two tabs are both kept", async (t) => {
  const { page, url, ready } = await open(t);
  await ready();
  const other = await page.context().newPage();
  await other.goto(url);
  await other.locator("#welcome").waitFor({ state: "hidden" });
  const begin = async (tab, lesson) => {
    await tab.evaluate((lesson) => (location.hash = `#v=1&lesson=${lesson}`), lesson);
    await until(() => records(tab), (kept) => kept.split(",").includes(lesson), `${lesson} among the records`);
  };
  await begin(page, "frames");
  // This tab began before anything was done in the first.
  await begin(other, "longitudinal");
  assert.equal(await records(page), "frames,longitudinal");
});

test("what is done in the same lesson in two tabs is kept in both, and shown in both", async (t) => {
  const { page, url, ready } = await open(t, { fragment: "#v=1&lesson=longitudinal" });
  await ready();
  const other = await page.context().newPage();
  await other.goto(`${url.split("#")[0]}#v=1&lesson=longitudinal`);
  await other.locator("#welcome").waitFor({ state: "hidden" });
  const record = (tab) => tab.evaluate(() => JSON.parse(localStorage.getItem("eigenwing.records")).lessons.longitudinal);
  const isAnswered = ({ answers }) => answers["1.2"]?.final === true;
  const press = (tab, name) => tab.getByRole("button", { name, exact: true }).dispatchEvent("click");
  // The other tab was open before anything was answered.
  await page.getByText("It swings for minutes.").first().dispatchEvent("click");
  await press(page, "Answer");
  await until(() => record(page), isAnswered, "the answer of the first tab");
  await other.bringToFront();
  await other.getByText("Not so.").first().waitFor({ state: "attached" });
  await press(other, "Next →");
  await until(() => record(other), ({ seen }) => seen.join() === "0,1", "the second step");
  assert.ok(isAnswered(await record(other)), "the answer stays");
  // The first tab goes on where it is, and what the second has done stays as well.
  await page.bringToFront();
  await page.evaluate(() => (location.hash = "#v=1&lesson=longitudinal&step=4"));
  await until(() => record(page), ({ seen }) => seen.join() === "0,1,3", "the fourth step beside the second");
  assert.ok(isAnswered(await record(page)));
});

test("where the storage is full a person is told, once, and the page goes on", async (t) => {
  const { page, ready, seen } = await open(t, {
    before: () => {
      // To the last letter.
      for (let size = 1 << 22; size >= 1; size >>= 1) {
        for (;;) {
          const key = `full-${size}-${localStorage.length}`;
          try {
            localStorage.setItem(key, "x".repeat(Math.max(size - key.length, 1)));
          } catch {
            break;
          }
        }
      }
    },
  });
  await ready();
  await page.evaluate(() => (location.hash = "#v=1&lesson=frames"));
  await page.locator("#announcements").getByText("This browser has no room to keep what you do here").waitFor({ state: "attached" });
  assert.deepEqual(seen.errors, []);
});
