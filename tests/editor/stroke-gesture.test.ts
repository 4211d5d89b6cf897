import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import {
  type Design,
  emptyDesign,
  findLayer,
  flattenLayers,
  makeFillLayer,
  makePaintLayer,
  makeStrokeLayer,
  type StrokeLayer,
} from "../../web/editor/document/index.ts";
import type { DecalReach } from "../../web/editor/state/decal-reach.ts";
import type { DesignSession } from "../../web/editor/state/design-session.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { withStroke } from "../../web/editor/tools/paint-target.ts";
import type { PathStep } from "../../web/editor/tools/pointer-path.ts";
import { StrokeGesture } from "../../web/editor/tools/stroke-gesture.ts";
import type { MaterialInfo } from "../../web/engine/engine-api.ts";

const BRUSH = { tip: "round", color: "#000000", hardness: 1, flow: 1 } as const;
const MEETS: Partial<DecalReach> = { all: () => [0] };

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

  /** @param reach what the stroke meets */
  stroke(layerId: string, blend: "normal" | "erase" = "normal", reach: Partial<DecalReach> = MEETS): StrokeGesture {
    const put = (design: Design, stroke: StrokeLayer) =>
      withStroke(design, { kind: "strokes", layerId }, stroke, stringsIn("en"));
    return new StrokeGesture({
      brush: BRUSH,
      ...{ name: "Stroke", size: 1, spacing: 0.5, pressure: "none", opacity: 1, mirror: null, alphaLock: false },
      ...{ erases: blend === "erase", put, session: this as unknown as DesignSession },
      reach: reach as DecalReach,
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

  it("does not look through all strokes before it in each frame for its own id, while panels look at what is shown", () => {
    let reads = 0;
    const before = makeStrokeLayer({ id: "before", dabs: [], brush: BRUSH });
    const readId = (): string => {
      reads += 1;
      return "before";
    };
    Object.defineProperty(before, "id", { enumerable: true, get: readId });
    const scene = new Scene(makePaintLayer({ id: "paint", strokes: [before] }));
    const stroke = scene.stroke("paint");
    const showFrame = (): void => {
      stroke.extend([STEP]);
      nextFrame();
      expect(findLayer(scene.shown as Design, "paint")?.type).toBe("paint");
    };
    showFrame();
    reads = 0;
    for (let frame = 0; frame < 10; frame++) showFrame();
    // To put the stroke into the design takes one.
    expect(reads).toBeLessThanOrEqual(10);
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

describe("a stroke on a part that takes no paint", () => {
  const BARE = { index: 0, name: "Bare", refusal: { code: "no-uvs", message: "" } } as MaterialInfo;
  const scene = (): Scene => new Scene(paint);
  beforeEach(() => {
    vi.stubGlobal("requestAnimationFrame", () => 1);
    vi.stubGlobal("cancelAnimationFrame", () => {});
  });
  afterEach(() => void vi.unstubAllGlobals());

  it("is no step of the history, and tells of which material the part is", () => {
    const there = scene();
    const before = there.recordedDesign;
    const stroke = there.stroke("paint", "normal", { all: () => [], bareOf: () => BARE });
    stroke.extend([STEP]);
    expect(stroke.end("brush stroke")).toBeNull();
    expect(there.recordedDesign).toBe(before);
    expect(stroke.bare).toBe(BARE);
  });

  it("is whole where it goes on to one that takes paint", () => {
    const there = scene();
    const met = [[], [1]];
    const stroke = there.stroke("paint", "normal", { all: () => met.shift() ?? [1], bareOf: () => BARE });
    stroke.extend([STEP]);
    stroke.extend([{ ...STEP, hit: { ...STEP.hit, position: [4, 0, 0], material: 1 } }]);
    expect(stroke.end("brush stroke")).toBe("paint");
    expect(stroke.bare).toBeNull();
  });
});
