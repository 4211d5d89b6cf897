import { describe, expect, it } from "vitest";
import { type LayerMaterials, makeDecalLayer } from "../../web/editor/document/index.ts";
import { DecalReach } from "../../web/editor/state/decal-reach.ts";
import type { MaterialInfo, PlanarProjector } from "../../web/engine/engine-api.ts";

const at = (x: number): PlanarProjector => ({
  kind: "planar",
  position: [x, 0, 0],
  rotation: [0, 0, 0, 1],
  size: [1, 1, 1],
});

/** Material 0 lies left of x = 1, material 1 right of x = -1, material 2, which takes no decals, is met everywhere. */
function reachOf(count = 3): DecalReach {
  const materials = [null, null, { code: "no-uvs", message: "" }].slice(0, count);
  return new DecalReach(
    {
      materialsReached: (projector) => {
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

  it("stay where it leaves the model, or lands on what takes no decals", () => {
    const reach = reachOf();
    expect(reach.movedTo(layer(-5, 0), at(100), null)).toBe(0);
    expect(reach.movedTo(layer(100, 0), at(100), 2)).toBe(0);
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
