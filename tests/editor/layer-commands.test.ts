import { expect, it, vi } from "vitest";
import {
  type DecalLayer,
  type Design,
  type DesignLayer,
  emptyDesign,
  makeDecalLayer,
  makeStrokeLayer,
} from "../../web/editor/document/index.ts";
import type { DesignSession } from "../../web/editor/state/design-session.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { LayerCommands } from "../../web/editor/state/layer-commands.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import type { Projector } from "../../web/engine/engine-api.ts";
import type { ModelViewer } from "../../web/viewer/viewer-api.ts";

const projector = { kind: "planar", position: [0, 0, 0], rotation: [0, 0, 0, 1], size: [1, 1, 1] } as const;
const decal = makeDecalLayer({ id: "decal", asset: "logo", projector });
const stroke = makeStrokeLayer({
  id: "stroke",
  brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
  blend: "erase",
  dabs: [{ ...projector, flow: 1 }],
});
const masked: DecalLayer = { ...decal, id: "masked", mask: { layers: [stroke], invert: false, linked: true } };

const unlinked: DecalLayer = { ...masked, mask: { layers: [stroke], invert: false, linked: false } };

/** What the commands recorded last; every nudge is a metre to the right. */
function commandsOn(...layers: DesignLayer[]) {
  const finishWork = vi.fn(() => {});
  const store = new Store<EditorState>({ ...INITIAL_STATE, selection: layers.map(({ id }) => id) });
  const recorded: Design[] = [{ ...emptyDesign(), layers }];
  const session = {
    get recordedDesign() {
      return recorded.at(-1);
    },
    get design() {
      return recorded.at(-1);
    },
    record: (design: Design) => void recorded.push(design),
    select: () => {},
  } as unknown as DesignSession;
  const nudge = (from: Projector): Projector =>
    from.kind === "uv" ? from : { ...from, position: [from.position[0] + 1, from.position[1], from.position[2]] };
  const commands = new LayerCommands({
    session,
    store,
    board: new NoticeBoard(store),
    viewer: { nudge, surface: { near: () => null } as unknown as ModelViewer["surface"] },
    finishWork,
  });
  const places = (): unknown[] =>
    (recorded.at(-1)?.layers ?? []).map(
      (layer) => "projector" in layer && (layer.projector as typeof projector).position[0],
    );
  return { commands, places, finishWork, design: () => recorded.at(-1) as Design };
}

it("a copy is put beside its original, also of one whose mask is still bare", () => {
  for (const original of [decal, { ...decal, mask: { layers: [], invert: false, linked: true } }]) {
    const { commands, places } = commandsOn(original);
    commands.duplicate();
    expect(places()).toEqual([0, 1]);
  }
});

it("a copy whose mask is painted is put beside its original with the mask", () => {
  const { commands, places, design } = commandsOn(masked);
  commands.duplicate();
  expect(places()).toEqual([0, 1]);
  const [original, copy] = design().layers;
  expect(original?.mask).toMatchObject({ layers: [{ dabs: [{ position: [0, 0, 0] }] }] });
  expect(copy?.mask).toMatchObject({ layers: [{ type: "stroke", dabs: [{ position: [1, 0, 0] }] }] });
  expect(copy?.mask?.layers[0]?.id).not.toBe(original?.mask?.layers[0]?.id);
});

it("a copy whose mask is painted and not linked stays where that is, and looks the same; so do those that are copied with it", () => {
  const { commands, places, design } = commandsOn(unlinked, {
    ...decal,
    projector: { ...projector, position: [5, 0, 0] },
  });
  commands.duplicate();
  expect(places()).toEqual([0, 0, 5, 5]);
  const [original, copy] = design().layers;
  expect(copy?.mask).toMatchObject({ layers: [{ type: "stroke", dabs: stroke.dabs }] });
  expect(copy?.mask?.layers[0]?.id).not.toBe(original?.mask?.layers[0]?.id);
});

it("what is pasted with such a mask lies where that is, too", () => {
  const { commands, places } = commandsOn(unlinked);
  commands.put({ ...emptyDesign(), layers: [{ ...unlinked, id: "clip" }] });
  expect(places()).toEqual([0, 0]);
});

it.each(["remove", "duplicate", "group", "ungroup", "merge"] as const)(
  "what a tool has under way is recorded before layers %s, as what it paints on may be gone after it",
  (act) => {
    const { commands, finishWork, design } = commandsOn(decal);
    const before = design();
    finishWork.mockImplementation(() => expect(design()).toBe(before));
    commands[act]();
    expect(finishWork).toHaveBeenCalledOnce();
  },
);
