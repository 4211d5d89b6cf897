import { describe, expect, it } from "vitest";
import {
  type Dab,
  type DecalLayer,
  emptyDesign,
  type GroupLayer,
  makeFillLayer,
  makeGroupLayer,
  makeStrokeLayer,
  parseDesign,
  serialiseDesign,
} from "../../web/editor/document/index.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { type ClonePatch, cloneTargetOf, isCloneGroup, withClone } from "../../web/editor/tools/clone-layer.ts";
import { areaOf, eyeOf, type Look, steppedLook } from "../../web/editor/tools/clone-look.ts";
import { areaAround, pictureOfSight, pieceOf } from "../../web/editor/tools/clone-picture.ts";

/** From in front of the origin, two metres away. */
const FRONT: Look = { at: [0, 0, 0], eye: [0, 0, 2], up: [0, 1, 0] };
/** From the right of another place, one metre away. */
const SIDE: Look = { at: [5, 1, 0], eye: [6, 1, 0], up: [0, 1, 0] };

it("while a mask is painted on nothing is cloned beside it: a mask has no picture", () => {
  const fill = makeFillLayer({
    id: "a",
    name: "Base",
    color: "#ff0000",
    mask: { layers: [], invert: false, linked: true },
  });
  const design = { ...emptyDesign(), layers: [fill] };
  expect(cloneTargetOf(design, "a", "a")).toEqual({ kind: "refused", reason: "mask", name: "Base" });
  expect(cloneTargetOf(design, "a")).toMatchObject({ kind: "new" });
});

describe("the two eyes of the clone tool", () => {
  it("see pictures of one size where they look, however far away they stand", () => {
    const spans = [FRONT, SIDE].map((look) => {
      const { fov, aspect, position } = eyeOf(look, [0.4, 0.2], 3);
      const distance = Math.hypot(...position.map((part, axis) => part - (look.at[axis] as number)));
      return [distance * Math.tan((fov * Math.PI) / 360), aspect];
    });
    for (const [half, aspect] of spans) {
      expect(half).toBeCloseTo(0.2, 12);
      expect(aspect).toBe(2);
    }
  });

  it("look along their own -Z with what is up upright", () => {
    expect(eyeOf(FRONT, [1, 1], 3).rotation).toEqual([0, 0, 0, 1]);
    const [x, y, z, w] = eyeOf(SIDE, [1, 1], 3).rotation;
    expect([x, z]).toEqual([0, 0]);
    expect([y, w].map((part) => part * part)).toEqual([expect.closeTo(0.5), expect.closeTo(0.5)]);
  });

  it("a step of the painted place is the same step of the source, as each is looked at", () => {
    const stepped = steppedLook(SIDE, FRONT, [0.3, -0.1, 0.7]);
    // To the right of the front is +X, to the right of the side -Z; what goes towards the eye is no step.
    for (const [axis, value] of [5, 0.9, -0.3].entries()) expect(stepped.at[axis]).toBeCloseTo(value);
    for (const [axis, value] of [6, 0.9, -0.3].entries()) expect(stepped.eye[axis]).toBeCloseTo(value);
  });

  it("a dab's area lies where the eye sees it, wider where it is nearer, and nowhere behind the eye", () => {
    const near = areaOf(FRONT, [0.1, 0, 1], 0.1);
    expect(((near?.left ?? 0) + (near?.right ?? 0)) / 2).toBeCloseTo(0.2);
    expect((near?.right ?? 0) - (near?.left ?? 0)).toBeGreaterThan(0.4);
    expect(areaOf(FRONT, [0, 0, 3], 0.1)).toBeNull();
  });
});

describe("the clone tool's pictures", () => {
  const texture = { width: 2, height: 1, rgba: Uint8Array.of(255, 0, 0, 255, 0, 0, 255, 0) };
  const all = { left: 0, top: 0, right: 2, bottom: 1 };
  const sight = (...uvs: number[]) => ({
    width: 2,
    height: 1,
    materials: Int32Array.of(3, -1),
    uvs: Float32Array.from(uvs),
  });

  it("take a seen place's colour; beside the model, outside the area and without a texture they are clear", () => {
    const seen = sight(0.25, 0.5, 0.25, 0.5);
    const textures = new Map([[3, texture]]);
    expect([...pictureOfSight(seen, textures, all, true).rgba]).toEqual([255, 0, 0, 255, 0, 0, 0, 0]);
    expect([...pictureOfSight(seen, textures, { ...all, left: 1 }, true).rgba]).toEqual(Array(8).fill(0));
    expect([...pictureOfSight(seen, new Map(), all, true).rgba]).toEqual(Array(8).fill(0));
  });

  it("mix neighbours by their alpha: what is clear lends no colour", () => {
    const { rgba } = pictureOfSight(sight(0.5, 0.5, 0, 0), new Map([[3, texture]]), all, false);
    expect([...rgba.subarray(0, 4)]).toEqual([255, 0, 0, 128]);
  });

  it("the texels around a source are always some of the texture's, wherever beyond it the source lies", () => {
    expect(areaAround({ width: 100, height: 50 }, [0.5, 0.5], 10)).toEqual({
      left: 40,
      top: 15,
      right: 60,
      bottom: 35,
    });
    for (const u of [-30, -1, -1e-9, 0, 0.99, 1, 2.5, 1e9]) {
      const { left, top, right, bottom } = areaAround({ width: 100, height: 50 }, [u, u], 10);
      expect([left, top].every((first) => first >= 0)).toBe(true);
      expect([right <= 100, bottom <= 50, left < right, top < bottom]).toEqual([true, true, true, true]);
    }
  });

  it("a piece that reaches over the texture's border is clear there", () => {
    const piece = pieceOf(texture, { left: -1, top: 0, right: 1, bottom: 2 });
    expect([piece.width, piece.height]).toEqual([2, 2]);
    expect([...piece.rgba]).toEqual([0, 0, 0, 0, 255, 0, 0, 255, ...Array(8).fill(0)]);
  });
});

