/**
 * Structs of the C ABI as typed tables. The ABI has 4-byte fields only (texelcast.h), so a struct is its fields in order
 * and nothing else: no padding, the same in every build.
 */

/** One field: its type, and how many of them for an array. */
export interface FieldLayout {
  readonly type: "u32" | "f32";
  /** Absent for a plain number. */
  readonly length?: number;
}

export type StructFields = Readonly<Record<string, FieldLayout>>;

/** What a struct reads as: a number a field, and for array fields a list of numbers. */
export type StructValue<Fields extends StructFields> = {
  readonly [Name in keyof Fields]: Fields[Name] extends { readonly length: number } ? readonly number[] : number;
};

export interface StructLayout<Fields extends StructFields = StructFields> {
  readonly fields: Fields;
  readonly byteSize: number;
}

export const u32 = { type: "u32" } as const satisfies FieldLayout;
export const f32 = { type: "f32" } as const satisfies FieldLayout;

/** An array field. */
export function f32Array<Length extends number>(length: Length) {
  return { type: "f32", length } as const satisfies FieldLayout;
}

/** A struct's layout: its fields in the order of the C struct, 4 bytes each number. */
export function defineStruct<const Fields extends StructFields>(fields: Fields): StructLayout<Fields> {
  let byteSize = 0;
  for (const field of Object.values<FieldLayout>(fields)) byteSize += 4 * (field.length ?? 1);
  return { fields, byteSize };
}

/** Reads the struct at `offset`; the result holds no reference to the view. */
export function readStruct<Fields extends StructFields>(
  layout: StructLayout<Fields>,
  view: DataView,
  offset: number,
): StructValue<Fields> {
  const value: Record<string, number | number[]> = {};
  let at = offset;
  for (const [name, field] of Object.entries<FieldLayout>(layout.fields)) {
    const numbers: number[] = [];
    for (let i = 0; i < (field.length ?? 1); i++, at += 4) {
      numbers.push(field.type === "u32" ? view.getUint32(at, true) : view.getFloat32(at, true));
    }
    value[name] = field.length === undefined ? (numbers[0] ?? 0) : numbers;
  }
  return value as StructValue<Fields>;
}

/** Writes the fields that `value` has and leaves the others as they are (a `*_default` maker has set them). */
export function writeStruct<Fields extends StructFields>(
  layout: StructLayout<Fields>,
  view: DataView,
  offset: number,
  value: Partial<StructValue<Fields>>,
): void {
  let at = offset;
  for (const [name, field] of Object.entries<FieldLayout>(layout.fields)) {
    const length = field.length ?? 1;
    // What is there and undefined is a name without a number, and no default.
    if (name in value) {
      const given = value[name as keyof Fields] as number | readonly number[];
      const numbers = typeof given === "number" ? [given] : given;
      if (numbers.length !== length) {
        throw new RangeError(`${name} takes ${length} number(s), ${numbers.length} given`);
      }
      numbers.forEach((number, i) => {
        if (field.type === "u32") view.setUint32(at + 4 * i, number, true);
        else view.setFloat32(at + 4 * i, number, true);
      });
    }
    at += 4 * length;
  }
}
