import { expect, it } from "vitest";
import type { DeskHooks } from "../../web/element/desk/desk-settings.ts";
import { paintableMaterial } from "../../web/element/desk/paintable.ts";
import { english } from "../../web/element/words/english.ts";
import type { ModelInfo } from "../../web/engine/engine-api.ts";

const REFUSED = { code: "NO_UVS", message: "It has no texture coordinates." };
const materials = [
  { index: 0, name: "", triangles: 10, refusal: null },
  { index: 1, name: "", triangles: 90, refusal: null },
  { index: 2, name: "", triangles: 99, refusal: REFUSED },
];

function chosen(material: number | null, of: readonly object[] = materials) {
  const warned: unknown[] = [];
  const hooks = {
    settings: () => ({ material, words: english }),
    warn: (error: unknown) => warned.push(error),
  } as unknown as DeskHooks;
  const index = paintableMaterial({ name: "mug.glb", materials: of } as unknown as ModelInfo, hooks);
  return { index, warned };
}

it("a product is painted on the material that the page names, else on the largest that can be", () => {
  expect(chosen(0)).toEqual({ index: 0, warned: [] });
  expect(chosen(null)).toEqual({ index: 1, warned: [] });
});

it("of a material that the model does not have the page is told, and the largest is taken", () => {
  const { index, warned } = chosen(7);
  expect(index).toBe(1);
  expect(warned).toMatchObject([{ code: "bad-argument", field: "material", value: "7" }]);
});

it("of the same material the page is told once for each model, and again when it has asked for another meanwhile", () => {
  const model = { name: "mug.glb", materials } as unknown as ModelInfo;
  const warned: unknown[] = [];
  const ask = (material: number | null): number => {
    const hooks = { settings: () => ({ material, words: english }), warn: (error: unknown) => warned.push(error) };
    return paintableMaterial(model, hooks as unknown as DeskHooks);
  };
  expect([ask(7), ask(7)]).toEqual([1, 1]);
  expect(warned).toHaveLength(1);
  ask(8);
  ask(0);
  ask(8);
  expect(warned).toHaveLength(3);
});

it("a material that cannot be painted is refused with its reason", () => {
  expect(() => chosen(2)).toThrow("no texture coordinates");
  expect(() => chosen(null, materials.slice(2))).toThrow("no texture coordinates");
});
