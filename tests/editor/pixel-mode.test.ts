import { BoxGeometry, type BufferGeometry } from "three";
import { describe, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Design, emptyDesign, makeFillLayer } from "../../web/editor/document/index.ts";
import { addOnTop } from "../../web/editor/state/design-edits.ts";
import type { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { floodFill } from "../../web/editor/tools/flood-fill.ts";
import { MOST_COLORS, parseGimpPalette, printGimpPalette } from "../../web/editor/tools/gimp-palette.ts";
import { PaletteCommands } from "../../web/editor/tools/palette-commands.ts";
import { colorsOf } from "../../web/editor/tools/picture-palette.ts";
import { PixelCanvas, pixelColorOf } from "../../web/editor/tools/pixel-canvas.ts";
import { PixelGesture, type PixelSource, type PixelStart } from "../../web/editor/tools/pixel-gesture.ts";
import { byMaterial, joined, texelsAlong } from "../../web/editor/tools/pixel-places.ts";
import { squared, texelLine, texelRectangle, tipCorner } from "../../web/editor/tools/pixel-shapes.ts";
import { TexelNeighbours } from "../../web/editor/tools/texel-neighbours.ts";
import type { ToolContext } from "../../web/editor/tools/tool-context.ts";
import type { Toolbox } from "../../web/editor/tools/toolbox.ts";
import type { Picture } from "../../web/engine/engine-api.ts";
import { decodePicture } from "../../web/engine/picture-decoder.ts";
import { encodePng } from "../../web/engine/png-encoder.ts";
import { texelPlaces } from "../../web/viewer/texel-places.ts";
import { queryOf, sheet } from "../viewer/surface-helpers.ts";

/** Texels across a face, and of the whole texture: the six faces lie side by side, three in a row, without a gap. */
const FACE = 8;
const WIDTH = FACE * 3;
const HEIGHT = FACE * 2;

function unwrappedBox(size: number): BufferGeometry {
  const box = new BoxGeometry(size, size, size);
  const uv = box.getAttribute("uv");
  for (let vertex = 0; vertex < uv.count; vertex++) {
    const face = Math.floor(vertex / 4);
    uv.setXY(vertex, ((face % 3) + uv.getX(vertex)) / 3, (Math.floor(face / 3) + uv.getY(vertex)) / 2);
  }
  return box;
}

const faceOf = (texel: number): number =>
  Math.floor((texel % WIDTH) / FACE) + 3 * Math.floor(Math.floor(texel / WIDTH) / FACE);

describe("texels side by side on a model", () => {
  const map = new TexelNeighbours(texelPlaces(queryOf(unwrappedBox(2)), 0, WIDTH, HEIGHT));

  it("each texel of a cube has a neighbour on every side, over its edges too", () => {
    const all = Array.from({ length: WIDTH * HEIGHT }, (_, texel) => texel);
    expect(new Set(all.map((texel) => map.of(texel).length))).toEqual(new Set([4]));
  });

  it("a fill goes over the seams round the cube, and stops at a closed line", () => {
    const rgba = new Uint8Array(WIDTH * HEIGHT * 4).fill(255);
    const options = { tolerance: 0, contiguous: true, neighbours: (texel: number) => map.of(texel) };
    expect(floodFill(rgba, 0, options)).toHaveLength(WIDTH * HEIGHT);

    // A ring round the first face, inside it.
    for (let texel = 0; texel < WIDTH * HEIGHT; texel++) {
      const [x, y] = [texel % WIDTH, Math.floor(texel / WIDTH)];
      const isRing = faceOf(texel) === 0 && (x === 0 || y === 0 || x === FACE - 1 || y === FACE - 1);
      if (isRing) rgba[texel * 4] = 0;
    }
    const inside = floodFill(rgba, WIDTH * 2 + 2, options);
    expect(inside).toHaveLength((FACE - 2) ** 2);
    const outside = floodFill(rgba, WIDTH * (FACE + 2), options);
    expect(new Set(outside.map(faceOf))).toEqual(new Set([1, 2, 3, 4, 5]));
  });

  it("tolerance lets near colours in, and without contiguity the colour is filled wherever it is", () => {
    const rgba = new Uint8Array(WIDTH * HEIGHT * 4).fill(255);
    rgba.set([250, 255, 255, 255], 4);
    const neighbours = (texel: number) => (texel === 0 ? [1] : []);
    expect(floodFill(rgba, 0, { tolerance: 4, contiguous: true, neighbours })).toEqual([0]);
    expect(floodFill(rgba, 0, { tolerance: 5, contiguous: true, neighbours })).toEqual([0, 1]);
    expect(floodFill(rgba, 0, { tolerance: 0, contiguous: false, neighbours })).toHaveLength(WIDTH * HEIGHT - 1);
  });

  it("what is clear is one colour, whatever it was before it was wiped", () => {
    const rgba = Uint8Array.from([255, 0, 0, 0, 0, 0, 255, 0, 255, 0, 0, 1]);
    const options = { tolerance: 0, contiguous: false, neighbours: () => [] };
    expect(floodFill(rgba, 0, options)).toEqual([0, 1]);
  });

  it("a shell that lies close over another is no neighbour of it", () => {
    /** The left half of the texture, or the right one. */
    const inHalf = (box: BufferGeometry, half: 0 | 1): BufferGeometry => {
      const uv = box.getAttribute("uv");
      for (let vertex = 0; vertex < uv.count; vertex++) uv.setX(vertex, (uv.getX(vertex) + half) / 2);
      return box;
    };
    const shells = queryOf(inHalf(unwrappedBox(2), 0), inHalf(unwrappedBox(2.05), 1));
    const near = new TexelNeighbours(texelPlaces(shells, 0, WIDTH * 2, HEIGHT));
    const halfOf = (texel: number): number => Math.floor((texel % (WIDTH * 2)) / WIDTH);
    for (let texel = 0; texel < WIDTH * 2 * HEIGHT; texel++) {
      expect(near.of(texel).map(halfOf)).toEqual(new Array(4).fill(halfOf(texel)));
    }
  });
});

describe("texels of two materials", () => {
  const left = texelPlaces(queryOf(sheet().translate(-1, 0, 0)), 0, 4, 4);
  const right = texelPlaces(queryOf(sheet().translate(1, 0, 0)), 0, 4, 4);
  /** One shell, as two materials of one mesh are. */
  const joint = new TexelNeighbours(
    { ...left, shells: left.shells.map(() => 0) },
    { ...right, shells: right.shells.map(() => 0) },
  );

  it("are beside each other over the border of the two, and nowhere else", () => {
    for (let texel = 0; texel < 16; texel++) {
      const over = joint.of(texel).filter((other) => other >= 16);
      expect(over, `texel ${texel}`).toEqual(texel % 4 === 3 ? [16 + texel - 3] : []);
    }
  });

  it("a fill goes over the border", () => {
    const rgba = new Uint8Array(32 * 4).fill(255);
    const options = { tolerance: 0, contiguous: true, neighbours: (texel: number) => joint.of(texel) };
    expect(floodFill(rgba, 0, options)).toHaveLength(32);
  });

  it("a path over the border goes on in the other material, each part at its own grid", () => {
    const at = (material: number, u: number) => ({
      hit: { position: [0, 0, 0], normal: [0, 0, 1], material, uv: [u, 0], face: 0 } as const,
      pressure: 1,
    });
    const sizes = [
      { width: 4, height: 4 },
      { width: 8, height: 8 },
    ];
    const { places, last } = texelsAlong(
      [at(0, 0.9), at(1, 0.05), at(1, 0.4)],
      (material) => sizes[material] ?? null,
      null,
    );
    const parts = byMaterial(places);
    expect(parts.get(0)?.map(([x]) => Math.floor(x))).toEqual([3]);
    expect(parts.get(1)?.map(([x]) => Math.floor(x))).toEqual([0, 1, 2, 3]);
    expect(last?.material).toBe(1);
    expect(texelsAlong([at(7, 0.5)], (material) => sizes[material] ?? null, last).last).toBeNull();
  });
});

describe("a change of the layers of two materials", () => {
  const begun: PixelStart = { layer: null, picture: { width: 2, height: 2, rgba: new Uint8Array(16) } };
  const source: PixelSource = { width: 2, height: 2, layerId: null, alphaLock: false, begun: Promise.resolve(begun) };
  const contextOf = (recorded: Design[]) => {
    const design = emptyDesign();
    const picture = (_: unknown, bytes: Uint8Array) => ({
      asset: { type: "image/png", uri: `data:${bytes.length},${recorded.length}` },
    });
    return {
      session: {
        recordedDesign: design,
        record: (next: Design) => recorded.push(next),
        preview: () => {},
        cancelPreview: () => {},
      },
      library: { add: picture, release: () => undefined, setLive: (bytes: Uint8Array) => picture(null, bytes) },
      store: { state: { selectedId: null } },
      board: { strings: stringsIn("en") },
    } as unknown as ToolContext;
  };

  it("is one step, with a layer of each", async () => {
    const recorded: Design[] = [];
    const gesture = new PixelGesture(contextOf(recorded), () => source);
    gesture.draw(0, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
    gesture.draw(3, (canvas) => canvas.set(1, 1, [1, 2, 3, 255]));
    await gesture.end("pencil");
    expect(recorded).toHaveLength(1);
    expect(recorded[0]?.layers.map(({ material }) => material).sort()).toEqual([0, 3]);
  });

  it("leaves a material alone on which nothing was drawn in the end, and one that cannot be painted", async () => {
    const recorded: Design[] = [];
    const gesture = new PixelGesture(contextOf(recorded), (material) => (material === 5 ? null : source));
    gesture.draw(5, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
    gesture.draw(3, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
    gesture.restart();
    gesture.draw(0, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
    await gesture.end("line");
    expect(recorded[0]?.layers.map(({ material }) => material)).toEqual([0]);
  });

  it("leaves what else was changed while its pictures were being written", async () => {
    const recorded: Design[] = [];
    const context = contextOf(recorded);
    const gesture = new PixelGesture(context, () => source);
    gesture.draw(0, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
    const written = context.library.add;
    context.library.add = async (name, bytes) => {
      const fill = makeFillLayer({ id: "fill", color: "#ffffff" });
      Object.assign(context.session, { recordedDesign: addOnTop(emptyDesign(), fill) });
      return written(name, bytes);
    };
    await gesture.end("pencil");
    expect(recorded[0]?.layers.map(({ type }) => type).sort()).toEqual(["decal", "fill"]);
  });
});

describe("the picture of a stroke", () => {
  const size = { width: 2, height: 2 };
  const begun: PixelStart = { layer: null, picture: { ...size, rgba: new Uint8Array(16) } };
  const source: PixelSource = { ...size, layerId: null, alphaLock: false, begun: Promise.resolve(begun) };
  const paintWith = (pictures: Uint8Array[], live: Uint8Array[], kept: [string, Picture][] = []) => {
    const design = emptyDesign();
    const asset = { type: "image/png", uri: "data:picture" };
    const context = {
      session: { recordedDesign: design, record: () => {}, preview: () => {}, cancelPreview: () => {} },
      library: {
        add: (_: string, bytes: Uint8Array) => {
          pictures.push(bytes);
          return { asset };
        },
        release: () => undefined,
        setLive: (bytes: Uint8Array) => live.push(bytes),
      },
      store: { state: { selectedId: null } },
      board: { strings: stringsIn("en") },
    } as unknown as ToolContext;
    return new PixelGesture(
      context,
      () => source,
      null,
      (uri, picture) => kept.push([uri, picture]),
    );
  };
  const shown = () => new Promise((resolve) => setTimeout(resolve, 0));

  it("is written once for all moves within one texel, and not again at the release", async () => {
    const [pictures, live]: Uint8Array[][] = [[], []];
    const gesture = paintWith(pictures as Uint8Array[], live as Uint8Array[]);
    for (let move = 0; move < 5; move++) {
      gesture.draw(0, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
      await shown();
    }
    await gesture.end("pencil");
    expect(live).toHaveLength(1);
    // The very bytes.
    expect(pictures?.[0]).toBe(live?.[0]);
  });

  it("is written anew for each texel more, for what is taken back, and at the release for what was not shown", async () => {
    const [pictures, live]: Uint8Array[][] = [[], []];
    const gesture = paintWith(pictures as Uint8Array[], live as Uint8Array[]);
    gesture.draw(0, (canvas) => canvas.set(0, 0, [1, 2, 3, 255]));
    await shown();
    gesture.draw(0, (canvas) => canvas.set(1, 0, [1, 2, 3, 255]));
    await shown();
    gesture.restart();
    await shown();
    expect(live).toHaveLength(3);
    gesture.draw(0, (canvas) => canvas.set(0, 1, [1, 2, 3, 255]));
    await gesture.end("line");
    const { rgba } = await decodePicture(pictures?.[0] as Uint8Array, "line.png");
    expect([...rgba]).toEqual([0, 0, 0, 0, 0, 0, 0, 0, 1, 2, 3, 255, 0, 0, 0, 0]);
  });

  it("is kept as it was drawn, for the next stroke to begin with", async () => {
    const kept: [string, Picture][] = [];
    const gesture = paintWith([], [], kept);
    gesture.draw(0, (canvas) => canvas.set(1, 1, [1, 2, 3, 255]));
    await gesture.end("pencil");
    expect(kept.map(([uri, { width, rgba }]) => [uri, width, rgba[12]])).toEqual([["data:picture", 2, 1]]);
  });
});

describe("shapes on the texel grid", () => {
  it("a line has no gaps, holds both ends, and is the same length either way", () => {
    for (const [x, y] of [
      [7, 3],
      [-2, 9],
      [0, 0],
      [-5, -5],
      [4, 0],
    ] as const) {
      const line = texelLine([0, 0], [x, y]);
      expect(line[0]).toEqual([0, 0]);
      expect(line.at(-1)).toEqual([x, y]);
      expect(line).toHaveLength(Math.max(Math.abs(x), Math.abs(y)) + 1);
      expect(texelLine([x, y], [0, 0])).toHaveLength(line.length);
    }
  });

  it("a rectangle is an outline or filled, whichever corners it is drawn between", () => {
    expect(texelRectangle([3, 4], [1, 1], true)).toHaveLength(12);
    expect(texelRectangle([1, 1], [3, 4], false)).toHaveLength(10);
    expect(texelRectangle([2, 2], [2, 2], false)).toEqual([[2, 2]]);
  });

  it("with Shift a rectangle is square, and a line level, upright or diagonal", () => {
    expect(squared([0, 0], [5, -3], false)).toEqual([5, -5]);
    expect(squared([0, 0], [9, 2], true)).toEqual([9, 0]);
    expect(squared([0, 0], [-1, 7], true)).toEqual([0, 7]);
    expect(squared([0, 0], [5, 4], true)).toEqual([5, 5]);
  });

  it("a wide tip stands about its place", () => {
    expect(tipCorner(5.5, 5.5, 1)).toEqual([5, 5]);
    expect(tipCorner(5.5, 5.5, 3)).toEqual([4, 4]);
    expect(tipCorner(5.9, 5.1, 2)).toEqual([5, 4]);
  });

  it("a path over the surface is joined within a chart and not from one chart to another", () => {
    const at = (x: number, y: number) => ({
      hit: { position: [0, 0, 0], normal: [0, 0, 1], material: 0, uv: [x / 16, y / 16], face: 0 } as const,
      pressure: 1,
    });
    const size = { width: 16, height: 16 };
    expect(texelsAlong([at(1.5, 1.5), at(4.4, 1.5)], () => size, null).places).toHaveLength(4);
    expect(texelsAlong([at(1.5, 1.5), at(9.5, 1.5)], () => size, null).places).toHaveLength(2);
    expect(texelsAlong([at(1.5, 1.5), null, at(3.5, 1.5)], () => size, null).places).toHaveLength(2);
    expect(joined([0.5, 0.5], [3.5, 0.5])).toEqual([
      [1.5, 0.5],
      [2.5, 0.5],
      [3.5, 0.5],
    ]);
  });
});

describe("a pixel layer's canvas", () => {
  it("with its alpha locked takes paint only where there is some, and keeps how dense it is", () => {
    const rgba = new Uint8Array([9, 9, 9, 128, 0, 0, 0, 0]);
    const canvas = new PixelCanvas({ width: 2, height: 1, rgba }, true);
    canvas.stamp([0, 0], 2, pixelColorOf("#ff8000"));
    expect([...canvas.rgba]).toEqual([255, 128, 0, 128, 0, 0, 0, 0]);
  });

  it("leaves out what lies outside, and knows whether anything changed", () => {
    const canvas = new PixelCanvas({ width: 1, height: 1, rgba: new Uint8Array(4) }, false);
    canvas.set(3, 0, [1, 2, 3, 255]);
    expect(canvas.changed).toBe(false);
    canvas.set(0, 0, [1, 2, 3, 255]);
    expect(canvas.changed).toBe(true);
    canvas.restart();
    expect(canvas.changed).toBe(false);
  });

  it("is unchanged again where what was set is as it was before, and changed while one texel is not", () => {
    const rgba = Uint8Array.from([1, 2, 3, 255, 4, 5, 6, 255]);
    const canvas = new PixelCanvas({ width: 2, height: 1, rgba }, false);
    canvas.stamp([0, 0], 2, [9, 9, 9, 255]);
    canvas.stamp([0, 0], 2, [8, 9, 9, 255]);
    canvas.set(0, 0, [1, 2, 3, 255]);
    expect(canvas.changed).toBe(true);
    canvas.set(1, 0, [4, 5, 6, 255]);
    expect(canvas.changed).toBe(false);
  });

  it("tells whether anything changed without reading the texels again, as it is asked in each frame of a stroke", () => {
    let reads = 0;
    const rgba = new Uint8Array(64 * 64 * 4);
    const read = (key: string | symbol): unknown => {
      if (typeof key === "string" && /^\d+$/.test(key)) reads += 1;
      const value: unknown = Reflect.get(rgba, key, rgba);
      return typeof value === "function" ? value.bind(rgba) : value;
    };
    const counted = new Proxy(rgba, { get: (_, key) => read(key) });
    const canvas = new PixelCanvas({ width: 64, height: 64, rgba: counted }, false);
    canvas.set(63, 63, [1, 2, 3, 255]);
    for (let frame = 0; frame < 10; frame++) expect(canvas.changed).toBe(true);
    expect(reads).toBeLessThan(10);
  });
});

describe("palettes", () => {
  const parse = (text: string) => parseGimpPalette(text, "skin.gpl", stringsIn("en").palette.errors);
  const faultOf = (text: string): TexelcastError => {
    try {
      parse(text);
    } catch (thrown) {
      if (thrown instanceof TexelcastError) return thrown;
    }
    throw new Error("It was taken.");
  };

  it("a GIMP palette comes back as it was written", () => {
    const palette = { name: "Skin tones", colors: ["#000000", "#f2d3b3", "#0a0b0c"] };
    expect(parse(printGimpPalette(palette))).toEqual(palette);
  });

  it("remarks, Windows line ends, tabs and names of colours are read over", () => {
    const text =
      "\uFEFFGIMP Palette\r\nName: Old\r\nColumns: 16\r\n# a remark\r\n255\t0 10\tRed: warm\r\n\r\n  1   2   3\r\n";
    expect(parse(text)).toEqual({ name: "Old", colors: ["#ff000a", "#010203"] });
    expect(parse("GIMP Palette\n1 2 3").name).toBe("skin");
  });

  it("what is no palette is refused by its line and what stands there", () => {
    expect(faultOf("JASC-PAL\n0100")).toMatchObject({
      code: "bad-palette",
      subject: "skin.gpl",
      field: "line 1",
      value: "JASC-PAL",
    });
    for (const line of ["256 0 0", "1 2", "red green blue", "-1 0 0", "1.5 0 0", "0x1 2 3"]) {
      expect(faultOf(`GIMP Palette\n1 2 3\n${line}\n`), line).toMatchObject({
        code: "bad-palette",
        field: "line 3",
        value: line,
      });
    }
    expect(faultOf("GIMP Palette\nName: Empty\n").code).toBe("bad-palette");
    expect(faultOf(`GIMP Palette\n${"1 2 3\n".repeat(MOST_COLORS + 1)}`).code).toBe("bad-palette");
  });

  it("a picture that is clear all over is refused, and the palette stays", async () => {
    const errors: unknown[] = [];
    const board = { strings: stringsIn("en"), error: (_title: string, thrown: unknown) => errors.push(thrown) };
    const configure = vi.fn();
    const commands = new PaletteCommands(
      { configure } as unknown as Toolbox,
      { ...board, announce: () => {} } as unknown as NoticeBoard,
    );
    const picture = await encodePng({ width: 2, height: 1, rgba: new Uint8Array(8) });
    await commands.open(new File([picture], "clear.png"));
    expect(configure).not.toHaveBeenCalled();
    expect(errors).toMatchObject([{ code: "bad-palette", subject: "clear.png" }]);
  });

  it("a skin keeps its own colours, a picture of many is thinned, and what is clear does not count", () => {
    expect(colorsOf({ rgba: new Uint8Array([255, 0, 0, 255, 0, 0, 9, 255, 0, 0, 9, 255, 1, 1, 1, 0]) }, 8)).toEqual([
      "#000009",
      "#ff0000",
    ]);
    const many = new Uint8Array(256 * 256 * 4).map((_, index) => (index % 4 === 3 ? 255 : (index * 2654435761) >>> 24));
    const thinned = colorsOf({ rgba: many }, 16);
    expect(new Set(thinned).size).toBe(thinned.length);
    expect(thinned.length).toBeGreaterThan(4);
    expect(thinned.length).toBeLessThanOrEqual(16);
  });
});
