/** What the demo shows: its decals, its models, and the design that each model opens with (spec.md, 8). */

import { multiplyQuaternions, type Quaternion, quaternionAbout, type Vec3 } from "./geometry/vector.ts";

export interface DemoDecal {
  readonly id: string;
  readonly name: string;
  /** Width of the picture, pixels; the height follows the drawing. */
  readonly width: number;
}

export const DEMO_DECALS: readonly DemoDecal[] = [
  { id: "mark", name: "Texelcast mark", width: 1024 },
  { id: "badge", name: "Travel badge", width: 1024 },
  { id: "sunburst", name: "Sunburst", width: 1024 },
  { id: "flower", name: "Flower", width: 1024 },
  { id: "waves", name: "Waves", width: 1024 },
  { id: "number", name: "Number 07", width: 1024 },
  { id: "smiley", name: "Smiley", width: 512 },
  { id: "checker", name: "Test card", width: 512 },
];

/** A decal of a starting design. Lengths in metres, model space. */
export interface DemoLayer {
  readonly id: string;
  readonly name: string;
  readonly decal: string;
  readonly position: Vec3;
  readonly rotation: Quaternion;
  readonly size: Vec3;
}

export interface DemoModel {
  readonly id: string;
  readonly name: string;
  /** glTF index of the material that the design paints. */
  readonly material: number;
  /** Width and height of its base picture, texels. */
  readonly size: readonly [number, number];
  readonly layers: readonly DemoLayer[];
}

const turn = (axis: Vec3, degrees: number): Quaternion => quaternionAbout(axis, (degrees * Math.PI) / 180);
const TO_FRONT: Quaternion = [0, 0, 0, 1];
const TO_BACK = turn([0, 1, 0], 180);
/** Faces up, and reads upright for someone who looks down from the front. */
const UPWARD = turn([1, 0, 0], -90);
/** A decal's own turn, anticlockwise as seen on the surface, then the way it faces. */
const slanted = (facing: Quaternion, degrees: number): Quaternion =>
  multiplyQuaternions(facing, turn([0, 0, 1], degrees));

export const DEMO_MODELS: readonly DemoModel[] = [
  {
    id: "mug",
    name: "Mug",
    material: 0,
    size: [2048, 2048],
    layers: [
      {
        id: "mark",
        name: "Texelcast mark",
        decal: "mark",
        position: [0, 0.0515, 0.041],
        rotation: TO_FRONT,
        size: [0.056, 0.056, 0.04],
      },
      {
        id: "smiley",
        name: "Smiley",
        decal: "smiley",
        position: [0, 0.0068, 0],
        rotation: UPWARD,
        size: [0.034, 0.034, 0.02],
      },
    ],
  },
  {
    id: "avatar",
    name: "Avatar",
    material: 0,
    size: [1024, 1024],
    layers: [
      {
        id: "badge",
        name: "Travel badge",
        decal: "badge",
        position: [0, 1.15, 0.14],
        rotation: TO_FRONT,
        size: [0.26, 0.26, 0.1],
      },
      {
        id: "number",
        name: "Number 07",
        decal: "number",
        position: [0, 1.13, -0.14],
        rotation: TO_BACK,
        size: [0.32, 0.24, 0.1],
      },
    ],
  },
  {
    id: "skateboard",
    name: "Skateboard",
    material: 0,
    size: [1024, 2048],
    layers: [
      {
        id: "sunburst",
        name: "Sunburst",
        decal: "sunburst",
        position: [0, 0.395, 0.005],
        rotation: TO_FRONT,
        size: [0.2, 0.2, 0.04],
      },
      {
        id: "waves",
        name: "Waves",
        decal: "waves",
        position: [0, 0.069, -0.02],
        rotation: slanted(TO_FRONT, 180),
        size: [0.3, 0.15, 0.18],
      },
      {
        id: "mark",
        name: "Texelcast mark",
        decal: "mark",
        position: [0, 0.705, -0.02],
        rotation: TO_FRONT,
        size: [0.11, 0.11, 0.12],
      },
    ],
  },
];

/** A model without a design, to begin something of one's own on. */
export interface DemoTemplate {
  readonly id: string;
  readonly name: string;
  /** What it is for, in a few words. */
  readonly hint: string;
  /** Name of its .glb. */
  readonly model: string;
  /** Name of its picture in `templates/`. */
  readonly picture: string;
  readonly material: number;
  /** Width and height of its texture, texels. */
  readonly size: readonly [number, number];
}

export const DEMO_TEMPLATES: readonly DemoTemplate[] = [
  {
    id: "block-wide",
    name: "Block figure, wide arms",
    hint: "Pixel skin with an outer layer",
    model: "block-wide",
    picture: "block-wide",
    material: 0,
    size: [64, 64],
  },
  {
    id: "block-slim",
    name: "Block figure, slim arms",
    hint: "Pixel skin with an outer layer",
    model: "block-slim",
    picture: "block-slim",
    material: 0,
    size: [64, 64],
  },
  {
    id: "avatar",
    name: "Avatar",
    hint: "Jointed figure that walks",
    model: "avatar",
    picture: "avatar",
    material: 0,
    size: [1024, 1024],
  },
  {
    id: "mug",
    name: "Mug",
    hint: "Ceramic, inside and out",
    model: "mug",
    picture: "mug",
    material: 0,
    size: [2048, 2048],
  },
  {
    id: "skateboard",
    name: "Skateboard",
    hint: "Graphic and grip",
    model: "skateboard",
    picture: "skateboard",
    material: 0,
    size: [1024, 2048],
  },
];

/** Width of a template's picture, pixels. */
export const TEMPLATE_PICTURE_WIDTH = 192;

/** The demo's index file: addresses of models and decals are relative to the page, those inside a design to this file. */
export function demoIndex(): string {
  const models = DEMO_MODELS.map(({ id, name, material, size, layers }) => ({
    id,
    name,
    model: `demo/${id}.glb`,
    material,
    size,
    design: designDocument(material, layers),
  }));
  const decals = DEMO_DECALS.map(({ id, name }) => ({ id, name, picture: `demo/decals/${id}.png` }));
  const templates = DEMO_TEMPLATES.map(({ model, picture, ...rest }) => ({
    ...rest,
    model: `demo/${model}.glb`,
    picture: `demo/templates/${picture}.png`,
  }));
  return `${JSON.stringify({ models, templates, decals }, null, 2)}\n`;
}

function designDocument(material: number, layers: readonly DemoLayer[]): object {
  const used = [...new Set(layers.map(({ decal }) => decal))];
  return {
    format: "texelcast-design",
    version: 1,
    assets: Object.fromEntries(used.map((decal) => [decal, { type: "image/png", uri: `decals/${decal}.png` }])),
    layers: layers.map(({ id, name, decal, position, rotation, size }) => ({
      id,
      type: "decal",
      name,
      material,
      asset: decal,
      occlusion: "self",
      projector: { kind: "planar", position, rotation: rotation.map(tidy), size },
    })),
  };
}

/** Rounds away the 1e-17 of a right angle's cosine. */
const tidy = (value: number): number => Math.round(value * 1e9) / 1e9 + 0;
