/**
 * Colour profiles (ICC.1:2022) and what they make of a picture: its colours in sRGB, relative to the white of both, with what sRGB
 * does not reach at its edge, as browsers show it. Profiles of three primaries with a curve each, and of a curve for grey: those
 * that cameras, screens and programs write into pictures.
 *
 * LittleCMS in WebAssembly (lcms-wasm 1.0.5) reads profiles by tables as well. It is 115 kB after gzip for every phone's photo, a
 * build with assertions, and brings a test runner along.
 */

import { asciiCodes } from "./ascii-codes.ts";
import { viewOf } from "./byte-view.ts";
import { power } from "./exact-power.ts";
import { PictureFault } from "./picture-fault.ts";

/** Of each step of a channel, 0 to 255, the light that it stands for, 0 to 1. */
type Curve = Float64Array;
type Three<Value> = readonly [Value, Value, Value];

export interface ColorProfile {
  /** Of red, green and blue; for grey three times the same. */
  readonly curves: Three<Curve>;
  /** Light to the light of sRGB's primaries, rows first; null: of grey, which stays as much light. */
  readonly toSrgb: Three<Three<number>> | null;
}

// Primaries as profiles hold them: X, Y and Z of each in 65536ths, brought from D65 to D50 by Bradford's matrix.
const TO_SRGB = inverse(columns([28576, 14581, 912], [25239, 46983, 6361], [9375, 3972, 46787]));
const DISPLAY_P3 = columns([33759, 15807, -69], [19135, 45367, 2745], [10296, 4363, 51385]);
const BT_2020 = columns([44137, 18287, -127], [10857, 44259, 1965], [8195, 2989, 52223]);

/** By their numbers of ITU-T H.273, which PNG's cICP and AVIF's nclx say: what is wider than sRGB. */
const PRIMARIES: ReadonlyMap<number, Three<Three<number>>> = new Map([
  [9, BT_2020],
  [12, DISPLAY_P3],
]);
/** Those of H.273's curves that are shown by sRGB's: BT.709, BT.601, BT.2020 of 10 and 12 bits, and sRGB itself. */
const CURVES: ReadonlySet<number> = new Set([1, 6, 13, 14, 15]);

/** The profile of primaries and curve by their numbers of H.273; null where they are sRGB's or not known here (HDR). */
export function codedProfile(primaries: number, curve: number): ColorProfile | null {
  const light = CURVES.has(curve) ? PRIMARIES.get(primaries) : undefined;
  if (light === undefined) return null;
  const srgb = sampled(srgbLight);
  return { curves: [srgb, srgb, srgb], toSrgb: product(TO_SRGB, light) };
}

/** Tags that colours are made of. */
const RGB_TAGS = ["rXYZ", "gXYZ", "bXYZ", "rTRC", "gTRC", "bTRC"] as const;
const GREY_TAG = "kTRC";

/**
 * Null where the picture's colours are sRGB's: by the profile itself to within one step of 255, and by a damaged one or one for other
 * kinds of colours (CMYK), at which browsers do not look either. Throws a PictureFault for one of tables alone.
 */
export function readColorProfile(icc: Uint8Array): ColorProfile | null {
  let profile: ColorProfile | null;
  try {
    profile = profileOf(new ProfileTags(icc));
  } catch (error) {
    if (error instanceof RangeError) return null;
    throw error;
  }
  return profile === null || isSrgb(profile) ? null : profile;
}

function profileOf(tags: ProfileTags): ColorProfile | null {
  if (tags.space === "GRAY" && tags.connects === "XYZ ") {
    const curve = readCurve(tags.of(GREY_TAG));
    return { curves: [curve, curve, curve], toSrgb: null };
  }
  if (tags.space !== "RGB ") return null;
  if (!tags.has("rXYZ") && tags.has("A2B0")) {
    throw new PictureFault("profile", "its colour profile goes by tables", "Save it in sRGB colours.");
  }
  const light = columns(readXyz(tags.of("rXYZ")), readXyz(tags.of("gXYZ")), readXyz(tags.of("bXYZ")));
  return {
    curves: [readCurve(tags.of("rTRC")), readCurve(tags.of("gTRC")), readCurve(tags.of("bTRC"))],
    toSrgb: product(TO_SRGB, light),
  };
}

const HEAD = 128;
/** Profiles of pictures have about ten. */
const MOST_TAGS = 100;

/** What asks for bytes that are not there throws a RangeError. */
class ProfileTags {
  readonly space: string;
  readonly connects: string;
  readonly #icc: Uint8Array;
  readonly #places = new Map<string, readonly [at: number, length: number]>();

