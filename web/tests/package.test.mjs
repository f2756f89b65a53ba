// The core as a package of npm, installed from its archive as a stranger would.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";

const run = (program, args, options) => promisify(execFile)(program, args, { timeout: 600_000, ...options });
const TSC = fileURLToPath(new URL("../node_modules/typescript/bin/tsc", import.meta.url));

test("the package installs, answers in Node.js, and has its types", async (t) => {
  const folder = mkdtempSync(join(tmpdir(), "eigenwing-package-"));
  t.after(() => rmSync(folder, { recursive: true }));
  writeFileSync(join(folder, "package.json"), '{ "name": "stranger", "private": true, "type": "module" }');
  await run("npm", ["install", "--offline", "--no-audit", "--no-fund", process.env.CORE_PACKAGE], { cwd: folder });
  const program = `
    import init, { analyse } from "eigenwing-core";
    await init();
    const { longitudinal } = analyse({ aircraft: "navion" });
    if (longitudinal && "modes" in longitudinal) console.log(longitudinal.modes.map((mode) => mode.key).join());
  `;
  writeFileSync(join(folder, "use.mjs"), program);
  const { stdout } = await run(process.execPath, ["use.mjs"], { cwd: folder });
  assert.equal(stdout.trim(), "short-period,phugoid");
  // A misspelt field is an error of the compiler.
  const wrong = "// @ts-expect-error: a misspelt field\nanalyse({ aircraft: 'navion', sett: {} });";
  writeFileSync(join(folder, "use.mts"), `${program}${wrong}`);
  const options = ["--noEmit", "--strict", "--target", "esnext", "--module", "nodenext", "--moduleResolution", "nodenext"];
  await run(process.execPath, [TSC, ...options, "use.mts"], { cwd: folder }).catch(({ stdout }) => assert.fail(stdout));
});
