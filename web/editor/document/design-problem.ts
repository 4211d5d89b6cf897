/** How a design's faults are told: where in the document, what it must be, what it is. */
import { cutText } from "../../core/cut-text.ts";
import { TexelcastError } from "../../core/texelcast-error.ts";

export type DesignPath = readonly (string | number)[];

export interface DesignProblem {
  readonly path: DesignPath;
  /** Reads on from the path: "must be above 0". */
  readonly message: string;
  /** What stands there; left out where it does not matter. */
  readonly value?: unknown;
}

const MAX_REPORTED = 20;
const MAX_VALUE_LENGTH = 60;

/** "layers[2].projector.size[1]"; keys that are not plain words stand in brackets and quotes. */
export function formatPath(path: DesignPath): string {
  return path.reduce<string>((text, key) => {
    if (typeof key === "number") return `${text}[${key}]`;
    if (!/^[A-Za-z_$][\w$]*$/.test(key)) return `${text}[${describeValue(key)}]`;
    return text === "" ? key : `${text}.${key}`;
  }, "");
}

/** A value in a few words: never its whole depth, which may be hostile. */
export function describeValue(value: unknown): string {
  if (Array.isArray(value)) {
    const isShort = value.length <= 4 && value.every((item) => typeof item === "number");
    return isShort ? `[${value.join(", ")}]` : `a list of ${value.length}`;
  }
  if (typeof value === "object" && value !== null) return "an object";
  if (typeof value === "string") return JSON.stringify(shorten(value));
  return shorten(String(value));
}

const shorten = (text: string): string =>
  text.length > MAX_VALUE_LENGTH ? `${cutText(text, MAX_VALUE_LENGTH - 1)}…` : text;

function formatProblem({ path, message, ...rest }: DesignProblem, what: string): string {
  const place = formatPath(path);
  const label = place === "" ? what : `${place}:`;
  if (!("value" in rest)) return `${label} ${message}`;
  if (rest.value === undefined) return `${label} is missing: ${message}`;
  return `${label} ${message}, is ${describeValue(rest.value)}`;
}

/**
 * The typed error of one or more problems. A place with several is told by its first: the others follow from it.
 */
export function designError(
  name: string,
  problems: readonly DesignProblem[],
  hint?: string,
  code = "bad-design",
  what = "the design",
): TexelcastError {
  const byPlace = new Map<string, DesignProblem>();
  for (const problem of problems) {
    const place = formatPath(problem.path);
    if (!byPlace.has(place)) byPlace.set(place, problem);
  }
  const distinct = [...byPlace.values()];
  const lines = distinct.slice(0, MAX_REPORTED).map((problem) => formatProblem(problem, what));
  const untold = distinct.length - lines.length;
  const first = distinct[0];
  return new TexelcastError(code, lines.join("; ") + (untold > 0 ? `; and ${untold} more` : ""), {
    subject: name,
    hint: hint ?? "The fields of a design are described in docs/design-document.md.",
    ...(first === undefined ? {} : { field: formatPath(first.path) }),
    ...(first?.value === undefined ? {} : { value: describeValue(first.value) }),
  });
}
