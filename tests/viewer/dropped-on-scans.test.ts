import { Vector3 } from "three";
import { afterEach, describe, expect, it } from "vitest";
import { makeDecalLayer } from "../../web/editor/document/index.ts";
import type { EngineDecalLayer, Vec3 } from "../../web/engine/engine-api.ts";
import { unwrapModel } from "../../web/engine/unwrap/unwrap-model.ts";
import { placeOnSurface } from "../../web/viewer/decal-placement.ts";
import { projectorOf } from "../../web/viewer/decal-pose.ts";
import { loadModelScene } from "../../web/viewer/model-scene.ts";
import { gatherRestingSurface } from "../../web/viewer/resting-surface.ts";
import { SurfaceQuery } from "../../web/viewer/surface-query.ts";
import { buildGlb } from "../support/model-builder.ts";
import { endHosts, startHost } from "../support/painted-plane.ts";
import { solidPng } from "../support/png-file.ts";
import { seeded } from "../support/seeded.ts";
import { creature, type Face, soupOf, turnedOver } from "../support/thin-legs.ts";
import { letThreeReadPictures } from "../support/three-in-node.ts";

letThreeReadPictures();
afterEach(endHosts);

const SIZE = 1024;
const DROPS = 30;

/** Of decals that are dropped all over the unwrapped model, as the page drops them: how many are not painted where they were dropped. */
async function unpainted(faces: readonly Face[], doubleSided: boolean): Promise<number> {
  const bytes = buildGlb({ meshes: [soupOf(faces)], materials: [{ doubleSided }] });
  const { glb } = await unwrapModel({ name: "scan.glb", bytes }, { materials: [0], size: SIZE });
  const engine = startHost();
  const info = await engine.loadModel({ name: "scan.glb", bytes: glb });
  await engine.openTarget({ material: 0, width: SIZE, height: SIZE });
  await engine.setAsset("red", { name: "red.png", bytes: solidPng(4, 4, [255, 0, 0, 255]) });
  const scene = await loadModelScene(info);
  const query = new SurfaceQuery(gatherRestingSurface(scene));
  const { center, radius } = query.bounds;
  const random = seeded(11);
  const around = (): Vector3 => new Vector3(random() - 0.5, random() - 0.5, random() - 0.5);
  let missed = 0;
  for (let drop = 0; drop < DROPS; ) {
    const eye = around()
      .setLength(3 * radius)
      .add(center);
    const direction = around()
      .multiplyScalar(1.2 * radius)
      .add(center)
      .sub(eye)
      .normalize();
    const hit = query.raycast(eye, direction);
    if (hit === null) continue;
    drop += 1;
    const right = direction
      .clone()
      .cross(new Vector3(0, 1, 0))
      .normalize();
    const view = { right, up: right.clone().cross(direction) };
    const place = { position: hit.position, normal: hit.normal.multiplyScalar(hit.isBack ? -1 : 1) };
    const projector = projectorOf(placeOnSurface(query, place, 0.44 * radius, 1, view, null));
    const decal = makeDecalLayer({ id: "a", name: "a", asset: "red", material: 0, projector, backfaces: !!hit.isBack });
    engine.setLayers([decal as EngineDecalLayer], drop);
    await engine.idle();
    const [x, y] = hit.uv.map((share) => Math.floor(share * SIZE)) as [number, number];
    const [red, green] = await engine.readTexels(0, x, y, 1, 1);
    if (!(red === 255 && green === 0)) missed += 1;
  }
  scene.dispose();
  return missed;
}

describe("a decal that is dropped on a scan with thin legs, unwrapped here", () => {
  it.each<[string, (faces: Face[]) => Face[]]>([
    ["as it should be", (faces) => faces],
    ["turned inside out", turnedOver],
    [
      "with a tenth of its triangles turned over",
      (faces) => faces.flatMap((face, i) => (i % 10 ? [face] : turnedOver([face]))),
    ],
    ["with every triangle twice", (faces) => [...faces, ...faces]],
    ["with every triangle on its twin that is turned over", (faces) => [...turnedOver(faces), ...faces]],
  ])("is painted where it was dropped, on one %s", async (_what, change) => {
    for (const doubleSided of [false, true]) expect(await unpainted(change(creature()), doubleSided)).toBeLessThan(2);
  });
});

describe("a box on a leg that is turned inside out", () => {
  it("ends before the near wall, which is not seen and would occlude it", async () => {
    const info = { name: "a.glb", glb: buildGlb({ meshes: [soupOf(turnedOver(creature()))], materials: [{}] }) };
    const scene = await loadModelScene(info as Parameters<typeof loadModelScene>[0]);
    const query = new SurfaceQuery(gatherRestingSurface(scene));
    const position: Vec3 = [1.9, 0.75, 3];
    const hit = query.raycast(new Vector3(...position), new Vector3(0, 0, -1));
    if (hit === null) throw new Error("the leg was missed");
    const view = { right: new Vector3(1, 0, 0), up: new Vector3(0, 1, 0) };
    const { size, position: middle } = placeOnSurface(query, hit, 1, 1, view, null);
    const above = size.z / 2 - hit.position.distanceTo(middle);
    expect(above).toBeGreaterThan(0.02);
    expect(above).toBeLessThan(0.1);
    scene.dispose();
  });
});
