import {
  AnimationClip,
  Bone,
  BoxGeometry,
  BufferAttribute,
  CylinderGeometry,
  Group,
  Mesh,
  MeshStandardMaterial,
  Quaternion,
  QuaternionKeyframeTrack,
  Ray,
  Skeleton,
  SkinnedMesh,
  Vector3,
} from "three";
import { describe, expect, it } from "vitest";
import { boxDrag } from "../../web/viewer/box-drag.ts";
import { axisOf, poseOf } from "../../web/viewer/decal-pose.ts";
import { rotateDrag, scaleDrag } from "../../web/viewer/gizmo-drag.ts";
import { ModelAnimation } from "../../web/viewer/model-animation.ts";
import type { ModelScene } from "../../web/viewer/model-scene.ts";
import { carried, dragAtRest } from "../../web/viewer/posed-gizmo.ts";
import { PosedSurface } from "../../web/viewer/posed-surface.ts";
import { gatherRestingSurface, triangleSubset } from "../../web/viewer/resting-surface.ts";
import { SurfaceQuery } from "../../web/viewer/surface-query.ts";
import { expectVector } from "./pose-helpers.ts";

function sceneOf(root: Group, animations: AnimationClip[], ...meshes: Mesh[]): ModelScene {
  const materials = new Map(meshes.map((mesh, index) => [index, [mesh.material as MeshStandardMaterial]]));
  return { root, animations, materials, labels: new Map(), dispose: () => {} };
}

/** A box of two metres whose node is turned about Y by a quarter over a second. */
function turningBox(): ModelScene {
  const root = new Group();
  const mesh = new Mesh(new BoxGeometry(2, 2, 2), new MeshStandardMaterial());
  mesh.name = "Box";
  root.add(mesh);
  const end = new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), Math.PI / 2);
  const track = new QuaternionKeyframeTrack("Box.quaternion", [0, 1], [0, 0, 0, 1, end.x, end.y, end.z, end.w]);
  return sceneOf(root, [new AnimationClip("Turn", 1, [track])], mesh);
}

/** A pole along Y, 4 metres, whose upper half follows a joint at its middle. */
function bendingPole(): { scene: ModelScene; bone: Bone } {
  const root = new Group();
  const geometry = new CylinderGeometry(0.3, 0.3, 4, 24, 16);
  const positions = geometry.getAttribute("position");
  const joints = new Uint16Array(positions.count * 4);
  const weights = new Float32Array(positions.count * 4);
  for (let vertex = 0; vertex < positions.count; vertex++) {
    const upper = Math.min(1, Math.max(0, positions.getY(vertex) + 0.5));
    joints[vertex * 4 + 1] = 1;
    weights.set([1 - upper, upper], vertex * 4);
  }
  geometry.setAttribute("skinIndex", new BufferAttribute(joints, 4));
  geometry.setAttribute("skinWeight", new BufferAttribute(weights, 4));
  const mesh = new SkinnedMesh(geometry, new MeshStandardMaterial());
  const [base, bone] = [new Bone(), new Bone()];
  base.add(bone);
  root.add(base, mesh);
  root.updateMatrixWorld(true);
  mesh.bind(new Skeleton([base, bone]));
  return { scene: sceneOf(root, [], mesh), bone };
}

/** At the end of its quarter turn. */
function turnedBox(): PosedSurface {
  const scene = turningBox();
  const surface = gatherRestingSurface(scene);
  const animation = new ModelAnimation(scene);
  const posed = new PosedSurface(scene, surface, new SurfaceQuery(surface));
  animation.set({ clip: 0, seconds: 1 - 1e-9 });
  posed.refresh();
  return posed;
}

