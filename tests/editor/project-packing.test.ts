import { describe, expect, it } from "vitest";
import { encodeDataUri } from "../../web/editor/document/data-uri.ts";
import { emptyDesign, makeDecalLayer } from "../../web/editor/document/index.ts";
import { type ProjectToPack, packProject, unpackProject } from "../../web/editor/files/project-packing.ts";
import { FRONT } from "../support/layers.ts";

const LOGO = Uint8Array.of(1, 2, 3, 4);
const project = (uri: string): ProjectToPack => ({
  name: "Mug",
  design: {
    ...emptyDesign(),
    assets: { logo: { type: "image/png", uri }, inter: { type: "font/ttf", uri: "texelcast:fonts/inter-700" } },
    layers: [makeDecalLayer({ id: "a", asset: "logo", projector: FRONT })],
  },
  targets: [{ material: 0, size: 64, gutter: null }],
  model: { title: "mug.glb", demo: null, source: { name: "mug.glb", bytes: Uint8Array.of(9, 8, 7) } },
});

describe("a project that is packed and unpacked by a worker", () => {
  it("comes out whole after a message's copy, pictures as files and shipped fonts as addresses", () => {
    const packed = packProject(structuredClone(project(encodeDataUri("image/png", LOGO))));
    const { design, assets, model } = structuredClone(unpackProject(packed, "mug.texelcast"));
    expect(assets.get(design.assets.logo?.uri ?? "")).toEqual(LOGO);
    expect(design.assets.inter?.uri).toBe("texelcast:fonts/inter-700");
    expect(model.source?.bytes).toEqual(Uint8Array.of(9, 8, 7));
  });

  it("is refused by a picture that its file holds damaged, before anything of it is opened", () => {
    const packed = packProject(project(encodeDataUri("image/png", LOGO)));
    const at = packed.findIndex((_, start) => LOGO.every((byte, i) => packed[start + i] === byte));
    packed[at] = 99;
    expect(() => unpackProject(packed, "mug.texelcast")).toThrow(/logo.*damaged/);
  });

  it("is refused by the picture that cannot be read", () => {
    expect(() => packProject(project("data:image/png;base64,%%%"))).toThrow(/logo|base64|data/i);
  });
});
