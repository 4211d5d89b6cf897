import { describe, expect, it } from "vitest";
import {
  type Dab,
  type Mask,
  type MaskLayer,
  makeDecalLayer,
  makeFillLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import { carriedGroupMask, carriedMask, maskGoesAlong } from "../../web/editor/state/carried-mask.ts";
import type { MaskSurface } from "../../web/editor/state/remembered-surface.ts";
import { spun } from "../../web/editor/state/rotation.ts";
import type {
  CylindricalProjector,
  PerspectiveProjector,
  PlanarProjector,
  Projector,
  Quaternion,
  UvProjector,
  Vec3,
} from "../../web/engine/engine-api.ts";

const FRONT: PlanarProjector = { kind: "planar", position: [1, 0, 0], rotation: [0, 0, 0, 1], size: [2, 1, 0.5] };
const dabAt = (position: Vec3, rest: Partial<PlanarProjector> = {}): Dab => ({
  ...{ kind: "planar", rotation: [0, 0, 0, 1], size: [0.2, 0.2, 0.2], flow: 0.5 },
  ...rest,
  position,
});
const strokeOf = (...dabs: Dab[]): MaskLayer =>
  makeStrokeLayer({ id: "s", brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 }, blend: "erase", dabs });
const maskOf = (...layers: MaskLayer[]): Mask => ({ layers, invert: false, linked: true });
const surfaceOf = (foot: (place: Vec3) => Vec3 | null): MaskSurface => ({
  near: (place) => {
    const position = foot(place);
    return position && { position, normal: [0, 0, 1], material: 0, uv: [0, 0], face: 0 };
  },
  atUv: () => null,
});
/** The plane z = 0. */
const flat = surfaceOf(([x, y]) => [x, y, 0]);
const nowhere = surfaceOf(() => null);

function carried(start: Projector, now: Projector, layer: MaskLayer, near = flat): MaskLayer {
  const mask = carriedMask({ projector: start, mask: maskOf(layer), mirror: null, material: 0 }, now, near);
  return mask?.layers[0] as MaskLayer;
}
function carriedDab(start: Projector, now: Projector, dab: Dab, near = flat): Dab {
  const layer = carried(start, now, strokeOf(dab), near);
  if (layer.type !== "stroke" || layer.dabs.length !== 1) throw new Error("The stroke has become something else.");
  return layer.dabs[0] as Dab;
}
const ABOUT_Y = (degrees: number): Quaternion => {
  const half = (degrees * Math.PI) / 360;
  return [0, Math.sin(half), 0, Math.cos(half)];
};
const near = (value: unknown): unknown =>
  typeof value === "number"
    ? expect.closeTo(value, 5)
    : Array.isArray(value)
      ? value.map(near)
      : value !== null && typeof value === "object"
        ? Object.fromEntries(Object.entries(value).map(([key, part]) => [key, near(part)]))
        : value;

