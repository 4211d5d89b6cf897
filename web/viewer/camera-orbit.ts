/** A camera's place about the model as pages write it: "30deg 75deg 105%", as `<model-viewer>` has it. */
import { TexelcastError } from "../core/texelcast-error.ts";

/** What is null is not said. */
export interface Orbit {
  /** About the vertical, degrees: 0 looks at the front, 90 at what faces +X. */
  readonly theta: number | null;
  /** Down from straight above, degrees: 90 is level. */
  readonly phi: number | null;
  /** From the model's middle: metres, or a share of the distance at which all of it is in view. */
  readonly distance: { readonly value: number; readonly unit: "m" | "share" } | null;
}

export const ANY_ORBIT: Orbit = { theta: null, phi: null, distance: null };

/**
 * Reads an orbit; "" and "auto" leave a part unsaid, and so do parts that are missing. Throws "bad-argument" naming `field`.
 */
export function parseOrbit(text: string, field: string): Orbit {
  const parts = text.trim().split(/\s+/).filter(Boolean);
  const refuse = (): TexelcastError =>
    new TexelcastError("bad-argument", `“${text}” is not a camera orbit.`, {
      field,
      value: text,
      hint: 'Write two angles and a distance, as in "30deg 75deg 105%" or "auto 90deg 0.4m".',
    });
  if (parts.length > 3) throw refuse();
  const degrees = (part = "auto"): number | null => {
    if (part === "auto") return null;
    const [, value, unit] = /^([+-]?(?:\d+\.?\d*|\.\d+))(deg|rad)$/.exec(part) ?? [];
    if (value === undefined) throw refuse();
    return unit === "rad" ? (Number(value) * 180) / Math.PI : Number(value);
  };
  const distance = (part = "auto"): Orbit["distance"] => {
    if (part === "auto") return null;
    const [, value, unit = ""] = /^(\d+\.?\d*|\.\d+)(%|mm|cm|m)$/.exec(part) ?? [];
    if (value === undefined || !(Number(value) > 0)) throw refuse();
    const scale = { "%": 0.01, mm: 0.001, cm: 0.01, m: 1 }[unit] ?? 1;
    return { value: Number(value) * scale, unit: unit === "%" ? "share" : "m" };
  };
  return { theta: degrees(parts[0]), phi: degrees(parts[1]), distance: distance(parts[2]) };
}
