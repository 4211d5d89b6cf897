import { describe, expect, it } from "vitest";
import { pastedDrawing } from "../../web/editor/files/pasted-drawing.ts";

const SVG = 'xmlns="http://www.w3.org/2000/svg"';
const XLINK = 'xmlns:xlink="http://www.w3.org/1999/xlink"';

describe("words that are a drawing's text", () => {
  it.each([
    `<svg ${SVG} viewBox="0 0 1 1"><path d="M0 0h1v1z"/></svg>`,
    `<?xml version="1.0"?>\n<!-- made by hand -->\n<svg ${SVG} ${XLINK}><use xlink:href="#a"/></svg>`,
    `<svg:svg xmlns:svg="http://www.w3.org/2000/svg"><svg:path d="M0 0h1v1z"/></svg:svg>`,
  ])("are its file as they are: %s", (words) => {
    expect(pastedDrawing(words)).toBe(words);
  });

  it.each([
    ["<svg><path/></svg>", `<svg ${SVG}><path/></svg>`],
    ['<svg viewBox="0 0 1 1"><svg/></svg>', `<svg ${SVG} viewBox="0 0 1 1"><svg/></svg>`],
    ['<svg><use xlink:href="#a"/></svg>', `<svg ${SVG} ${XLINK}><use xlink:href="#a"/></svg>`],
    [`\n<?xml version="1.0"?><svg ${SVG}/>\n`, `<?xml version="1.0"?><svg ${SVG}/>`],
  ])("get what they lack as a file: %s", (words, file) => {
    expect(pastedDrawing(words)).toBe(file);
  });

  it.each(["", "SVG", "ACME <svg>", "<p>words</p>", "a < b"])("are not those: %s", (words) => {
    expect(pastedDrawing(words)).toBeNull();
  });
});