describe("what a clone stroke becomes", () => {
  const dab: Dab = { kind: "planar", position: [1, 0, 0], rotation: [0, 0, 0, 1], size: [0.1, 0.1, 0.1], flow: 1 };
  const stroke = makeStrokeLayer({
    id: "layer-1",
    brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
    dabs: [dab],
  });
  const patch: ClonePatch = {
    asset: { type: "image/png", uri: "data:image/png;base64,AAAA" },
    projector: eyeOf(FRONT, [0.4, 0.2], 3),
    material: 0,
    filter: "linear",
    opacity: 0.5,
    mirror: null,
  };
  const top = cloneTargetOf(emptyDesign(), null);
  if (top.kind === "refused") throw new Error("An empty design refuses nothing.");
  const once = withClone(emptyDesign(), top, stroke, patch, stringsIn("en").clone);

  it("a decal in a group of its own, shown where the stroke went, that is read back as it was written", () => {
    const [group] = once.design.layers as [GroupLayer];
    expect(isCloneGroup(group)).toBe(true);
    expect(group.layers[0]).toMatchObject({
      type: "decal",
      opacity: 0.5,
      mask: { invert: true, layers: [{ type: "stroke", blend: "erase", opacity: 1, dabs: [dab] }] },
    });
    expect(parseDesign(serialiseDesign(once.design), "clone.json")).toEqual(once.design);
  });

  it("the next goes into the same group while that or a stroke of it is selected, else above the selection", () => {
    const [group] = once.design.layers as [GroupLayer];
    for (const id of [group.id, group.layers[0]?.id ?? null]) {
      const target = cloneTargetOf(once.design, id);
      expect(target).toEqual({ kind: "group", groupId: group.id });
      if (target.kind === "refused") continue;
      const [grown] = withClone(once.design, target, stroke, patch, stringsIn("en").clone).design.layers as [
        GroupLayer,
      ];
      expect(grown.layers).toHaveLength(2);
    }
    const below = makeFillLayer({ id: "below", color: "#ffffff" });
    const design = { ...once.design, layers: [below, ...once.design.layers] };
    expect(cloneTargetOf(design, "below")).toMatchObject({ kind: "new", place: { index: 1 } });
  });

  it("in a new group on top where the one that it was for has gone since", () => {
    const below = makeFillLayer({ id: "below", color: "#ffffff" });
    const design = { ...emptyDesign(), layers: [below] };
    const place = { parentId: "gone", list: "layers", index: 0 } as const;
    for (const target of [{ kind: "group", groupId: "gone" } as const, { kind: "new", place } as const]) {
      const placed = withClone(design, target, stroke, patch, stringsIn("en").clone);
      expect(placed.design.layers).toMatchObject([{ id: "below" }, { id: placed.layerId, type: "group" }]);
    }
  });

  it("with a mirror its twin is a layer of its own, with the picture and the dabs mirrored", () => {
    const mirror = { axis: "x", offset: 0, readable: false } as const;
    const [group] = withClone(emptyDesign(), top, stroke, { ...patch, mirror }, stringsIn("en").clone).design
      .layers as [GroupLayer];
    const [, twin] = group.layers as [DecalLayer, DecalLayer];
    expect(twin.flipX).toBe(true);
    expect(twin.mask?.layers[0]).toMatchObject({ dabs: [{ position: [-1, 0, 0] }] });
  });

  it("a twin that grows keeps the very dabs that it had: the engine knows by them what it has painted", () => {
    const mirror = { axis: "x", offset: 0, readable: false } as const;
    const twinDabs = (dabs: readonly Dab[]): readonly Dab[] => {
      const { design } = withClone(
        emptyDesign(),
        top,
        { ...stroke, dabs },
        { ...patch, mirror },
        stringsIn("en").clone,
      );
      const [, twin] = (design.layers as [GroupLayer])[0].layers as [DecalLayer, DecalLayer];
      const [layer] = twin.mask?.layers ?? [];
      return layer?.type === "stroke" ? layer.dabs : [];
    };
    const [before] = twinDabs(stroke.dabs);
    const [kept, added] = twinDabs([...stroke.dabs, { ...dab, flow: 0.5 }]);
    expect(kept).toBe(before);
    expect(added).toMatchObject({ flow: 0.5, position: [-1, 0, 0] });
  });

  it("a locked or hidden group is not painted on", () => {
    const [group] = once.design.layers as [GroupLayer];
    const held = (change: Partial<GroupLayer>) => ({
      ...once.design,
      layers: [makeGroupLayer({ ...group, ...change })],
    });
    expect(cloneTargetOf(held({ locked: true }), group.id)).toMatchObject({ kind: "refused", reason: "locked" });
    expect(cloneTargetOf(held({ visible: false }), group.id)).toMatchObject({ kind: "refused", reason: "hidden" });
  });
});
