/** The palette's own file work: from a .gpl, from a picture, and back into a .gpl. */
import { decodePicture } from "../../engine/picture-decoder.ts";
import { download, fileNameOf, fileStem } from "../files/download.ts";
import { bytesOf } from "../files/file-bytes.ts";
import type { NoticeBoard } from "../state/notice-board.ts";
import { ToldError } from "../strings/told-error.ts";
import { DEFAULT_PALETTE } from "./default-palette.ts";
import { type Palette, parseGimpPalette, printGimpPalette } from "./gimp-palette.ts";
import { colorsOf } from "./picture-palette.ts";
import type { Toolbox } from "./toolbox.ts";

/** Taken from a picture; more are hard to choose among. */
const PICTURE_COLORS = 64;

export class PaletteCommands {
  readonly #tools: Toolbox;
  readonly #board: NoticeBoard;

  constructor(tools: Toolbox, board: NoticeBoard) {
    this.#tools = tools;
    this.#board = board;
  }

  /** A .gpl file, or a picture whose colours become the palette. A file that cannot be read leaves the palette as it is. */
  async open(file: File): Promise<void> {
    try {
      const isPalette = file.name.toLowerCase().endsWith(".gpl");
      const palette = isPalette
        ? parseGimpPalette(await file.text(), file.name, this.#board.strings.palette.errors)
        : await this.#ofPicture(file);
      this.#tools.configure({ palette });
      this.#board.announce(this.#board.strings.palette.opened(palette.name, palette.colors.length));
    } catch (thrown) {
      this.#board.error(this.#board.strings.errors.couldNotOpen(file.name), thrown);
    }
  }

  async #ofPicture(file: File): Promise<Palette> {
    const colors = colorsOf(await decodePicture(await bytesOf(file), file.name, { asSeen: true }), PICTURE_COLORS);
    if (colors.length === 0) {
      throw new ToldError("bad-palette", this.#board.strings.palette.errors.clearPicture, { subject: file.name });
    }
    return { name: fileStem(file.name), colors };
  }

  save(): void {
    const { palette } = this.#tools.settings;
    const name = palette.name || this.#board.strings.palette.basic;
    download(`${fileNameOf(name)}.gpl`, "text/plain", printGimpPalette({ ...palette, name }));
  }

  reset(): void {
    this.#tools.configure({ palette: DEFAULT_PALETTE });
  }
}
