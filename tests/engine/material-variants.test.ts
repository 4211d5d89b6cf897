import { describe, expect, it } from "vitest";
import { readContainer, writeGlb } from "../../web/engine/gltf-container.ts";
import type { JsonObject } from "../../web/engine/gltf-json.ts";
import { variantsOf, withVariant } from "../../web/engine/material-variants.ts";
import { buildModel, plane } from "../support/model-builder.ts";
import { glbWithVariants, primitivesOf } from "../support/variant-model.ts";

const NAMES = ["day", "night"];
const mapping = (material: number, ...variants: number[]): JsonObject => ({ material, variants });

interface Square {
  readonly material?: number;
  readonly mappings?: readonly JsonObject[];
}

/** Squares with their materials, of five, and what the variants make of them. */
function model(squares: readonly Square[], names: readonly string[] = NAMES) {
  const built = buildModel({
    meshes: squares.map(() => plane(1, 0)),
    materials: [0, 1, 2, 3, 4].map((index) => ({ name: `M${index}` })),
  });
  for (const [i, primitive] of primitivesOf(built.json).entries()) {
    const material = squares[i]?.material;
    if (material === undefined) delete primitive.material;
    else primitive.material = material;
  }
  const mappings = squares.map((square) => square.mappings);
  return { name: "model.glb", bytes: glbWithVariants(built, names, mappings) };
}

const materialsOf = (bytes: Uint8Array): unknown[] =>
  primitivesOf(readContainer({ name: "model.glb", bytes }).json).map(({ material }) => material);

describe("a model's variants", () => {
  it("are none where it names none", () => {
    const { json, binary } = buildModel({ meshes: [plane(1, 0)], materials: [] });
    expect(variantsOf({ name: "plain.glb", bytes: writeGlb(json, binary) })).toBeNull();
    expect(variantsOf(model([{ material: 0 }], []))).toBeNull();
  });

  it("tell which is shown, and whether the file's own look is one of them", () => {
    const first = { material: 0, mappings: [mapping(0, 0), mapping(1, 1)] };
    expect(variantsOf(model([first]))).toEqual({ names: NAMES, shown: 0, hasOwnLook: false });
    const other = { material: 2, mappings: [mapping(0, 0), mapping(1, 1)] };
    expect(variantsOf(model([other]))).toEqual({ names: NAMES, shown: null, hasOwnLook: true });
  });

  it("are shown with what they map, and what they do not stays", () => {
    const source = model([
      { material: 0, mappings: [mapping(3, 0), mapping(4, 1)] },
      { material: 1, mappings: [mapping(2, 1)] },
      { material: 1 },
    ]);
    const night = withVariant(source, 1);
    expect(materialsOf(night.glb)).toEqual([4, 2, 1]);
    expect([...night.moved]).toEqual([
      [0, [4]],
      [1, [1, 2]],
    ]);
    expect(night.isRenaming).toBe(false);
    expect(variantsOf({ name: "night.glb", bytes: night.glb })).toMatchObject({ shown: 1, hasOwnLook: true });
  });

  it("are left again for another one and for the file's own look, also where that has no material", () => {
    const source = model([{ material: 0, mappings: [mapping(3, 0), mapping(4, 1)] }, { mappings: [mapping(2, 1)] }]);
    const night = { name: "night.glb", bytes: withVariant(source, 1).glb };
    expect(materialsOf(night.bytes)).toEqual([4, 2]);
    expect(materialsOf(withVariant(night, 0).glb), "what day does not map is the file's own").toEqual([3, undefined]);
    const own = withVariant({ name: "day.glb", bytes: withVariant(night, 0).glb }, null);
    expect(materialsOf(own.glb)).toEqual([0, undefined]);
    expect([...withVariant(source, 1).moved]).toEqual([
      [0, [4]],
      [5, [2]],
    ]);
    expect(withVariant(source, 1).isRenaming).toBe(true);
  });

  it("may be broken in their details, and then map nothing", () => {
    const broken = model([
      { material: 0, mappings: [{ material: "red", variants: [1] }, { variants: 1 }, mapping(3)] },
    ]);
    expect(materialsOf(withVariant(broken, 1).glb)).toEqual([0]);
  });
});
