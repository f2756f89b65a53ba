// Serves dist/ from a sub-folder, compressed and with the headers of docs/hosting/nginx.conf, as static hosts do.

import { existsSync, readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname } from "node:path";
import { fileURLToPath } from "node:url";
import { gzipSync } from "node:zlib";

const DIST = new URL("../../dist/", import.meta.url);
const FOLDER = "/some/sub/path/";
const TYPES = {
  ".css": "text/css",
  ".html": "text/html; charset=utf-8",
  ".js": "text/javascript",
  ".png": "image/png",
  ".svg": "image/svg+xml",
  ".wasm": "application/wasm",
  ".webmanifest": "application/manifest+json",
};
const NGINX = readFileSync(new URL("../../docs/hosting/nginx.conf", import.meta.url), "utf8");
const HEADERS = Object.fromEntries([...NGINX.matchAll(/^ *add_header (\S+) "(.*)" always;$/gm)].map(([, name, value]) => [name, value]));

// A file as it travels: the one that the build has compressed, or compressed now.
function compressed(name, files) {
  if (name in files) return gzipSync(files[name], { level: 1 });
  const path = fileURLToPath(new URL(name, DIST));
  return existsSync(`${path}.gz`) ? readFileSync(`${path}.gz`) : gzipSync(readFileSync(path), { level: 1 });
}

// `missing` matches names that are not found; `slowly` sends the program in that many pieces, each once `sent` of its number, from 1 on,
// has come true.
// `files` are texts by their names, beside those of the page or in their place; a test may change them later. It may also set
// `isDown` of the server, which then answers nothing.
export async function serve({ missing = /^$/, slowly = 1, sent, files = {} } = {}) {
  const state = { isDown: false };
  const server = createServer(async (request, response) => {
    if (state.isDown) return request.socket.destroy();
    const { pathname } = new URL(request.url, "http://localhost");
    const name = pathname.slice(FOLDER.length).replace(/(^|\/)$/, "$1index.html");
    try {
      if (!pathname.startsWith(FOLDER) || missing.test(name)) throw new Error("missing");
      const body = compressed(name, files);
      response.writeHead(200, {
        ...HEADERS,
        "cache-control": /-[0-9a-f]{16}(_bg)?\.\w+$/.test(name) ? "max-age=31536000" : "no-cache",
        "content-type": TYPES[extname(name)] ?? "application/octet-stream",
        "content-encoding": "gzip",
        "content-length": body.length,
      });
      const pieces = name.endsWith(".wasm") ? slowly : 1;
      for (let piece = 0; piece < pieces; piece++) {
        if (piece > 0) await sent(piece + 1);
        response.write(body.subarray((piece * body.length) / pieces, ((piece + 1) * body.length) / pieces));
      }
      response.end();
    } catch {
      response.writeHead(404, { "content-type": "text/plain" }).end("not found");
    }
  });
  await new Promise((listening) => server.listen(0, "127.0.0.1", listening));
  return Object.assign(state, {
    url: `http://127.0.0.1:${server.address().port}${FOLDER}`,
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  });
}
