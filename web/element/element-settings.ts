/** The element's properties as a desk uses them, and what is wrong with those that cannot be used. */
import type { TexelcastError } from "../core/texelcast-error.ts";
import { ToldError } from "../editor/strings/told-error.ts";
import { ANY_ORBIT, type Orbit, parseOrbit } from "../viewer/camera-orbit.ts";
import type { DeskSettings } from "./desk/desk-settings.ts";
import type { TexelcastEditorProperties } from "./element-api.ts";
import { DEFAULTS } from "./element-properties.ts";
import type { Words } from "./words/words.ts";

export interface ReadSettings {
  readonly settings: DeskSettings;
  /** Where the camera begins; null: where it usually does. */
  readonly orbit: Orbit | null;
  /** By property: what it says cannot be used, and the default holds. Two that do not go together have one fault. */
  readonly faults: ReadonlyMap<keyof TexelcastEditorProperties, TexelcastError>;
}

type Numbers = "material" | "size" | "maxDecals" | "maxMegapixels" | "maxFileSize";
/** What the words of some properties may be, the default first. */
const CHOICES = { mode: ["shop", "full"], loading: ["auto", "lazy", "eager"] } as const;

/** What an orbit looks like, for whoever wrote none. */
const ORBIT = "30deg 75deg 105%";

type Orbits = "cameraOrbit" | "minCameraOrbit" | "maxCameraOrbit";

/** Throws nothing: a page that writes a wrong number has an element that works, and is told. */
export function readSettings(element: TexelcastEditorProperties, words: Words): ReadSettings {
  const faults = new Map<keyof TexelcastEditorProperties, TexelcastError>();
  const wrong = (name: keyof TexelcastEditorProperties, hint: string, also = name): void => {
    const value: unknown = element[name];
    const details = { field: name, value: typeof value === "object" ? "object" : String(value), hint };
    const fault = new ToldError("bad-argument", words.errors.badOption(name), details);
    faults.set(name, fault).set(also, fault);
  };
  const number = (name: Numbers, least: number, most: number, whole = true): number | null => {
    const value: unknown = element[name];
    if (value !== null && value !== undefined && value !== "") {
      const given = typeof value === "string" || typeof value === "number" ? Number(value) : Number.NaN;
      if (given >= least && given <= most && (!whole || Number.isInteger(given))) return given;
      wrong(name, `${least} – ${most}`);
    }
    return DEFAULTS[name];
  };
  const orbit = (name: Orbits): Orbit => {
    try {
      if (element[name]) return parseOrbit(element[name], name);
    } catch {
      wrong(name, ORBIT);
    }
    return ANY_ORBIT;
  };
  for (const [name, allowed] of Object.entries(CHOICES) as [keyof typeof CHOICES, readonly string[]][]) {
    if (element[name] && !allowed.includes(element[name])) wrong(name, allowed.join(", "));
  }
  const { beforeAccept } = element;
  // It stays, and refuses all: a default that asks nobody would let in what the shop wanted to see first.
  if (beforeAccept && typeof beforeAccept !== "function") wrong("beforeAccept", "function");
  const camera = (): DeskSettings["camera"] => {
    const [min, max] = [orbit("minCameraOrbit"), orbit("maxCameraOrbit")];
    if (!isCrossed(min, max)) return { min, max };
    wrong("minCameraOrbit", `– ${element.maxCameraOrbit}`, "maxCameraOrbit");
    return { min: ANY_ORBIT, max: ANY_ORBIT };
  };
  const settings: DeskSettings = {
    words,
    material: number("material", 0, 65_535),
    size: number("size", 1, 8192),
    readonly: element.readonly,
    maxDecals: number("maxDecals", 0, 10_000),
    limits: {
      megapixels: number("maxMegapixels", 1e-6, 1e6, false) ?? DEFAULTS.maxMegapixels,
      bytes: number("maxFileSize", 1, 2 ** 40) ?? DEFAULTS.maxFileSize,
    },
    camera: camera(),
    beforeAccept: beforeAccept ?? null,
  };
  const start = orbit("cameraOrbit");
  return { settings, orbit: start === ANY_ORBIT ? null : start, faults };
}

/** Whether nothing lies between two limits; distances in shares and in metres are known to lie apart only with a model. */
function isCrossed(min: Orbit, max: Orbit): boolean {
  const above = (low: number | null | undefined, high: number | null | undefined): boolean =>
    low != null && high != null && low > high;
  const sameUnit = min.distance?.unit === max.distance?.unit;
  return (
    above(min.theta, max.theta) ||
    above(min.phi, max.phi) ||
    (sameUnit && above(min.distance?.value, max.distance?.value))
  );
}
