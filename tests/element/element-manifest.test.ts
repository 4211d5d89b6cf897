import { describe, expect, it } from "vitest";
import { elementManifest } from "../../scripts/package/element-manifest.mjs";
import { PROPERTIES } from "../../web/element/element-properties.ts";

const METHODS = [
  ...["start", "restart", "submit", "addDecal", "addText", "select", "removeLayer", "undo", "redo"],
  ...["exportTexture", "exportModel", "exportDesign", "snapshot", "validate"],
];

describe("the Custom Elements Manifest", () => {
  const [module] = elementManifest("dist/define.js").modules;
  const [element] = module.declarations;
  const names = (list: readonly { name: string }[]): string[] => list.map(({ name }) => name);

  it("names the element, and every attribute that it takes", () => {
    expect(element.tagName).toBe("texelcast-editor");
    const attributes = Object.entries(PROPERTIES).flatMap(([name, declaration]) => {
      const attribute: unknown = "attribute" in declaration ? declaration.attribute : name;
      return typeof attribute === "string" ? [attribute] : [];
    });
    expect(names(element.attributes).toSorted()).toEqual(attributes.toSorted());
  });

  it("names every property, method and event, and nothing private", () => {
    const members = names(element.members);
    expect(members).toEqual(expect.arrayContaining([...Object.keys(PROPERTIES), ...METHODS]));
    expect(members.filter((name) => name.startsWith("#"))).toEqual([]);
    expect(names(element.events).toSorted()).toEqual(["change", "error", "load", "progress", "select", "submit"]);
    expect(names(element.slots)).toEqual(["poster", "progress", "toolbar", "empty", "submit"]);
  });
});
