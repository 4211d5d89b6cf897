/** The avatar's walk: one stride of both legs, in place, from tables of angles over the cycle. */

import { add, multiplyQuaternions, type Quaternion, quaternionAbout, rotate, type Vec3 } from "../geometry/vector.ts";
import { armTilt, type JointName, type JointPose, jointPlaces, type Pose, REST_POSE } from "./avatar-skeleton.ts";

export const WALK_SECONDS = 1.08;
/** Poses over the cycle; the last one repeats the first. */
export const WALK_KEYS = 33;

/**
 * Degrees at eighths of the left leg's cycle, which begins as its heel strikes the ground and leaves the ground at
 * about 0.6. The right leg is half a cycle behind.
 */
const THIGH_FORWARD = [27, 21, 8, -8, -20, -13, 13, 28];
const KNEE_BENT = [5, 13, 9, 6, 15, 44, 56, 24];
/** Of the foot against the ground; toes down is positive. */
const FOOT_PITCH = [-15, 0, 0, 2, 18, 46, 28, -6];
const ARM_FORWARD = [-24, -20, -8, 8, 22, 20, 8, -10];
const ELBOW_BENT = [12, 12, 15, 20, 27, 27, 21, 15];

/** A smooth curve through values at even steps of a cycle: periodic Catmull-Rom. */
function overCycle(values: readonly number[], phase: number): number {
  const count = values.length;
  const position = (((phase % 1) + 1) % 1) * count;
  const index = Math.floor(position) % count;
  const t = position - Math.floor(position);
  const at = (offset: number): number => values[(index + offset + count) % count] as number;
  const [a, b, c, d] = [at(-1), at(0), at(1), at(2)];
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

const degrees = (angle: number): number => (angle * Math.PI) / 180;
const pitch = (angle: number): Quaternion => quaternionAbout([1, 0, 0], degrees(angle));
const yaw = (angle: number): Quaternion => quaternionAbout([0, 1, 0], degrees(angle));
const roll = (angle: number): Quaternion => quaternionAbout([0, 0, 1], degrees(angle));
const turns = (...list: Quaternion[]): Quaternion => list.reduce(multiplyQuaternions);

/** The pose at a phase from 0 to 1. The lower foot touches the ground, which gives the walk its bob. */
export function walkPose(phase: number): Pose {
  const wave = (harmonic: number, shift = 0): number => Math.cos(2 * Math.PI * (harmonic * phase + shift));
  const pose: Record<JointName, JointPose> = { ...REST_POSE };
  const turn = (name: JointName, rotation: Quaternion): void => {
    pose[name] = { translation: REST_POSE[name].translation, rotation };
  };
  turn("Hips", turns(yaw(-5 * wave(1)), roll(2.2 * wave(1, -0.25))));
  turn("Spine", turns(yaw(10 * wave(1)), roll(-2.2 * wave(1, -0.25)), pitch(2.5 + 1 * wave(2, 0.1))));
  turn("Head", turns(yaw(-5 * wave(1)), pitch(-2 - 1.5 * wave(2, 0))));
  for (const side of ["Left", "Right"] as const) {
    const own = side === "Left" ? phase : phase + 0.5;
    const thigh = -overCycle(THIGH_FORWARD, own);
    const knee = overCycle(KNEE_BENT, own);
    turn(`${side}Thigh`, pitch(thigh));
    turn(`${side}Shin`, pitch(knee));
    turn(`${side}Foot`, pitch(overCycle(FOOT_PITCH, own) - thigh - knee));
    turn(`${side}UpperArm`, turns(pitch(-overCycle(ARM_FORWARD, own)), armTilt(side)));
    turn(`${side}Forearm`, pitch(-overCycle(ELBOW_BENT, own)));
  }
  const sway = 0.016 * wave(1, -0.25);
  const [, height] = REST_POSE.Hips.translation;
  pose.Hips = { translation: [sway, height, 0], rotation: pose.Hips.rotation };
  pose.Hips = { translation: [sway, height - lowestSole(pose), 0], rotation: pose.Hips.rotation };
  return pose;
}

/** Heel and toe edges of a shoe, from its ankle; metres. */
const SOLE: readonly Vec3[] = [-0.06, 0.06].flatMap((x) => [-0.085, 0.16].map((z): Vec3 => [x, -0.11, z]));

/** Height of the lowest point of both soles over the ground. */
export function lowestSole(pose: Pose): number {
  const places = jointPlaces(pose);
  const heights = (["LeftFoot", "RightFoot"] as const).flatMap((foot) =>
    SOLE.map((corner) => add(places[foot].translation, rotate(places[foot].rotation, corner))[1]),
  );
  return Math.min(...heights);
}