describe("a mask goes with its layer", () => {
  it("where that is moved and turned, each dab on its place of the picture", () => {
    const now = { ...FRONT, position: [3, 1, 0], rotation: spun(FRONT.rotation, 90) } as const;
    expect(carriedDab(FRONT, now, dabAt([1.5, 0.25, 0]))).toEqual(
      near(dabAt([2.75, 1.5, 0], { rotation: spun([0, 0, 0, 1], 90) })),
    );
  });

  it("where that grows, and where one side of it does", () => {
    const twice: PlanarProjector = { ...FRONT, size: [4, 2, 0.5] };
    const grown = dabAt([2, 0.5, 0], { size: [0.4, 0.4, 0.4] });
    expect(carriedDab(FRONT, twice, dabAt([1.5, 0.25, 0]))).toEqual(near(grown));
    const wider: PlanarProjector = { ...FRONT, size: [4, 1, 0.5] };
    const upright = dabAt([1.5, 0.25, 0], { rotation: spun([0, 0, 0, 1], 90) });
    const high = carriedDab(FRONT, wider, upright);
    expect(high).toMatchObject(near({ position: [2, 0.25, 0], size: [0.2, 0.4, 0.2 * Math.SQRT2] }) as object);
    expect(carriedDab(wider, FRONT, high), "and back").toEqual(near(upright));
  });

  it("round a mug with a label, which also grows there", () => {
    const label: CylindricalProjector = {
      ...{
        kind: "cylindrical",
        position: [0, 0, 0],
        rotation: [0, 0, 0, 1],
        radius: 1,
        height: 1,
        arc: 90,
        depth: 0.2,
      },
    };
    const onMug = (degrees: number, y: number, size: Vec3): Dab => {
      const angle = (degrees * Math.PI) / 180;
      return dabAt([Math.sin(angle), y, Math.cos(angle)], { rotation: ABOUT_Y(degrees), size });
    };
    const now = { ...label, position: [0, 1, 0], rotation: ABOUT_Y(60), height: 2, arc: 180 } as const;
    expect(carriedDab(label, now, onMug(20, 0.25, [0.1, 0.1, 0.1]), nowhere)).toEqual(
      near(onMug(100, 1.5, [0.2, 0.2, 0.2])),
    );
  });

  it("with what a lens throws, as wide as that opens", () => {
    const lens: PerspectiveProjector = {
      ...{ kind: "perspective", position: [0, 0, 2], rotation: [0, 0, 0, 1], fov: 60, aspect: 1, near: 0.1, far: 9 },
    };
    const wide = { ...lens, fov: (Math.atan(2 * Math.tan(Math.PI / 6)) * 360) / Math.PI };
    expect(carriedDab(lens, wide, dabAt([0.1, 0.2, 0]))).toEqual(near(dabAt([0.2, 0.4, 0], { size: [0.4, 0.4, 0.4] })));
  });

  it("stays on a surface that does not go on as it did, and beside the model where it was", () => {
    const step = surfaceOf(([x, y]) => (y > 0.6 ? null : [x, y, x > 2 ? -0.3 : 0]));
    const now: PlanarProjector = { ...FRONT, position: [2, 0, 0] };
    expect(carriedDab(FRONT, now, dabAt([1.5, 0, 0.05]), step)).toEqual(near(dabAt([2.5, 0, -0.25])));
    expect(carriedDab(FRONT, now, dabAt([1.5, 0.7, 0.05]), step)).toEqual(near(dabAt([2.5, 0.7, 0.05])));
  });

  it("in the texture as a stamp does", () => {
    const stamp: UvProjector = { kind: "uv", center: [0.5, 0.5], size: [0.2, 0.2], angle: 0 };
    const dab: Dab = { kind: "uv", center: [0.6, 0.5], size: [0.02, 0.04], angle: 0, flow: 1 };
    const now: UvProjector = { ...stamp, center: [0.3, 0.4], angle: 90, size: [0.4, 0.4] };
    expect(carriedDab(stamp, now, dab)).toEqual(near({ ...dab, center: [0.3, 0.6], angle: 90, size: [0.04, 0.08] }));
    const turned: UvProjector = { ...stamp, angle: 30 };
    expect(carriedDab(turned, { ...turned, center: [0, 0] }, dab)).toEqual(near({ ...dab, center: [0.1, 0] }));
  });

  it("with its gradients, and with decals in it", () => {
    const now: PlanarProjector = { ...FRONT, position: [2, 0, 0], size: [4, 2, 0.5] };
    const stops = [
      { offset: 0, color: "#000000" },
      { offset: 1, color: "#00000000" },
    ];
    const fill = makeFillLayer({ id: "f", color: "#000000" });
    const linear = { ...fill, gradient: { kind: "linear", from: [1, -0.4, 0], to: [1, 0.4, 0], stops } } as const;
    expect(carried(FRONT, now, linear)).toMatchObject(
      near({ gradient: { from: [2, -0.8, 0], to: [2, 0.8, 0] } }) as object,
    );
    const radial = { ...fill, gradient: { kind: "radial", center: [1.5, 0, 0], radius: 0.5, stops } } as const;
    expect(carried(FRONT, now, radial)).toMatchObject(near({ gradient: { center: [3, 0, 0], radius: 1 } }) as object);
    const decal = makeDecalLayer({ id: "d", asset: "logo", projector: FRONT });
    expect(carried(FRONT, now, decal)).toMatchObject({ projector: near({ ...now, size: [4, 2, 1] }) });
  });
});

