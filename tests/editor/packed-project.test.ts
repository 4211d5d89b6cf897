import { createHash } from "node:crypto";
import { describe, expect, it, vi } from "vitest";
import { encodeDataUri } from "../../web/editor/document/data-uri.ts";
import {
  type DecalLayer,
  type Design,
  emptyDesign,
  type GroupLayer,
  makeDecalLayer,
  makeGroupLayer,
  makePaintLayer,
  makeStrokeLayer,
  type StrokeLayer,
} from "../../web/editor/document/index.ts";
import { noteRead, ProjectPacker } from "../../web/editor/storage/packed-project.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { FRONT } from "../support/layers.ts";

const BRUSH = { tip: "round", color: "#c02050", hardness: 0.5, flow: 0.5 } as const;
const stroke = (id: string, opacity = 1) =>
  makeStrokeLayer({ id, brush: BRUSH, opacity, dabs: [{ ...FRONT, flow: 1 }] });
const painted = (strokes: ReturnType<typeof stroke>[]): Design => ({
  ...emptyDesign(),
  layers: [makePaintLayer({ id: "paint", strokes })],
});

const decal = (id: string, opacity = 1) =>
  makeDecalLayer({ id, asset: "dot", opacity, projector: { ...FRONT, size: [0.1, 0.1, 0.1] } });
const DOT = { type: "image/png", uri: "https://example.com/dot.png" } as const;
const placed = (layers: readonly (DecalLayer | GroupLayer)[]): Design => ({
  ...emptyDesign(),
  assets: { dot: DOT },
  layers: [...layers],
});

const pack = (packer: ProjectPacker, design: Design) =>
  packer.pack({
    name: "Mug",
    design,
    model: { source: null as never, title: "Mug", demoId: "mug" },
    targets: new Map(),
  });

/** How many strokes are read while something is packed. */
async function strokesRead(work: () => Promise<unknown>): Promise<number> {
  const reading = vi.spyOn(JSON, "parse");
  try {
    await work();
    return reading.mock.calls.reduce((sum, [text]) => sum + text.split('"dabs":').length - 1, 0);
  } finally {
    reading.mockRestore();
  }
}

