/** A blocky, jointed avatar, 1.8 m tall, with a skeleton and a looping walk. */

import type { Document, Node } from "@gltf-transform/core";
import { type Atlas, joinAtlas, layOutCharts } from "../geometry/atlas.ts";
import { addAccessor, addMaterial, addPrimitive, createDocument, writeGlb } from "../output/glb.ts";
import { atlasGuide, partData } from "../output/part-data.ts";
import { encodePng } from "../picture/png.ts";
import { avatarCharts, type BoundChart } from "./avatar-body.ts";
import { paintAvatar } from "./avatar-look.ts";
import { inverseBindMatrix, JOINT_NAMES, type JointName, jointPlaces, PARENTS, REST_POSE } from "./avatar-skeleton.ts";
import { WALK_KEYS, WALK_SECONDS, walkPose } from "./avatar-walk.ts";

function avatarAtlas(bound: readonly BoundChart[]): Atlas {
  return layOutCharts(
    bound.map(({ chart }) => chart),
    { width: 1024, height: 1024, spacing: 6 },
  );
}

const SIDED = ["sleeve", "arm", "hand", "leg", "shoe"];
/** The charts that people paint; ears, hair's edges and the ends of limbs go without a name. */
const AVATAR_PARTS: Readonly<Record<string, string>> = {
  head: "Head",
  "hair cap": "Hair",
  "hair back": "Back hair",
  torso: "Torso",
  hips: "Hips",
  ...Object.fromEntries(
    ["left", "right"].flatMap((side) =>
      SIDED.map((limb) => [`${side} ${limb}`, `${side === "left" ? "Left" : "Right"} ${limb}`]),
    ),
  ),
};

export async function buildAvatar(): Promise<Uint8Array<ArrayBuffer>> {
  const bound = avatarCharts();
  const atlas = avatarAtlas(bound);
  const document = createDocument();
  const material = addMaterial(document, {
    name: "Avatar",
    roughness: 0.62,
    metallic: 0,
    basePicture: await encodePng(await paintAvatar(atlas, bound)),
  });
  material.setExtras(partData({ guide: atlasGuide(atlas, AVATAR_PARTS) }));
  const primitive = addPrimitive(document, joinAtlas(atlas), material);
  const { joints, weights } = vertexWeights(bound);
  primitive
    .setAttribute("JOINTS_0", addAccessor(document, "VEC4", joints))
    .setAttribute("WEIGHTS_0", addAccessor(document, "VEC4", weights));
  const nodes = addSkeleton(document);
  const skin = document.createSkin("Avatar");
  for (const name of JOINT_NAMES) skin.addJoint(nodes[name]);
  const places = jointPlaces(REST_POSE);
  const matrices = JOINT_NAMES.flatMap((name) => inverseBindMatrix(places[name]));
  skin.setSkeleton(nodes.Hips).setInverseBindMatrices(addAccessor(document, "MAT4", new Float32Array(matrices)));
  const body = document.createNode("Body").setMesh(document.createMesh("Body").addPrimitive(primitive)).setSkin(skin);
  document.createScene("Avatar").addChild(body).addChild(nodes.Hips);
  addWalk(document, nodes);
  return writeGlb(document);
}

/** In the order of the joined geometry: chart by chart. */
function vertexWeights(bound: readonly BoundChart[]): {
  joints: Uint8Array<ArrayBuffer>;
  weights: Float32Array<ArrayBuffer>;
} {
  const all = bound.flatMap((entry) => entry.weights);
  const joints = new Uint8Array(all.length * 4);
  const weights = new Float32Array(all.length * 4);
  all.forEach((entries, vertex) => {
    entries.forEach(([joint, weight], slot) => {
      joints[vertex * 4 + slot] = JOINT_NAMES.indexOf(joint);
      weights[vertex * 4 + slot] = weight;
    });
  });
  return { joints, weights };
}

function addSkeleton(document: Document): Record<JointName, Node> {
  const nodes = {} as Record<JointName, Node>;
  for (const name of JOINT_NAMES) {
    const { translation, rotation } = REST_POSE[name];
    const node = document
      .createNode(name)
      .setTranslation([...translation])
      .setRotation([...rotation]);
    nodes[name] = node;
    const parent = PARENTS[name];
    if (parent) nodes[parent].addChild(node);
  }
  return nodes;
}

function addWalk(document: Document, nodes: Record<JointName, Node>): void {
  const animation = document.createAnimation("Walk");
  // The last key takes the first one's phase, so the loop closes bit by bit.
  const poses = Array.from({ length: WALK_KEYS }, (_, key) => walkPose((key % (WALK_KEYS - 1)) / (WALK_KEYS - 1)));
  const times = new Float32Array(poses.map((_, key) => (WALK_SECONDS * key) / (WALK_KEYS - 1)));
  const input = addAccessor(document, "SCALAR", times);
  const addChannel = (name: JointName, path: "rotation" | "translation"): void => {
    const values = new Float32Array(poses.flatMap((pose) => [...pose[name][path]]));
    const output = addAccessor(document, path === "rotation" ? "VEC4" : "VEC3", values);
    const sampler = document.createAnimationSampler().setInput(input).setOutput(output).setInterpolation("LINEAR");
    const channel = document.createAnimationChannel().setTargetNode(nodes[name]).setTargetPath(path);
    animation.addSampler(sampler).addChannel(channel.setSampler(sampler));
  };
  addChannel("Hips", "translation");
  for (const name of JOINT_NAMES) addChannel(name, "rotation");
}
