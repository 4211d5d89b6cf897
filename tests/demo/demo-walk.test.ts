import type { Animation, Document, Node } from "@gltf-transform/core";
import { beforeAll, describe, expect, it } from "vitest";
import { buildAvatar } from "../../scripts/demo/models/avatar.ts";
import { inverseBindMatrix, jointPlaces, REST_POSE } from "../../scripts/demo/models/avatar-skeleton.ts";
import { lowestSole, walkPose } from "../../scripts/demo/models/avatar-walk.ts";
import { type MaterialGeometry, readDemoModel } from "./demo-files.ts";

let document: Document;
let body: MaterialGeometry;
let walk: Animation;

beforeAll(async () => {
  const model = await readDemoModel(new Map([["avatar.glb", await buildAvatar()]]), "avatar");
  document = model.document;
  body = model.parts[0] as MaterialGeometry;
  walk = document.getRoot().listAnimations()[0] as Animation;
});

/** Keys of a channel, one array each. */
function keysOf(channel: ReturnType<Animation["listChannels"]>[number]): number[][] {
  const output = channel.getSampler()?.getOutput();
  if (!output) throw new Error("the channel has no output");
  return Array.from({ length: output.getCount() }, (_, key) => output.getElement(key, []));
}

describe("the avatar's skeleton", () => {
  it("leaves every vertex where it is at rest", () => {
    const places = jointPlaces(REST_POSE);
    for (const [name, place] of Object.entries(places)) {
      const inverse = inverseBindMatrix(place);
      const joint = document
        .getRoot()
        .listNodes()
        .find((node) => node.getName() === name) as Node;
      const forward = joint.getWorldMatrix();
      for (let row = 0; row < 4; row++) {
        for (let column = 0; column < 4; column++) {
          let product = 0;
          for (let k = 0; k < 4; k++) product += (forward[k * 4 + row] as number) * (inverse[column * 4 + k] as number);
          expect(product).toBeCloseTo(row === column ? 1 : 0, 6);
        }
      }
    }
  });

  it("weighs every vertex to one in sum", () => {
    const weights = document.getRoot().listMeshes()[0]?.listPrimitives()[0]?.getAttribute("WEIGHTS_0")?.getArray();
    const sums = Array.from({ length: body.positions.length / 3 }, (_, vertex) =>
      [0, 1, 2, 3].reduce((sum, slot) => sum + (weights?.[vertex * 4 + slot] as number), 0),
    );
    expect(Math.min(...sums)).toBeCloseTo(1, 6);
    expect(Math.max(...sums)).toBeCloseTo(1, 6);
  });

  it("holds the arms away from the body at rest", () => {
    const { LeftForearm, LeftUpperArm, RightForearm } = jointPlaces(REST_POSE);
    expect(LeftForearm.translation[0]).toBeGreaterThan(LeftUpperArm.translation[0] + 0.03);
    expect(RightForearm.translation[0]).toBeCloseTo(-LeftForearm.translation[0], 9);
  });
});

describe("the avatar's walk", () => {
  it("is named Walk and moves every joint", () => {
    expect(walk.getName()).toBe("Walk");
    const turned = walk.listChannels().filter((channel) => channel.getTargetPath() === "rotation");
    expect(new Set(turned.map((channel) => channel.getTargetNode()?.getName())).size).toBe(13);
  });

  it("ends where it began, bit by bit", () => {
    for (const channel of walk.listChannels()) {
      const keys = keysOf(channel);
      expect(keys[keys.length - 1]).toEqual(keys[0]);
    }
  });

  it("passes from its last step to its first no faster than it moves elsewhere", () => {
    for (const channel of walk.listChannels()) {
      const keys = keysOf(channel);
      const steps = keys
        .slice(1)
        .map((key, index) => Math.hypot(...key.map((value, axis) => value - (keys[index]?.[axis] as number))));
      expect(steps[steps.length - 1]).toBeLessThanOrEqual(Math.max(...steps.slice(0, -1)) * 1.05 + 1e-6);
    }
  });

  it("always has a foot on the ground and none below it", () => {
    for (let step = 0; step < 40; step++) expect(lowestSole(walkPose(step / 40))).toBeCloseTo(0, 9);
  });

  it("swings the arm against the leg of the same side", () => {
    const { LeftThigh, LeftUpperArm, RightThigh } = walkPose(0);
    expect(LeftThigh.rotation[0]).toBeLessThan(0);
    expect(RightThigh.rotation[0]).toBeGreaterThan(0);
    expect(LeftUpperArm.rotation[0]).toBeGreaterThan(0);
  });
});
