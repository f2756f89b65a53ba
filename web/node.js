// The core in Node.js, which has the program beside it on the disk: imported as in a browser, `await init()` and all.

import { readFileSync } from "node:fs";
import { initSync } from "./eigenwing-core.js";

initSync({ module: readFileSync(new URL("eigenwing-core_bg.wasm", import.meta.url)) });

export * from "./eigenwing-core.js";
export default async function init() {}
