/** Parts of the model that take no paint of their own: what lies on one of them alone is seen nowhere, which is said. */
import type { MaterialInfo } from "../../engine/engine-api.ts";
import type { Strings } from "../strings.ts";
import { takesPaintUnwrapped } from "./bare-model-error.ts";
import type { NoticeBoard } from "./notice-board.ts";
import type { Tasks } from "./tasks.ts";
import type { UnwrapCommand } from "./unwrap-command.ts";

/** Why a material takes no paint, by its refusal's code, in a few words. */
export function whyNotPaintable(code: string, { target: { whyNot } }: Strings): string {
  return Object.hasOwn(whyNot, code) ? whyNot[code as keyof typeof whyNot] : whyNot.other;
}

export interface BarePartsParts {
  readonly board: NoticeBoard;
  readonly tasks: Tasks;
  /** Null where models are not unwrapped. */
  readonly unwrapping: UnwrapCommand | null;
}

export class BareParts {
  readonly #parts: BarePartsParts;

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

  #offer(told: { readonly title: string; readonly message: string }, unwrap: () => Promise<unknown>): void {
    const { board, tasks } = this.#parts;
    const { notices, errors } = board.strings;
    const run = (): void => void tasks.quietly(unwrap());
    board.info({ ...told, hint: errors.bareModelHint, action: { label: notices.unwrapPart, run } });
  }
}
