/** The element's properties as a desk uses them, and what is wrong with those that cannot be used. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { ANY_ORBIT, type Orbit, parseOrbit } from "../viewer/camera-orbit.ts";
import type { DeskSettings } from "./desk/desk-settings.ts";
import type { TexelcastEditorProperties } from "./element-api.ts";
import { DEFAULTS } from "./element-properties.ts";
import type { Words } from "./words/words.ts";

export interface ReadSettings {
  readonly settings: DeskSettings;
  /** Where the camera begins; null: where it usually does. */
  readonly orbit: Orbit | null;
  /** By property: what it says cannot be used, and the default holds. */
  readonly faults: ReadonlyMap<keyof TexelcastEditorProperties, TexelcastError>;
}

type Numbers = "material" | "size" | "maxDecals" | "maxMegapixels" | "maxFileSize";
type Orbits = "cameraOrbit" | "minCameraOrbit" | "maxCameraOrbit";

/** Throws nothing: a page that writes a wrong number has an element that works, and is told. */
export function readSettings(element: TexelcastEditorProperties, words: Words): ReadSettings {
  const faults = new Map<keyof TexelcastEditorProperties, TexelcastError>();
  const number = (name: Numbers, least: number, most: number, whole = true): number | null => {
    const value: unknown = element[name];
    if (value === null || value === undefined || value === "") return DEFAULTS[name];
    const given = Number(value);
    if (given >= least && given <= most && (!whole || Number.isInteger(given))) return given;
    const details = { field: name, value: String(value), hint: `${least} – ${most}` };
    faults.set(name, new TexelcastError("bad-argument", words.errors.badOption(name), details));
    return DEFAULTS[name];
  };
  const orbit = (name: Orbits): Orbit => {
    try {
      return element[name] ? parseOrbit(element[name], name) : ANY_ORBIT;
    } catch (thrown) {
      faults.set(name, TexelcastError.wrap(thrown, "bad-argument", words.errors.badOption(name)));
      return ANY_ORBIT;
    }
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
    camera: { min: orbit("minCameraOrbit"), max: orbit("maxCameraOrbit") },
    beforeAccept: element.beforeAccept,
  };
  const start = orbit("cameraOrbit");
  return { settings, orbit: start === ANY_ORBIT ? null : start, faults };
}
