/**
 * How many bytes a set of immutable values holds together. Values that share structure hold the shared part once, as
 * memory does: every object is counted while at least one value of the set reaches it.
 */

/** Estimates for a 64-bit engine that does not compress its pointers: header and element pointer; a field or element. */
const OBJECT_BYTES = 24;
const SLOT_BYTES = 8;
/** A number that is no small integer lies in a box of its own when it is a field of an object. */
const NUMBER_BYTES = 16;
/**
 * Vectors up to this long count as part of each object that points to them, as if nothing shared them: to keep count of a dab's
 * three, beside the dab, was most of the time in which a painting of 160,000 dabs became a history's first value.
 */
const SHORT_VECTOR = 4;

export class HeldWeight {
  readonly #counts = new Map<object, number>();
  #bytes = 0;

  /** Of everything retained and not released yet. */
  get bytes(): number {
    return this.#bytes;
  }

  retain(value: unknown): void {
    this.#walk(value, (node) => {
      const count = this.#counts.get(node) ?? 0;
      this.#counts.set(node, count + 1);
      if (count === 0) this.#bytes += ownBytes(node);
      return count === 0;
    });
  }

  /** Takes back one `retain` of the same value. */
  release(value: unknown): void {
    this.#walk(value, (node) => {
      const count = this.#counts.get(node) ?? 0;
      if (count > 1) this.#counts.set(node, count - 1);
      else this.#counts.delete(node);
      if (count === 1) this.#bytes -= ownBytes(node);
      return count === 1;
    });
  }

  /** Goes on into a node's parts where `enter` says so: what was counted before has its parts counted too. */
  #walk(value: unknown, enter: (node: object) => boolean): void {
    const open: unknown[] = [value];
    while (open.length > 0) {
      const node = open.pop();
      if (typeof node === "object" && node !== null && enter(node)) pushParts(node, open);
    }
  }
}

function pushParts(node: object, open: unknown[]): void {
  if (ArrayBuffer.isView(node)) open.push(node.buffer);
  else if (node instanceof Map) open.push(...node.keys(), ...node.values());
  else if (node instanceof ArrayBuffer || isNumbers(node)) return;
  // One by one: a stroke has more dabs than a call takes arguments.
  else for (const part of Object.values(node)) if (typeof part === "object" && !isShortVector(part)) open.push(part);
}

/** Without the objects that it points to, but for short vectors. */
function ownBytes(node: object): number {
  if (node instanceof ArrayBuffer) return OBJECT_BYTES + node.byteLength;
  if (ArrayBuffer.isView(node)) return OBJECT_BYTES;
  if (isNumbers(node)) return vectorBytes(node);
  const values = node instanceof Map ? [...node.keys(), ...node.values()] : Object.values(node);
  let bytes = OBJECT_BYTES + SLOT_BYTES * values.length;
  for (const value of values) {
    // A data: address has one byte a character.
    if (typeof value === "string") bytes += value.length;
    else if (typeof value === "number") bytes += NUMBER_BYTES;
    else if (isShortVector(value)) bytes += vectorBytes(value);
  }
  return bytes;
}

/** A vector: its numbers lie in it and point nowhere. */
function isNumbers(node: unknown): node is readonly number[] {
  return Array.isArray(node) && typeof node[0] === "number";
}

const isShortVector = (part: unknown): part is readonly number[] => isNumbers(part) && part.length <= SHORT_VECTOR;
const vectorBytes = (vector: readonly number[]): number => OBJECT_BYTES + SLOT_BYTES * vector.length;
