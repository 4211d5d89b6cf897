/** From figures to tables, and what machine and versions they are of. */
import { execFileSync } from "node:child_process";
import { arch, cpus, platform, release, totalmem } from "node:os";
import { fileURLToPath } from "node:url";
import type { Figures } from "./rounds.ts";

/** Figures of one engine at one piece of work. */
export interface EngineRow extends Figures {
  readonly work: string;
  readonly mesh: string;
  /** Texels along a side of the map. */
  readonly size: number;
  readonly engine: string;
}

export interface Row extends EngineRow {
  /** Median over the plain method's: below 1 is faster. */
  readonly toPlainNative?: number;
  readonly toPlainWasm?: number;
  /** Median over that of the same decal without others below it; only where there are others. */
  readonly toAlone?: number;
}

/** A map at rest. */
export interface MemoryRow {
  readonly mesh: string;
  readonly size: number;
  /** All that is derived from the map included. */
  readonly bytes: number;
  readonly coveredTexels: number;
  readonly gutterTexels: number;
  readonly bytesPerCoveredTexel: number;
  /** Of the plain method, which keeps 24 bytes for every texel of the map. */
  readonly plainBytesPerCoveredTexel: number;
}

type Column<Item> = readonly [title: string, cell: (item: Item) => string];

/** A Markdown table whose first columns, `texts` of them, hold words, and the others numbers. */
export function formatTable<Item>(items: readonly Item[], texts: number, columns: readonly Column<Item>[]): string {
  const cells = items.map((item) => columns.map(([, cell]) => cell(item)));
  const widths = columns.map(([title], column) => Math.max(title.length, ...cells.map((row) => row[column].length)));
  const line = (row: readonly string[]) =>
    `| ${row.map((cell, column) => (column < texts ? cell.padEnd(widths[column]) : cell.padStart(widths[column]))).join(" | ")} |`;
  const rule = widths.map((width, column) => (column < texts ? "-".repeat(width) : `${"-".repeat(width - 1)}:`));
  return [line(columns.map(([title]) => title)), `| ${rule.join(" | ")} |`, ...cells.map(line)].join("\n");
}

const count = (number: number): string => number.toLocaleString("en");

export function formatRows(rows: readonly Row[]): string {
  const stacked = rows.some(({ toAlone }) => toAlone !== undefined);
  return formatTable(rows, 4, [
    ["work", ({ work }) => work],
    ["mesh", ({ mesh }) => mesh],
    ["size", ({ size }) => `${size}²`],
    ["engine", ({ engine }) => engine],
    ["texels", ({ texels }) => count(texels)],
    ["median", ({ median }) => median.toFixed(2)],
    ["min", ({ min }) => min.toFixed(2)],
    ["max", ({ max }) => max.toFixed(2)],
    ["÷ native", ({ toPlainNative }) => toPlainNative?.toFixed(3) ?? ""],
    ["÷ WebAssembly", ({ toPlainWasm }) => toPlainWasm?.toFixed(3) ?? ""],
    ...(stacked ? [["÷ alone", ({ toAlone }: Row) => toAlone?.toFixed(2) ?? ""] as const] : []),
  ]);
}

/** The page's engines, beside each other without a yardstick. */
export function formatEngines(rows: readonly EngineRow[]): string {
  return formatTable(rows, 4, [
    ["work", ({ work }) => work],
    ["mesh", ({ mesh }) => mesh],
    ["size", ({ size }) => `${size}²`],
    ["engine", ({ engine }) => engine],
    ["texels", ({ texels }) => (texels > 0 ? count(texels) : "none")],
    ["median", ({ median }) => median.toFixed(2)],
    ["min", ({ min }) => min.toFixed(2)],
    ["max", ({ max }) => max.toFixed(2)],
    ["until read", ({ untilRead }) => untilRead?.toFixed(2) ?? ""],
  ]);
}

export function formatMemory(rows: readonly MemoryRow[]): string {
  return formatTable(rows, 2, [
    ["mesh", ({ mesh }) => mesh],
    ["size", ({ size }) => `${size}²`],
    ["map, bytes", ({ bytes }) => count(bytes)],
    ["covered texels", ({ coveredTexels }) => count(coveredTexels)],
    ["gutter texels", ({ gutterTexels }) => count(gutterTexels)],
    ["bytes ÷ covered", ({ bytesPerCoveredTexel }) => bytesPerCoveredTexel.toFixed(2)],
    ["plain method's", ({ plainBytesPerCoveredTexel }) => plainBytesPerCoveredTexel.toFixed(2)],
  ]);
}

export interface Circumstances {
  readonly date: string;
  readonly machine: string;
  readonly versions: Readonly<Record<string, string>>;
}

/** @param more versions of what else took part */
export function circumstances(more: Readonly<Record<string, string>> = {}): Circumstances {
  const gibibytes = Math.round(totalmem() / 2 ** 30);
  return {
    date: new Date().toISOString(),
    machine: `${cpus()[0]?.model ?? "unknown processor"}, ${cpus().length} cores, ${gibibytes} GiB, ${platform()} ${release()} ${arch()}`,
    versions: {
      texelcast: firstLine("git", ["describe", "--always", "--dirty"]),
      node: process.version,
      v8: process.versions.v8,
      emscripten: firstLine("emcc", ["--version"]),
      compiler: firstLine("c++", ["--version"]),
      ...more,
    },
  };
}

/** Machine and versions as the lines above a table. */
export function formatCircumstances({ machine, versions }: Circumstances): string {
  const named = Object.entries(versions).map(([name, version]) => `${name} ${version}`);
  return `${machine}\n${named.join(" · ")}`;
}

function firstLine(program: string, args: readonly string[]): string {
  try {
    const cwd = fileURLToPath(new URL("..", import.meta.url));
    return execFileSync(program, args, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }).split("\n")[0];
  } catch {
    return "unknown";
  }
}
