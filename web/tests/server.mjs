// Serves dist/ from a sub-folder and compressed, as static hosts do.

import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname } from "node:path";
import { setTimeout as sleep } from "node:timers/promises";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const DIST = new URL("../../dist/", import.meta.url);
const FOLDER = "/some/sub/path/";
const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
};

// `missing` matches names that are not found; `slowly` sends the program in that many pieces,
// with pauses of 50 ms.
// `files` are texts by their names, beside those of the page.
export async function serve({ missing = /^$/, slowly = 1, files = {} } = {}) {
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, "http://localhost");
    const name = pathname.slice(FOLDER.length).replace(/(^|\/)$/, "$1index.html");
    try {
      if (!pathname.startsWith(FOLDER) || missing.test(name)) throw new Error("missing");
      const body = gzipSync(files[name] ?? readFileSync(fileURLToPath(new URL(name, DIST))), { level: 1 });
      response.writeHead(200, {
        "content-type": TYPES[extname(name)] ?? "application/octet-stream",
        "content-encoding": "gzip",
        "content-length": body.length,
      });
      const pieces = name.endsWith(".wasm") ? slowly : 1;
      for (let piece = 0; piece < pieces; piece++) {
        if (piece > 0) await sleep(50);
        response.write(body.subarray((piece * body.length) / pieces, ((piece + 1) * body.length) / pieces));
      }
      response.end();
    } catch {
      response.writeHead(404, { "content-type": "text/plain" }).end("not found");
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return {
    url: `http://127.0.0.1:${server.address().port}${FOLDER}`,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}
