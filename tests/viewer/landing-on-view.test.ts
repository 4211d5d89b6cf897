import { PlaneGeometry, Vector3 } from "three";
import { describe, expect, it } from "vitest";
import type { PlanarProjector, Projector } from "../../web/engine/engine-api.ts";
import type { DecalHands } from "../../web/viewer/decal-hands.ts";
import { landingOn } from "../../web/viewer/landing-on-view.ts";
import type { SurfaceHit, ViewerDecal } from "../../web/viewer/viewer-api.ts";
import { placedFromFront, queryOf } from "./surface-helpers.ts";

/** A wall, looked at from the front; the view is 4 metres wide and high. */
const wall = queryOf(new PlaneGeometry(4, 4));
const SIDE = 400;
const looks = {
  lookAt: ({ position: [x, y] }: SurfaceHit) => ({ eye: [x, y, 10], up: [0, 1, 0] }) as never,
  metresPerPixel: () => 4 / SIDE,
};

const projectorAt = placedFromFront(wall);

/** Where something 0.9 metres wide lands on the wall, from its middle. */
function landingBeside(...decals: ViewerDecal[]): number {
  const hands = {
    gizmo: { decals },
    screen: { size: { width: SIDE, height: SIDE } },
    sampleAt: ({ x, y }: { x: number; y: number }) =>
      wall.raycast(new Vector3((x / SIDE - 0.5) * 4, (0.5 - y / SIDE) * 4, 10), new Vector3(0, 0, -1)),
    projectorAt,
  } as unknown as DecalHands;
  const landing = landingOn(hands, wall, 0.9, 1, looks);
  return Math.hypot(...(landing?.hit.position ?? []));
}

type Told = Pick<ViewerDecal, "visible" | "materials" | "projector">;

const inMiddle = (changes: Partial<Told> = {}, width = 0.9): ViewerDecal => ({
  id: "d",
  name: "Smiley",
  aspect: 1,
  visible: true,
  materials: [0],
  projector: projectorAt({ position: [0, 0, 0], normal: [0, 0, 1] }, width, 1),
  ...changes,
});
const behind = (projector: PlanarProjector): Projector => ({ ...projector, rotation: [0, 1, 0, 0] });
const around: Projector = {
  kind: "cylindrical",
  position: [0, 0, 0],
  rotation: [0, 0, 0, 1],
  radius: 0.01,
  height: 4,
  arc: 360,
  depth: 1,
};

describe("something new", () => {
  it("lies in the middle of a wall that is bare, and beside a picture that lies there, or a part of one", () => {
    expect(landingBeside()).toBe(0);
    expect(landingBeside(inMiddle())).toBeGreaterThan(0.6);
    expect(landingBeside(inMiddle({}, 0.5))).toBeGreaterThan(0.3);
    expect(landingBeside(inMiddle(), inMiddle({ visible: false }))).toBeGreaterThan(0.6);
  });

  it("lies in the middle over what is not seen there: a hidden picture, one of another material, one on the back", () => {
    const hidden = inMiddle({ visible: false });
    const elsewhere = inMiddle({ materials: [1] });
    const { projector } = inMiddle();
    const back = inMiddle({ projector: behind(projector as PlanarProjector) });
    expect(landingBeside(hidden, elsewhere, back)).toBe(0);
  });

  it("lies in the middle of what is its background: a picture twice as large, and what is thrown all around", () => {
    expect(landingBeside(inMiddle({}, 1.79))).toBeGreaterThan(0);
    expect(landingBeside(inMiddle({}, 1.81))).toBe(0);
    expect(landingBeside(inMiddle({ projector: around }))).toBe(0);
  });
});