  constructor(icc: Uint8Array) {
    this.#icc = icc;
    const view = viewOf(icc);
    this.space = textAt(view, 16);
    this.connects = textAt(view, 20);
    const count = view.getUint32(HEAD);
    if (textAt(view, 36) !== "acsp" || count > MOST_TAGS) throw new RangeError("This is no profile.");
    for (let i = 0; i < count; i++) {
      const at = HEAD + 4 + 12 * i;
      this.#places.set(textAt(view, at), [view.getUint32(at + 4), view.getUint32(at + 8)]);
    }
  }

  has(tag: string): boolean {
    return this.#places.has(tag);
  }

  bytes(tag: string): Uint8Array {
    const [at, length] = this.#places.get(tag) ?? [0, 0];
    if (length === 0 || at + length > this.#icc.length) throw new RangeError(`The tag “${tag}” is missing.`);
    return this.#icc.subarray(at, at + length);
  }

  of(tag: string): DataView {
    return viewOf(this.bytes(tag));
  }
}

const textAt = (view: DataView, at: number): string =>
  String.fromCharCode(...[0, 1, 2, 3].map((i) => view.getUint8(at + i)));

/** A number of 16 bits before the point and 16 behind it, in 65536ths. */
const readXyz = (tag: DataView): Three<number> => [tag.getInt32(8), tag.getInt32(12), tag.getInt32(16)];

function readCurve(tag: DataView): Curve {
  const kind = textAt(tag, 0);
  if (kind === "para") return readFormula(tag);
  if (kind !== "curv") throw new RangeError(`A curve of kind “${kind}” is not known.`);
  const count = tag.getUint32(8);
  if (count === 0) return sampled((step) => step);
  if (count === 1) {
    const gamma = positive(tag.getUint16(12) / 256);
    return sampled((step) => power(step, gamma));
  }
  const entry = (i: number): number => tag.getUint16(12 + 2 * i) / 65535;
  entry(count - 1); // Throws where the table is cut short.
  return sampled((step) => {
    const place = step * (count - 1);
    const below = Math.min(Math.floor(place), count - 2);
    return entry(below) + (entry(below + 1) - entry(below)) * (place - below);
  });
}

/** ICC.1:2022, 10.18: how many numbers each kind of formula has. */
const FORMULAS = [1, 3, 4, 5, 7];

function readFormula(tag: DataView): Curve {
  const kind = tag.getUint16(8);
  const length = FORMULAS[kind];
  if (length === undefined) throw new RangeError(`A formula of kind ${kind} is not known.`);
  const numbers = Array.from({ length }, (_, i) => tag.getInt32(12 + 4 * i) / 65536);
  const [gamma = 1, a = 1, b = 0, c = 0, d = 0, e = 0, f = 0] = numbers;
  const exponent = positive(gamma);
  const curved = (step: number): number => power(clamp(a * step + b), exponent);
  if (kind === 0) return sampled(curved);
  if (kind === 1) return sampled((step) => (a * step + b >= 0 ? curved(step) : 0));
  if (kind === 2) return sampled((step) => (a * step + b >= 0 ? curved(step) : 0) + c);
  return sampled((step) => (step >= d ? curved(step) + e : c * step + f));
}

function positive(gamma: number): number {
  if (!(gamma > 0)) throw new RangeError("A curve without a power.");
  return gamma;
}

const clamp = (value: number): number => Math.min(Math.max(value, 0), 1);

const sampled = (light: (step: number) => number): Curve =>
  Float64Array.from({ length: 256 }, (_, i) => clamp(light(i / 255)));

const srgbLight = (step: number): number => (step <= 0.04045 ? step / 12.92 : power((step + 0.055) / 1.055, 2.4));

const FINE = 4096;

/** Finds the step of sRGB that is nearest to a light. */
class SrgbSteps {
  /** The light from which on it is the next step, 0 to 254. */
  readonly #bounds = Float64Array.from({ length: 255 }, (_, i) => srgbLight((i + 0.5) / 255));
  /** The first step that light of so many 4096ths could be. */
  readonly #first = new Uint8Array(FINE + 1);

