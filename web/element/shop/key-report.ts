/**
 * What keys do to what is chosen, told to who does not see it once they rest: a held one would be heard long after it is let go.
 * Loaded with the first of them.
 */
import { isPlaced } from "../../editor/document/design.ts";
import type { Projector } from "../../engine/engine-api.ts";
import type { Desk } from "../desk/desk.ts";

/** How a field of the panel reads it, which it is told by. */
export interface Figures {
  /** Metres; null where it has no size of lengths. */
  readonly sizeOf: (projector: Projector) => { readonly width: number; readonly height: number } | null;
  /** Degrees. */
  readonly turnOf: (projector: Projector) => number;
}

export interface KeyStep {
  readonly kind: "nudge" | "spin" | "scale";
  /** As the view shows it, metres. */
  readonly right: number;
  readonly up: number;
}

/** Milliseconds without another key. */
const REST = 500;
/** Left, right, down, up. */
const WAYS = {
  en: ["to the left", "to the right", "down", "up"],
  de: ["nach links", "nach rechts", "nach unten", "nach oben"],
} as const;

export class KeyReport {
  readonly #desk: Desk;
  readonly #figures: Figures;
  #timer: ReturnType<typeof setTimeout> | undefined;
  /** Since what was told last: of the layer, metres. */
  #moved: { readonly id: string; right: number; up: number } | null = null;

  constructor(desk: Desk, figures: Figures) {
    this.#desk = desk;
    this.#figures = figures;
  }

  /** A step was taken with what is chosen. */
  after({ kind, right, up }: KeyStep): void {
    const id = this.#desk.selected?.id ?? "";
    if (this.#moved?.id !== id) this.#moved = { id, right: 0, up: 0 };
    this.#moved.right += right;
    this.#moved.up += up;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#tell(kind), REST);
  }

  #tell(kind: KeyStep["kind"]): void {
    const { selected, hooks, closed } = this.#desk;
    const moved = this.#moved;
    this.#moved = null;
    if (closed || !moved || selected?.id !== moved.id) return;
    if (!isPlaced(selected)) return;
    const told = kind === "nudge" ? this.#way(moved.right, moved.up) : this.#look(kind, selected.projector);
    if (told.length > 0) hooks.announce(told.join(", "));
  }

  #way(right: number, up: number): string[] {
    const { language, own } = this.#desk.settings.words;
    const ways = own?.ways ?? WAYS[language];
    return [
      ...(right === 0 ? [] : [`${this.#length(Math.abs(right))} ${ways[right < 0 ? 0 : 1]}`]),
      ...(up === 0 ? [] : [`${this.#length(Math.abs(up))} ${ways[up < 0 ? 2 : 3]}`]),
    ];
  }

  #look(kind: "spin" | "scale", projector: Projector): string[] {
    const { words } = this.#desk.settings;
    if (kind === "spin") return [`${words.turn} ${this.#number(this.#figures.turnOf(projector))}${words.degrees}`];
    const size = this.#figures.sizeOf(projector);
    if (size === null) return [];
    return [`${words.width} ${this.#length(size.width)}`, `${words.height} ${this.#length(size.height)}`];
  }

  #length(metres: number): string {
    const { settings, zones } = this.#desk;
    return `${this.#number(metres * (zones?.printScale ?? 1) * 100)} ${settings.words.centimetres}`;
  }

  #number(value: number): string {
    const { lang } = this.#desk.settings.words;
    return (Math.round(value * 10) / 10 + 0).toLocaleString(lang, { minimumFractionDigits: 1 });
  }
}