describe("a design that is packed to be kept", () => {
  it("has what was packed before neither written nor read again: a stroke more costs that stroke", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    let asked = 0;
    const watched = ["a", "b", "c"].map((id) => {
      return new Proxy(stroke(id), {
        get: (layer, field) => {
          if (field === "dabs") asked += 1;
          return Reflect.get(layer, field);
        },
      });
    });
    await pack(packer, painted(watched));
    expect(asked).toBeGreaterThan(0);
    asked = 0;
    const { design } = await pack(packer, painted([...watched, stroke("d")]));
    expect(asked).toBe(0);
    const [paint] = JSON.parse(design).layers;
    expect(paint.strokes.map(({ id }: { id: string }) => id)).toEqual(["a", "b", "c", "d"]);
  });

  it("has strokes not read again that differ from others in their ids alone, as those of a layer's copy", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    const strokes = ["a", "b", "c"].map((id) => stroke(id));
    const paint = makePaintLayer({ id: "paint", strokes });
    const withCopy = (ids: string[], changes: Partial<StrokeLayer> = {}): Design => {
      const copies = strokes.map((each, index) => ({ ...each, ...changes, id: ids[index] as string }));
      return { ...emptyDesign(), layers: [paint, makePaintLayer({ id: "copy", strokes: copies })] };
    };
    await pack(packer, { ...emptyDesign(), layers: [paint] });
    // A list's first is always read, for the place that it tells.
    expect(await strokesRead(() => pack(packer, withCopy(["layer-1", "layer-2", "layer-3"])))).toBe(2);
    expect(await strokesRead(() => pack(packer, withCopy(["layer-4", "layer-5", "layer-6"], { opacity: 0.5 })))).toBe(
      4,
    );
    for (const [ids, changes] of [
      [["layer-7", "layer-8", ""], {}],
      [["layer-7", "layer-8", "a"], {}],
      [["layer-7", "layer-8", "layer-9"], { opacity: 7 }],
    ] as const)
      await expect(pack(packer, withCopy([...ids], changes))).rejects.toMatchObject({ code: "bad-design" });
  });

  it("lets the page have a turn between parts of many strokes, where hashes come at once", async () => {
    // As in Chromium, which hashes what is short without leaving the turn.
    const digest = async (_: AlgorithmIdentifier, bytes: BufferSource) =>
      new Uint8Array(
        createHash("sha256")
          .update(bytes as Uint8Array)
          .digest(),
      ).buffer;
    const hashing = vi.spyOn(crypto.subtle, "digest").mockImplementation(digest);
    let turns = 0;
    let waiting = setImmediate(function count() {
      turns += 1;
      waiting = setImmediate(count);
    });
    const strokes = Array.from({ length: 16 }, (_, index) =>
      makeStrokeLayer({
        id: `s${index}`,
        brush: BRUSH,
        dabs: Array.from({ length: 900 }, () => ({ ...FRONT, flow: 1 })),
      }),
    );
    const { blobs } = await pack(new ProjectPacker(stringsIn("en")), painted(strokes));
    clearImmediate(waiting);
    hashing.mockRestore();
    expect(blobs.size).toBeGreaterThan(2);
    expect(turns).toBeGreaterThanOrEqual(blobs.size);
  });

  it("has a mask's strokes not read again at each stroke more on it", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    const [a, b, c] = ["a", "b", "c"].map((id) => stroke(id)) as [StrokeLayer, StrokeLayer, StrokeLayer];
    const masked = (...layers: StrokeLayer[]): Design =>
      placed([{ ...decal("decal"), mask: { layers, invert: false, linked: true } }]);
    await pack(packer, masked(a, b, c));
    expect(await strokesRead(() => pack(packer, masked(a, b, c, stroke("d"))))).toBe(2);
    for (const wrong of [stroke("e", 7), stroke("a")])
      await expect(pack(packer, masked(a, b, c, wrong))).rejects.toMatchObject({ code: "bad-design" });
  });

  it("has a picture decoded once to be named and stored, and no more once it is", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    const uri = encodeDataUri("image/png", Uint8Array.of(1, 2, 3));
    const design: Design = { ...emptyDesign(), assets: { dot: { type: "image/png", uri } }, layers: [decal("a")] };
    const decoded = vi.spyOn(globalThis, "atob");
    const stored: Uint8Array[] = [];
    for (const { bytes } of (await pack(packer, design)).blobs.values()) stored.push(bytes());
    await pack(packer, { ...design, layers: [decal("a", 0.5)] });
    const { length } = decoded.mock.calls;
    decoded.mockRestore();
    expect(stored).toEqual([Uint8Array.of(1, 2, 3)]);
    expect(length).toBe(1);
  });

  it("has no layer written or read again that did not change, in groups neither", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    let asked = 0;
    const watched = (id: string): DecalLayer =>
      new Proxy(decal(id), {
        get: (layer, field) => {
          if (field === "projector") asked += 1;
          return Reflect.get(layer, field);
        },
      });
    const [a, b, c, d] = ["a", "b", "c", "d"].map(watched) as [DecalLayer, DecalLayer, DecalLayer, DecalLayer];
    await pack(packer, placed([a, b, makeGroupLayer({ id: "g", layers: [c, d] })]));
    expect(asked).toBeGreaterThan(0);
    asked = 0;
    const moved = makeGroupLayer({ id: "g", layers: [c, decal("e", 0.5), d], opacity: 0.25 });
    const { design } = await pack(packer, placed([a, moved, b]));
    expect(asked).toBe(0);
    expect(JSON.parse(design).layers).toMatchObject([
      { id: "a", projector: { kind: "planar" } },
      { id: "g", opacity: 0.25, layers: [{ id: "c" }, { id: "e", opacity: 0.5 }, { id: "d" }] },
      { id: "b", projector: { kind: "planar" } },
    ]);
  });

  it("is not read again where it was read from a file a moment ago: its faults would have been met there", async () => {
    const opened = placed([decal("a"), decal("b", 7)]);
    await expect(pack(new ProjectPacker(stringsIn("en")), opened)).rejects.toMatchObject({ code: "bad-design" });
    noteRead(opened);
    expect(JSON.parse((await pack(new ProjectPacker(stringsIn("en")), opened)).design).layers).toHaveLength(2);
  });

  it("is refused for a layer that could not be read again, wherever it is, and for what layers have to do with each other", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    const kept = [decal("a"), decal("b")];
    await pack(packer, placed(kept));
    const deep = (layer: DecalLayer) => makeGroupLayer({ id: "g", layers: [decal("c"), layer] });
    const lone = { ...emptyDesign(), layers: kept };
    for (const design of [
      placed([...kept, decal("c", 7)]),
      placed([...kept, deep(decal("d", 7))]),
      placed([...kept, deep({ ...decal("d"), mask: { layers: [decal("m", 7)], invert: false, linked: true } })]),
      placed([...kept, deep(decal("b"))]),
      lone,
    ])
      await expect(pack(packer, design)).rejects.toMatchObject({ code: "bad-design" });
  });

  it("is refused where it could not be read again: by a new stroke, and by what strokes have to do with each other", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    const kept = [stroke("a"), stroke("b")];
    await pack(packer, painted(kept));
    const picture = makeStrokeLayer({
      id: "c",
      brush: { ...BRUSH, tip: "picture", asset: "gone", color: null },
      dabs: [],
    });
    const bad = [
      painted([...kept, stroke("c", 7)]),
      painted([...kept, stroke("b")]),
      painted([...kept, picture as ReturnType<typeof stroke>]),
      { ...emptyDesign(), layers: [...painted(kept).layers, makePaintLayer({ id: "more", strokes: kept })] },
    ];
    for (const design of bad) await expect(pack(packer, design)).rejects.toMatchObject({ code: "bad-design" });
  });
});
