/** Changes pictures inside a GLB's BIN chunk, and the buffer views that say where everything lies. */
import { indexAt, type JsonObject, listForWriting, listOf } from "./gltf-json.ts";
import { bufferPlaces } from "./gltf-packer.ts";
import { GrowingBinary } from "./growing-binary.ts";

/** Bytes behind a picture that is cut out move by a multiple of this, so that every accessor stays aligned. */
const ALIGNMENT = 16;

export class BinaryEditor {
  readonly #json: JsonObject;
  readonly #name: string;
  readonly #binary: GrowingBinary;

  /** `json` is changed in place; `binary` is only read. */
  constructor(json: JsonObject, binary: Uint8Array | null, name: string) {
    this.#json = json;
    this.#name = name;
    this.#binary = new GrowingBinary(binary);
  }

  /** Adds a picture and returns its index in "images". */
  addImage(png: Uint8Array): number {
    const images = listForWriting(this.#json, "images", this.#name);
    images.push({ bufferView: this.#addView(png), mimeType: "image/png" });
    return images.length - 1;
  }

  /** Gives image `index` another picture. Its old bytes go, unless something else lies on them. */
  replaceImage(index: number, png: Uint8Array): void {
    const image = listOf(this.#json, "images", this.#name)[index] ?? {};
    const view = this.#ownView(index);
    if (view === undefined) image.bufferView = this.#addView(png);
    else {
      this.#cut(view);
      view.byteOffset = this.#binary.append(png, ALIGNMENT);
      view.byteLength = png.length;
    }
    image.mimeType = "image/png";
  }

  /** The BIN with all changes; "buffers" says its length. */
  finish(): Uint8Array | null {
    return this.#binary.length === 0 ? null : this.#binary.finish(this.#json, this.#name);
  }

  #addView(bytes: Uint8Array): number {
    const views = listForWriting(this.#json, "bufferViews", this.#name);
    views.push({ buffer: 0, byteOffset: this.#binary.append(bytes, ALIGNMENT), byteLength: bytes.length });
    return views.length - 1;
  }

  /** The buffer view that image `index` has to itself; undefined when another image or an accessor shares it. */
  #ownView(index: number): JsonObject | undefined {
    const images = listOf(this.#json, "images", this.#name);
    const view = indexAt(images[index], "bufferView");
    const sharers = [...images, ...listOf(this.#json, "accessors", this.#name)];
    if (view === undefined || sharers.filter((sharer) => sharer.bufferView === view).length !== 1) return undefined;
    return listOf(this.#json, "bufferViews", this.#name)[view];
  }

  /** Takes a view's bytes out and moves what lies behind them up, if they are old bytes that no other place touches. */
  #cut(view: JsonObject): void {
    const places = bufferPlaces(this.#json, this.#name).filter(
      (place) => place !== view && indexAt(place, "buffer") === 0,
    );
    const start = indexAt(view, "byteOffset") ?? 0;
    const end = start + (indexAt(view, "byteLength") ?? 0);
    const overlapped = places.some((place) => {
      const from = indexAt(place, "byteOffset") ?? 0;
      return from < end && from + (indexAt(place, "byteLength") ?? 0) > start;
    });
    if (overlapped || indexAt(view, "buffer") !== 0 || end > this.#binary.old.length) return;
    const length = Math.floor((end - start) / ALIGNMENT) * ALIGNMENT;
    this.#binary.cut(start, length);
    for (const place of places) {
      const offset = indexAt(place, "byteOffset") ?? 0;
      if (offset >= end) place.byteOffset = offset - length;
    }
  }
}
