import { describe, expect, it } from "vitest";
import { BLEND_MODES } from "../../web/editor/document/index.ts";
import { layersFault } from "../../web/engine/check-layers.ts";

describe("layers that are looked at", () => {
  const group = { id: "a", type: "group", opacity: 1, blend: "normal", blendSpace: "srgb", layers: [] };

  it("may have every mode that a design may have, and no other", () => {
    for (const blend of BLEND_MODES) expect(layersFault([{ ...group, blend }]), blend).toBeNull();
    expect(layersFault([{ ...group, blend: "dissolve" }])).toMatchObject({
      code: "bad-argument",
      field: "layers[0].blend",
      value: "dissolve",
    });
  });
});
