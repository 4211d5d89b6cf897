/** Random designs for property tests: everything that spec.md, 8, allows, with every field set. */
import fc from "fast-check";
import {
  ALIGNS,
  BLEND_MODES,
  BLEND_SPACES,
  type Dab,
  type Design,
  type DesignAsset,
  type DesignLayer,
  FILTERS,
  type Gradient,
  layerDepth,
  MIRROR_AXES,
  type Mirror,
  OCCLUSIONS,
  type Parts,
  PICTURE_TYPES,
  type Projector,
  WRAPS,
} from "../../web/editor/document/index.ts";

// JSON has no -0, so a document cannot keep one.
const finite = (min: number, max: number) =>
  fc.double({ min, max, noNaN: true }).map((value) => (Object.is(value, -0) ? 0 : value));
const coordinate = finite(-1e9, 1e9);
const length = finite(1e-9, 1e9);
const point = fc.tuple(coordinate, coordinate, coordinate);
const rotation = fc
  .tuple(finite(-1, 1), finite(-1, 1), finite(-1, 1), finite(-1, 1))
  .filter((parts) => Math.hypot(...parts) > 1e-2);
const hexDigits = fc.string({ unit: fc.constantFrom(..."0123456789abcdefABCDEF"), minLength: 8, maxLength: 8 });
const color = fc.tuple(hexDigits, fc.boolean()).map(([digits, alpha]) => `#${alpha ? digits : digits.slice(0, 6)}`);

const projector: fc.Arbitrary<Projector> = fc.oneof(
  fc.record({
    kind: fc.constant("planar" as const),
    position: point,
    rotation,
    size: fc.tuple(length, length, length),
  }),
  fc.record({
    kind: fc.constant("perspective" as const),
    position: point,
    rotation,
    fov: finite(1, 179),
    aspect: length,
    near: finite(0.01, 1),
    far: finite(2, 100),
  }),
  fc.record({
    kind: fc.constant("cylindrical" as const),
    position: point,
    rotation,
    radius: length,
    height: length,
    arc: finite(1, 360),
    depth: length,
  }),
  fc.record({
    kind: fc.constant("uv" as const),
    center: fc.tuple(coordinate, coordinate),
    size: fc.tuple(length, length),
    angle: coordinate,
  }),
);

const base = {
  name: fc.string(),
  material: fc.oneof(fc.nat(65_535), fc.uniqueArray(fc.nat(65_535), { minLength: 1, maxLength: 4 })),
  visible: fc.boolean(),
  opacity: finite(0, 1),
  blend: fc.constantFrom(...BLEND_MODES),
  blendSpace: fc.constantFrom(...BLEND_SPACES),
  lockAlpha: fc.boolean(),
  locked: fc.boolean(),
  mask: fc.constant(null),
};
const mirror = fc.option(
  fc.record({ axis: fc.constantFrom(...MIRROR_AXES), offset: coordinate, readable: fc.boolean() }),
);
/** Projectors of kind "uv" have no mirror. */
const unmirroredUv = <Layer extends { mirror: Mirror | null; projector: Projector }>(layer: Layer): Layer =>
  layer.projector.kind === "uv" ? { ...layer, mirror: null } : layer;
const stops = fc
  .array(fc.record({ offset: finite(0, 1), color }), { minLength: 2, maxLength: 5 })
  .map((list) => list.toSorted((a, b) => a.offset - b.offset));
const gradient: fc.Arbitrary<Gradient> = fc.oneof(
  fc
    .record({ kind: fc.constant("linear" as const), from: point, to: point, stops })
    .filter(({ from, to }) => from.some((part, axis) => Math.fround(part) !== Math.fround(to[axis] as number))),
  fc.record({ kind: fc.constant("radial" as const), center: point, radius: length, stops }),
);
const triangles = fc.array(fc.nat(0xffff_ffff), { maxLength: 5 });
const parts: fc.Arbitrary<Parts> = fc.oneof(
  fc.record({ kind: fc.constant("charts" as const), charts: triangles }),
  fc.record({ kind: fc.constant("faces" as const), faces: triangles }),
);
const projected = {
  backfaces: fc.boolean(),
  angleFade: fc.tuple(finite(0, 90), finite(0, 90)).map(([a, b]): [number, number] => [Math.min(a, b), Math.max(a, b)]),
  occlusion: fc.constantFrom(...OCCLUSIONS),
};
const picture = {
  filter: fc.constantFrom(...FILTERS),
  wrap: fc.constantFrom(...WRAPS),
  flipX: fc.boolean(),
  flipY: fc.boolean(),
};

