/** From runs to figures, and from figures to a table. */
import { execFileSync } from "node:child_process";
import { arch, cpus, platform, release, totalmem } from "node:os";
import { fileURLToPath } from "node:url";

/** Figures of one engine at one piece of work, milliseconds. */
export interface Row {
  readonly work: string;
  readonly mesh: string;
  /** Texels along a side of the map. */
  readonly size: number;
  readonly engine: string;
  /** Written (bake) or painted (project). */
  readonly texels: number;
  readonly median: number;
  readonly min: number;
  readonly max: number;
  /** Median over the plain method's: below 1 is faster. */
  readonly toPlainNative: number;
  readonly toPlainWasm: number;
}

export function figures(milliseconds: readonly number[]): Pick<Row, "median" | "min" | "max"> {
  const sorted = [...milliseconds].sort((a, b) => a - b);
  const middle = sorted.length / 2;
  const median = Number.isInteger(middle) ? (sorted[middle - 1] + sorted[middle]) / 2 : sorted[Math.floor(middle)];
  return { median, min: sorted[0], max: sorted[sorted.length - 1] };
}

export function formatTable(rows: readonly Row[]): string {
  const head = ["work", "mesh", "size", "engine", "texels", "median", "min", "max", "÷ native", "÷ WebAssembly"];
  const cells = rows.map((row) => [
    row.work,
    row.mesh,
    `${row.size}²`,
    row.engine,
    row.texels.toLocaleString("en"),
    row.median.toFixed(2),
    row.min.toFixed(2),
    row.max.toFixed(2),
    row.toPlainNative.toFixed(2),
    row.toPlainWasm.toFixed(2),
  ]);
  const widths = head.map((title, column) => Math.max(title.length, ...cells.map((row) => row[column].length)));
  const line = (row: readonly string[]) =>
    `| ${row.map((cell, column) => (column < 4 ? cell.padEnd(widths[column]) : cell.padStart(widths[column]))).join(" | ")} |`;
  const rule = `| ${widths.map((width, column) => (column < 4 ? "-".repeat(width) : `${"-".repeat(width - 1)}:`)).join(" | ")} |`;
  return [line(head), rule, ...cells.map(line)].join("\n");
}

export interface Circumstances {
  readonly date: string;
  readonly machine: string;
  readonly versions: Readonly<Record<string, string>>;
}

export function circumstances(): Circumstances {
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
    },
  };
}

function firstLine(program: string, args: readonly string[]): string {
  try {
    const cwd = fileURLToPath(new URL("..", import.meta.url));
    return execFileSync(program, args, { cwd, encoding: "utf8", stdio: ["ignore", "pipe", "ignore"] }).split("\n")[0];
  } catch {
    return "unknown";
  }
}