  constructor() {
    for (let i = 0, step = 0; i <= FINE; i++) {
      while (step < 255 && (this.#bounds[step] as number) <= i / FINE) step++;
      this.#first[i] = step;
    }
  }

  nearest(light: number): number {
    const within = clamp(light);
    let step = this.#first[Math.floor(within * FINE)] as number;
    while (step < 255 && within >= (this.#bounds[step] as number)) step++;
    return step;
  }
}

let known: SrgbSteps | undefined;

/** Made by the first picture that needs them. */
function srgbSteps(): SrgbSteps {
  known ??= new SrgbSteps();
  return known;
}

/** Turns the pixels into sRGB, in place; alpha stays. By a profile of grey nothing, where any pixel is not grey. */
export function convertToSrgb(rgba: Uint8Array, { curves: [red, green, blue], toSrgb }: ColorProfile): void {
  if (toSrgb === null) {
    if (isGrey(rgba)) convertGrey(rgba, red);
    return;
  }
  const [toRed, toGreen, toBlue] = toSrgb;
  const steps = srgbSteps();
  for (let i = 0; i < rgba.length; i += 4) {
    const r = red[rgba[i] as number] as number;
    const g = green[rgba[i + 1] as number] as number;
    const b = blue[rgba[i + 2] as number] as number;
    rgba[i] = steps.nearest(toRed[0] * r + toRed[1] * g + toRed[2] * b);
    rgba[i + 1] = steps.nearest(toGreen[0] * r + toGreen[1] * g + toGreen[2] * b);
    rgba[i + 2] = steps.nearest(toBlue[0] * r + toBlue[1] * g + toBlue[2] * b);
  }
}

function isGrey(rgba: Uint8Array): boolean {
  for (let i = 0; i < rgba.length; i += 4) {
    if (rgba[i] !== rgba[i + 1] || rgba[i] !== rgba[i + 2]) return false;
  }
  return true;
}

function convertGrey(rgba: Uint8Array, curve: Curve): void {
  const steps = srgbSteps();
  const shown = Uint8Array.from(curve, (light) => steps.nearest(light));
  for (let i = 0; i < rgba.length; i += 4) rgba.fill(shown[rgba[i] as number] as number, i, i + 3);
}

/** Whether no colour of a grid, nor any grey, is moved by more than a step. */
function isSrgb(profile: ColorProfile): boolean {
  const steps = Array.from({ length: 256 }, (_, i) => [i, i, i]);
  if (profile.toSrgb !== null) {
    const nine = Array.from({ length: 9 }, (_, i) => Math.min(i * 32, 255));
    for (const r of nine) for (const g of nine) for (const b of nine) steps.push([r, g, b]);
  }
  const colors = Uint8Array.from(steps.flatMap((color) => [...color, 255]));
  const converted = colors.slice();
  convertToSrgb(converted, profile);
  return converted.every((value, i) => Math.abs(value - (colors[i] as number)) <= 1);
}

/**
 * The profile with what colours are made of alone, in bytes that hang on that alone: screens' names and serial numbers, dates and
 * texts go. Null as for `readColorProfile`, which also says what it throws.
 */
export function cleanProfile(icc: Uint8Array): Uint8Array | null {
  const profile = readColorProfile(icc);
  if (profile === null) return null;
  const from = new ProfileTags(icc);
  const tags = (profile.toSrgb === null ? [GREY_TAG] : RGB_TAGS).map((tag) => ({ tag, bytes: from.bytes(tag) }));
  let size = HEAD + 4 + 12 * tags.length;
  const places = tags.map(({ bytes }) => {
    const at = size;
    size = (at + bytes.length + 3) & ~3;
    return at;
  });
  const clean = new Uint8Array(size);
  const view = viewOf(clean);
  view.setUint32(0, size);
  view.setUint32(8, 0x04400000); // Version 4.4, which knows all kinds of curves.
  for (const [at, text] of [
    [12, "mntr"],
    [16, from.space],
    [20, "XYZ "],
    [36, "acsp"],
  ] as const)
    clean.set(asciiCodes(text), at);
  for (const [i, part] of [0xf6d6, 0x10000, 0xd32d].entries()) view.setUint32(68 + 4 * i, part); // The light: D50.
  view.setUint32(HEAD, tags.length);
  for (const [i, { tag, bytes }] of tags.entries()) {
    const at = HEAD + 4 + 12 * i;
    clean.set(asciiCodes(tag), at);
    view.setUint32(at + 4, places[i] ?? 0);
    view.setUint32(at + 8, bytes.length);
    clean.set(bytes, places[i]);
  }
  return clean;
}

/** A matrix of three columns in 65536ths. */
function columns(first: Three<number>, second: Three<number>, third: Three<number>): Three<Three<number>> {
  const row = (i: 0 | 1 | 2): Three<number> => [first[i] / 65536, second[i] / 65536, third[i] / 65536];
  return [row(0), row(1), row(2)];
}

function product(a: Three<Three<number>>, b: Three<Three<number>>): Three<Three<number>> {
  const row = ([x, y, z]: Three<number>): Three<number> => {
    const part = (i: 0 | 1 | 2): number => x * b[0][i] + y * b[1][i] + z * b[2][i];
    return [part(0), part(1), part(2)];
  };
  return [row(a[0]), row(a[1]), row(a[2])];
}

function inverse([[a, b, c], [d, e, f], [g, h, i]]: Three<Three<number>>): Three<Three<number>> {
  const [x, y, z] = [e * i - f * h, f * g - d * i, d * h - e * g];
  const whole = a * x + b * y + c * z;
  return [
    [x / whole, (c * h - b * i) / whole, (b * f - c * e) / whole],
    [y / whole, (a * i - c * g) / whole, (c * d - a * f) / whole],
    [z / whole, (b * g - a * h) / whole, (a * e - b * d) / whole],
  ];
}
