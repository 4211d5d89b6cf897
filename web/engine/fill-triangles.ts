/** A fill's parts as the material's triangles. */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { EngineParts } from "./engine-api.ts";
import { chartsOf } from "./uv-charts.ts";

/** One material's triangles and charts, looked at when first asked for. */
export class FillTriangles {
  readonly #readUvs: () => Float32Array;
  readonly #model: string;
  #count: number | null = null;
  #charts: Uint32Array | null = null;

  /** `readUvs`: six numbers a triangle (`Engine.uvTriangles`); `model`: its name, for errors. */
  constructor(readUvs: () => Float32Array, model: string) {
    this.#readUvs = readUvs;
    this.#model = model;
  }

  /** Ascending. @throws TexelcastError "bad-argument" for a triangle that the material does not have. */
  of(parts: EngineParts): Uint32Array {
    const named = parts.kind === "charts" ? parts.charts : parts.faces;
    const charts = parts.kind === "charts" ? this.#chartsOf() : null;
    this.#check(parts.kind, named);
    if (charts === null) return Uint32Array.from(new Set(named)).sort();
    const chosen = new Set(named.map((triangle) => charts[triangle]));
    return Uint32Array.from(charts.keys()).filter((triangle) => chosen.has(charts[triangle]));
  }

  #chartsOf(): Uint32Array {
    if (this.#charts === null) {
      this.#charts = chartsOf(this.#readUvs());
      this.#count = this.#charts.length;
    }
    return this.#charts;
  }

  #check(kind: EngineParts["kind"], named: readonly number[]): void {
    this.#count ??= this.#readUvs().length / 6;
    const at = named.findIndex(
      (triangle) => !Number.isInteger(triangle) || triangle < 0 || triangle >= Number(this.#count),
    );
    if (at < 0) return;
    const field = `parts.${kind}[${at}]`;
    const message = `“${field}” is ${named[at]}, but the material has ${this.#count} triangles, counted from 0.`;
    throw new TexelcastError("bad-argument", message, {
      subject: this.#model,
      field,
      value: String(named[at]),
      hint: "The fill was made for another model, or for another material: choose its parts anew.",
      reason: "other-model",
    });
  }
}
