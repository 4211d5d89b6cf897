/** The avatar's parts: blocks with rounded edges, each bound to one joint, or blended over two where a limb bends. */

import { bevelledBox } from "../geometry/bevelled-box.ts";
import { type Chart, deformChart, placeChart } from "../geometry/chart.ts";
import { add, mix, quaternionAbout, rotate, scale, smoothstep, type Vec3 } from "../geometry/vector.ts";
import { armTilt, type JointName, STRAIGHT_JOINTS } from "./avatar-skeleton.ts";

export type Cloth = "skin" | "hair" | "shirt" | "trousers" | "shoe" | "trim";

export interface AvatarPart {
  readonly name: string;
  readonly cloth: Cloth;
  readonly size: Vec3;
  readonly bevel: number;
  /** Model space, arms straight. */
  readonly centre: Vec3;
  readonly joint: JointName;
  /** The joint that takes over below its own height. */
  readonly bends?: JointName;
  /** Width and depth at the bottom relative to the top. */
  readonly taper?: number;
  /** Turn about +Z before placing, degrees. */
  readonly roll?: number;
  /** Texel density of the band around its sides; caps get less. */
  readonly density: number;
  readonly steps?: number;
}

export interface BoundChart {
  readonly chart: Chart;
  readonly part: AvatarPart;
  /** Joint and weight, at most two, for each vertex. */
  readonly weights: readonly (readonly (readonly [JointName, number])[])[];
}

/** Half of the length over which a limb bends, metres. */
const BEND_REACH = 0.05;

const CENTRAL_PARTS: readonly AvatarPart[] = [
  {
    name: "head",
    cloth: "skin",
    size: [0.4, 0.385, 0.36],
    bevel: 0.075,
    centre: [0, 1.585, 0],
    joint: "Head",
    density: 1.5,
    steps: 8,
  },
  {
    name: "neck",
    cloth: "skin",
    size: [0.15, 0.12, 0.14],
    bevel: 0.03,
    centre: [0, 1.38, 0],
    joint: "Head",
    density: 0.5,
    steps: 4,
  },
  {
    name: "hair cap",
    cloth: "hair",
    size: [0.432, 0.15, 0.392],
    bevel: 0.07,
    centre: [0, 1.735, -0.012],
    joint: "Head",
    density: 0.6,
  },
  {
    name: "hair back",
    cloth: "hair",
    size: [0.43, 0.27, 0.215],
    bevel: 0.06,
    centre: [0, 1.625, -0.1],
    joint: "Head",
    density: 0.6,
  },
  {
    name: "fringe right",
    cloth: "hair",
    size: [0.27, 0.1, 0.085],
    bevel: 0.038,
    centre: [-0.07, 1.715, 0.17],
    joint: "Head",
    roll: 9,
    density: 0.6,
    steps: 4,
  },
  {
    name: "fringe left",
    cloth: "hair",
    size: [0.18, 0.09, 0.075],
    bevel: 0.034,
    centre: [0.118, 1.718, 0.165],
    joint: "Head",
    roll: -14,
    density: 0.6,
    steps: 4,
  },
  {
    name: "collar",
    cloth: "trim",
    size: [0.2, 0.05, 0.19],
    bevel: 0.022,
    centre: [0, 1.362, 0],
    joint: "Spine",
    density: 0.5,
    steps: 4,
  },
  {
    name: "torso",
    cloth: "shirt",
    size: [0.485, 0.5, 0.28],
    bevel: 0.06,
    centre: [0, 1.115, 0],
    joint: "Spine",
    taper: 0.9,
    density: 1.5,
    steps: 8,
  },
  {
    name: "hips",
    cloth: "trousers",
    size: [0.41, 0.16, 0.24],
    bevel: 0.05,
    centre: [0, 0.835, 0],
    joint: "Hips",
    density: 0.7,
  },
];

