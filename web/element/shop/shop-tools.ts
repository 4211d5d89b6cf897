/** What the shop mode loads when it is first touched, beside the view's hands: what puts things on the product and changes them. */
import type { nothing, TemplateResult } from "lit";
import type { DesignLayer } from "../../editor/document/design.ts";
import { PICTURES, pickFiles } from "../../editor/ui/file-picker.ts";
import { focusPressed } from "../../editor/ui/press-focus.ts";
import type { Desk } from "../desk/desk.ts";
import { addPicture } from "../desk/placing.ts";
import { Texts } from "../desk/texts.ts";
import type { DecalSource, PlaceOptions } from "../element-api.ts";
import type { KeyReport } from "./key-report.ts";
import { type FieldsHost, layerFields, sizeOf, turnOf } from "./layer-fields.ts";
import { handleKey } from "./shop-keys.ts";

export class ShopTools {
  readonly texts: Texts;
  readonly #desk: Desk;
  #report: Promise<KeyReport | null> | undefined;

  constructor(desk: Desk) {
    this.#desk = desk;
    this.texts = new Texts(desk);
    focusPressed(desk.viewer.element.getRootNode(), desk.signal);
  }

  addPicture(source: DecalSource, options?: PlaceOptions): Promise<string> {
    return addPicture(this.#desk, source, options);
  }

  /** Asks the user for files. */
  pickPictures(picked: (files: readonly File[]) => void): void {
    pickFiles({ accept: PICTURES }, (files) => picked(files.map(({ file }) => file)));
  }

  /** Puts files on, a single one where it was dropped (client pixels). One that cannot be used is told, and the others go on. */
  async addFiles(files: readonly File[], at: { readonly x: number; readonly y: number } | null = null): Promise<void> {
    const desk = this.#desk;
    const hit = at && (await desk.takeHands()).surfaceAtPointer(at.x, at.y);
    for (const file of files) {
      await addPicture(desk, file, undefined, files.length === 1 ? hit : null).catch(desk.hooks.failed);
    }
  }

  /** True when the key was ours, and its default must not happen. */
  key(event: KeyboardEvent): boolean {
    return handleKey(event, this.#desk, (step) => {
      this.#report ??= import("./key-report.ts").then(
        ({ KeyReport }) => new KeyReport(this.#desk, { sizeOf, turnOf }),
        () => null,
      );
      void this.#report.then((report) => report?.after(step));
    });
  }

  fields(host: Omit<FieldsHost, "texts">, layer: DesignLayer): TemplateResult | typeof nothing {
    return layerFields({ ...host, texts: this.texts }, layer);
  }
}
