import { describe, expect, it } from "vitest";
import {
  type LayerMaterials,
  makeDecalLayer,
  makePaintLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import { DecalReach } from "../../web/editor/state/decal-reach.ts";
import { mirrorPatch, scrubbedMirrorPatch } from "../../web/editor/state/mirror-reach.ts";
import type { MaterialInfo, PlanarProjector } from "../../web/engine/engine-api.ts";

const at = (x: number): PlanarProjector => ({
  kind: "planar",
  position: [x, 0, 0],
  rotation: [0, 0, 0, 1],
  size: [1, 1, 1],
});

/** Material 0 lies left of x = 1, material 1 right of x = -1, material 2, which takes no decals, is met everywhere. */
function reachOf(count = 3, asked: unknown[] = []): DecalReach {
  const materials = [null, null, { code: "no-uvs", message: "" }].slice(0, count);
  return new DecalReach(
    {
      materialsReached: (projector) => {
        asked.push(projector);
        const x = projector.kind === "planar" ? projector.position[0] : 0;
        return [...(x < 1 ? [0] : []), ...(x > -1 && x < 50 ? [1] : []), ...(x < 50 ? [2] : [])];
      },
    },
    () => materials.map((refusal, index) => ({ index, refusal }) as MaterialInfo),
  );
}
const layer = (x: number, material: LayerMaterials) =>
  makeDecalLayer({ id: "a", asset: "logo", projector: at(x), material });

describe("a decal's materials", () => {
  it("are all that it meets and that take decals, one of them as a number", () => {
    expect(reachOf().at(at(0), false, 7)).toEqual([0, 1]);
    expect(reachOf().at(at(-5), false, 7)).toBe(0);
    expect(reachOf().at(at(100), false, 7)).toBe(7);
  });

  it("follow it over a border and beyond", () => {
    const reach = reachOf();
    expect(reach.movedTo(layer(-5, 0), at(0), 0)).toEqual([0, 1]);
    expect(reach.movedTo(layer(0, [0, 1]), at(5), 1)).toBe(1);
    expect(reach.movedTo(layer(-5, 0), at(5), null)).toBe(1);
  });

  it("stay what they were chosen to be where it was kept off one that it meets", () => {
    const reach = reachOf();
    expect(reach.movedTo(layer(0, 0), at(0.5), 0)).toBe(0);
    expect(reach.movedTo(layer(0, 0), at(0.5), null)).toBe(0);
    expect(reach.movedTo(layer(0, 0), at(0.5), 1)).toBe(1);
  });

  it("stay where it leaves the model", () => {
    const reach = reachOf();
    expect(reach.movedTo(layer(-5, 0), at(100), null)).toBe(0);
    expect(reach.movedTo(layer(0, 0), at(100), null)).toBe(0);
  });

  it("are what it lies on where that alone takes no decals, as that may be unwrapped yet; not where it was kept off others", () => {
    const reach = reachOf();
    expect(reach.movedTo(layer(-5, 0), at(100), 2)).toBe(2);
    expect(reach.movedTo(layer(0, 0), at(100), 2)).toBe(0);
    expect(reach.movedTo(layer(100, 2), at(0), 0), "from there it goes on as others do").toEqual([0, 1]);
  });

  it("are those of its twin, too, from when it has a mirror until it has none", () => {
    const reach = reachOf();
    const mirror = { axis: "x", offset: 0, readable: false } as const;
    expect(reach.at(at(-5), false, 7, mirror)).toEqual([0, 1]);
    expect(reach.movedTo(layer(-5, 0), at(-5), null, mirror)).toEqual([0, 1]);
    const mirrored = { ...layer(-5, [0, 1]), mirror };
    expect(reach.movedTo(mirrored, at(-6), 0)).toEqual([0, 1]);
    expect(reach.movedTo(mirrored, at(-5), null, null)).toBe(0);
    expect(reach.movedTo({ ...layer(-5, 0), mirror }, at(-6), 0), "kept off its twin's").toBe(0);
  });

  it("are the model's one where it has no other, however the decal came to another", () => {
    expect(reachOf(1).movedTo(layer(0, 0), at(5), null)).toBe(0);
    expect(reachOf(1).movedTo(layer(0, 5), at(5), 0)).toBe(0);
  });

  it("tell of a bare part where it reaches nothing that takes decals", () => {
    const reach = reachOf();
    expect(reach.bareOf(at(100), false, 2)).toMatchObject({ index: 2 });
    expect(reach.bareOf(at(0), false, 2)).toBeNull();
    expect(reach.bareOf(at(100), false, 0)).toBeNull();
    expect(reach.bareOf(at(100), false, null)).toBeNull();
  });
});

describe("a mirror for what was painted", () => {
  const mirror = { axis: "x", offset: 0, readable: false } as const;
  const dab = { ...at(-5), flow: 1 };
  const brush = { tip: "round", color: "#000000", hardness: 1, flow: 1 } as const;
  const stroke = makeStrokeLayer({ id: "s", brush, dabs: [dab], material: 0 });

  it("brings the materials of the twins, to a stroke and to each of a paint layer", () => {
    expect(mirrorPatch(reachOf(), stroke, mirror)).toEqual({ mirror, material: [0, 1] });
    const paint = makePaintLayer({ id: "p", strokes: [stroke], material: 0 });
    expect(mirrorPatch(reachOf(), paint, mirror).strokes).toMatchObject([{ material: [0, 1] }]);
    expect(mirrorPatch(reachOf(), paint, null)).toEqual({ mirror: null, strokes: [stroke] });
  });

  it("brings those of a twin's twin where the stroke has a mirror of its own", () => {
    const own = makeStrokeLayer({ ...stroke, mirror: { axis: "y", offset: 0, readable: false } });
    const paint = makePaintLayer({ id: "p", strokes: [own], material: 0 });
    expect(mirrorPatch(reachOf(), paint, mirror).strokes).toMatchObject([{ material: [0, 1] }]);
  });

  it("leaves a stroke as the object that it is where the twins meet nothing new", () => {
    const wide = { ...stroke, material: [0, 1] };
    const paint = makePaintLayer({ id: "p", strokes: [wide], material: 0 });
    expect(mirrorPatch(reachOf(), paint, mirror).strokes?.[0]).toBe(wide);
  });

  it("asks for few of many twins while it is scrubbed, of strokes with a dab each too, and for all when it is set", () => {
    const dabs = Array.from({ length: 2000 }, (_, place) => ({ ...at(-5 - place / 100), flow: 1 }));
    const long = makeStrokeLayer({ ...stroke, dabs });
    const points = dabs.map((each, place) => makeStrokeLayer({ ...stroke, id: `s${place}`, dabs: [each] }));
    for (const layer of [
      long,
      makePaintLayer({ id: "p", strokes: [long, long], material: 0 }),
      makePaintLayer({ id: "p", strokes: points, material: 0 }),
    ]) {
      const asked: unknown[] = [];
      const few = scrubbedMirrorPatch(reachOf(3, asked), layer, mirror);
      expect(asked.length).toBeGreaterThan(16);
      expect(asked.length).toBeLessThanOrEqual(32);
      const materials = layer.type === "paint" ? few.strokes?.map(({ material }) => material) : [few.material];
      expect(materials?.[0]).toEqual([0, 1]);
      asked.length = 0;
      const all = mirrorPatch(reachOf(3, asked), layer, mirror);
      expect(asked).toHaveLength(layer.type === "paint" ? layer.strokes.flatMap((one) => one.dabs).length : 2000);
      expect(all.strokes?.every(({ material }) => String(material) === "0,1") ?? true).toBe(true);
    }
  });

  it("asks for all twins of a short stroke while it is scrubbed", () => {
    expect(scrubbedMirrorPatch(reachOf(), stroke, mirror)).toEqual(mirrorPatch(reachOf(), stroke, mirror));
  });
});
