import { expect, it } from "vitest";
import {
  type Design,
  type DesignAsset,
  type DesignLayer,
  emptyDesign,
  makeDecalLayer,
  makeFillLayer,
  makeGroupLayer,
  parseDesign,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import { clipOf, fitToModel, putClip } from "../../web/editor/state/layer-clip.ts";

const picture = (name: string): DesignAsset => ({ type: "image/png", uri: `https://example.org/${name}.png` });
const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const decal = (id: string, asset: string): DesignLayer => makeDecalLayer({ id, name: id, asset, projector });
const fill = (id: string): DesignLayer => makeFillLayer({ id, name: id, color: "#ff0000" });
const group = (id: string, ...layers: DesignLayer[]): DesignLayer => makeGroupLayer({ id, name: id, layers });
const designOf = (assets: Design["assets"], ...layers: DesignLayer[]): Design => ({ ...emptyDesign(), assets, layers });

/** Names, bottom to top: "a g(b c) d". */
const shape = (layers: readonly DesignLayer[]): string =>
  layers.map((layer) => (layer.type === "group" ? `${layer.name}(${shape(layer.layers)})` : layer.name)).join(" ");

const source = designOf(
  { star: picture("star"), moon: picture("moon") },
  decal("a", "star"),
  group("g", fill("b"), decal("c", "moon")),
);

it("takes the chosen layers, what they hold, and no asset of any other", () => {
  const clip = clipOf(source, ["c", "g"]);
  expect(shape(clip.layers)).toBe("g(b c)");
  expect(Object.keys(clip.assets)).toEqual(["moon"]);
});

it("stays whole as text", () => {
  const clip = clipOf(source, ["a", "g"]);
  expect(parseDesign(serialiseDesign(clip), "clipboard")).toEqual(clip);
});

it("gives layers ids of their own, and another key to a picture whose key another one has", () => {
  const hidden = { ...fill("d"), mask: { layers: [decal("e", "star")], invert: false, linked: true } } as DesignLayer;
  const clip = designOf({ star: picture("sun") }, group("a", hidden));
  const { design, ids } = putClip(source, clip, null);
  expect(design.assets.star).toEqual(picture("star"));
  expect(design.assets["star-2"]).toEqual(picture("sun"));
  const [put] = design.layers.slice(-1);
  expect(put?.id).toBe(ids[0]);
  expect(JSON.stringify(put)).toContain('"asset":"star-2"');
  expect(put?.name, "and a name of their own").toBe("a 2");
  expect(() => parseDesign(serialiseDesign(design), "pasted"), "no id twice").not.toThrow();
});

it("takes no picture twice", () => {
  const { design } = putClip(source, clipOf(source, ["a"]), "a");
  expect(Object.keys(design.assets)).toEqual(["star", "moon"]);
});

it("puts them above the chosen layer, or into a chosen group", () => {
  const clip = clipOf(source, ["a"]);
  expect(shape(putClip(source, clip, "a").design.layers)).toBe("a a 2 g(b c)");
  expect(shape(putClip(source, clip, "b").design.layers)).toBe("a g(b a 2 c)");
  expect(shape(putClip(source, clip, "g").design.layers)).toBe("a g(b c a 2)");
  expect(shape(putClip(source, clip, null).design.layers)).toBe("a g(b c) a 2");
});

it("puts a group beside itself and not into itself", () => {
  expect(shape(putClip(source, clipOf(source, ["g"]), "g").design.layers)).toBe("a g(b c) g 2(b c)");
});

it("puts nothing into a locked group", () => {
  const locked = designOf({}, { ...group("g", fill("b")), locked: true } as DesignLayer, fill("z"));
  const clip = designOf({}, fill("a"));
  for (const id of ["g", "b"]) expect(shape(putClip(locked, clip, id).design.layers)).toBe("g(b) z a");
});

it("paints the shown material where the model has none of a layer's own", () => {
  const parts = { kind: "charts", ids: [1] } as never;
  const fitted = fitToModel(
    group("g", { ...fill("b"), material: 3, parts } as DesignLayer, { ...fill("c"), material: [0, 3] } as DesignLayer),
    new Set([0, 1]),
    1,
  );
  expect(fitted).toMatchObject({ layers: [{ material: 1, parts: null }, { material: 0 }] });
});
