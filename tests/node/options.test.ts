import { describe, expect, it } from "vitest";
import {
  fileOfMaterial,
  parseBase,
  parseDpi,
  parseGlbOutput,
  parseGutter,
  parseMaterial,
  parsePath,
  parsePrintOutput,
  parsePrintSize,
  parseRenderOutput,
  parseSide,
  parseSize,
} from "../../node/options.ts";

const isRefused = (parse: (text: string) => unknown, text: string): boolean => {
  try {
    parse(text);
    return false;
  } catch (error) {
    expect((error as { code?: string }).code).toBe("commander.invalidArgument");
    return true;
  }
};

describe("a number on the command line", () => {
  it.each<[string, (text: string) => unknown, number, number]>([
    ["a size's side", (text) => parseSize(text).width, 1, 8192],
    ["a size's second side", (text) => parseSize(`7x${text}`).height, 1, 8192],
    ["a printed size's side", (text) => parsePrintSize(text).height, 1, 16_384],
    ["a material", parseMaterial, 0, 65_535],
    ["a gutter", parseGutter, 0, 64],
    ["an unwrapped texture's side", parseSide, 64, 8192],
    ["a density", parseDpi, 1, 10_000],
  ])(
    "that is %s may be the least and the greatest that the help says, and nothing beyond",
    (_what, parse, least, greatest) => {
      for (const within of [least, greatest]) expect(parse(String(within))).toBe(within);
      for (const beyond of [least - 1, greatest + 1]) expect(isRefused(parse, String(beyond)), `${beyond}`).toBe(true);
      for (const none of ["", " 64", "64 ", "+64", "64.0", "6e1", "0x40", "64px", "٦٤", "64,0", "1".repeat(10)]) {
        expect(isRefused(parse, none), none).toBe(true);
      }
    },
  );

  it("of a size stands for both sides, or one for each, in either case of the x", () => {
    expect(parseSize("64")).toEqual({ width: 64, height: 64 });
    for (const text of ["64x32", "64X32"]) expect(parseSize(text)).toEqual({ width: 64, height: 32 });
    for (const text of ["64x", "x64", "64x32x16", "64*32"]) expect(isRefused(parseSize, text), text).toBe(true);
  });
});

describe("an output's path", () => {
  it("says by its ending, in either case, what is written, and by {material} in its name whether it is one file", () => {
    expect(parseRenderOutput("out/cup.png")).toEqual({ file: "out/cup.png", kind: "png" });
    expect(parseRenderOutput("out/cup.PNG").kind).toBe("png");
    expect(parseRenderOutput("cup.Glb").kind).toBe("glb");
    expect(parseRenderOutput("cup.usdz").kind).toBe("usdz");
    expect(parseRenderOutput("out/{material}.png").kind).toBe("pngs");
    expect(parseRenderOutput("{material}/cup.png").kind).toBe("png");
    expect(parseRenderOutput("{material}/cup.glb").kind).toBe("glb");
    for (const text of ["cup", "png", "cup.jpg", "cup.png.txt", "cup.gltf", "{material}.glb", "{material}.usdz"]) {
      expect(isRefused(parseRenderOutput, text), text).toBe(true);
    }
    expect([parsePrintOutput("a.PNG"), parseGlbOutput("a.GLB")]).toEqual(["a.PNG", "a.GLB"]);
    for (const text of ["a.glb", "apng", "a.png~"]) expect(isRefused(parsePrintOutput, text), text).toBe(true);
    for (const text of ["a.png", "aglb", "a.glb~"]) expect(isRefused(parseGlbOutput, text), text).toBe(true);
  });

  it("has the material's index in place of each {material} of its name, and its folder as it is", () => {
    expect(fileOfMaterial("{material}/m{material}-{material}.png", 12)).toBe("{material}/m12-12.png");
  });

  it("is not empty, and no option that stands where a path was forgotten", () => {
    expect([parsePath("a"), parsePath("./-a"), parsePath("a-b")]).toEqual(["a", "./-a", "a-b"]);
    for (const text of ["", "-", "--out"]) expect(isRefused(parsePath, text), text).toBe(true);
  });
});

describe("a base", () => {
  it("is white, a colour with or without its alpha, or else a picture's path", () => {
    expect(parseBase("white")).toEqual([1, 1, 1, 1]);
    expect(parseBase("#ff0033")).toEqual([1, 0, 0.2, 1]);
    expect(parseBase("#ff003333")).toEqual([1, 0, 0.2, 0.2]);
    expect(parseBase("white.png")).toEqual({ file: "white.png" });
    for (const text of ["#fff", "#ff00zz", "#", "", "--base"]) expect(isRefused(parseBase, text), text).toBe(true);
  });
});
