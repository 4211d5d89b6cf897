/**
 * The template for pixel skins: a figure of boxes, 1.8 m tall, with a blank 64 x 64 skin and an outer layer of slightly
 * larger boxes that is transparent until it is painted. Its joints are nodes, not a skin: each box turns as a whole.
 */

import { type Document, type Material, type Node, TextureInfo } from "@gltf-transform/core";
import type { Geometry } from "../geometry/atlas.ts";
import { type Quaternion, quaternionAbout, type Vec3 } from "../geometry/vector.ts";
import { addAccessor, addMaterial, addPrimitive, createDocument, writeGlb } from "../output/glb.ts";
import { type GuideEntry, partData } from "../output/part-data.ts";
import { encodePng } from "../picture/png.ts";
import type { Picture } from "../picture/svg.ts";
import {
  type ArmWidth,
  BLOCK_FACES,
  type Block,
  type BlockFace,
  blocksOf,
  FACE_NORMALS,
  FIGURE_HEIGHT,
  faceBox,
  faceCorners,
  SKIN_SIZE,
} from "./block-layout.ts";

const METRES_PER_PIXEL = 1.8 / FIGURE_HEIGHT;
/** Boxes that lie side by side on the skin share no edge: each is drawn in by this much, texels, to be a chart of its own. */
const INSET = 1 / 64;

/** Soft tints that tell the parts apart until they are painted. */
const TINTS: Readonly<Record<string, Vec3>> = {
  Head: [236, 214, 196],
  Torso: [186, 205, 216],
  "Right arm": [214, 206, 226],
  "Left arm": [206, 218, 198],
  "Right leg": [222, 214, 190],
  "Left leg": [218, 200, 204],
};

/** Faces that look away from the light are a little darker, so that the form reads where nothing is lit. */
const SHADES: Readonly<Record<BlockFace, number>> = {
  front: 1,
  top: 1.02,
  right: 0.965,
  left: 0.965,
  back: 0.94,
  bottom: 0.9,
};

export async function buildBlockFigure(arms: ArmWidth): Promise<Uint8Array<ArrayBuffer>> {
  const blocks = blocksOf(arms);
  const document = createDocument();
  const material = addMaterial(document, {
    name: "Skin",
    roughness: 0.85,
    metallic: 0,
    basePicture: await encodePng(blankSkin(blocks)),
  });
  // A skin's texels are to be seen as squares; what is transparent on the outer layer is not there.
  material
    .setAlphaMode("MASK")
    .setAlphaCutoff(0.5)
    .setDoubleSided(true)
    .setExtras(partData({ guide: guideOf(blocks) }));
  material
    .getBaseColorTextureInfo()
    ?.setMagFilter(TextureInfo.MagFilter.NEAREST)
    .setMinFilter(TextureInfo.MinFilter.NEAREST_MIPMAP_LINEAR);
  const joints = addBlocks(document, blocks, material);
  const scene = document.createScene("Block figure");
  for (const block of blocks) if (block.covers === null) scene.addChild(joints.get(block.name) as Node);
  addClip(document, joints, "Walk", 1.1, walkAngle);
  addClip(document, joints, "Wave", 1.6, waveAngle);
  return writeGlb(document);
}

/** The outer layer's boxes hang on the parts that they cover, and are hidden at first: they would take every click. */
function addBlocks(document: Document, blocks: readonly Block[], material: Material): Map<string, Node> {
  const joints = new Map<string, Node>();
  for (const block of blocks) {
    const primitive = addPrimitive(document, blockGeometry(block), material);
    const node = document.createNode(block.name).setMesh(document.createMesh(block.name).addPrimitive(primitive));
    if (block.covers === null) {
      node.setTranslation(block.joint.map((value) => value * METRES_PER_PIXEL) as [number, number, number]);
      joints.set(block.name, node);
    } else {
      node.setExtras(partData({ group: "Overlay", hidden: true }));
      joints.get(block.covers)?.addChild(node);
    }
  }
  return joints;
}

