/** Takes out of a model's BIN the bytes that nothing lies on any more. */
import { indexAt, type JsonObject, listOf } from "./gltf-json.ts";

/** Accessors stay aligned where what lies before them shrinks by a multiple of this, bytes. */
const ALIGNMENT = 16;

/** Bytes from `start` to before `end`. */
export interface Span {
  readonly start: number;
  readonly end: number;
}

/** Of a buffer view, or of what else says where bytes lie. */
export function spanOf(place: JsonObject): Span {
  const start = indexAt(place, "byteOffset") ?? 0;
  return { start, end: start + (indexAt(place, "byteLength") ?? 0) };
}

/** What of `gone` lies under none of `kept`, from the first byte to the last, in whole multiples of the alignment. */
export function cutsOf(gone: readonly Span[], kept: readonly Span[]): Span[] {
  const cuts: Span[] = [];
  const under = kept.toSorted((a, b) => a.start - b.start);
  let at = 0;
  let next = 0;
  const add = (start: number, end: number): void => {
    const length = Math.floor((end - start) / ALIGNMENT) * ALIGNMENT;
    if (length > 0) cuts.push({ start, end: start + length });
  };
  for (const { start, end } of gone.toSorted((a, b) => a.start - b.start)) {
    at = Math.max(at, start);
    while (at < end) {
      while (next < under.length && (under[next] as Span).end <= at) next++;
      const cover = under[next];
      const free = Math.min(end, cover?.start ?? end);
      if (at < free) {
        add(at, free);
        at = free;
      } else {
        at = cover?.end ?? end;
      }
    }
  }
  return cuts;
}

export const bytesIn = (spans: readonly Span[]): number => spans.reduce((sum, { start, end }) => sum + end - start, 0);

/** What is left of the BIN, with room for `more` bytes behind it. */
export function withoutCuts(binary: Uint8Array, cuts: readonly Span[], more = 0): Uint8Array {
  const kept = new Uint8Array(binary.length - bytesIn(cuts) + more);
  let from = 0;
  let to = 0;
  for (const { start, end } of [...cuts, { start: binary.length, end: binary.length }]) {
    kept.set(binary.subarray(from, start), to);
    to += start - from;
    from = end;
  }
  return kept;
}

/** Says in `json` where its buffer views lie once these are cut, and how many bytes its buffer has. */
export function moveViews(json: JsonObject, cuts: readonly Span[], name: string): void {
  let passed = 0;
  let shift = 0;
  for (const view of listOf(json, "bufferViews", name).toSorted((a, b) => spanOf(a).start - spanOf(b).start)) {
    const { start } = spanOf(view);
    for (let next = cuts[passed]; next !== undefined && next.end <= start; next = cuts[++passed])
      shift += next.end - next.start;
    if (shift > 0) view.byteOffset = start - shift;
  }
  const [buffer] = listOf(json, "buffers", name);
  if (buffer !== undefined) buffer.byteLength = (indexAt(buffer, "byteLength") ?? 0) - bytesIn(cuts);
}
