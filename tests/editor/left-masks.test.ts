import { expect, it } from "vitest";
import {
  type DecalLayer,
  type Mask,
  type MaskLayer,
  makeDecalLayer,
  makeFillLayer,
  makeGroupLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { LeftMasks, picturesIn, staysOf } from "../../web/editor/state/left-masks.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";

const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const whole = { kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 } as const;
const pixels = makeDecalLayer({ id: "pixels", asset: "pixels", projector: whole });
const stroke = makeStrokeLayer({
  ...{ id: "stroke", brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 } },
  dabs: [{ ...projector, flow: 1 }],
});
const maskOf = (...layers: MaskLayer[]): Mask => ({ layers, invert: false, linked: true });
const badge = (mask: Mask | null): DecalLayer => ({
  ...makeDecalLayer({ id: "badge", name: "Badge", asset: "logo", projector }),
  mask,
});
const told = (): { left: LeftMasks; board: NoticeBoard; titles: () => string[] } => {
  const store = new Store<EditorState>(INITIAL_STATE);
  return {
    left: new LeftMasks(),
    board: new NoticeBoard(store),
    titles: () => store.state.notices.map(({ title }) => title),
  };
};

it("says once that the pixels of a mask stay while its layer is moved, and again when more was drawn", () => {
  const { left, board, titles } = told();
  const layer = badge(maskOf(stroke, pixels));
  left.tell([[layer, [layer]]], board);
  expect(titles()).toEqual(["A part of the mask of Badge stays where it is"]);
  board.dismissAll();
  left.tell([[layer, [layer]]], board);
  expect(titles()).toEqual([]);
  const more = badge(maskOf(stroke, { ...pixels }));
  left.tell([[more, [more]]], board);
  expect(titles()).toHaveLength(1);
});

it("says nothing where all goes along, or nothing is to", () => {
  const { left, board, titles } = told();
  const unlinked = badge({ ...maskOf(pixels), linked: false });
  for (const layer of [badge(maskOf(stroke)), badge(null), unlinked]) left.tell([[layer, [layer]]], board);
  expect(titles()).toEqual([]);
});

it("knows what of a group's mask stays by what is in the group", () => {
  const parts = { ...makeFillLayer({ id: "fill", color: "#000000" }), parts: { kind: "faces", faces: [1] } } as const;
  const stamp = { ...badge(null), id: "stamp", projector: whole };
  const group = (...layers: DecalLayer[]) => ({
    ...makeGroupLayer({ id: "group", name: "Group", layers }),
    mask: maskOf(pixels, parts, stroke),
  });
  const stays = (of: ReturnType<typeof group>): readonly MaskLayer[] => staysOf(of, picturesIn(of));
  expect(stays(group(badge(null)))).toEqual([pixels, parts]);
  expect(stays(group(badge(null), stamp))).toEqual([parts]);
});
