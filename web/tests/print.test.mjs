// The scene on paper: what Ctrl P hands to the printer is one page of A4 and of Letter, with the address it opens at, and the page goes on
// as it was.

import assert from "node:assert/strict";
import { test } from "node:test";
import { open, until } from "./page.mjs";

// A print of a frame would open a window that no test can close: instead what would be printed is kept.
function keepsPrints() {
  const { get } = Object.getOwnPropertyDescriptor(HTMLIFrameElement.prototype, "contentWindow");
  Object.defineProperty(HTMLIFrameElement.prototype, "contentWindow", {
    get() {
      const inside = get.call(this);
      if (this.className === "paper") {
        inside.print = () => {
          const { documentElement, adoptedStyleSheets } = inside.document;
          const rules = adoptedStyleSheets.flatMap((sheet) => [...sheet.cssRules].map((rule) => rule.cssText));
          window.printed = { html: documentElement.outerHTML, heading: documentElement.querySelector("h1").textContent, style: rules.join("\n"), title: document.title };
          window.donePrinting = () => inside.dispatchEvent(new Event("afterprint"));
        };
      }
      return inside;
    },
  });
}

// Sheets of a PDF.
const sheets = (pdf) => pdf.toString("latin1").match(/\/Type\s*\/Page\b(?!s)/g).length;

for (const [what, fragment] of [
  ["a response", "#v=1&ac=navion&cg=16"],
  ["six modes under a law", "#v=1&ac=b747-cruise-etkin&plane=lat&k.r_dr=1&washout=3&actuator=0.1&tab=frequency"],
]) {
  test(`Ctrl P prints ${what} on one sheet, with its address, and the page is back afterwards`, async (t) => {
    const { page, url, ready, rest, seen } = await open(t, { fragment, before: keepsPrints });
    await ready();
    await rest();
    const title = await page.title();
    await page.keyboard.press("Control+p");
    const printed = await until(() => page.evaluate(() => window.printed), (printed) => printed, "it is printed");
    const address = url.split("#")[0];
    assert.ok(printed.html.includes(`${address}#v=1&amp;ac=`), "the whole address");
    assert.ok(printed.title !== title && printed.title === printed.heading, "a file of the print has the name of the scene");
    await page.evaluate(() => window.donePrinting());
    assert.equal(await page.title(), title);
    assert.equal(await page.locator("iframe.paper").count(), 0);

    const paper = await page.context().newPage();
    // Without a document type, as in the frame.
    await paper.setContent(printed.html.replace("</head>", `<style>${printed.style}</style></head>`));
    await paper.emulateMedia({ media: "print" });
    for (const format of ["A4", "Letter"]) {
      const pdf = await paper.pdf({ format, preferCSSPageSize: false, printBackground: true, margin: { top: "12mm", bottom: "12mm", left: "12mm", right: "12mm" } });
      assert.equal(sheets(pdf), 1, format);
    }
    // Nothing is cut off at the right, and every figure has its ink.
    await paper.setViewportSize({ width: 703, height: 1000 });
    const wide = await paper.evaluate(() => document.documentElement.scrollWidth);
    assert.ok(wide <= 703, `${wide} pixels of 186 mm`);
    assert.equal(await paper.locator("svg").count(), 3);
    assert.deepEqual(seen.errors, []);
  });
}
