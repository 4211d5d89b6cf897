import { describe, expect, it } from "vitest";
import {
  type Design,
  emptyDesign,
  type Gradient,
  makeFillLayer,
  makeGroupLayer,
} from "../../web/editor/document/index.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import type { LayerCommands } from "../../web/editor/state/layer-commands.ts";
import { followGradient, shownGradient } from "../../web/editor/state/shown-gradient.ts";

const STOPS = [
  { offset: 0, color: "#000000" },
  { offset: 1, color: "#ffffff" },
] as const;
const LINEAR: Gradient = { kind: "linear", from: [0, 0, 0], to: [0, 1, 0], stops: STOPS };
const fill = makeFillLayer({ id: "fill", color: "#ff0000", gradient: LINEAR });

const stateOf = (layers: Design["layers"], selectedId: string | null = "fill"): EditorState => ({
  ...INITIAL_STATE,
  design: { ...emptyDesign(), layers },
  selectedId,
});

describe("a gradient's handles", () => {
  it("are the selected fill's, without its colours", () => {
    expect(shownGradient(stateOf([fill]))).toEqual({ kind: "linear", from: [0, 0, 0], to: [0, 1, 0] });
    const round = { kind: "radial", center: [1, 2, 3], radius: 4 } as const;
    expect(shownGradient(stateOf([{ ...fill, gradient: { ...round, stops: STOPS } }]))).toEqual(round);
  });

  it("are those of the mask that is painted on, also where the layer has a gradient of its own", () => {
    const there = { kind: "linear", from: [1, 0, 0], to: [2, 0, 0] } as const;
    const fade = makeFillLayer({ id: "fade", color: "#000000", blend: "erase", gradient: { ...there, stops: STOPS } });
    const masked = { ...fill, mask: { layers: [fade], invert: false, linked: true } };
    const marked = { ...stateOf([masked]), editingMask: "fill" };
    expect(shownGradient(marked)).toEqual(there);
    expect(shownGradient(stateOf([masked]))).toMatchObject({ from: [0, 0, 0] });
    expect(
      shownGradient({ ...marked, design: { ...emptyDesign(), layers: [{ ...masked, locked: true }] } }),
    ).toBeNull();
    const plain = { ...masked, mask: { layers: [], invert: false, linked: true } };
    expect(shownGradient({ ...stateOf([plain]), editingMask: "fill" })).toBeNull();
    const changed: unknown[] = [];
    const layers = { change: (id: string, patch: unknown) => changed.push([id, patch]) } as unknown as LayerCommands;
    const moved = { ...there, to: [5, 0, 0] } as const;
    followGradient(marked, layers, moved, "end", "move");
    expect(changed).toEqual([["fade", { gradient: { ...moved, stops: STOPS } }]]);
  });

  it("are not there for a plain fill, a hidden or locked one, one in a hidden group, or one that is not selected", () => {
    const hidden = [
      stateOf([{ ...fill, gradient: null }]),
      stateOf([{ ...fill, visible: false }]),
      stateOf([{ ...fill, locked: true }]),
      stateOf([makeGroupLayer({ id: "group", layers: [fill], visible: false })]),
      stateOf([makeGroupLayer({ id: "group", layers: [fill], locked: true })]),
      stateOf([fill], null),
    ];
    for (const state of hidden) expect(shownGradient(state)).toBeNull();
  });

  it("moved, keep the colours: shown while they move, a step at the end, nothing after Escape", () => {
    const calls: unknown[] = [];
    const layers = {
      preview: (id: string, patch: unknown) => calls.push(["preview", id, patch]),
      change: (id: string, patch: unknown) => calls.push(["change", id, patch]),
      cancelPreview: () => calls.push(["cancel"]),
    } as unknown as LayerCommands;
    const place = { kind: "linear", from: [0, 0, 0], to: [5, 0, 0] } as const;
    for (const phase of ["move", "end", "cancel"] as const)
      followGradient(stateOf([fill]), layers, place, phase, "move");
    const patch = { gradient: { ...place, stops: STOPS } };
    expect(calls).toEqual([["preview", "fill", patch], ["change", "fill", patch], ["cancel"]]);
  });

  it("are a step of its own after each drag, however soon a key follows; keys alone may be one", () => {
    const keys: (string | undefined)[] = [];
    const layers = {
      change: (_id: string, _patch: unknown, _label: string, mergeKey?: string) => keys.push(mergeKey),
    } as unknown as LayerCommands;
    const place = { kind: "linear", from: [0, 0, 0], to: [5, 0, 0] } as const;
    for (const phase of ["end", "step", "step", "end"] as const)
      followGradient(stateOf([fill]), layers, place, phase, "move");
    expect(keys).toEqual([undefined, "gradient:fill", "gradient:fill", undefined]);
  });

  it("of another kind than the fill is by now change nothing", () => {
    const layers = { change: () => expect.unreachable() } as unknown as LayerCommands;
    followGradient(stateOf([fill]), layers, { kind: "radial", center: [0, 0, 0], radius: 1 }, "end", "move");
  });
});
