import { describe, expect, it } from "vitest";
import { collectDrop } from "../../web/editor/files/file-collection.ts";

/** A file's entry as WebKit makes it of a file that a script has put into the transfer: it lies nowhere. */
const unreadable = (name: string) => ({
  isFile: true,
  isDirectory: false,
  name,
  fullPath: `/${name}`,
  file: (_: unknown, refuse: (fault: Error) => void) => refuse(new Error("Path does not exist.")),
});

/** A folder that tells what it holds in two parts, as Chromium tells hundreds. */
function folder(name: string, files: readonly string[]) {
  const entries = files.map((file) => ({
    isFile: true,
    isDirectory: false,
    name: file,
    fullPath: `/${name}/${file}`,
    file: (give: (file: File) => void) => give(new File([], file)),
  }));
  const parts = [entries.slice(0, 1), entries.slice(1), []];
  return {
    isFile: false,
    isDirectory: true,
    name,
    fullPath: `/${name}`,
    createReader: () => ({ readEntries: (give: (part: unknown) => void) => give(parts.shift()) }),
  };
}

const drop = (...items: readonly { readonly entry: unknown; readonly file: File | null }[]): DataTransfer =>
  ({
    items: items.map(({ entry, file }) => ({ kind: "file", webkitGetAsEntry: () => entry, getAsFile: () => file })),
  }) as unknown as DataTransfer;

describe("what is dropped", () => {
  it("is a file also where the browser knows no place that it lies in", async () => {
    const file = new File([], "logo.png");
    expect(await collectDrop(drop({ entry: unreadable("logo.png"), file }))).toEqual([{ path: "logo.png", file }]);
  });

  it("is a folder to its end, without what is hidden in it", async () => {
    const collected = await collectDrop(
      drop({ entry: folder("shoe", ["shoe.gltf", "sole.png", ".DS_Store"]), file: null }),
    );
    expect(collected.map(({ path }) => path)).toEqual(["shoe/shoe.gltf", "shoe/sole.png"]);
  });
});
