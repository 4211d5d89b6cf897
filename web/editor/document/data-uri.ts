/** `data:` URIs (RFC 2397) to bytes and back. */
import { TexelcastError } from "../../core/texelcast-error.ts";

/** A multiple of three, so that no part of the base64 but the last is filled up. A call takes only so many arguments. */
const PART_BYTES = 0x7ffe;

/** The browser's own, from 2025 on: a fortieth of the time. */
type NativeBase64 = Uint8Array & { toBase64?(): string };

export function encodeDataUri(type: string, bytes: Uint8Array): string {
  return `data:${type};base64,${(bytes as NativeBase64).toBase64?.() ?? inParts(bytes)}`;
}

function inParts(bytes: Uint8Array): string {
  let base64 = "";
  for (let start = 0; start < bytes.length; start += PART_BYTES) {
    const part = bytes.subarray(start, start + PART_BYTES) as Iterable<number> as number[];
    // Spread, the bytes are asked for one by one: a second for a large photograph on a phone.
    base64 += btoa(String.fromCharCode.apply(null, part));
  }
  return base64;
}

/**
 * Throws a TexelcastError of code "bad-design" that names `subject`. A "#" belongs to the data, as a drawing's colours have it that
 * was not encoded: to `fetch` it would be the data's end.
 */
export function decodeDataUri(uri: string, subject: string): Uint8Array<ArrayBuffer> {
  const comma = uri.indexOf(",");
  if (!/^data:/i.test(uri) || comma < 0) throw malformed(subject);
  try {
    const body = uri
      .slice(comma + 1)
      .replace(/[\u0080-\uffff]+/g, encodeURIComponent)
      .replace(/%([0-9a-f]{2})/gi, (_, hex: string) => String.fromCharCode(Number.parseInt(hex, 16)));
    return bytesOf(/; *base64$/i.test(uri.slice(0, comma)) ? atob(body) : body);
  } catch (cause) {
    throw malformed(subject, cause);
  }
}

/** In a loop: `Uint8Array.from` with a function takes thirty times as long, a second for a large photograph. */
function bytesOf(binary: string): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(binary.length);
  for (let place = 0; place < binary.length; place += 1) bytes[place] = binary.charCodeAt(place);
  return bytes;
}

function malformed(subject: string, cause?: unknown): TexelcastError {
  return new TexelcastError("bad-design", `${subject} is not a well-formed data: address.`, { subject, cause });
}
