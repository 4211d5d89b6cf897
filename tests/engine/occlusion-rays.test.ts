/** Occlusion against another ray caster: three-mesh-bvh, one ray a texel (spec.md, 4). */
import {
  BoxGeometry,
  BufferGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Ray,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";
import { MeshBVH } from "three-mesh-bvh";
import { expect, test } from "vitest";
import { Filters, Occlusions } from "../../web/core/abi.ts";
import { Session } from "../../web/core/session.ts";
import { loadCore } from "../../web/core/wasm-module.ts";

const SIZE = 160;

/** A knot, a ball inside one of its loops and a box before it, each in a part of the texture of its own. */
function makeScene(): BufferGeometry {
  const parts = [
    new TorusKnotGeometry(1, 0.3, 96, 10),
    new SphereGeometry(0.5, 24, 12),
    new BoxGeometry(0.6, 0.3, 0.4, 2, 2, 2).translate(0.4, 0.3, 1.6),
  ];
  parts.forEach((part, index) => {
    const uv = part.getAttribute("uv");
    for (let i = 0; i < uv.count; i++) uv.setX(i, (index + 0.02 + 0.96 * Math.min(uv.getX(i), 0.9999)) / 3);
  });
  const merged = mergeGeometries(parts.map((part) => part.toNonIndexed()));
  const scene = new BufferGeometry();
  for (const name of ["position", "normal", "uv"]) {
    scene.setAttribute(name, new Float32BufferAttribute(merged.getAttribute(name).array, name === "uv" ? 2 : 3));
  }
  return scene;
}

test("occlusion hides exactly the texels whose ray meets another triangle, grazing ones apart", async () => {
  const session = Session.create(await loadCore());
  const scene = makeScene();
  const array = (name: string) => scene.getAttribute(name).array as Float32Array;
  session.addMesh({ positions: array("position"), normals: array("normal"), uvs: array("uv") });
  const target = session.createTarget({ width: SIZE, height: SIZE, gutter: 0 });
  while (!target.bake(1 << 20).done);
  const image = session.createImage(1, 1, new Uint8Array([255, 0, 0, 255]));
  const texels = target.readPositions(0, SIZE);
  const normals = target.readNormals(0, SIZE);
  const coverage = target.readCoverage(0, SIZE);
  const bvh = new MeshBVH(scene);
  scene.computeBoundingBox();
  const diagonal = scene.boundingBox?.getSize(new Vector3()).length() ?? 0;

  let hidden = 0;
  let seen = 0;
  let different = 0;
  const directions = [
    new Vector3(0, 0, 1),
    new Vector3(1, 0.3, 0.2).normalize(),
    new Vector3(-0.5, 0.7, 0.4).normalize(),
  ];
  for (const towards of directions) {
    const rotation = quaternionTo(towards);
    const shared = {
      image,
      rotation,
      filter: Filters.nearest,
      size: [8, 8, 8] as [number, number, number],
      angleFadeStart: 90,
      angleFadeEnd: 90,
    };
    const layer = target.createLayer({ ...shared, occlusion: Occlusions.none });
    target.update();
    const through = target.read(0, 0, 0, SIZE, SIZE);
    target.updateLayer(layer, { ...shared, occlusion: Occlusions.self });
    target.update();
    const painted = target.read(0, 0, 0, SIZE, SIZE);
    target.destroyLayer(layer);
    for (let texel = 0; texel < SIZE * SIZE; texel++) {
      const facing = new Vector3().fromArray(normals, texel * 3).dot(towards);
      // What the decal reaches without occlusion; edges of shapes apart, where a ray grazes its own neighbours.
      if (coverage[texel] !== 1 || facing < 0.25 || through[texel * 4 + 1] !== 0) continue;
      const origin = new Vector3().fromArray(texels, texel * 3);
      const answers = [-1, 0, 1].map((shift) => isBlocked(bvh, origin, towards, diagonal * (0.001 + 0.0004 * shift)));
      if (answers.some((answer) => answer !== answers[1])) continue;
      const isHidden = painted[texel * 4 + 1] !== 0;
      if (isHidden) hidden += 1;
      else seen += 1;
      if (isHidden !== answers[1]) different += 1;
    }
  }
  expect(hidden).toBeGreaterThan(1500);
  expect(seen).toBeGreaterThan(5000);
  // Rays that pass within rounding of a triangle's edge.
  expect(different).toBeLessThanOrEqual((hidden + seen) / 2000);
  session.destroy();
});

function isBlocked(bvh: MeshBVH, origin: Vector3, towards: Vector3, nearest: number): boolean {
  const start = origin.clone().addScaledVector(towards, nearest);
  return bvh.raycastFirst(new Ray(start, towards), DoubleSide) !== null;
}

/** Turns +Z towards a direction. */
function quaternionTo(towards: Vector3): [number, number, number, number] {
  const axis = new Vector3(0, 0, 1).cross(towards);
  const half = new Vector3(axis.x, axis.y, axis.z);
  const w = 1 + towards.z;
  const length = Math.hypot(half.x, half.y, half.z, w);
  return [half.x / length, half.y / length, half.z / length, w / length];
}