function layers(pictures: readonly string[]): fc.Arbitrary<DesignLayer[]> {
  const decal = fc
    .record({
      type: fc.constant("decal" as const),
      id: fc.constant(""),
      ...base,
      ...projected,
      ...picture,
      projector,
      mirror,
      asset: fc.constantFrom(...pictures),
    })
    .map(unmirroredUv);
  const text = fc
    .record({
      type: fc.constant("text" as const),
      id: fc.constant(""),
      ...base,
      ...projected,
      ...picture,
      projector,
      mirror,
      text: fc.string(),
      font: fc.constant("the font"),
      fontSize: length,
      letterSpacing: finite(-1, 10),
      align: fc.constantFrom(...ALIGNS),
      curve: finite(-360, 360),
      color,
      outline: fc.option(fc.record({ color, width: length })),
    })
    .map(unmirroredUv);
  const stroke = fc
    .record({
      type: fc.constant("stroke" as const),
      id: fc.constant(""),
      ...base,
      ...projected,
      ...picture,
      mirror,
      brush: fc.oneof(
        fc.record({ tip: fc.constant("round" as const), color, hardness: finite(0, 1), flow: finite(0, 1) }),
        fc.record({
          tip: fc.constant("picture" as const),
          asset: fc.constantFrom(...pictures),
          color: fc.option(color),
          flow: finite(0, 1),
        }),
      ),
      dabs: fc.array(
        fc.tuple(projector, finite(0, 1)).map(([from, flow]): Dab => ({ ...from, flow })),
        { maxLength: 3 },
      ),
    })
    .map((layer) => (layer.dabs.some(({ kind }) => kind === "uv") ? { ...layer, mirror: null } : layer));
  const fill = fc
    .record({
      type: fc.constant("fill" as const),
      id: fc.constant(""),
      ...base,
      color,
      gradient: fc.option(gradient),
      parts: fc.option(parts),
    })
    .map((layer) => (typeof layer.material === "number" ? layer : { ...layer, parts: null }));
  const paint = fc
    .record({
      type: fc.constant("paint" as const),
      id: fc.constant(""),
      ...base,
      strokes: fc.array(stroke, { maxLength: 3 }),
      mirror,
    })
    .map((layer) =>
      layer.strokes.some(({ dabs }) => dabs.some(({ kind }) => kind === "uv")) ? { ...layer, mirror: null } : layer,
    );
  const leaf: fc.Arbitrary<DesignLayer> = fc.oneof(decal, text, stroke, fill, paint);
  const masked = (any: fc.Arbitrary<DesignLayer>): fc.Arbitrary<DesignLayer> => {
    const held = fc.array(fc.oneof(decal, text, stroke, fill), { maxLength: 2 });
    const mask = fc.option(fc.record({ layers: held, invert: fc.boolean(), linked: fc.boolean() }), { freq: 1 });
    return fc.tuple(any, mask).map(([layer, own]) => ({ ...layer, mask: own }) as DesignLayer);
  };
  const { any } = fc.letrec<{ any: DesignLayer; group: DesignLayer }>((tie) => ({
    any: masked(
      fc.oneof({ depthSize: "small" }, { arbitrary: leaf, weight: 4 }, { arbitrary: tie("group"), weight: 1 }),
    ),
    group: fc.record({
      type: fc.constant("group" as const),
      id: fc.constant(""),
      ...base,
      layers: fc.array(tie("any"), { maxLength: 3 }),
      isolated: fc.boolean(),
    }),
  }));
  return fc
    .tuple(
      fc.array(any, { maxLength: 6 }),
      fc.uniqueArray(fc.string({ minLength: 1, maxLength: 20 }), { minLength: 6, maxLength: 6 }),
    )
    .filter(([list]) => list.every((layer) => layerDepth(layer) <= 16))
    .map(([list, names]) => withIds(list, names));
}

/** Ids for the whole tree: names as they come, then numbers. */
function withIds(list: readonly DesignLayer[], names: readonly string[]): DesignLayer[] {
  let met = 0;
  const rename = <Layer extends DesignLayer>(layer: Layer): Layer => {
    const number = met++;
    const id = names[number] ?? `unnamed ${number} ${names.join("")}`;
    const mask = layer.mask && { ...layer.mask, layers: layer.mask.layers.map(rename) };
    if (layer.type === "group") return { ...layer, id, mask, layers: layer.layers.map(rename) };
    if (layer.type === "paint") return { ...layer, id, mask, strokes: layer.strokes.map(rename) };
    return { ...layer, id, mask };
  };
  return list.map(rename);
}

const reserved = ["__proto__", "prototype", "constructor", "the font"];
const assetName = fc.string({ minLength: 1, maxLength: 20 }).filter((name) => !reserved.includes(name));
const assetEntry = fc.tuple(
  assetName,
  fc.record({ type: fc.constantFrom(...PICTURE_TYPES), uri: fc.string({ minLength: 1 }) }),
);

export const arbitraryDesign: fc.Arbitrary<Design> = fc
  .array(assetEntry, { minLength: 1, maxLength: 4 })
  .chain((entries) => {
    const assets: Record<string, DesignAsset> = {
      ...Object.fromEntries(entries),
      "the font": { type: "font/ttf", uri: "font.ttf" },
    };
    return layers(entries.map(([name]) => name)).map(
      (list): Design => ({ format: "texelcast-design", version: 1, assets, layers: list }),
    );
  });
