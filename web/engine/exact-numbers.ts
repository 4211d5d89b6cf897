/**
 * JSON through JavaScript without loss. A JavaScript number cannot give back "-0.0" (it is written as 0), nor whole
 * numbers beyond 2^53 (ids in extras), nor 1e400. Such literals travel as marked strings while a model's JSON is changed, so that
 * what is not ours to change stays as it was.
 */
import type { JsonObject } from "./gltf-json.ts";

const MARK = "#texelcast-number:";

/** A string or a number of JSON text. The string's part is written so that it does not backtrack over long ones. */
const TOKEN = /"[^"\\]*(?:\\.[^"\\]*)*"|-?\d[\d.eE+-]*/g;
const MARKED = new RegExp(`"${MARK}([^"]*)"`, "g");

/** Parses JSON text; numbers that would change become marked strings. */
export function parseExact(text: string): JsonObject {
  // A text that has the mark already would come back as another one.
  if (text.includes(MARK)) return JSON.parse(text) as JsonObject;
  const marked = text.replace(TOKEN, (token) =>
    token.startsWith('"') || survives(token) ? token : `"${MARK}${token}"`,
  );
  return JSON.parse(marked) as JsonObject;
}

/** The JSON text of what `parseExact` gave, with every number as it was. */
export function stringifyExact(json: JsonObject): string {
  const text = JSON.stringify(json);
  return text.includes(MARK) ? text.replace(MARKED, "$1") : text;
}

function survives(literal: string): boolean {
  const value = Number(literal);
  if (Object.is(value, -0) || !Number.isFinite(value)) return false;
  return Number.isSafeInteger(value) || !/^-?\d+$/.test(literal);
}
