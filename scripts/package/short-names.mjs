/**
 * Short names for the scripts that only other scripts name, by what is in them. The bundler's hashes have eight letters, which no
 * compression makes less of, wherever one script asks for another: with four, what shops load at first is 269 bytes less after gzip,
 * and so is every stage after it. Four still tell one version's script from another's in a cache, a million to one. The bundler's
 * own would not: they are of scripts before they were merged, and one that a cache has kept would lack what another version's ask it for.
 */
import { createHash } from "node:crypto";
import { existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { decode, encode } from "@jridgewell/sourcemap-codec";

const LEAST_LETTERS = 4;

/** A script's name without its ending, as the bundler writes it: what it is for, and its hash. */
const HASHED = /\b(page|standalone|worker)-([A-Z0-9]{8})(?=\.js\b)/g;

/** Letters left out of a line: the column behind them, as it was, and how many. @typedef {{ behind: number, by: number }} Cut */

/**
 * Gives all hashed scripts of a folder short names, and names them so in every script there. Source maps stay true.
 *
 * @param {string} dist
 */
export function shortenNames(dist) {
  const scripts = readdirSync(dist).filter((each) => each.endsWith(".js"));
  const texts = new Map(scripts.map((name) => [name, readFileSync(join(dist, name), "utf8")]));
  const hashOf = contentHashes(texts);
  const shorter = shortNames([...hashOf.values()].map((hashed) => `${hashed}.js`));
  const shortOf = new Map([...hashOf].map(([name, hashed]) => [name, shorter.get(hashed) ?? hashed]));
  const renamed = (/** @type {string} */ text) => text.replace(HASHED, (name) => shortOf.get(name) ?? name);
  /** @type {Map<string, string>} Written when all are read: one's new name may be another's old one. */
  const written = new Map();
  for (const [name, before] of texts) {
    const after = renamed(before);
    const own = renamed(name);
    if (after === before && own === name) continue;
    const mapFile = join(dist, `${name}.map`);
    if (existsSync(mapFile)) {
      const map = JSON.parse(readFileSync(mapFile, "utf8"));
      const mappings = moved(decode(map.mappings), cutsOf(before, shortOf));
      written.set(`${own}.map`, JSON.stringify({ ...map, mappings: encode(mappings) }));
    }
    written.set(own, after);
    rmSync(join(dist, name));
    rmSync(mapFile, { force: true });
  }
  for (const [name, text] of written) writeFileSync(join(dist, name), text);
}

/**
 * Of each hashed name one of its kind with eight letters of what is in that script and in all scripts that it asks for, directly or
 * not: they are named in it, and some ask for each other, so that none can be named first.
 *
 * @param {Map<string, string>} texts by the scripts' file names @returns {Map<string, string>}
 */
export function contentHashes(texts) {
  const named = (/** @type {string} */ text) => [...new Set(text.match(HASHED))];
  const digest = (/** @type {readonly string[]} */ parts) =>
    createHash("sha256").update(parts.join("\n")).digest("hex").slice(0, 8).toUpperCase();
  const hashed = [...texts.keys()].flatMap(named);
  const textOf = (/** @type {string} */ name) => texts.get(`${name}.js`) ?? "";
  const own = new Map(hashed.map((name) => [name, textOf(name).replace(HASHED, "$1")]));
  const reach = (/** @type {string} */ name, seen = new Set()) => {
    if (seen.has(name)) return seen;
    seen.add(name);
    for (const other of named(textOf(name))) reach(other, seen);
    return seen;
  };
  // In the order in which they are named: which of two is asked for where makes another script.
  const hashOf = (/** @type {string} */ name) => digest([...reach(name)].map((each) => own.get(each) ?? ""));
  return new Map(hashed.map((name) => [name, name.replace(/[^-]*$/, hashOf(name))]));
}

/**
 * Of each hashed name its short one: as many letters as tell it from all others of its kind, and no fewer than four.
 *
 * @param {readonly string[]} names of files @returns {Map<string, string>}
 */
export function shortNames(names) {
  const hashed = new Set(names.flatMap((name) => name.match(HASHED) ?? []));
  /** @type {Map<string, string>} */
  const shortOf = new Map();
  for (const name of hashed) {
    const others = [...hashed].filter((other) => other !== name);
    let end = name.indexOf("-") + 1 + LEAST_LETTERS;
    while (others.some((other) => other.startsWith(name.slice(0, end)))) end++;
    shortOf.set(name, name.slice(0, end).toLowerCase());
  }
  return shortOf;
}

/** Line by line. @param {string} text @param {Map<string, string>} shortOf @returns {Cut[][]} */
function cutsOf(text, shortOf) {
  return text.split("\n").map((line) =>
    [...line.matchAll(HASHED)].flatMap(({ index, 0: name }) => {
      const short = shortOf.get(name);
      return short === undefined ? [] : [{ behind: index + name.length, by: name.length - short.length }];
    }),
  );
}

/** @param {import("@jridgewell/sourcemap-codec").SourceMapMappings} mappings @param {Cut[][]} cuts */
function moved(mappings, cuts) {
  return mappings.map((segments, line) =>
    segments.map((segment) => {
      const [column, ...rest] = segment;
      const left = (cuts[line] ?? []).filter(({ behind }) => behind <= column).reduce((sum, { by }) => sum + by, 0);
      return /** @type {import("@jridgewell/sourcemap-codec").SourceMapSegment} */ ([column - left, ...rest]);
    }),
  );
}
