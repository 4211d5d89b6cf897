/** A projector's numbers as fields: what each is called, its bounds, what a change makes of the projector. */
import type {
  CylindricalProjector,
  PerspectiveProjector,
  Projector,
  UvProjector,
  Vec3,
} from "../../engine/engine-api.ts";
import { DESIGN_LIMITS } from "../document/design-limits.ts";
import { type Orientation, quaternionOf, wrapDegrees } from "../state/rotation.ts";
import type { Strings } from "../strings.ts";

export interface ProjectorField {
  readonly label: string;
  /** Accessible name, unique in the panel. */
  readonly name: string;
  readonly value: number;
  readonly step: number;
  /** Value, step and bounds are metres, which are shown in the unit that fits the model. */
  readonly isLength?: boolean;
  readonly min?: number;
  readonly max?: number;
  readonly unit?: string;
  readonly hint?: string;
  readonly set: (value: number) => Projector;
}

export interface ProjectorFieldGroup {
  readonly title: string;
  readonly fields: readonly ProjectorField[];
}

/** A projector that has a place and a direction in the model. */
export type PosedProjector = Exclude<Projector, UvProjector>;

/**
 * Where a projector is and which way it looks.
 *
 * @param lengthStep Metres a step of a length.
 * @param orientation What the rotation was last shown as; `keep` is told what a change makes of it.
 */
export function poseFields(
  projector: PosedProjector,
  lengthStep: number,
  orientation: Orientation,
  keep: (orientation: Orientation) => void,
  words: Strings["properties"],
): ProjectorFieldGroup[] {
  const position = (axis: 0 | 1 | 2, label: string): ProjectorField => ({
    label,
    name: words.axis(words.position, label),
    value: projector.position[axis],
    step: lengthStep,
    isLength: true,
    set: (value) => ({ ...projector, position: withAxis(projector.position, axis, value) }),
  });
  const turn = (key: keyof Orientation, label: string, hint: string): ProjectorField => ({
    label,
    name: words.turns[key],
    hint,
    unit: words.degrees,
    value: orientation[key],
    step: 1,
    ...(key === "tilt" && { min: -90, max: 90 }),
    set: (value) => {
      const next = { ...orientation, [key]: key === "tilt" ? value : wrapDegrees(value) };
      keep(next);
      return { ...projector, rotation: quaternionOf(next) };
    },
  });
  return [
    { title: words.position, fields: [position(0, "X"), position(1, "Y"), position(2, "Z")] },
    {
      title: words.direction,
      fields: [
        turn("heading", words.heading, words.headingHint),
        turn("tilt", words.tilt, words.tiltHint),
        turn("spin", words.spin, words.spinHint),
      ],
    },
  ];
}

export function withAxis([x, y, z]: Vec3, axis: 0 | 1 | 2, value: number): Vec3 {
  if (axis === 0) return [value, y, z];
  return axis === 1 ? [x, value, z] : [x, y, value];
}

/** Degrees that a field may be set to; the document allows all between 0 and 180 (360). */
const LEAST_DEGREES = 0.1;
const WIDEST_FOV = 179;

/**
 * @param lengthStep Metres a step of a length.
 * @param recorded The projector without what a scrub only shows so far: what makes way for a number that is passed comes back.
 */
export function projectorFields(
  projector: PerspectiveProjector | CylindricalProjector | UvProjector,
  lengthStep: number,
  words: Strings["properties"],
  recorded: Projector = projector,
): ProjectorFieldGroup[] {
  if (projector.kind === "perspective") {
    const from = recorded.kind === "perspective" ? recorded : projector;
    return perspectiveFields(projector, lengthStep, words, from);
  }
  return projector.kind === "cylindrical"
    ? cylindricalFields(projector, lengthStep, words)
    : uvFields(projector, words);
}

function perspectiveFields(
  projector: PerspectiveProjector,
  step: number,
  words: Strings["properties"],
  from: PerspectiveProjector,
): ProjectorFieldGroup[] {
  const { fov, aspect, near, far } = projector;
  // What a field shows as something.
  const least = Math.max(step / 10, DESIGN_LIMITS.lengthMin);
  // Far from the eye a fixed gap would be lost in the engine's 32-bit numbers.
  const gap = (distance: number): number => Math.max(least, distance * 1e-6);
  return [
    {
      title: words.lens,
      fields: [
        {
          label: words.fov,
          name: words.fov,
          hint: words.fovHint,
          unit: words.degrees,
          value: fov,
          step: 1,
          min: LEAST_DEGREES,
          max: WIDEST_FOV,
          set: (value) => ({ ...projector, fov: value }),
        },
        {
          label: words.aspect,
          name: words.aspect,
          hint: words.aspectHint,
          value: aspect,
          step: 0.01,
          min: 0.01,
          set: (value) => ({ ...projector, aspect: value }),
        },
      ],
    },
    {
      title: words.range,
      fields: [
        {
          label: words.near,
          name: words.near,
          hint: words.nearHint,
          value: near,
          step,
          isLength: true,
          min: least,
          max: DESIGN_LIMITS.lengthMax / 2,
          // The far end makes way, so that near stays below it.
          set: (value) => ({ ...from, near: value, far: Math.max(from.far, value + gap(value)) }),
        },
        {
          label: words.far,
          name: words.far,
          hint: words.farHint,
          value: far,
          step,
          isLength: true,
          min: 2 * least,
          set: (value) => ({ ...from, far: value, near: Math.min(from.near, value - gap(value)) }),
        },
      ],
    },
  ];
}

function cylindricalFields(
  projector: CylindricalProjector,
  step: number,
  words: Strings["properties"],
): ProjectorFieldGroup[] {
  const length = (key: "radius" | "height" | "depth", label: string, hint = ""): ProjectorField => ({
    label,
    name: label,
    hint,
    value: projector[key],
    step,
    isLength: true,
    min: Math.max(step / 10, DESIGN_LIMITS.lengthMin),
    set: (value) => ({ ...projector, [key]: value }),
  });
  return [
    {
      title: words.label,
      fields: [
        {
          label: words.arc,
          name: words.arc,
          hint: words.arcHint,
          unit: words.degrees,
          value: projector.arc,
          step: 1,
          min: LEAST_DEGREES,
          max: 360,
          set: (value) => ({ ...projector, arc: value }),
        },
        length("height", words.labelHeight),
      ],
    },
    {
      title: words.cylinder,
      fields: [length("radius", words.radius), length("depth", words.reachDepth, words.reachDepthHint)],
    },
  ];
}

function uvFields(projector: UvProjector, words: Strings["properties"]): ProjectorFieldGroup[] {
  const pair = (key: "center" | "size", title: string, axis: 0 | 1, label: string): ProjectorField => ({
    label,
    name: words.axis(title, label),
    value: projector[key][axis],
    step: 0.001,
    ...(key === "size" && { min: 1e-4 }),
    set: (value) => {
      const [first, second] = projector[key];
      return { ...projector, [key]: axis === 0 ? [value, second] : [first, value] };
    },
  });
  return [
    {
      title: words.stampCenter,
      fields: [pair("center", words.stampCenter, 0, "U"), pair("center", words.stampCenter, 1, "V")],
    },
    {
      title: words.size,
      fields: [pair("size", words.size, 0, "U"), pair("size", words.size, 1, "V")],
    },
    {
      title: words.direction,
      fields: [
        {
          label: words.angle,
          name: words.angle,
          hint: words.angleHint,
          unit: words.degrees,
          value: projector.angle,
          step: 1,
          set: (value) => ({ ...projector, angle: wrapDegrees(value) }),
        },
      ],
    },
  ];
}
