/** The colour of the finished texture at a place of the surface. */

import type { SurfaceHit } from "../../viewer/viewer-api.ts";
import { ToldError } from "../strings/told-error.ts";
import type { ToolContext } from "./tool-context.ts";

export class PixelProbe {
  readonly #context: ToolContext;
  #request = 0;

  constructor(context: ToolContext) {
    this.#context = context;
  }

  /** Makes the colour at a place the one that is painted with; a newer question overtakes an older one. */
  pick(hit: SurfaceHit | null): void {
    if (hit === null) return;
    this.#request += 1;
    const request = this.#request;
    const { tools, board } = this.#context;
    this.colorAt(hit)
      .then((color) => {
        if (request !== this.#request || color === null) return;
        tools.useColor(color);
        board.announce(this.#context.board.strings.tools.picked(color));
      })
      .catch((thrown: unknown) => board.error(this.#context.board.strings.tools.couldNotPick, thrown));
  }

  /** "#rrggbb"; null where no target is open. Rejects as the engine does. */
  async colorAt({ material, uv }: Pick<SurfaceHit, "material" | "uv">): Promise<string | null> {
    const target = this.#context.store.state.targets.get(material);
    if (!target) return null;
    const x = Math.min(target.width - 1, Math.floor(uv[0] * target.width));
    const y = Math.min(target.height - 1, Math.floor(uv[1] * target.height));
    const [red, green, blue] = await this.#context.engine.readTexels(material, x, y, 1, 1);
    if (red === undefined || green === undefined || blue === undefined) {
      throw new ToldError("engine-crashed", this.#context.board.strings.tools.noTexel, {
        field: "uv",
        value: uv.join(", "),
      });
    }
    return hexOf(red, green, blue);
  }
}

export const hexOf = (...channels: readonly number[]): string =>
  `#${channels.map((channel) => channel.toString(16).padStart(2, "0")).join("")}`;
