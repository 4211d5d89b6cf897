/** What `renderPrint`, `checkPrint` and `createEngine` are given, looked at once at the door: callers in plain JavaScript have no types. */
import { types } from "node:util";
import * as v from "valibot";
import { MAX_SIZE } from "../web/core/sizes.ts";
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { describeValue, formatPath } from "../web/editor/document/design-problem.ts";

const optional = <Schema extends v.GenericSchema>(schema: Schema) => v.optional(schema);
const numeric = v.number("must be a number");
/** Of any realm: test runners give each file its own Uint8Array. */
const isBytes = (value: unknown): boolean => types.isUint8Array(value) && !isHandedOn(value);

/** Whether an array's memory went to another thread with a message, which leaves an array of nothing. */
function isHandedOn({ buffer, length }: Uint8Array): boolean {
  if (length > 0) return false;
  try {
    void new Uint8Array(buffer);
    return false;
  } catch {
    return true;
  }
}

const isObject = (value: unknown): value is object => typeof value === "object" && value !== null;

const MODEL =
  "must be a path, the bytes of a .glb (a Uint8Array), or { name, bytes, resources }, resources a Map of addresses to bytes";
const isModel = (value: unknown): boolean => {
  if (typeof value === "string" || isBytes(value)) return true;
  if (!isObject(value)) return false;
  const { name, bytes, resources } = value as Record<string, unknown>;
  return typeof name === "string" && isBytes(bytes) && (resources === undefined || types.isMap(resources));
};

const asset = v.looseObject(
  {
    name: v.string("must be the design's address of the file"),
    bytes: v.custom(isBytes, "must be a Uint8Array"),
  },
  (issue) => (issue.expected === "Object" ? "must be { name, bytes }" : "is missing"),
);
const isFunction = (value: unknown): boolean => typeof value === "function";
const ASSETS = "must be a list of { name, bytes }, or a function from an address to bytes";
const SIZE = "must be a number of texels, or two as in [2048, 1024]";

const subject = {
  model: v.custom(isModel, MODEL),
  // Their readers look at them.
  design: optional(v.unknown()),
  zones: optional(v.unknown()),
  assets: v.nullish(v.lazy((input) => (isFunction(input) ? v.unknown() : v.array(asset, ASSETS)))),
};
const SIDE = `must be a whole number of texels from 1 to ${MAX_SIZE}`;
const side = v.pipe(v.number(SIDE), v.integer(SIDE), v.minValue(1, SIDE), v.maxValue(MAX_SIZE, SIDE));
const checkOptions = v.strictObject({ ...subject, size: optional(side) }, told);
const renderOptions = v.strictObject(
  {
    ...subject,
    material: optional(numeric),
    size: optional(v.union([v.number(), v.tuple([v.number(), v.number()])], SIZE)),
    dpi: optional(numeric),
    zone: optional(v.string("must be a zone's id")),
    flattened: optional(v.boolean("must be true or false")),
    base: optional(v.picklist(["model", "none"], 'must be "model" or "none"')),
    signal: optional(v.custom((value) => isObject(value) && "aborted" in value, "must be an AbortSignal")),
    onProgress: optional(v.custom(isFunction, "must be a function")),
  },
  told,
);
const BUDGET = "must be a number of MiB from 1 to 65536";
const engineOptions = v.looseObject(
  { memoryBudgetMib: optional(v.pipe(v.number(BUDGET), v.minValue(1, BUDGET), v.maxValue(65_536, BUDGET))) },
  "must be an object",
);

function told(issue: v.BaseIssue<unknown>): string {
  if (issue.expected === "never") return "is no option";
  return issue.expected === "Object" ? "must be an object with `model` and `design`" : "is missing";
}

/** The options as an object's own, inherited ones and getters too. @throws TexelcastError "bad-argument" */
export const checkRenderArguments = <Options>(options: Options): Options => check(renderOptions, options);
/** As `checkRenderArguments`. @throws TexelcastError "bad-argument" */
export const checkCheckArguments = <Options>(options: Options): Options => check(checkOptions, options);
/** Of its WebAssembly the engine tells, once it is loaded. @throws TexelcastError "bad-argument" */
export const checkEngineOptions = (options: unknown): void => void check(engineOptions, options);

function check<Options>(schema: v.GenericSchema, options: Options): Options {
  const result = v.safeParse(schema, options, { abortEarly: true });
  if (result.success) return result.output as Options;
  const [issue] = result.issues;
  const path = (issue.path ?? []).map(({ key }) => key as string | number);
  // Of an option that there is not, the input is its name.
  const found = issue.expected === "never" ? issue.path?.at(-1)?.value : issue.input;
  throw badArgument(path.length === 0 ? "options" : formatPath(path), issue.message, found);
}

/** Bytes that a reader of assets gave; null: it has no such file. @throws TexelcastError "bad-argument" */
export function checkAssetBytes(given: unknown, uri: string): Uint8Array | null {
  if (given === null || given === undefined) return null;
  if (types.isUint8Array(given) && isBytes(given)) return given;
  throw badArgument("assets", `must give a Uint8Array or null for ${describeValue(uri)}`, given);
}

function badArgument(field: string, message: string, value: unknown): TexelcastError {
  const kind = isObject(value) && !Array.isArray(value) ? value.constructor?.name : "Object";
  const plain = kind === undefined || kind === "Object" ? describeValue(value) : kind;
  const found = types.isUint8Array(value) ? "a Uint8Array whose memory was handed to another thread" : plain;
  return new TexelcastError("bad-argument", `${field}: ${message}, is ${found}`, {
    field,
    value: found,
    hint: "docs/guides/server.md and the types of texelcast/node say what is taken.",
  });
}