describe("a mask stays as it is", () => {
  const now: PlanarProjector = { ...FRONT, position: [2, 0, 0] };
  const stays = (mask: Mask, goal: Projector = now): void =>
    expect(carriedMask({ projector: FRONT, mask, mirror: null, material: 0 }, goal, flat)).toBe(mask);

  it("where it is not linked, or its layer is where it was", () => {
    const mask = maskOf(strokeOf(dabAt([1.123456789, 0, 0])));
    stays({ ...mask, linked: false });
    stays(mask, { ...FRONT });
    expect(carriedMask({ projector: FRONT, mask: null, mirror: null, material: 0 }, now, flat)).toBeNull();
  });

  it("where its layer is thrown as another kind", () => {
    stays(maskOf(strokeOf(dabAt([1, 0, 0]))), { ...FRONT, kind: "uv", center: [0, 0], angle: 0, size: [1, 1] });
  });

  it("where nothing in it can go along", () => {
    const fill = makeFillLayer({ id: "f", color: "#000000" });
    const uv: UvProjector = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 };
    const sheet = makeDecalLayer({ id: "sheet", asset: "pixels", projector: uv });
    stays(maskOf(fill, sheet, strokeOf({ ...uv, flow: 1 })));
    expect(maskGoesAlong(maskOf(fill, strokeOf(dabAt([1, 0, 0]))), [{ projector: FRONT }])).toBe(true);
    expect(maskGoesAlong(maskOf(fill, sheet), [{ projector: FRONT }])).toBe(false);
    expect(maskGoesAlong(maskOf(sheet), [{ projector: uv }])).toBe(true);
    expect(maskGoesAlong({ ...maskOf(), linked: false }, [{ projector: uv }])).toBe(false);
  });
});

