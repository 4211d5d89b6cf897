/** Bytes behind the URIs of a model: data URIs and the side files that came with it (glTF 2.0, 2.8). */
import { TexelcastError } from "../core/texelcast-error.ts";
import { badContainer } from "./gltf-json.ts";

export interface Resource {
  readonly bytes: Uint8Array;
  /** As a data URI states it; "" elsewhere. */
  readonly mediaType: string;
}

/** Schemes are read whatever their capitals (RFC 3986, 3.1). */
export const isDataUri = (uri: string): boolean => /^data:/i.test(uri);

/**
 * The bytes of `uri` at the JSON path `field`. Throws "missing-file" naming the side file that was not given, and
 * "bad-container" for a broken data URI.
 */
export function resolveUri(
  uri: string,
  field: string,
  name: string,
  resources: ReadonlyMap<string, Uint8Array>,
): Resource {
  if (isDataUri(uri)) return decodeDataUri(uri, field, name);
  for (const key of spellings(uri)) {
    const bytes = resources.get(key);
    if (bytes !== undefined) return { bytes, mediaType: "" };
  }
  // One letter is a drive of Windows.
  const isRemote = /^[a-z][\w+.-]+:/i.test(uri);
  throw new TexelcastError("missing-file", `“${name}” needs the file “${uri}”, which was not given with it.`, {
    subject: name,
    field,
    value: uri,
    hint: `${isRemote ? "Nothing is downloaded on a model's behalf:" : `Give “${uri}” together with the model, or`} export it as a single .glb file.`,
  });
}

/** The same file as people and exporters write it: percent-encoded or not, with "./" or backslashes. */
function spellings(uri: string): string[] {
  const found = [uri];
  try {
    found.push(decodeURIComponent(uri));
  } catch {
    // A stray "%" is no encoding: the name is meant as it stands.
  }
  return found.flatMap((spelling) => [spelling, spelling.replace(/\\/g, "/").replace(/^(\.\/)+/, "")]);
}

function decodeDataUri(uri: string, field: string, name: string): Resource {
  const comma = uri.indexOf(",");
  if (comma < 0) throw badContainer(name, `“${field}” is not a whole data address`, field, uri);
  const header = uri.slice("data:".length, comma);
  const mediaType = header.split(";")[0] ?? "";
  const data = uri.slice(comma + 1);
  try {
    const text = /;base64/i.test(header) ? atob(data) : decodePercent(data);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < bytes.length; i++) bytes[i] = text.charCodeAt(i);
    return { bytes, mediaType };
  } catch {
    throw badContainer(name, `“${field}” holds data that cannot be decoded`, field, uri);
  }
}

/** Each "%XX" as one byte; `decodeURIComponent` would insist on UTF-8. */
function decodePercent(data: string): string {
  return data.replace(/%([0-9a-f]{2})/gi, (_, digits: string) => String.fromCharCode(Number(`0x${digits}`)));
}
