/** What keys do to the chosen decal on the model, told to who does not see it: where it is by then, once the keys rest. */
import type { Projector } from "../../engine/engine-api.ts";
import type { PlacedLayer } from "../document/design.ts";
import type { Strings } from "../strings.ts";
import { type LengthUnit, unitFor } from "../tools/length-unit.ts";
import { diagonalOf } from "./design-state.ts";
import type { EditorState } from "./editor-state.ts";
import type { NoticeBoard } from "./notice-board.ts";
import { orientationOf } from "./rotation.ts";
import type { Store } from "./store.ts";

export type StepKind = "nudge" | "spin" | "scale";

/** Milliseconds without another key. A held one would else be heard long after it is let go. */
const REST = 500;

export class StepReport {
  readonly #board: NoticeBoard;
  readonly #store: Store<EditorState>;
  readonly #selected: () => PlacedLayer | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(board: NoticeBoard, store: Store<EditorState>, selected: () => PlacedLayer | undefined) {
    this.#board = board;
    this.#store = store;
    this.#selected = selected;
  }

  /** A step was taken with what is chosen now. */
  after(kind: StepKind): void {
    const id = this.#selected()?.id;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      const layer = this.#selected();
      // Of a group, or of what is no longer chosen, no single place could be told.
      if (layer === undefined || layer.id !== id) return;
      const unit = unitFor(diagonalOf(this.#store.state.model));
      this.#board.announce(reported(kind, layer.projector, unit, this.#board.strings));
    }, REST);
  }
}

function reported(
  kind: StepKind,
  projector: Projector,
  { symbol, perMetre }: LengthUnit,
  { properties: words, numbers }: Pick<Strings, "properties" | "numbers">,
): string {
  const { hundredths, tenths } = numbers;
  const length = (metres: number): string => hundredths(metres * perMetre);
  const angle = (degrees: number): string => `${tenths(degrees)}${words.degrees}`;
  if (projector.kind === "uv") {
    const [u, v] = projector.center.map(hundredths);
    const [width, height] = projector.size.map(hundredths);
    if (kind === "nudge") return `${words.stampCenter} U ${u}, V ${v}`;
    return kind === "spin" ? `${words.angle} ${angle(projector.angle)}` : `${words.size} ${width} × ${height}`;
  }
  if (kind === "nudge") {
    const [x, y, z] = projector.position.map(length);
    return `${words.position} X ${x}, Y ${y}, Z ${z} ${symbol}`;
  }
  if (kind === "spin") return `${words.turns.spin} ${angle(orientationOf(projector.rotation).spin)}`;
  switch (projector.kind) {
    case "planar":
      return `${words.size} ${length(projector.size[0])} × ${length(projector.size[1])} ${symbol}`;
    case "perspective":
      return `${words.fov} ${angle(projector.fov)}`;
    case "cylindrical":
      return `${words.arc} ${angle(projector.arc)}, ${words.labelHeight} ${length(projector.height)} ${symbol}`;
  }
}
