/** The element's attributes and properties as Lit takes them, and how their text is read. */
import type { PropertyDeclarations } from "lit";
import type { TexelcastEditorProperties } from "./element-api.ts";

/** What a number's attribute says; null without it, NaN where it is none. */
const numeric = {
  fromAttribute: (value: string | null): number | null =>
    value === null || value.trim() === "" ? null : Number(value),
};

/**
 * Whether it is another wish: frameworks take a property back with undefined or an empty text, and what lays a server's page over the
 * one that is shown takes attributes away, which must not open the product anew.
 */
const otherThan =
  (otherwise: unknown) =>
  (now: unknown, before: unknown): boolean =>
    !Object.is(now || otherwise, before || otherwise);
const hasChanged = otherThan(null);

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
  mode: { reflect: true, hasChanged: otherThan("shop") },
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
  wasmUrl: { attribute: "wasm-url", hasChanged },
  beforeAccept: { attribute: false },
} satisfies Record<keyof TexelcastEditorProperties, PropertyDeclarations[string]>;
