/** What a print may be asked for, looked at before anything is made of it: callers in plain JavaScript have no types. */
import { MAX_TEXTURE_SIZE } from "../core/sizes.ts";
import type { PrintFileOptions } from "./print-report.ts";

export interface OptionFault {
  readonly field: string;
  /** What stands there. */
  readonly value: string;
  /** What may stand there, in signs that every language reads. */
  readonly allowed: string;
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

/** The first option that is not what it may be; null: each is. What is undefined is not said. */
export function printOptionFault(options: unknown): OptionFault | null {
  if (typeof options !== "object" || options === null || Array.isArray(options)) {
    return { field: "options", value: told(options), allowed: `{ ${Object.keys(RULES).join(", ")} }` };
  }
  for (const [field, { allowed, admits }] of Object.entries(RULES)) {
    const value = (options as Record<string, unknown>)[field];
    if (value !== undefined && !admits(value)) return { field, value: told(value), allowed };
  }
  return null;
}

/** The options alone, without what else the caller's object has: a worker can be sent no function. */
export function ownPrintOptions(options: PrintFileOptions): PrintFileOptions {
  const given = Object.entries(options).filter(([name, value]) => Object.hasOwn(RULES, name) && value !== undefined);
  return Object.fromEntries(given);
}

function told(value: unknown): string {
  if (typeof value === "string") return JSON.stringify(value);
  if (Array.isArray(value)) return `[${value.map(told).join(", ")}]`;
  return typeof value === "object" && value !== null ? "an object" : String(value);
}