describe("the mask of a stamp goes with it over the surface", () => {
  /** The texture's left half lies on the plane z = 0, its right half on the plane x = 5 round the corner; four metres wide. */
  const corner: MaskSurface = {
    near: ([x, y, z]) =>
      x < 4.9
        ? { position: [x, y, 0], normal: [0, 0, 1], material: 0, uv: [x / 4, -y / 4], face: 0 }
        : { position: [5, y, z], normal: [1, 0, 0], material: 0, uv: [0.5 - z / 4, -y / 4], face: 1 },
    atUv: (material, [u, v]) => {
      if (material !== 0 || u < 0 || u > 1) return null;
      const place: Vec3 = u < 0.5 ? [4 * u, -4 * v, 0] : [5, -4 * v, 2 - 4 * u];
      return { position: place, normal: u < 0.5 ? [0, 0, 1] : [1, 0, 0], material, uv: [u, v], face: 0 };
    },
  };
  const stamp: UvProjector = { kind: "uv", center: [0.25, 0.5], size: [0.2, 0.2], angle: 0 };
  const carriedBy = (now: UvProjector, layer: MaskLayer, material = 0): MaskLayer =>
    carriedMask({ projector: stamp, mask: maskOf(layer), mirror: null, material }, now, corner)?.layers[0] as MaskLayer;
  const dab = dabAt([1.2, -1.8, 0.01]);

  it("each dab to where its place of the texture is taken, turned and sized as that", () => {
    expect(carriedBy({ ...stamp, center: [0.75, 0.5] }, strokeOf(dab))).toMatchObject({
      dabs: [near({ position: [5.01, -1.8, -1.2], rotation: ABOUT_Y(90), size: [0.2, 0.2, 0.2] })],
    });
    const twice: UvProjector = { ...stamp, angle: 90, size: [0.4, 0.4] };
    expect(carriedBy(twice, strokeOf(dab))).toMatchObject({
      dabs: [near({ position: [1.4, -2.4, 0.02], rotation: spun([0, 0, 0, 1], -90), size: [0.4, 0.4, 0.4] })],
    });
  });

  it.each([
    ["a fold of the surface", 2],
    ["another part of it", 5],
  ])("a dab at its chart's rim, beyond which the texture goes on with %s, as those beside it", (_what, side) => {
    const folded: MaskSurface = {
      near: ([x, y]) => ({ position: [x, y, 0], normal: [0, 0, 1], material: 0, uv: [x / 4, -y / 4], face: 0 }),
      atUv: (material, uv) => {
        const hit = corner.atUv(material, uv);
        const [x, y, z] = hit?.position ?? [0, 0, 0];
        return hit && { ...hit, position: [x === 5 ? side : x, y, z] };
      },
    };
    const layer = strokeOf(dabAt([1.9999, -1.8, 0.01]));
    const now: UvProjector = { ...stamp, center: [0.25, 0.4] };
    expect(
      carriedMask({ projector: stamp, mask: maskOf(layer), mirror: null, material: 0 }, now, folded),
    ).toMatchObject({
      layers: [{ dabs: [near({ position: [1.9999, -1.4, 0.01], rotation: [0, 0, 0, 1], size: [0.2, 0.2, 0.2] })] }],
    });
  });

  it("and is never smaller or larger than a design may have it", () => {
    const least: UvProjector = { ...stamp, size: [2e-10, 0.2] };
    const layer = carriedBy(least, strokeOf(dab));
    if (layer.type !== "stroke") throw new Error("It is no stroke any more.");
    const { size } = layer.dabs[0] as PlanarProjector;
    expect(Math.min(...size)).toBe(1e-9);
    const sheet = makeDecalLayer({ id: "d", asset: "a", projector: { ...FRONT, size: [1e-3, 1e-3, 1e-3] } });
    const start: PlanarProjector = { ...FRONT, size: [1e6, 1e6, 1] };
    const shrunk = carried(start, { ...start, size: [1e-2, 1e-2, 1] }, sheet, nowhere);
    expect(shrunk).toMatchObject({ projector: { size: [1e-9, 1e-9, expect.any(Number)] } });
    const grown = carried({ ...start, size: [1e-5, 1e-5, 1] }, { ...start, size: [1e9, 1e9, 1] }, sheet, nowhere);
    expect(grown).toMatchObject({ projector: { size: [1e9, 1e9, expect.any(Number)] } });
  });

  it("gradients as the surface under its middle does", () => {
    const stops = [
      { offset: 0, color: "#000000" },
      { offset: 1, color: "#00000000" },
    ];
    const fill = makeFillLayer({ id: "f", color: "#000000" });
    const linear = { ...fill, gradient: { kind: "linear", from: [1, -9, 0], to: [1, 3, 0], stops } } as const;
    const now: UvProjector = { ...stamp, center: [0.75, 0.25], angle: 180 };
    expect(carriedBy(now, linear)).toMatchObject(near({ gradient: { from: [5, 6, -1], to: [5, -6, -1] } }) as object);
  });

  it("and stays where the texture has no surface there", () => {
    const stroke = strokeOf(dab);
    expect(carriedBy({ ...stamp, center: [1.6, 0.5] }, stroke)).toBe(stroke);
    expect(carriedBy({ ...stamp, center: [0.75, 0.5] }, stroke, 1)).toBe(stroke);
  });
});