describe("a posed surface", () => {
  it("tells what a ray meets as it lies at rest: on a box that has turned, its other side", () => {
    const posed = turnedBox();
    const hit = posed.pick(new Ray(new Vector3(0.25, 0.5, 5), new Vector3(0, 0, -1)));
    // A quarter about Y brings the side that looks to -X to the front, what lay at z in it to x.
    expectVector(hit?.position ?? new Vector3(), new Vector3(-1, 0.5, 0.25), 1e-4);
    expectVector(hit?.normal ?? new Vector3(), new Vector3(-1, 0, 0), 1e-4);
    expect(hit?.distance).toBeCloseTo(4, 4);
  });

  it("keeps a place in its triangle: the texture coordinates are those of the posed hit", () => {
    const { scene, bone } = bendingPole();
    const surface = gatherRestingSurface(scene);
    const rest = new SurfaceQuery(surface);
    const posed = new PosedSurface(scene, surface, rest);
    bone.rotation.z = -1.2;
    posed.refresh();
    for (const [x, y] of [
      [1.2, 0.4],
      [0.8, 0.3],
      [0.05, -1.52],
    ] as const) {
      const ray = new Ray(new Vector3(x, y, 4), new Vector3(0, 0, -1));
      const seen = posed.query.raycast(ray.origin, ray.direction);
      const met = posed.pick(ray);
      expect(met?.triangle).toBeTypeOf("number");
      expect(met?.triangle).toBe(seen?.triangle);
      expect(met?.uv[0]).toBeCloseTo(seen?.uv[0] ?? -1, 5);
      expect(met?.uv[1]).toBeCloseTo(seen?.uv[1] ?? -1, 5);
      // And it lies on the resting pole, not on the bent one.
      expect(Math.hypot(met?.position.x ?? 0, met?.position.z ?? 0)).toBeCloseTo(0.3, 1);
      expectVector(posed.toPosed(met?.position ?? new Vector3()), seen?.position ?? new Vector3(), 1e-4);
    }
  });

  it("meets nothing where the model has moved away from", () => {
    const { scene, bone } = bendingPole();
    const surface = gatherRestingSurface(scene);
    const posed = new PosedSurface(scene, surface, new SurfaceQuery(surface));
    const through = new Ray(new Vector3(0, 1.8, 4), new Vector3(0, 0, -1));
    expect(posed.pick(through)).not.toBeNull();
    bone.rotation.z = -Math.PI / 2;
    posed.refresh();
    expect(posed.pick(through)).toBeNull();
  });
});

describe("a model's animation", () => {
  it("stops anywhere, runs at another speed, and comes back to rest exactly", () => {
    const scene = turningBox();
    const box = scene.root.children[0] as Mesh;
    const animation = new ModelAnimation(scene);
    animation.set({ playing: true, speed: 0.5 });
    animation.advance(0.8);
    expect(animation.state).toMatchObject({ clip: 0, playing: true, seconds: 0.4 });
    animation.set({ playing: false });
    animation.advance(5);
    expect(animation.state.seconds).toBe(0.4);
    expect(box.rotation.y).toBeGreaterThan(0.5);
    animation.set({ clip: null });
    expect(animation.posed).toBe(false);
    expect(box.quaternion.toArray()).toEqual([0, 0, 0, 1]);
  });

  it("goes round and round", () => {
    const animation = new ModelAnimation(turningBox());
    animation.set({ playing: true });
    for (let frame = 0; frame < 25; frame++) animation.advance(0.1);
    expect(animation.state.seconds).toBeCloseTo(0.5, 6);
  });

  it("is scrubbed within its clip and no further", () => {
    const animation = new ModelAnimation(turningBox());
    animation.set({ clip: 0, seconds: 7 });
    expect(animation.state.seconds).toBe(1);
    animation.set({ seconds: Number.NaN });
    expect(animation.state.seconds).toBe(0);
  });

  it("that does not exist leaves the model at rest", () => {
    const animation = new ModelAnimation(turningBox());
    animation.set({ clip: 3, playing: true });
    expect(animation.state).toMatchObject({ clip: null, playing: false });
  });
});