function sideParts(side: "Left" | "Right"): AvatarPart[] {
  const sign = side === "Left" ? 1 : -1;
  const at = (x: number, y: number, z: number): Vec3 => [sign * x, y, z];
  const lower = side.toLowerCase();
  return [
    {
      name: `${lower} ear`,
      cloth: "skin",
      size: [0.045, 0.085, 0.07],
      bevel: 0.02,
      centre: at(0.204, 1.565, 0.035),
      joint: "Head",
      density: 0.6,
      steps: 4,
    },
    {
      name: `${lower} sideburn`,
      cloth: "hair",
      size: [0.046, 0.12, 0.075],
      bevel: 0.022,
      centre: at(0.191, 1.665, 0.1),
      joint: "Head",
      density: 0.6,
      steps: 4,
    },
    {
      name: `${lower} sleeve`,
      cloth: "shirt",
      size: [0.162, 0.21, 0.176],
      bevel: 0.045,
      centre: at(0.318, 1.245, 0),
      joint: `${side}UpperArm`,
      density: 1,
    },
    {
      name: `${lower} arm`,
      cloth: "skin",
      size: [0.126, 0.48, 0.138],
      bevel: 0.035,
      centre: at(0.318, 1.06, 0),
      joint: `${side}UpperArm`,
      bends: `${side}Forearm`,
      density: 1,
      steps: 4,
    },
    {
      name: `${lower} hand`,
      cloth: "skin",
      size: [0.118, 0.15, 0.15],
      bevel: 0.045,
      centre: at(0.318, 0.775, 0.004),
      joint: `${side}Forearm`,
      density: 0.8,
    },
    {
      name: `${lower} leg`,
      cloth: "trousers",
      size: [0.192, 0.74, 0.2],
      bevel: 0.045,
      centre: at(0.108, 0.462, 0),
      joint: `${side}Thigh`,
      bends: `${side}Shin`,
      density: 1.2,
      steps: 4,
    },
    {
      name: `${lower} shoe`,
      cloth: "shoe",
      size: [0.186, 0.13, 0.3],
      bevel: 0.05,
      centre: at(0.108, 0.065, 0.042),
      joint: `${side}Foot`,
      density: 0.9,
    },
  ];
}

const AVATAR_PARTS: readonly AvatarPart[] = [...CENTRAL_PARTS, ...sideParts("Left"), ...sideParts("Right")];

export function avatarCharts(): BoundChart[] {
  return AVATAR_PARTS.flatMap((part) => partCharts(part));
}

function partCharts(part: AvatarPart): BoundChart[] {
  const { size, centre, bends } = part;
  const bendAt = bends ? STRAIGHT_JOINTS[bends][1] - centre[1] : 0;
  const rings = bends ? [-2, -1, -0.5, 0, 0.5, 1, 2].map((share) => bendAt + share * BEND_REACH) : [];
  const charts = bevelledBox({ name: part.name, size, bevel: part.bevel, steps: part.steps ?? 6, rings });
  return charts.map((raw, index) => {
    const narrow = ([x, y, z]: Vec3): Vec3 => {
      const width = mix(part.taper ?? 1, 1, y / size[1] + 0.5);
      return [x * width, y, z * mix(width, 1, 0.4)];
    };
    const tapered = part.taper ? deformChart(raw, narrow) : raw;
    const turn = quaternionAbout([0, 0, 1], ((part.roll ?? 0) * Math.PI) / 180);
    const straight = placeChart(tapered, centre, (vector) => rotate(turn, vector));
    const weights = straight.positions.map(([, y]): [JointName, number][] => {
      if (!bends) return [[part.joint, 1]];
      const height = STRAIGHT_JOINTS[bends][1];
      const share = smoothstep(height + BEND_REACH, height - BEND_REACH, y);
      if (share === 0) return [[part.joint, 1]];
      if (share === 1) return [[bends, 1]];
      return [
        [part.joint, 1 - share],
        [bends, share],
      ];
    });
    // Caps are seen less than sides.
    const density = index === 0 ? part.density : part.density * 0.62;
    return { chart: { ...toRest(straight, part.joint), density }, part, weights };
  });
}

/** Arms leave the straight position by a turn about the shoulder. */
function toRest(chart: Chart, joint: JointName): Chart {
  const side = joint.startsWith("Left") ? "Left" : "Right";
  if (!joint.includes("arm") && !joint.includes("Arm")) return chart;
  const shoulder = STRAIGHT_JOINTS[`${side}UpperArm`];
  const turn = armTilt(side);
  const offset = add(shoulder, scale(rotate(turn, shoulder), -1));
  return placeChart(chart, offset, (vector) => rotate(turn, vector));
}
