/** Values as an engine is given them, checked by name: what is wrong is told with its field and its value. */
import { TexelcastError } from "../core/texelcast-error.ts";

/** What a value must be, in words, and whether it is. */
export interface Rule {
  readonly must: string;
  readonly holds: (value: unknown) => boolean;
}
/** By field. */
export type Rules = Readonly<Record<string, Rule>>;

export const isObject = (value: unknown): value is Readonly<Record<string, unknown>> =>
  typeof value === "object" && value !== null && !Array.isArray(value);

const isNumber = (value: unknown): value is number => typeof value === "number" && Number.isFinite(value);

export const TEXT: Rule = { must: "a text", holds: (value) => typeof value === "string" };
export const FLAG: Rule = { must: "true or false", holds: (value) => typeof value === "boolean" };
export const NUMBER: Rule = { must: "a number", holds: isNumber };
export const LIST: Rule = { must: "a list", holds: Array.isArray };
export const OBJECT: Rule = { must: "an object", holds: isObject };

export const between = (least: number, most: number): Rule => ({
  must: `a number from ${least} to ${most}`,
  holds: (value) => isNumber(value) && value >= least && value <= most,
});

export const ABOVE_ZERO: Rule = { must: "a number above 0", holds: (value) => isNumber(value) && value > 0 };

export const numbers = (count: number): Rule => ({
  must: `${count} numbers`,
  holds: (value) => Array.isArray(value) && value.length === count && value.every(isNumber),
});

export const oneOf = (...names: readonly string[]): Rule => ({
  must: `one of ${names.join(", ")}`,
  holds: (value) => names.includes(value as string),
});

/** Sets a rule aside for what may be left out. */
export const maybe = ({ must, holds }: Rule): Rule => ({
  must: `${must}, or null`,
  holds: (value) => value === undefined || value === null || holds(value),
});

export const either = (one: Rule, other: Rule): Rule => ({
  must: `${one.must} or ${other.must}`,
  holds: (value) => one.holds(value) || other.holds(value),
});

/** @throws TexelcastError "bad-argument" with the field and the value. */
export function checkValue(value: unknown, { must, holds }: Rule, field: string): void {
  if (holds(value)) return;
  throw new TexelcastError("bad-argument", `“${field}” must be ${must}.`, { field, value: shown(value) });
}

/** The fields of an object, which it must be. @throws TexelcastError "bad-argument". */
export function checkFields(value: unknown, rules: Rules, field: string): void {
  checkValue(value, OBJECT, field);
  for (const [name, rule] of Object.entries(rules)) {
    checkValue((value as Readonly<Record<string, unknown>>)[name], rule, field === "" ? name : `${field}.${name}`);
  }
}

/** Short, and of whatever kind: JSON knows neither undefined nor NaN. */
function shown(value: unknown): string {
  if (typeof value === "object" && value !== null)
    return Array.isArray(value) ? `[${value.map(String).join(", ")}]`.slice(0, 80) : "object";
  return String(value).slice(0, 80);
}