describe("a surface without some of its meshes", () => {
  it("keeps what its triangles know, and lets rays through the others", () => {
    const root = new Group();
    const near = new Mesh(new BoxGeometry(1, 1, 1).translate(0, 0, 3), new MeshStandardMaterial());
    const far = new Mesh(new BoxGeometry(1, 1, 1), new MeshStandardMaterial());
    root.add(near, far);
    const surface = gatherRestingSurface(sceneOf(root, [], near, far));
    const ray = [new Vector3(0.1, 0.1, 9), new Vector3(0, 0, -1)] as const;
    expect(new SurfaceQuery(surface).raycast(...ray)?.material).toBe(0);
    const without = triangleSubset(surface, (mesh) => mesh !== 0);
    const hit = new SurfaceQuery(without).raycast(...ray);
    expect(hit?.material).toBe(1);
    expect(hit?.position.z).toBeCloseTo(0.5, 6);
    expect(hit?.face).toBeLessThan(12);
  });

  it("tells what the view's directions mean at rest: a step to the right there is a step to the right here", () => {
    const posed = turnedBox();
    const view = { eye: new Vector3(0.2, 0.3, 9), right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
    // The side that looks to -X at rest is the one in front.
    const place = new Vector3(-1, 0.5, 0.25);
    const { eye, right, up } = posed.viewAtRest(place, view);
    expectVector(right, new Vector3(0, 0, 1), 1e-4);
    expectVector(up, view.up, 1e-4);
    expectVector(eye, new Vector3(-9, 0.3, 0.2), 1e-3);
    const stepped = posed.toPosed(place.clone().addScaledVector(right, 0.3).addScaledVector(up, -0.2));
    expectVector(stepped, posed.toPosed(place).add(new Vector3(0.3, -0.2, 0)), 1e-4);
  });

  it("turns the view with the joint that the place hangs on", () => {
    const { scene, bone } = bendingPole();
    const surface = gatherRestingSurface(scene);
    const posed = new PosedSurface(scene, surface, new SurfaceQuery(surface));
    bone.rotation.z = Math.PI / 2;
    posed.refresh();
    const view = { eye: new Vector3(0, 0, 9), right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
    // The upper half now points to -X: along it, to the left, was up at rest.
    expectVector(posed.viewAtRest(new Vector3(0, 1.5, 0.3), view).right, new Vector3(0, -1, 0), 1e-3);
    expectVector(posed.viewAtRest(new Vector3(0, -1.5, 0.3), view).right, view.right, 1e-3);
  });
});

describe("the gizmo on a posed surface", () => {
  const projector = {
    kind: "planar",
    position: [-1, 0.25, 0.5],
    rotation: [0, -Math.SQRT1_2, 0, Math.SQRT1_2],
    size: [0.5, 0.25, 0.2],
  } as const;
  const start = poseOf(projector);
  const limits = { least: 0.01, most: 10 };
  const pointer = (x: number, y: number) => ({
    ray: new Ray(new Vector3(x, y, 5), new Vector3(0, 0, -1)),
    alt: false,
    shift: false,
  });

  it("stands where the turn of the box has brought the decal's side", () => {
    const motion = turnedBox().motionAt(start.position);
    const shown = poseOf(carried(projector, motion));
    expectVector(shown.position, new Vector3(0.5, 0.25, 1), 1e-4);
    expectVector(axisOf(shown, 2), new Vector3(0, 0, 1), 1e-4);
    expect(shown.size.toArray()).toEqual(start.size.toArray());
  });

  it("scales and turns the resting decal by as much as the pointer has moved over the posed one", () => {
    const motion = turnedBox().motionAt(start.position);
    // The decal's right, at rest along +Z, is the screen's +X in the pose.
    const right = pointer(0.75, 0.25);
    const atRest = { ...right, ray: right.ray.clone().applyMatrix4(motion.clone().invert()) };
    const box = (drag: ReturnType<typeof scaleDrag>) => dragAtRest(boxDrag(drag), motion);
    const wider = box(scaleDrag(start, "e", 0, atRest.ray, limits)).move(pointer(0.95, 0.25));
    expect(wider?.kind === "planar" && wider.size[0]).toBeCloseTo(0.7, 4);
    expect(wider?.kind === "planar" && wider.size[1]).toBeCloseTo(0.25, 6);
    const turned = box(rotateDrag(start, 0, atRest.ray)).move(pointer(0.5, 0.5));
    if (turned?.kind !== "planar") throw new Error("The decal did not turn.");
    expectVector(axisOf(poseOf(turned), 0), new Vector3(0, 1, 0), 1e-4);
    expectVector(axisOf(poseOf(turned), 2), new Vector3(-1, 0, 0), 1e-4);
  });
});
