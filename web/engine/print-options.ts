/** What a print may be asked for, looked at before anything is made of it: callers in plain JavaScript have no types. */
import { MAX_TEXTURE_SIZE } from "../core/sizes.ts";
import type { PrintFileOptions } from "./print-report.ts";

export interface OptionFault {
  readonly field: string;
  /** What stands there. */
  readonly value: string;
  /** What may stand there, in signs that every language reads; of an option that there is not, those that there are. */
  readonly allowed: string;
  /** "unknown": there is no such option. "clash": `size` says already how many texels are printed. */
  readonly kind?: "unknown" | "clash";
}

interface Rule {
  readonly allowed: string;
  readonly admits: (value: unknown) => boolean;
}

const MOST_DPI = 10_000;

const wholeUpTo =
  (least: number, most: number) =>
  (value: unknown): boolean =>
    Number.isInteger(value) && (value as number) >= least && (value as number) <= most;
const isSide = wholeUpTo(1, MAX_TEXTURE_SIZE);

const RULES: Readonly<Record<keyof PrintFileOptions, Rule>> = {
  material: { allowed: "0, 1, 2 …", admits: wholeUpTo(0, 65_535) },
  size: {
    allowed: `1 – ${MAX_TEXTURE_SIZE}, [2048, 1024]`,
    admits: (value) => (Array.isArray(value) ? value.length === 2 && value.every(isSide) : isSide(value)),
  },
  dpi: { allowed: `1 – ${MOST_DPI}`, admits: (value) => typeof value === "number" && value >= 1 && value <= MOST_DPI },
  zone: { allowed: '"…"', admits: (value) => typeof value === "string" },
  flattened: { allowed: "true, false", admits: (value) => typeof value === "boolean" },
  base: { allowed: '"model", "none"', admits: (value) => value === "model" || value === "none" },
};

const KNOWN = Object.keys(RULES).join(", ");

/** The first option that is not what it may be, or that there is not; null: each is. What is undefined is not said. */
export function printOptionFault(options: unknown): OptionFault | null {
  if (typeof options !== "object" || options === null || Array.isArray(options)) {
    return { field: "options", value: told(options), allowed: `{ ${KNOWN} }` };
  }
  for (const [field, value] of Object.entries(options)) {
    if (value === undefined) continue;
    const rule = Object.hasOwn(RULES, field) && RULES[field as keyof PrintFileOptions];
    // A slip of the pen ("dip") would print with what nobody asked for.
    if (!rule) return { field, value: told(value), allowed: KNOWN, kind: "unknown" };
    if (!rule.admits(value)) return { field, value: told(value), allowed: rule.allowed };
  }
  const asked: PrintFileOptions = options;
  return isSizedTwice(asked) ? { field: "dpi", value: told(asked.dpi), allowed: "size, dpi", kind: "clash" } : null;
}

/** No texture has two sizes. Flat art has pixels of its own, sampled from a texture of any size. */
export function isSizedTwice({
  size,
  dpi,
  flattened,
}: {
  size?: unknown;
  dpi?: unknown;
  flattened?: unknown;
}): boolean {
  return size !== undefined && dpi !== undefined && !flattened;
}

/** The options that are said. */
export function saidPrintOptions(options: PrintFileOptions): PrintFileOptions {
  return Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));
}

function told(value: unknown): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map(told).join(", ")}]`;
  if (typeof value === "function") return "a function";
  return typeof value === "object" && value !== null ? "an object" : String(value);
}
