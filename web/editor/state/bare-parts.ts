/** Parts of the model that take no paint of their own: what lies on one of them is seen nowhere, or on others too, which is said. */
import type { MaterialInfo } from "../../engine/engine-api.ts";
import type { Strings } from "../strings.ts";
import { takesPaintUnwrapped } from "./bare-model-error.ts";
import type { ModelRef } from "./design-state.ts";
import type { EditorState } from "./editor-state.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Store } from "./store.ts";
import type { Tasks } from "./tasks.ts";
import { sharesTexels, type UnwrapCommand } from "./unwrap-command.ts";

/** Why a material takes no paint, by its refusal's code, in a few words. */
export function whyNotPaintable(code: string, { target: { whyNot } }: Strings): string {
  return Object.hasOwn(whyNot, code) ? whyNot[code as keyof typeof whyNot] : whyNot.other;
}

export interface BarePartsParts {
  readonly store: Store<EditorState>;
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  /** Null where models are not unwrapped. */
  readonly unwrapping: UnwrapCommand | null;
}

export class BareParts {
  readonly #parts: BarePartsParts;
  /** Models of which `tellTwins` has told. */
  readonly #told = new WeakSet<ModelRef>();

  constructor(parts: BarePartsParts) {
    this.#parts = parts;
  }

  /**
   * Says that nothing is painted on a part of that material, and offers to unwrap it where that helps; nothing where `material`
   * is null, or takes paint after all.
   */
  tell(material: MaterialInfo | null): void {
    if (!material?.refusal) return;
    const { board, unwrapping } = this.#parts;
    const { notices, errors, materialName } = board.strings;
    const { code } = material.refusal;
    const why = whyNotPaintable(code, board.strings);
    const told = {
      title: notices.barePart,
      message: notices.barePartWhy(materialName(material.index, material.name), why),
    };
    if (!takesPaintUnwrapped(material)) board.info(told);
    else if (unwrapping === null) board.info({ ...told, hint: errors.noUvsHint });
    else this.#offer(told, () => unwrapping.runForBare());
  }

  /** The same of a part that shows the texels of another one. */
  tellShared(): void {
    const { board, unwrapping } = this.#parts;
    const { notices } = board.strings;
    const told = { title: notices.barePart, message: notices.sharedPartWhy };
    if (unwrapping === null) board.info(told);
    else this.#offer(told, () => unwrapping.run());
  }

  /**
   * Says that what was painted on these materials is seen on other parts too, which who made the model may have wanted: once of
   * each model, and where parts can be told apart by an unwrapping.
   */
  tellTwins(materials: readonly number[]): void {
    const { store, board, tasks, unwrapping } = this.#parts;
    const { model, targets } = store.state;
    if (unwrapping === null || model === null || this.#told.has(model.ref)) return;
    const shown = materials.map((material) => targets.get(material));
    if (!shown.some((target) => target !== undefined && sharesTexels(target))) return;
    this.#told.add(model.ref);
    const { notices, target } = board.strings;
    const run = (): void => void tasks.quietly(unwrapping.run());
    board.info({ title: notices.twinParts, message: notices.twinPartsWhy, action: { label: target.unwrap, run } });
  }

  #offer(told: { readonly title: string; readonly message: string }, unwrap: () => Promise<unknown>): void {
    const { board, tasks } = this.#parts;
    const { notices, errors } = board.strings;
    const run = (): void => void tasks.quietly(unwrap());
    board.info({ ...told, hint: errors.bareModelHint, action: { label: notices.unwrapPart, run } });
  }
}
