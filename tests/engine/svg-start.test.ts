import { gzipSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { isSvg } from "../../web/engine/svg-start.ts";
import { unknownPicture } from "../../web/engine/unknown-picture.ts";

const SVG = '<svg xmlns="http://www.w3.org/2000/svg"/>';
const bytesOf = (text: string): Uint8Array => new TextEncoder().encode(text);

describe("a file that is told by its first bytes", () => {
  it.each([
    ["a byte order mark", "\ufeff"],
    ["a byte order mark and a declaration", '\ufeff<?xml version="1.0"?>\n'],
    ["comments, with tags in them", "<!-- <b> a > b -- -->\n<!---->"],
    ["a licence in a comment", `<!-- ${"All rights reserved. ".repeat(1000)} -->\n`],
    ["a document's type", '<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "svg11.dtd">\n'],
    ["all of that", '<?xml version="1.0"?><!-- a --><!DOCTYPE svg [<!ENTITY a "b">]><!-- c -->'],
  ])("is an SVG drawing also where it begins with %s", (_what, before) => {
    expect(isSvg(bytesOf(before + SVG))).toBe(true);
  });

  it("is none where only a comment is", () => {
    expect(isSvg(bytesOf(`<!-- ${SVG} --><html/>`))).toBe(false);
    expect(isSvg(bytesOf(`<!DOCTYPE html>${SVG}`))).toBe(false);
  });

  it("is told at once, however many comments it begins with", () => {
    expect(isSvg(bytesOf(`${"<!---->".repeat(500)}<html/>`))).toBe(false);
    expect(isSvg(bytesOf(`${"<!---->".repeat(500)}${SVG}`))).toBe(true);
  });
});

describe("a file that is no picture", () => {
  const saidOf = (bytes: Uint8Array): object => {
    const { reason, message, hint } = unknownPicture(bytes, "file");
    return { reason, message, hint };
  };

  it("is told as a packed drawing, and to be unpacked, where it is one", () => {
    expect(saidOf(gzipSync(bytesOf(SVG)))).toMatchObject({
      reason: "svgz",
      message: expect.stringMatching(/compressed SVG/),
      hint: expect.stringMatching(/plain SVG/),
    });
  });

  it("is told as a drawing by its content, and as nothing known where it is another XML", () => {
    expect(saidOf(bytesOf(`\ufeff<!-- a -->${SVG}`))).toMatchObject({ reason: "svg" });
    expect(saidOf(bytesOf('<?xml version="1.0"?><plist/>'))).toMatchObject({
      reason: "unknown",
      message: expect.stringMatching(/SVG/),
      hint: expect.stringMatching(/SVG/),
    });
  });
});
