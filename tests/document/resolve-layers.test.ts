import { describe, expect, it } from "vitest";
import {
  BLEND_MODES,
  BLEND_SPACES,
  emptyDesign,
  makeDecalLayer,
  makeFillLayer,
  makePaintLayer,
  makeStrokeLayer,
  parseDesign,
  resolveLayers,
} from "../../web/editor/document/index.ts";
import type { EngineLayer } from "../../web/engine/engine-api.ts";

const planar = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;

function resolve(layer: object) {
  const inter = { type: "font/ttf", uri: "texelcast:fonts/inter-700" };
  const assets = { logo: { type: "image/png", uri: "a" }, serif: { type: "font/ttf", uri: "b" }, inter };
  return resolveLayers(parseDesign({ format: "texelcast-design", version: 1, assets, layers: [layer] }));
}
const decal = (fields: object = {}) => ({ type: "decal", asset: "logo", projector: planar, ...fields });

describe("resolving layers for the engine", () => {
  it("hands a decal on with every field, its name left out", () => {
    const [layer] = resolve(decal({ name: "Front", opacity: 0.5, flipX: true }));
    expect(layer).toEqual({
      id: "layer-1",
      type: "decal",
      material: 0,
      visible: true,
      asset: "logo",
      opacity: 0.5,
      blend: "normal",
      blendSpace: "srgb",
      lockAlpha: false,
      mask: null,
      filter: "linear",
      wrap: "none",
      flipX: true,
      flipY: false,
      backfaces: false,
      angleFade: [70, 90],
      occlusion: "self",
      projector: planar,
    });
  });

  it("asks strokes that it has resolved before for nothing again when another one comes", () => {
    const asked: PropertyKey[] = [];
    const watched = (id: string) => {
      const stroke = makeStrokeLayer({ id, brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 }, dabs: [] });
      return new Proxy(stroke, {
        get: (layer, field) => {
          if (field !== "type" && field !== "mask") asked.push(field);
          return Reflect.get(layer, field);
        },
      });
    };
    const [first, second] = [watched("a"), watched("b")];
    const paint = makePaintLayer({ id: "p", strokes: [first, second] });
    const before = resolveLayers({ ...emptyDesign(), layers: [paint] });
    asked.length = 0;
    const third = makeStrokeLayer({ id: "c", brush: first.brush, dabs: [] });
    asked.length = 0;
    const after = resolveLayers({ ...emptyDesign(), layers: [{ ...paint, strokes: [first, second, third] }] });
    expect(asked).toEqual([]);
    const held = (layers: typeof after) => (layers[0]?.type === "group" ? layers[0].layers : []);
    expect(held(after).slice(0, 2)).toEqual(held(before));
  });

  it("turns a fill's colour into numbers, opaque unless it says otherwise", () => {
    expect(resolve({ type: "fill", color: "#ff8000" })[0]).toMatchObject({ type: "fill", color: [1, 128 / 255, 0, 1] });
    expect(resolve({ type: "fill", color: "#FF800033" })[0]).toMatchObject({ color: [1, 128 / 255, 0, 0.2] });
  });

  it("makes of the editor's own layers what it makes of files", () => {
    const made = makeDecalLayer({ id: "layer-1", asset: "logo", projector: planar });
    const assets = { logo: { type: "image/png", uri: "a" } } as const;
    expect(resolveLayers({ ...emptyDesign(), assets, layers: [made] })).toEqual(resolve(decal()));
    const fill = makeFillLayer({ id: "layer-1", color: "#00ff00" });
    expect(resolveLayers({ ...emptyDesign(), layers: [fill] })).toEqual(resolve({ type: "fill", color: "#00ff00" }));
    const brush = { tip: "round", color: "#00ff00", hardness: 1, flow: 1 } as const;
    const stroke = makeStrokeLayer({ id: "layer-1", brush, dabs: [{ ...planar, flow: 1 }] });
    expect(resolveLayers({ ...emptyDesign(), layers: [stroke] })).toEqual(
      resolve({ type: "stroke", brush: { color: "#00ff00" }, dabs: [planar] }),
    );
  });

  it.each(BLEND_MODES)("hands on the blend mode %s, in both spaces, of decals and fills", (blend) => {
    for (const blendSpace of BLEND_SPACES) {
      const mixing = { blend, blendSpace, lockAlpha: true };
      expect(resolve(decal(mixing))[0]).toMatchObject(mixing);
      expect(resolve({ type: "fill", color: "#000000", ...mixing })[0]).toMatchObject(mixing);
    }
  });

  it.each([
    {
      kind: "perspective",
      position: [0, 0, 1],
      rotation: [0, 0, 0, 1],
      fov: 40,
      aspect: 1.5,
      near: 0.1,
      far: 9,
    },
    {
      kind: "cylindrical",
      position: [0, 0, 1],
      rotation: [0, 0, 0, 1],
      radius: 1,
      height: 2,
      arc: 360,
      depth: 0.1,
    },
    { kind: "uv", center: [0.5, 0.25], size: [1, 0.5], angle: -30 },
  ])("hands on a decal by the projector $kind, its numbers as they are", (projector) => {
    expect(resolve(decal({ projector }))[0]).toMatchObject({ type: "decal", projector });
  });

  it("makes words the picture of a decal, in the design's own font by its key", () => {
    const text = { type: "text", text: "Ada", font: "serif", color: "#ff0000", projector: planar };
    const [layer] = resolve({ ...text, outline: { color: "#0000ff80", width: 0.1 }, name: "Name", opacity: 0.5 });
    expect(layer).toEqual({
      ...resolve(decal({ opacity: 0.5 }))[0],
      asset: {
        text: "Ada",
        font: "serif",
        fontSize: 1,
        letterSpacing: 0,
        align: "center",
        curve: 0,
        color: [1, 0, 0, 1],
        outline: { color: [0, 0, 1, 128 / 255], width: 0.1 },
      },
    });
  });

  it("names a font that comes with Texelcast by its address, and mirrors words as it mirrors pictures", () => {
    const text = { type: "text", text: "Ada", font: "inter", projector: planar };
    expect(resolve({ ...text, mirror: { axis: "x", readable: true } })[0]).toMatchObject({
      type: "stroke",
      brush: { tip: "picture", asset: { text: "Ada", font: "texelcast:fonts/inter-700" } },
      dabs: [{ flow: 1 }, { flow: 1 }],
    });
  });

  it("hands on a stroke with every field, its colours as numbers and its dabs as they are", () => {
    const dabs = [planar, { kind: "uv", center: [0, 0], size: [1, 1], angle: 0, flow: 0.5 }];
    expect(resolve({ type: "stroke", brush: { color: "#ff800033" }, dabs })[0]).toEqual({
      id: "layer-1",
      type: "stroke",
      material: 0,
      visible: true,
      brush: { tip: "round", color: [1, 128 / 255, 0, 0.2], hardness: 1, flow: 1 },
      opacity: 1,
      blend: "normal",
      blendSpace: "srgb",
      lockAlpha: false,
      mask: null,
      filter: "linear",
      wrap: "none",
      flipX: false,
      flipY: false,
      backfaces: false,
      angleFade: [70, 90],
      occlusion: "self",
      dabs: [{ ...planar, flow: 1 }, dabs[1]],
    });
    const brush = { tip: "picture", asset: "logo", flow: 0.25 };
    expect(resolve({ type: "stroke", brush, dabs: [] })[0]).toMatchObject({ brush: { ...brush, color: null } });
    expect(resolve({ type: "stroke", brush: { ...brush, color: "#0000ff" }, dabs: [] })[0]).toMatchObject({
      brush: { ...brush, color: [0, 0, 1, 1] },
    });
  });

  it("keeps a stroke's dabs the same objects, by which the engine knows what is new", () => {
    const dab = { ...planar, flow: 1 };
    const made = makeStrokeLayer({
      id: "s",
      brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
      dabs: [dab],
    });
    const [layer] = resolveLayers({ ...emptyDesign(), layers: [made] });
    expect(layer?.type === "stroke" && layer.dabs[0]).toBe(dab);
  });

  it("lets a mask's layers reach what the masked layer paints, whatever materials they name", () => {
    const mask = { layers: [decal(), { type: "fill", color: "#000000", material: 7, mask: { layers: [decal()] } }] };
    const [masked] = resolve(decal({ material: [1, 2], mask }));
    expect(masked?.mask?.layers).toMatchObject([
      { material: [1, 2] },
      { material: [1, 2], mask: { layers: [{ material: [1, 2] }] } },
    ]);
    const inside = [
      decal({ material: 3 }),
      { type: "paint", strokes: [{ type: "stroke", brush: {}, dabs: [], material: 5 }] },
    ];
    const [group] = resolve({ type: "group", layers: inside, mask: { layers: [decal({ material: 1 })] } });
    expect(group?.mask?.layers).toMatchObject([{ material: [3, 5] }]);
  });

  it("keeps what a mask has in the texture itself to those of its materials that the masked layer paints", () => {
    const stamp = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 };
    const parts = { kind: "faces", faces: [0] };
    const layers = [
      decal({ projector: stamp, material: [2, 3] }),
      decal({ projector: stamp, material: 9 }),
      { type: "fill", color: "#000000", parts, material: 1 },
      { type: "fill", color: "#000000", parts, material: 9 },
      { type: "stroke", brush: {}, dabs: [stamp], material: 2 },
    ];
    const [masked] = resolve(decal({ material: [1, 2], mask: { layers } }));
    const materials = masked?.mask?.layers.map((layer) => (layer.type === "group" ? null : layer.material));
    expect(materials).toEqual([2, [1, 2], 1, [], 2]);
  });

  it("follows a masked layer to other materials", () => {
    const mask = { layers: [decal()], invert: false };
    const design = parseDesign({
      format: "texelcast-design",
      version: 1,
      assets: { logo: { type: "image/png", uri: "a" } },
      layers: [decal({ mask })],
    });
    expect(resolveLayers(design)[0]?.mask?.layers).toMatchObject([{ material: 0 }]);
    const [layer] = design.layers;
    if (layer === undefined) throw new Error("The design has a layer.");
    const moved = resolveLayers({ ...design, layers: [{ ...layer, material: [0, 4] }] });
    expect(moved[0]?.mask?.layers).toMatchObject([{ material: [0, 4] }]);
  });

  it("masks the twin of a mirrored layer as it masks the layer, and a twin that stays readable as its picture lies", () => {
    const brush = { tip: "round", color: "#000000", hardness: 1, flow: 1 } as const;
    const dab = { ...planar, position: [1.25, 0.5, 0], flow: 1 };
    const hiding = { type: "stroke", brush, blend: "erase", dabs: [dab] };
    const stamp = {
      type: "decal",
      asset: "logo",
      projector: { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 },
    };
    const masked = (mirror: object, layer = decal()) => ({
      ...layer,
      ...(layer.type === "decal" && { projector: { ...planar, position: [1, 0, 0] } }),
      mirror,
      mask: {
        layers: [
          hiding,
          { ...hiding, mirror: { axis: "x" } },
          decal({ projector: { ...planar, position: [2, 0, 0] } }),
          stamp,
        ],
      },
    });
    const maskOf = (layer: object) => resolve(layer)[0]?.mask?.layers ?? [];
    const places = (layer: EngineLayer | undefined) =>
      layer?.type === "stroke" ? layer.dabs.map((each) => each.kind === "planar" && each.position) : null;

    const mirrored = maskOf(masked({ axis: "x" }));
    expect(mirrored.map(places)).toEqual([
      [
        [1.25, 0.5, 0],
        [-1.25, 0.5, 0],
      ],
      [
        [1.25, 0.5, 0],
        [-1.25, 0.5, 0],
      ],
      [
        [2, 0, 0],
        [-2, 0, 0],
      ],
      null,
    ]);
    expect(mirrored[0]).toMatchObject({ blend: "erase", dabs: [{}, { flipX: true }] });
    expect(places(maskOf(masked({ axis: "x", readable: true }))[0])).toEqual([
      [1.25, 0.5, 0],
      [-0.75, 0.5, 0],
    ]);
    const paint = { type: "paint", strokes: [{ type: "stroke", brush, dabs: [dab] }] };
    expect(maskOf(masked({ axis: "x" }, paint as never)).map(places)).toEqual(mirrored.map(places));
    expect(maskOf({ ...masked({ axis: "x" }), mirror: null }).map(places)[0]).toEqual([[1.25, 0.5, 0]]);
  });
});
