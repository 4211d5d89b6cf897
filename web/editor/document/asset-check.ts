/**
 * A design's files when the design comes from somebody else: where they may lie, and whether they are what it says they are.
 * The same in the page and in a shop's server.
 */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { readFontHeader } from "../../engine/font-file.ts";
import { checkUpload, type UploadLimits } from "../../engine/upload-check.ts";
import type { AssetType, DesignAsset } from "./design.ts";
import { describeValue } from "./design-problem.ts";

const FONT_BYTES = 16 * 2 ** 20;

/**
 * Throws "outside-folder" for an address that leads out of the design's own folder: absolute, with "..", backslashes or control
 * characters, spelt in per cents or not. `data:` addresses are inside.
 */
export function checkAssetAddress(key: string, uri: string): void {
  if (uri.startsWith("data:")) return;
  const spelt = decoded(decoded(uri));
  const leavesFolder =
    spelt === null ||
    spelt === "" ||
    // biome-ignore lint/suspicious/noControlCharactersInRegex: they are what is looked for.
    /^[a-z][a-z0-9+.-]*:|^\/|\\|[\u0000-\u001f\u007f]|[?#]/i.test(spelt) ||
    spelt.split("/").includes("..");
  if (!leavesFolder) return;
  throw new TexelcastError(
    "outside-folder",
    `The design names a file outside of its own folder: ${describeValue(uri)}.`,
    {
      field: `assets.${key}.uri`,
      value: describeValue(uri),
      hint: "A design's files lie beside it, or in it as data: addresses.",
    },
  );
}

/** Null where it is not well-formed. */
function decoded(text: string | null): string | null {
  try {
    return text === null ? null : decodeURIComponent(text);
  } catch {
    return null;
  }
}

/**
 * The bytes of an asset, clean (`checkUpload`). Rejects with "bad-design" where they, or the media type of a `data:` address, are not
 * of the type that the design gives; and as `checkUpload` and `readFontHeader` do.
 *
 * @param name what errors call the file
 */
export async function checkAsset(
  key: string,
  { type, uri }: DesignAsset,
  bytes: Uint8Array,
  limits: UploadLimits = {},
  name = key,
): Promise<Uint8Array<ArrayBuffer>> {
  const said = uri.startsWith("data:") ? (/^data:([^;,]*)/.exec(uri)?.[1] ?? "").toLowerCase() : type;
  if (said !== type) throw liar(key, type, said || "nothing");
  if (type.startsWith("font/")) {
    if (bytes.length > FONT_BYTES) {
      throw new TexelcastError("too-large", `The font “${name}” has more than ${FONT_BYTES / 2 ** 20} MiB.`, {
        field: `assets.${key}`,
        value: String(bytes.length),
        hint: "Use a font with fewer characters.",
      });
    }
    const is: AssetType = `font/${readFontHeader(bytes, name).format}`;
    if (is !== type) throw liar(key, type, is);
    return bytes.slice();
  }
  const { type: is, bytes: clean } = await checkUpload(name, bytes, limits);
  if (is !== type) throw liar(key, type, is);
  return clean;
}

const liar = (key: string, said: string, is: string): TexelcastError =>
  new TexelcastError("bad-design", `The asset ${describeValue(key)} is said to be ${said} and is ${is}.`, {
    field: `assets.${key}.type`,
    value: said,
    hint: "Put the picture into the design anew.",
  });
