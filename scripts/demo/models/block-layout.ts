/**
 * Where the block figure's boxes lie: on the figure, and unfolded in the common 64 x 64 arrangement that pixel skins are
 * drawn in. Every box is unfolded alike: its sides in a row (right, front, left, back), the top over the front and the
 * underside beside the top. The underside lies as if looked at from above, through the box; that is the arrangement's
 * custom, so it is the one face that is mirrored.
 */

import type { Vec2, Vec3 } from "../geometry/vector.ts";

/** Sides as the figure itself says right and left; it faces +Z, so its right is -X. */
export const BLOCK_FACES = ["right", "front", "left", "back", "top", "bottom"] as const;
export type BlockFace = (typeof BLOCK_FACES)[number];
export type ArmWidth = "wide" | "slim";

/** A box; lengths in pixels of the skin, which are all of one size on the figure. */
export interface Block {
  readonly name: string;
  /** The part that it covers, for a box of the outer layer; null on the figure itself. */
  readonly covers: string | null;
  /** Texels of the top left corner of its unfolded rectangle. */
  readonly corner: Vec2;
  /** Width (x), height (y), depth (z). */
  readonly size: Vec3;
  /** Where it turns: the joint, above the ground between the feet. */
  readonly joint: Vec3;
  /** The box's middle from its joint. */
  readonly middle: Vec3;
  /** How far every face stands out, so that the outer layer lies around the figure. */
  readonly swell: number;
}

export const SKIN_SIZE = 64;
/** Height of the figure, pixels: legs, torso, head. */
export const FIGURE_HEIGHT = 32;

interface Limb {
  readonly name: string;
  readonly size: Vec3;
  readonly joint: Vec3;
  readonly middle: Vec3;
  readonly corner: Vec2;
  readonly outerCorner: Vec2;
  readonly swell: number;
}

/** The boxes of a figure with arms of 4 or 3 pixels: six of the figure, then six of the outer layer. */
export function blocksOf(arms: ArmWidth): Block[] {
  const arm = arms === "wide" ? 4 : 3;
  const limbs: readonly Limb[] = [
    {
      name: "Head",
      size: [8, 8, 8],
      joint: [0, 24, 0],
      middle: [0, 4, 0],
      corner: [0, 0],
      outerCorner: [32, 0],
      swell: 0.5,
    },
    {
      name: "Torso",
      size: [8, 12, 4],
      joint: [0, 12, 0],
      middle: [0, 6, 0],
      corner: [16, 16],
      outerCorner: [16, 32],
      swell: 0.25,
    },
    {
      name: "Right arm",
      size: [arm, 12, 4],
      joint: [-4 - arm / 2, 22, 0],
      middle: [0, -4, 0],
      corner: [40, 16],
      outerCorner: [40, 32],
      swell: 0.25,
    },
    {
      name: "Left arm",
      size: [arm, 12, 4],
      joint: [4 + arm / 2, 22, 0],
      middle: [0, -4, 0],
      corner: [32, 48],
      outerCorner: [48, 48],
      swell: 0.25,
    },
    {
      name: "Right leg",
      size: [4, 12, 4],
      joint: [-2, 12, 0],
      middle: [0, -6, 0],
      corner: [0, 16],
      outerCorner: [0, 32],
      swell: 0.25,
    },
    {
      name: "Left leg",
      size: [4, 12, 4],
      joint: [2, 12, 0],
      middle: [0, -6, 0],
      corner: [16, 48],
      outerCorner: [0, 48],
      swell: 0.25,
    },
  ];
  const inner = limbs.map((limb): Block => ({ ...limb, covers: null, swell: 0 }));
  const outer = limbs.map(
    (limb): Block => ({ ...limb, name: `${limb.name} overlay`, covers: limb.name, corner: limb.outerCorner }),
  );
  return [...inner, ...outer];
}

/** A rectangle on the texture, texels. */
export interface TexelBox {
  readonly x: number;
  readonly y: number;
  readonly width: number;
  readonly height: number;
}

export function faceBox({ corner: [x, y], size: [width, height, depth] }: Block, face: BlockFace): TexelBox {
  switch (face) {
    case "right":
      return { x, y: y + depth, width: depth, height };
    case "front":
      return { x: x + depth, y: y + depth, width, height };
    case "left":
      return { x: x + depth + width, y: y + depth, width: depth, height };
    case "back":
      return { x: x + 2 * depth + width, y: y + depth, width, height };
    case "top":
      return { x: x + depth, y, width, height: depth };
    case "bottom":
      return { x: x + depth + width, y, width, height: depth };
  }
}

/** The corners of a face as they lie on the texture: top left, bottom left, bottom right, top right; each -1 or 1. */
export function faceCorners(face: BlockFace): readonly [Vec3, Vec3, Vec3, Vec3] {
  switch (face) {
    case "right":
      return corners([-1, 1, -1], [-1, -1, -1], [-1, -1, 1], [-1, 1, 1]);
    case "front":
      return corners([-1, 1, 1], [-1, -1, 1], [1, -1, 1], [1, 1, 1]);
    case "left":
      return corners([1, 1, 1], [1, -1, 1], [1, -1, -1], [1, 1, -1]);
    case "back":
      return corners([1, 1, -1], [1, -1, -1], [-1, -1, -1], [-1, 1, -1]);
    case "top":
      return corners([-1, 1, -1], [-1, 1, 1], [1, 1, 1], [1, 1, -1]);
    case "bottom":
      return corners([-1, -1, -1], [-1, -1, 1], [1, -1, 1], [1, -1, -1]);
  }
}

export const FACE_NORMALS: Readonly<Record<BlockFace, Vec3>> = {
  right: [-1, 0, 0],
  front: [0, 0, 1],
  left: [1, 0, 0],
  back: [0, 0, -1],
  top: [0, 1, 0],
  bottom: [0, -1, 0],
};

const corners = (...all: [Vec3, Vec3, Vec3, Vec3]): readonly [Vec3, Vec3, Vec3, Vec3] => all;
