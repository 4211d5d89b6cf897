/** Trucks, wheels and bolts. Each truck is built about a point on the deck's underside: x along the axle, z away from it. */

import { bevelledBox } from "../geometry/bevelled-box.ts";
import { type Chart, deformChart, placeChart } from "../geometry/chart.ts";
import { latheBand, latheDisc } from "../geometry/lathe.ts";
import { type ProfileCorner, profileRun, roundedProfile } from "../geometry/profile.ts";
import { mix, type Quaternion, quaternionAbout, rotate, type Vec3 } from "../geometry/vector.ts";

const MM = 0.001;
/** From the deck's underside to the axle. */
const AXLE_HEIGHT = 50 * MM;
const WHEEL_CENTRE = 84 * MM;

/** A closed body turned about an axis, from corners in millimetres (x = radius, y = along the axis). */
function turnedBody(
  name: string,
  section: readonly ProfileCorner[],
  segments: number,
  parts: [number, number],
): Chart[] {
  const profile = roundedProfile(
    section.map((corner) => ({
      ...corner,
      x: corner.x * MM,
      y: corner.y * MM,
      ...(corner.radius === undefined ? {} : { radius: corner.radius * MM }),
    })),
    40 * MM,
  );
  const widest = Math.max(...section.map((corner) => corner.x)) * MM;
  const [lower, upper] = parts;
  return [
    latheDisc(`${name} lower face`, profileRun(profile, -1, lower), segments),
    latheBand(`${name} side`, profileRun(profile, lower, upper), {
      segments,
      seamAngle: Math.PI,
      patternRadius: widest,
    }),
    latheDisc(`${name} upper face`, profileRun(profile, upper, -1), segments),
  ];
}

/** A cylinder with softened edges, millimetres, centred, along +Y. */
function drum(name: string, radius: number, height: number, soft: number, segments = 20): Chart[] {
  const section = [
    { x: 0, y: -height / 2 },
    { x: radius, y: -height / 2, radius: soft, steps: 2 },
    { x: radius, y: height / 2, radius: soft, steps: 2 },
    { x: 0, y: height / 2 },
  ];
  return turnedBody(name, section, segments, [1, 2]);
}

const place = (charts: readonly Chart[], offset: Vec3, turn: Quaternion = [0, 0, 0, 1]): Chart[] =>
  charts.map((chart) => placeChart(chart, offset, (vector) => rotate(turn, vector)));

/** Turns +Y to +X. */
const ALONG_AXLE = quaternionAbout([0, 0, 1], -Math.PI / 2);
/** Turns +Y to +Z. */
const AWAY_FROM_DECK = quaternionAbout([1, 0, 0], Math.PI / 2);

