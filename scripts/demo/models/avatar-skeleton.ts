/** The avatar's joints in their rest pose. Left is the avatar's own left: +X, since it faces +Z. Metres. */

import {
  add,
  multiplyQuaternions,
  type Quaternion,
  quaternionAbout,
  rotate,
  scale,
  type Vec3,
} from "../geometry/vector.ts";

export const JOINT_NAMES = [
  "Hips",
  "Spine",
  "Head",
  "LeftUpperArm",
  "LeftForearm",
  "RightUpperArm",
  "RightForearm",
  "LeftThigh",
  "LeftShin",
  "LeftFoot",
  "RightThigh",
  "RightShin",
  "RightFoot",
] as const;

export type JointName = (typeof JOINT_NAMES)[number];

export interface JointPose {
  /** Relative to the parent. */
  readonly translation: Vec3;
  readonly rotation: Quaternion;
}

export type Pose = Readonly<Record<JointName, JointPose>>;

export const PARENTS: Readonly<Record<JointName, JointName | null>> = {
  Hips: null,
  Spine: "Hips",
  Head: "Spine",
  LeftUpperArm: "Spine",
  LeftForearm: "LeftUpperArm",
  RightUpperArm: "Spine",
  RightForearm: "RightUpperArm",
  LeftThigh: "Hips",
  LeftShin: "LeftThigh",
  LeftFoot: "LeftShin",
  RightThigh: "Hips",
  RightShin: "RightThigh",
  RightFoot: "RightShin",
};

/** How far the arms are held away from the body at rest. */
const ARM_TILT = (11 * Math.PI) / 180;

/** Where the joints lie in the model while the arms hang straight; parts are built in that position. */
export const STRAIGHT_JOINTS: Readonly<Record<JointName, Vec3>> = {
  Hips: [0, 0.84, 0],
  Spine: [0, 0.92, 0],
  Head: [0, 1.37, 0],
  LeftUpperArm: [0.318, 1.285, 0],
  LeftForearm: [0.318, 1.035, 0],
  RightUpperArm: [-0.318, 1.285, 0],
  RightForearm: [-0.318, 1.035, 0],
  LeftThigh: [0.108, 0.8, 0],
  LeftShin: [0.108, 0.45, 0],
  LeftFoot: [0.108, 0.11, 0],
  RightThigh: [-0.108, 0.8, 0],
  RightShin: [-0.108, 0.45, 0],
  RightFoot: [-0.108, 0.11, 0],
};

/** The arm's turn about its shoulder that takes the straight position to rest. */
export function armTilt(side: "Left" | "Right"): Quaternion {
  return quaternionAbout([0, 0, 1], side === "Left" ? ARM_TILT : -ARM_TILT);
}

const NO_TURN: Quaternion = [0, 0, 0, 1];

function restPose(): Pose {
  const joints = {} as Record<JointName, JointPose>;
  for (const name of JOINT_NAMES) {
    const parent = PARENTS[name];
    const here = STRAIGHT_JOINTS[name];
    const translation = parent ? add(here, scale(STRAIGHT_JOINTS[parent], -1)) : here;
    const rotation = name === "LeftUpperArm" ? armTilt("Left") : name === "RightUpperArm" ? armTilt("Right") : NO_TURN;
    joints[name] = { translation, rotation };
  }
  return joints;
}

export const REST_POSE: Pose = restPose();

/** Where a pose puts every joint in the model. */
export function jointPlaces(pose: Pose): Record<JointName, JointPose> {
  const places = {} as Record<JointName, JointPose>;
  for (const name of JOINT_NAMES) {
    const parent = PARENTS[name];
    const own = pose[name];
    const above = parent ? places[parent] : undefined;
    places[name] = above
      ? {
          translation: add(above.translation, rotate(above.rotation, own.translation)),
          rotation: multiplyQuaternions(above.rotation, own.rotation),
        }
      : own;
  }
  return places;
}

/** The matrix from the model to a joint at rest, column by column, as glTF's inverse bind matrices are. */
export function inverseBindMatrix(place: JointPose): number[] {
  const [x, y, z, w] = place.rotation;
  const inverse: Quaternion = [-x, -y, -z, w];
  const columns = (
    [
      [1, 0, 0],
      [0, 1, 0],
      [0, 0, 1],
    ] as const
  ).map((axis) => rotate(inverse, axis));
  const origin = scale(rotate(inverse, place.translation), -1);
  return [...columns.flatMap((column) => [...column, 0]), ...origin, 1];
}
