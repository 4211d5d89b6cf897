/** Colour profiles (ICC.1:2022) made tag by tag, and pictures that have one. */
import { deflateSync } from "node:zlib";
import { makePng, type PngParts } from "./png-file.ts";

type Numbers3 = readonly [number, number, number];

/** X, Y and Z of red, green and blue under D50. */
export const PRIMARIES = {
  srgb: [
    [0.43607, 0.22249, 0.01392],
    [0.38515, 0.71687, 0.09708],
    [0.14307, 0.06061, 0.7141],
  ],
  displayP3: [
    [0.51512, 0.2412, -0.00105],
    [0.29198, 0.69225, 0.04189],
    [0.1571, 0.06657, 0.78407],
  ],
  adobeRgb: [
    [0.60974, 0.31111, 0.01947],
    [0.20528, 0.62567, 0.06087],
    [0.14919, 0.06322, 0.74457],
  ],
} as const satisfies Record<string, readonly [Numbers3, Numbers3, Numbers3]>;

const u16 = (value: number): number[] => [(value >> 8) & 0xff, value & 0xff];
const u32 = (value: number): number[] => [...u16(value >>> 16), ...u16(value & 0xffff)];
const fixed = (value: number): number[] => u32(Math.round(value * 65536) >>> 0);
const codes = (text: string): number[] => [...text].map((character) => character.charCodeAt(0));

export const curves = {
  linear: [...codes("curv"), ...u32(0), ...u32(0)],
  gamma: (power: number): number[] => [...codes("curv"), ...u32(0), ...u32(1), ...u16(Math.round(power * 256))],
  table: (values: readonly number[]): number[] => [
    ...codes("curv"),
    ...u32(0),
    ...u32(values.length),
    ...values.flatMap((value) => u16(Math.round(value * 65535))),
  ],
  formula: (kind: number, ...numbers: readonly number[]): number[] => [
    ...codes("para"),
    ...u32(0),
    ...u16(kind),
    ...u16(0),
    ...numbers.flatMap(fixed),
  ],
};
export const SRGB_FORMULA = curves.formula(3, 2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045);

export function makeProfile(
  space: "RGB " | "GRAY" | "CMYK",
  tags: Readonly<Record<string, readonly number[]>>,
): Uint8Array {
  const entries = Object.entries(tags);
  const table: number[] = [];
  const data: number[] = [];
  for (const [tag, bytes] of entries) {
    table.push(...codes(tag), ...u32(132 + 12 * entries.length + data.length), ...u32(bytes.length));
    data.push(...bytes);
    while (data.length % 4 !== 0) data.push(0);
  }
  const head = new Array<number>(128).fill(0);
  head.splice(12, 12, ...codes(`mntr${space}XYZ `));
  head.splice(36, 4, ...codes("acsp"));
  // Version 4.4 and its light, D50, without which browsers do not look at it.
  head.splice(8, 2, 4, 0x40);
  head.splice(68, 12, ...[0.9642, 1, 0.8249].flatMap(fixed));
  const profile = [...head, ...u32(entries.length), ...table, ...data];
  profile.splice(0, 4, ...u32(profile.length));
  return Uint8Array.from(profile);
}

/** With a name, as profiles have one. */
export function rgbProfile(
  [red, green, blue]: readonly [Numbers3, Numbers3, Numbers3],
  curve: readonly number[],
  name = "A profile",
): Uint8Array {
  const xyz = (numbers: Numbers3): number[] => [...codes("XYZ "), ...u32(0), ...numbers.flatMap(fixed)];
  const colors = { rXYZ: xyz(red), gXYZ: xyz(green), bXYZ: xyz(blue), rTRC: curve, gTRC: curve, bTRC: curve };
  return makeProfile("RGB ", {
    desc: [...codes("desc"), ...u32(0), ...u32(name.length + 1), ...codes(`${name}\0`)],
    ...colors,
  });
}

export const greyProfile = (curve: readonly number[]): Uint8Array => makeProfile("GRAY", { kTRC: curve });

/** Chunk for `makePng`. */
export const iccChunk = (profile: Uint8Array): readonly [string, Uint8Array] => [
  "iCCP",
  Buffer.concat([Buffer.from("Screen of Jane\0\0", "latin1"), deflateSync(profile)]),
];

/** A row of colours, opaque. */
export function rowPng(colors: readonly (readonly number[])[], extra: NonNullable<PngParts["extra"]> = []): Uint8Array {
  return makePng({ width: colors.length, height: 1, bitDepth: 8, colorType: 2, rows: [colors.flat()], extra });
}

/** The file with the profile in pieces of so many bytes, behind its first marker. */
export function jpegWith(jpeg: Uint8Array, profile: Uint8Array, piece = 65_000): Uint8Array {
  const count = Math.ceil(profile.length / piece);
  const segments = Array.from({ length: count }, (_, i) => {
    const part = profile.subarray(i * piece, (i + 1) * piece);
    return [0xff, 0xe2, ...u16(part.length + 16), ...codes("ICC_PROFILE\0"), i + 1, count, ...part];
  });
  return Uint8Array.from([...jpeg.subarray(0, 2), ...segments.flat(), ...jpeg.subarray(2)]);
}

/** A WebP file of the simple kind made one of the extended kind that has the profile. */
export function webpWith(webp: Uint8Array, profile: Uint8Array, width: number, height: number): Uint8Array {
  const chunk = (type: string, data: readonly number[]): number[] => [
    ...codes(type),
    ...u32(data.length).reverse(),
    ...data,
    ...(data.length % 2 === 1 ? [0] : []),
  ];
  const size = (value: number): number[] => [(value - 1) & 0xff, ((value - 1) >> 8) & 0xff, 0];
  const head = chunk("VP8X", [0x20, 0, 0, 0, ...size(width), ...size(height)]);
  const body = [...codes("WEBP"), ...head, ...chunk("ICCP", [...profile]), ...webp.subarray(12)];
  return Uint8Array.from([...codes("RIFF"), ...u32(body.length).reverse(), ...body]);
}