/** In metres from the block's joint. */
function blockGeometry(block: Block): Geometry {
  const positions: number[] = [];
  const normals: number[] = [];
  const uvs: number[] = [];
  const indices: number[] = [];
  const [width, height, depth] = block.size;
  const net = { width: 2 * (width + depth), height: height + depth };
  const drawnIn = (value: number, from: number, size: number): number =>
    (from + size / 2 + (value - from - size / 2) * (1 - (2 * INSET) / size)) / SKIN_SIZE;
  for (const face of BLOCK_FACES) {
    const first = positions.length / 3;
    const box = faceBox(block, face);
    for (const [corner, signs] of faceCorners(face).entries()) {
      for (const axis of [0, 1, 2] as const) {
        const half = block.size[axis] / 2 + block.swell;
        positions.push((block.middle[axis] + signs[axis] * half) * METRES_PER_PIXEL);
      }
      normals.push(...FACE_NORMALS[face]);
      const u = box.x + (corner >= 2 ? box.width : 0);
      const v = box.y + (corner === 1 || corner === 2 ? box.height : 0);
      uvs.push(drawnIn(u, block.corner[0], net.width), drawnIn(v, block.corner[1], net.height));
    }
    const [a, b, c, d] = [first, first + 1, first + 2, first + 3];
    indices.push(...(face === "bottom" ? [a, c, b, a, d, c] : [a, b, c, a, c, d]));
  }
  return {
    positions: new Float32Array(positions),
    normals: new Float32Array(normals),
    uvs: new Float32Array(uvs),
    indices: new Uint16Array(indices),
  };
}

function blankSkin(blocks: readonly Block[]): Picture {
  const rgba = new Uint8ClampedArray(SKIN_SIZE * SKIN_SIZE * 4);
  for (const block of blocks) {
    const tint = TINTS[block.name];
    for (const face of tint ? BLOCK_FACES : []) {
      const { x, y, width, height } = faceBox(block, face);
      for (let texel = 0; texel < width * height; texel++) {
        const at = ((y + Math.floor(texel / width)) * SKIN_SIZE + x + (texel % width)) * 4;
        rgba.set([...(tint as Vec3).map((value) => Math.min(255, Math.round(value * SHADES[face]))), 255], at);
      }
    }
  }
  return { width: SKIN_SIZE, height: SKIN_SIZE, rgba };
}

function guideOf(blocks: readonly Block[]): GuideEntry[] {
  return blocks.flatMap((block) =>
    BLOCK_FACES.map((face): GuideEntry => {
      const { x, y, width, height } = faceBox(block, face);
      return {
        part: block.name,
        face,
        uv: [x / SKIN_SIZE, y / SKIN_SIZE, (x + width) / SKIN_SIZE, (y + height) / SKIN_SIZE],
      };
    }),
  );
}

const KEYS = 17;

/** A looping clip of turns about one axis a part; angles in degrees, by a phase from 0 to 1. */
function addClip(
  document: Document,
  joints: ReadonlyMap<string, Node>,
  name: string,
  seconds: number,
  turnOf: (part: string, phase: number) => Quaternion | null,
): void {
  const animation = document.createAnimation(name);
  const phases = Array.from({ length: KEYS }, (_, key) => key / (KEYS - 1));
  const input = addAccessor(document, "SCALAR", new Float32Array(phases.map((phase) => phase * seconds)));
  for (const [part, node] of joints) {
    const turns = phases.map((phase) => turnOf(part, phase % 1));
    if (turns.some((turn) => turn === null)) continue;
    const output = addAccessor(document, "VEC4", new Float32Array(turns.flatMap((turn) => [...(turn as Quaternion)])));
    const sampler = document.createAnimationSampler().setInput(input).setOutput(output).setInterpolation("LINEAR");
    const channel = document.createAnimationChannel().setTargetNode(node).setTargetPath("rotation");
    animation.addSampler(sampler).addChannel(channel.setSampler(sampler));
  }
}

const turn = (axis: Vec3, degrees: number): Quaternion => quaternionAbout(axis, (degrees * Math.PI) / 180);
const swing = (phase: number): number => Math.sin(2 * Math.PI * phase);

function walkAngle(part: string, phase: number): Quaternion | null {
  if (part === "Torso") return null;
  if (part === "Head") return turn([0, 1, 0], 4 * swing(phase));
  const forward = part === "Right arm" || part === "Left leg" ? 1 : -1;
  return turn([1, 0, 0], (part.endsWith("arm") ? 28 : 34) * forward * swing(phase));
}

function waveAngle(part: string, phase: number): Quaternion | null {
  if (part === "Right arm") return turn([0, 0, 1], -140 + 18 * swing(2 * phase));
  if (part === "Left arm") return turn([0, 0, 1], 4);
  return part === "Head" ? turn([0, 0, 1], 4 * swing(phase)) : null;
}