/** `inner` is the direction along Y towards the middle of the board: 1 or -1. */
export function truckMetal(inner: 1 | -1, centre: Vec3): Chart[] {
  const name = (part: string): string => `truck ${inner} ${part}`;
  const at = (x: number, y: number, z: number): Vec3 => [x * MM, y * inner * MM, z * MM];
  const box = (part: string, size: Vec3, bevel: number): Chart[] =>
    bevelledBox({ name: name(part), size: [size[0] * MM, size[1] * MM, size[2] * MM], bevel: bevel * MM, steps: 4 });

  const base = place(box("base", [56, 84, 10], 3), at(0, 0, 5));
  const seat = place(box("seat", [34, 36, 16], 5), at(0, 16, 12));
  const cup = place(box("cup", [24, 24, 20], 6), at(0, -22, 12));
  // The hanger's body widens towards the axle.
  const yoke = place(
    box("yoke", [104, 24, 26], 7).map((chart) =>
      deformChart(chart, ([x, y, z]) => [x * mix(0.4, 1, (z + 13 * MM) / (26 * MM)), y, z]),
    ),
    at(0, 0, 39),
  );
  const axleTube = place(
    turnedBody(
      name("hanger"),
      [
        { x: 0, y: -67 },
        { x: 8, y: -67, radius: 1.5, steps: 4 },
        { x: 9, y: -40, radius: 40, steps: 4 },
        { x: 13, y: -12, radius: 40, steps: 4 },
        { x: 13, y: 12, radius: 40, steps: 4 },
        { x: 9, y: 40, radius: 40, steps: 4 },
        { x: 8, y: 67, radius: 1.5, steps: 4 },
        { x: 0, y: 67 },
      ],
      24,
      [1, 6],
    ),
    at(0, 0, 50),
    ALONG_AXLE,
  );
  const axle = place(drum(name("axle"), 4, 206, 1, 16), at(0, 0, 50), ALONG_AXLE);
  const kingpin = quaternionAbout([1, 0, 0], Math.PI / 2 - (inner * (24 * Math.PI)) / 180);
  const alongKingpin = (distance: number): Vec3 => {
    const [x, y, z] = rotate(kingpin, [0, distance * MM, 0]);
    return [x, y + 15 * inner * MM, z + 14 * MM];
  };
  const stack = [
    ...place(drum(name("lower washer"), 13, 3, 1), alongKingpin(5), kingpin),
    ...place(drum(name("ring"), 15, 9, 3), alongKingpin(22.5), kingpin),
    ...place(drum(name("upper washer"), 11, 3, 1), alongKingpin(37.5), kingpin),
    ...place(drum(name("kingpin"), 5, 50, 1.5), alongKingpin(22), kingpin),
    ...place(drum(name("kingpin nut"), 8, 7, 1.5, 6), alongKingpin(42), kingpin),
  ];
  const pivot = place(
    drum(name("pivot"), 7, 34, 3),
    at(0, -12, 32),
    quaternionAbout([1, 0, 0], Math.PI / 2 - inner * 0.7),
  );
  const ends = ([-1, 1] as const).flatMap((side) => [
    ...place(drum(name(`nut ${side}`), 6.6, 6, 1.6), at(side * 99, 0, 50), ALONG_AXLE),
    ...place(drum(name(`bearing out ${side}`), 11.2, 3, 0.6), at(side * 94.5, 0, 50), ALONG_AXLE),
    ...place(drum(name(`bearing in ${side}`), 11.2, 3, 0.6), at(side * 73.5, 0, 50), ALONG_AXLE),
  ]);
  return place([...base, ...seat, ...cup, ...yoke, ...axleTube, ...axle, ...stack, ...pivot, ...ends], centre);
}

/** The two soft rings on the kingpin. */
export function truckBushings(inner: 1 | -1, centre: Vec3): Chart[] {
  const kingpin = quaternionAbout([1, 0, 0], Math.PI / 2 - (inner * (24 * Math.PI)) / 180);
  return [
    { part: "lower", distance: 12, radius: 12 },
    { part: "upper", distance: 31.5, radius: 10.5 },
  ].flatMap(({ part, distance, radius }) => {
    const [x, y, z] = rotate(kingpin, [0, distance * MM, 0]);
    const offset: Vec3 = [x + centre[0], y + 15 * inner * MM + centre[1], z + 14 * MM + centre[2]];
    return place(drum(`bushing ${inner} ${part}`, radius, 11, 2.4), offset, kingpin);
  });
}

const WHEEL_SECTION: readonly ProfileCorner[] = [
  { x: 0, y: -9 },
  { x: 11.6, y: -9, radius: 0.8, steps: 2 },
  { x: 12.6, y: -14.8, radius: 1.2, steps: 4 },
  { x: 20, y: -15.6, radius: 6, steps: 2 },
  { x: 27, y: -10.5, radius: 5.5, steps: 6 },
  { x: 27, y: 10.5, radius: 5.5, steps: 6 },
  { x: 20, y: 15.6, radius: 6, steps: 2 },
  { x: 12.6, y: 14.8, radius: 1.2, steps: 4 },
  { x: 11.6, y: 9, radius: 0.8, steps: 2 },
  { x: 0, y: 9 },
];

/** Both wheels of a truck. */
export function truckWheels(inner: 1 | -1, centre: Vec3): Chart[] {
  return ([-1, 1] as const).flatMap((side) =>
    place(
      turnedBody(`wheel ${inner} ${side}`, WHEEL_SECTION, 36, [4, 5]),
      [centre[0] + side * WHEEL_CENTRE, centre[1], centre[2] + AXLE_HEIGHT],
      ALONG_AXLE,
    ),
  );
}

/** Four bolt heads on the grip side; `centre` is a point on that side. */
export function gripBolts(inner: 1 | -1, centre: Vec3): Chart[] {
  return [-1, 1].flatMap((x) =>
    [-1, 1].flatMap((y) =>
      place(
        drum(`bolt ${inner} ${x} ${y}`, 4.4, 1.6, 0.5, 16),
        [centre[0] + x * 20.6 * MM, centre[1] + y * 26.5 * MM, centre[2]],
        AWAY_FROM_DECK,
      ),
    ),
  );
}
