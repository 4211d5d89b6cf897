/** The element's attributes and properties as Lit takes them, and how their text is read. */
import type { PropertyDeclarations } from "lit";
import type { TexelcastEditorProperties } from "./element-api.ts";

/** What a number's attribute says; null without it, NaN where it is none. */
const numeric = {
  fromAttribute: (value: string | null): number | null =>
    value === null || value.trim() === "" ? null : Number(value),
};

/** Frameworks take a property back with undefined, which is no other wish than null: the product must not be opened anew for it. */
const hasChanged = (now: unknown, before: unknown): boolean => !Object.is(now ?? null, before ?? null);

export const DEFAULTS: TexelcastEditorProperties = {
  src: null,
  design: null,
  zones: null,
  mode: "shop",
  material: null,
  size: null,
  locale: "",
  wording: null,
  readonly: false,
  poster: "",
  loading: "auto",
  maxDecals: null,
  maxMegapixels: 64,
  maxFileSize: 20 * 2 ** 20,
  cameraOrbit: "",
  minCameraOrbit: "",
  maxCameraOrbit: "",
  wasmUrl: "",
  beforeAccept: null,
};

export const PROPERTIES = {
  src: { hasChanged },
  design: { hasChanged },
  zones: { hasChanged },
  mode: { reflect: true },
  material: { converter: numeric },
  size: { converter: numeric },
  locale: {},
  wording: { hasChanged },
  readonly: { type: Boolean, reflect: true },
  poster: {},
  loading: {},
  maxDecals: { attribute: "max-decals", converter: numeric },
  maxMegapixels: { attribute: "max-megapixels", converter: numeric },
  maxFileSize: { attribute: "max-file-size", converter: numeric },
  cameraOrbit: { attribute: "camera-orbit" },
  minCameraOrbit: { attribute: "min-camera-orbit" },
  maxCameraOrbit: { attribute: "max-camera-orbit" },
  wasmUrl: { attribute: "wasm-url" },
  beforeAccept: { attribute: false },
} satisfies Record<keyof TexelcastEditorProperties, PropertyDeclarations[string]>;