describe("the mask of a group goes with the pictures in it", () => {
  const picture = (x: number, rest: Partial<PlanarProjector> = {}) => ({
    projector: { ...FRONT, position: [x, 0, 0] as Vec3, ...rest },
    mirror: null,
    material: 0,
  });
  const [left, right] = [picture(0), picture(4)];
  const dabsOf = (mask: Mask | null): (readonly [number, number, number])[] =>
    (mask?.layers ?? []).flatMap((layer) =>
      layer.type === "stroke" ? layer.dabs.flatMap((dab) => (dab.kind === "uv" ? [] : [dab.position])) : [],
    );

  it("each thing in it as it would on the picture that it is nearest to", () => {
    const mask = maskOf(strokeOf(dabAt([0.5, 0, 0]), dabAt([2.5, 0, 0]), dabAt([3.5, 0.2, 0])));
    const up = { ...left.projector, position: [0, 1, 0] } as const;
    const turned = { ...right.projector, rotation: spun(FRONT.rotation, 90) };
    const carried = carriedGroupMask(mask, [left, right], [up, turned], flat);
    expect(dabsOf(carried)).toEqual(
      near([
        [0.5, 1, 0],
        [4, -1.5, 0],
        [3.8, -0.5, 0],
      ]),
    );
    expect(carriedGroupMask(mask, [left, right], [left.projector, right.projector], flat)).toBe(mask);
    expect(carriedGroupMask({ ...mask, linked: false }, [left], [up], flat)).toMatchObject({ layers: mask.layers });
  });

  it("as one body where they are moved as one, gradients too", () => {
    const stops = [
      { offset: 0, color: "#000000" },
      { offset: 1, color: "#00000000" },
    ];
    const fill = makeFillLayer({ id: "f", color: "#000000" });
    const gradient = { kind: "linear", from: [-1, 0, 0], to: [5, 0, 0], stops } as const;
    const mask = maskOf({ ...fill, gradient }, strokeOf(dabAt([1.9, 0, 0]), dabAt([2.1, 0, 0])));
    const about = (x: number): PlanarProjector => ({
      ...FRONT,
      position: [2, x - 2, 0],
      rotation: spun([0, 0, 0, 1], 90),
    });
    const carried = carriedGroupMask(mask, [left, right], [about(0), about(4)], flat);
    expect(carried?.layers[0]).toMatchObject(near({ gradient: { from: [2, -3, 0], to: [2, 3, 0] } }) as object);
    expect(dabsOf(carried)).toEqual(
      near([
        [2, -0.1, 0],
        [2, 0.1, 0],
      ]),
    );
  });

  it("what lies in a texture with the stamps alone", () => {
    const stamp: UvProjector = { kind: "uv", center: [0.2, 0.2], size: [0.1, 0.1], angle: 0 };
    const other: UvProjector = { ...stamp, center: [0.8, 0.8] };
    const mask = maskOf(strokeOf({ ...other, center: [0.7, 0.7], flow: 1 }, dabAt([0.5, 0, 0])));
    const pictures = [
      left,
      { projector: stamp, mirror: null, material: 0 },
      { projector: other, mirror: null, material: 0 },
    ];
    const moved: UvProjector = { ...other, center: [0.9, 0.8] };
    const carried = carriedGroupMask(mask, pictures, [{ ...left.projector, position: [1, 0, 0] }, stamp, moved], flat);
    expect(carried?.layers[0]).toMatchObject({ dabs: [{ center: near([0.8, 0.7]) }, { position: near([1.5, 0, 0]) }] });
    expect(maskGoesAlong(mask, pictures)).toBe(true);
    expect(maskGoesAlong(mask, [left])).toBe(false);
  });
});

it("what masks a layer where its mirror shows it goes as that does", () => {
  const mirror = { axis: "x", offset: 0, readable: false } as const;
  const layer = {
    projector: FRONT,
    material: 0,
    mirror,
    mask: maskOf(strokeOf(dabAt([1.5, 0, 0]), dabAt([-1.5, 0, 0]))),
  };
  const now: PlanarProjector = { ...FRONT, position: [2, 0.5, 0], rotation: spun(FRONT.rotation, 90) };
  const [stroke] = carriedMask(layer, now, flat)?.layers ?? [];
  expect(stroke).toMatchObject({ dabs: [{ position: near([2, 1, 0]) }, { position: near([-2, 1, 0]) }] });
});
