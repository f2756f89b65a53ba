// A lesson as a package of a learning platform: its manifest, and what it tells the platform.

import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { open, until } from "./page.mjs";

// A platform that opens the package in a frame, and keeps what it is told.
const PLATFORM = `<script>
  window.kept = JSON.parse(sessionStorage.getItem("kept") ?? '{"cmi.core.lesson_status": "not attempted"}');
  window.calls = [];
  const keep = () => sessionStorage.setItem("kept", JSON.stringify(window.kept));
  window.API = {
    LMSInitialize: (none) => (calls.push("LMSInitialize"), "true"),
    LMSGetValue: (name) => kept[name] ?? "",
    LMSSetValue: (name, value) => ((kept[name] = value), keep(), "true"),
    LMSCommit: () => (calls.push("LMSCommit"), "true"),
    LMSFinish: () => (calls.push("LMSFinish"), keep(), "true"),
    LMSGetLastError: () => "0",
  };
</script><iframe id="package" width="1200" height="700" src="index-of-package.html"></iframe>`;

function files() {
  const folder = process.env.SCORM;
  const found = readdirSync(folder).map((name) => [name === "index.html" ? "index-of-package.html" : name, readFileSync(join(folder, name), "utf8")]);
  return { ...Object.fromEntries(found), "platform.html": PLATFORM };
}

test("the manifest names one page that can be started, and every file", async (t) => {
  const { page } = await open(t);
  const folder = process.env.SCORM;
  const manifest = readFileSync(join(folder, "imsmanifest.xml"), "utf8");
  const read = await page.evaluate((text) => {
    const document = new DOMParser().parseFromString(text, "application/xml");
    const all = (name) => [...document.getElementsByTagName(name)];
    const adl = "http://www.adlnet.org/xsd/adlcp_rootv1p2";
    return {
      damaged: all("parsererror").length,
      root: document.documentElement.namespaceURI,
      schema: all("schema")[0].textContent + " " + all("schemaversion")[0].textContent,
      organization: all("organizations")[0].getAttribute("default") === all("organization")[0].getAttribute("identifier"),
      item: all("item")[0].getAttribute("identifierref") === all("resource")[0].getAttribute("identifier"),
      kind: all("resource")[0].getAttributeNS(adl, "scormtype"),
      href: all("resource")[0].getAttribute("href"),
      files: all("file").map((file) => file.getAttribute("href")),
    };
  }, manifest);
  assert.deepEqual(read, {
    damaged: 0,
    root: "http://www.imsproject.org/xsd/imscp_rootv1p1p2",
    schema: "ADL SCORM 1.2",
    organization: true,
    item: true,
    kind: "sco",
    href: "index.html",
    files: readdirSync(folder).filter((name) => name !== "imsmanifest.xml").sort(),
  });
});

test("a platform is told status, score and a note, with which the lesson goes on", async (t) => {
  const { page: home, url } = await open(t, { server: { files: files() } });
  const page = await home.context().newPage();
  await page.goto(`${url.split("#")[0]}platform.html`);
  const kept = () => page.evaluate(() => window.kept);
  const lesson = page.frameLocator("#package").frameLocator("#lesson");
  await lesson.getByText("Does the nose come back?").first().waitFor({ state: "attached" });
  await until(kept, (now) => now["cmi.core.lesson_status"] === "incomplete", "begun");
  await lesson.getByText("Yes, it does.").first().dispatchEvent("click");
  await lesson.getByRole("button", { name: "Answer" }).dispatchEvent("click");
  await until(kept, (now) => now["cmi.core.lesson_status"] === "completed", "completed");
  assert.equal((await kept())["cmi.core.score.raw"], "100");
  await until(kept, (now) => now["cmi.suspend_data"]?.includes('"final":true'), "the note");
  assert.ok((await page.evaluate(() => window.calls)).includes("LMSCommit"));

  // On another device: nothing is stored there but by the platform.
  await page.evaluate(() => localStorage.clear());
  // The clock is set back meanwhile, which makes the time no less than none.
  for (const frame of page.frames()) {
    await frame.evaluate(() => {
      const now = Date.now;
      Date.now = () => now() - 3_600_000;
    });
  }
  await page.reload();
  await lesson.getByText(/Half of the swing is gone after/).first().waitFor({ state: "attached" });
  assert.match((await kept())["cmi.core.session_time"], /^\d\d:\d\d:\d\d$/);
});
