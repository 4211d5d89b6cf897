/**
 * Palettes as GIMP keeps them (.gpl), read and written: a first line "GIMP Palette", lines "Name:" and "Columns:", then
 * three numbers from 0 to 255 and a name for each colour; lines that begin with # are remarks.
 */

import type { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";
import { hexOf } from "./pixel-probe.ts";

type PaletteErrors = Strings["palette"]["errors"];

export interface Palette {
  /** "" for the one that an editor begins with, which each language calls otherwise. */
  readonly name: string;
  /** "#rrggbb". */
  readonly colors: readonly string[];
}

/** More would be a picture, not a palette. */
export const MOST_COLORS = 1024;
const FIRST_LINE = "GIMP Palette";
const COLOR_LINE = /^\s*(\S+)\s+(\S+)\s+(\S+)(?:\s|$)/;

/**
 * @param file as the user knows it; errors name it
 * @param words of those errors
 * @throws TexelcastError "bad-palette" that names the line and what is in it
 */
export function parseGimpPalette(text: string, file: string, words: PaletteErrors): Palette {
  const lines = text.replace(/^\uFEFF/, "").split(/\r\n|\r|\n/);
  if (lines[0]?.trim() !== FIRST_LINE) throw fault(file, 1, lines[0] ?? "", words.noHeader, words);
  let name = "";
  const colors: string[] = [];
  for (const [index, line] of lines.entries()) {
    if (index === 0 || line.trim() === "" || line.trimStart().startsWith("#")) continue;
    const field = /^\s*(Name|Columns|Channels)\s*:\s*(.*)$/i.exec(line);
    if (field !== null && colors.length === 0) {
      if (field[1]?.toLowerCase() === "name") name = (field[2] ?? "").trim();
      continue;
    }
    if (colors.length >= MOST_COLORS) throw fault(file, index + 1, line, words.tooMany(MOST_COLORS), words);
    colors.push(colorIn(line, file, index + 1, words));
  }
  if (colors.length === 0) throw fault(file, lines.length, "", words.noColors, words);
  return { name: name || file.replace(/\.[^.]*$/, ""), colors };
}

export function printGimpPalette({ name, colors }: Palette): string {
  // A line break in a name would begin a line of its own.
  const oneLine = name.replace(/\s+/g, " ").trim();
  const rows = colors.map((color) => {
    const channels = [1, 3, 5].map((at) => String(Number.parseInt(color.slice(at, at + 2), 16)).padStart(3));
    return `${channels.join(" ")}\t${color}`;
  });
  return [FIRST_LINE, `Name: ${oneLine}`, "Columns: 8", "#", ...rows, ""].join("\n");
}

function colorIn(line: string, file: string, number: number, words: PaletteErrors): string {
  const match = COLOR_LINE.exec(line);
  const channels = (match ?? []).slice(1, 4).map((part) => (/^\d{1,3}$/.test(part) ? Number(part) : Number.NaN));
  if (channels.length !== 3 || !channels.every((channel) => channel <= 255)) {
    throw fault(file, number, line, words.notAColor, words);
  }
  return hexOf(...channels);
}

function fault(file: string, line: number, value: string, message: string, words: PaletteErrors): TexelcastError {
  return new ToldError("bad-palette", message, {
    subject: file,
    field: words.line(line),
    value: value.length > 80 ? `${value.slice(0, 80)}…` : value,
    hint: words.hint,
  });
}
