import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import {
  type Design,
  emptyDesign,
  flattenLayers,
  makeFillLayer,
  makePaintLayer,
  type StrokeLayer,
} from "../../web/editor/document/index.ts";
import type { DecalReach } from "../../web/editor/state/decal-reach.ts";
import type { DesignSession } from "../../web/editor/state/design-session.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { withStroke } from "../../web/editor/tools/paint-target.ts";
import type { PathStep } from "../../web/editor/tools/pointer-path.ts";
import { StrokeGesture } from "../../web/editor/tools/stroke-gesture.ts";

/** As much of the editor as a stroke asks for: a history of one step, and what is shown of a gesture. */
class Scene {
  recordedDesign: Design;
  shown: Design | null = null;

  constructor(...layers: Design["layers"]) {
    this.recordedDesign = { ...emptyDesign(), layers };
  }

  preview(design: Design): void {
    this.shown = design;
  }

  cancelPreview(): void {
    this.shown = null;
  }

  record(design: Design): void {
    this.recordedDesign = design;
    this.shown = null;
  }

  stroke(layerId: string, blend: "normal" | "erase" = "normal"): StrokeGesture {
    const put = (design: Design, stroke: StrokeLayer) =>
      withStroke(design, { kind: "strokes", layerId }, stroke, stringsIn("en"));
    return new StrokeGesture({
      brush: { tip: "round", color: "#000000", hardness: 1, flow: 1 },
      ...{ name: "Stroke", size: 1, spacing: 0.5, pressure: "none", opacity: 1, mirror: null, alphaLock: false },
      ...{ erases: blend === "erase", put, session: this as unknown as DesignSession },
      reach: { all: () => [0] } as unknown as DecalReach,
    });
  }
}

const STEP: PathStep = {
  hit: { position: [0, 0, 0], normal: [0, 0, 1], material: 0, uv: [0, 0], face: 0 },
  pressure: 1,
};
const paint = makePaintLayer({ id: "paint", strokes: [] });

describe("a stroke under way while the design changes", () => {
  const frames: (() => void)[] = [];
  beforeEach(() => {
    vi.stubGlobal("requestAnimationFrame", (frame: () => void) => frames.push(frame));
    vi.stubGlobal("cancelAnimationFrame", () => {});
  });
  afterEach(() => {
    frames.length = 0;
    vi.unstubAllGlobals();
  });
  const nextFrame = (): void => frames.splice(0).forEach((frame) => void frame());

  it("has an id that no other layer has, also where a layer takes its own in the meantime", () => {
    const scene = new Scene(paint);
    const stroke = scene.stroke("paint");
    stroke.extend([STEP]);
    nextFrame();
    const shown = flattenLayers(scene.shown as Design).map(({ id }) => id);
    const taken = shown.find((id) => id !== "paint") as string;
    scene.record({ ...scene.recordedDesign, layers: [paint, makeFillLayer({ id: taken, color: "#ffffff" })] });
    stroke.extend([STEP]);
    nextFrame();
    stroke.end("Paint");
    const ids = flattenLayers(scene.recordedDesign).map(({ id }) => id);
    expect(ids).toHaveLength(3);
    expect(new Set(ids).size).toBe(3);
  });

  it("is kept in a layer of its own where the one that it was for is undone", () => {
    const scene = new Scene(paint);
    const stroke = scene.stroke("paint");
    stroke.extend([STEP]);
    scene.record(emptyDesign());
    nextFrame();
    expect(stroke.end("Paint")).not.toBeNull();
    expect(scene.recordedDesign.layers).toMatchObject([{ type: "paint", strokes: [{ type: "stroke" }] }]);
  });

  it("erases nothing, and is no step, where the layer that it was for is undone", () => {
    const scene = new Scene(paint);
    const stroke = scene.stroke("paint", "erase");
    stroke.extend([STEP]);
    nextFrame();
    const empty = emptyDesign();
    scene.recordedDesign = empty;
    expect(stroke.end("Erase")).toBeNull();
    expect(scene.recordedDesign).toBe(empty);
    expect(scene.shown).toBeNull();
  });
});
