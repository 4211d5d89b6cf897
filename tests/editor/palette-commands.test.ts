import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import type { Palette } from "../../web/editor/tools/gimp-palette.ts";
import { PaletteCommands } from "../../web/editor/tools/palette-commands.ts";
import type { Toolbox } from "../../web/editor/tools/toolbox.ts";

/** The name of the file that a palette of that name is saved as. */
function savedAs(name: string): string {
  const link = { click: () => {}, download: "", href: "" };
  vi.stubGlobal("document", { createElement: () => link });
  const palette: Palette = { name, colors: ["#ff0000"] };
  const board = { strings: stringsIn("en") } as NoticeBoard;
  new PaletteCommands({ settings: { palette } } as unknown as Toolbox, board).save();
  return link.download;
}

describe("a palette that is saved", () => {
  beforeEach(() => void vi.useFakeTimers());
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("has its whole name, as far as a file system takes it", () => {
    expect(savedAs("Warm 2.5")).toBe("Warm 2.5.gpl");
    expect(savedAs("Red/Blue")).toBe("Red-Blue.gpl");
    expect(savedAs("")).toBe("Basic colours.gpl");
  });
});
