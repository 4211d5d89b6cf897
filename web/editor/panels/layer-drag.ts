/**
 * Dragging rows of the layer list. A mouse or pen drags a row by any part of it; a finger, whose stroke scrolls the list, by
 * its grip, and a long press of it takes the row into the choice.
 */
import { takesBack } from "../../viewer/take-back-key.ts";
import { windowOf } from "../../viewer/window-of.ts";
import { dropAt, type LayerDrop, type LayerRow } from "../state/layer-rows.ts";

export interface LayerDragHost {
  readonly rows: readonly LayerRow[];
  /** What scrolls. */
  readonly list: HTMLElement | null;
  /** As high as all rows together, whose elements it holds as far as they are near. */
  readonly content: HTMLElement | null;
  /** Pixels a level of depth. */
  readonly indent: number;
  requestUpdate(): void;
  /** Ids that go along when that row is dragged. */
  dragged(id: string): readonly string[];
  move(ids: readonly string[], drop: LayerDrop): void;
  longPress(id: string): void;
}

/** Pixels before a press becomes a drag. */
const DRAG_START = 4;
const LONG_PRESS = 450;
/** Pixels from the list's ends from which on it scrolls, faster the further the pointer is past that. */
const SCROLL_EDGE = 24;
/** Of what the pointer is past it, each 60th of a second. */
const SCROLL_SHARE = 0.4;
/** A frame that took longer scrolls no further: one must see what goes by. */
const LONGEST_FRAME_MS = 50;

type Pointer = Pick<PointerEvent, "clientX" | "clientY">;

export class LayerDrag {
  readonly #host: LayerDragHost;
  /** Where the newest press is followed: that which the row is seen in. */
  #window: Window = window;
  #press: { readonly id: string; readonly pointer: number; readonly x: number; readonly y: number } | null = null;
  #ids: readonly string[] = [];
  #drop: LayerDrop | null = null;
  #pointer: Pointer | null = null;
  /** The frame in which the list scrolls on; 0: none is asked for. */
  #frame = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #swallow = false;

  constructor(host: LayerDragHost) {
    this.#host = host;
  }

  /** Ids of the layers that are being dragged. */
  get ids(): readonly string[] {
    return this.#ids;
  }

  /** Id of the layer whose row is being pressed. */
  get pressed(): string | undefined {
    return this.#press?.id;
  }

  /** Where they would go now. */
  get drop(): LayerDrop | null {
    return this.#drop;
  }

  /** True once after a drag or a long press: the click that follows is not one. */
  takeClick(): boolean {
    const swallowed = this.#swallow;
    this.#swallow = false;
    return swallowed;
  }

  press(event: PointerEvent, id: string, byGrip: boolean): void {
    this.#swallow = false;
    if (event.button !== 0 || this.#press) return;
    this.#window = windowOf(event.target as Element);
    const touch = event.pointerType === "touch";
    if (touch && !byGrip) {
      this.#waitForLongPress(event, id);
      return;
    }
    this.#press = { id, pointer: event.pointerId, x: event.clientX, y: event.clientY };
    this.#window.addEventListener("pointermove", this.#move);
    this.#window.addEventListener("pointerup", this.#release);
    this.#window.addEventListener("pointercancel", this.#cancel);
    this.#window.addEventListener("keydown", this.#key, { capture: true });
  }

  /** Ends a drag without its effect, and takes back what was listened for. */
  readonly #cancel = (): void => {
    this.#end();
  };

  #waitForLongPress({ clientX, clientY, pointerId }: PointerEvent, id: string): void {
    const seenIn = this.#window;
    const types = ["pointermove", "pointerup", "pointercancel"] as const;
    const stop = (): void => {
      clearTimeout(this.#timer);
      for (const type of types) seenIn.removeEventListener(type, follow);
    };
    const follow = (event: PointerEvent): void => {
      const moved = Math.hypot(event.clientX - clientX, event.clientY - clientY) > 2 * DRAG_START;
      if (event.pointerId === pointerId && (event.type !== "pointermove" || moved)) stop();
    };
    for (const type of types) seenIn.addEventListener(type, follow);
    this.#timer = setTimeout(() => {
      stop();
      this.#swallow = true;
      this.#host.longPress(id);
    }, LONG_PRESS);
  }

  readonly #move = (event: PointerEvent): void => {
    const press = this.#press;
    if (!press || event.pointerId !== press.pointer) return;
    // It was let go where no release is told, as in a dialog that came between.
    if (event.buttons === 0) {
      this.#end();
      return;
    }
    if (this.#ids.length === 0) {
      if (Math.hypot(event.clientX - press.x, event.clientY - press.y) < DRAG_START) return;
      this.#ids = this.#host.dragged(press.id);
    }
    event.preventDefault();
    this.#pointer = event;
    this.#drop = this.#dropUnder(event);
    this.#host.requestUpdate();
    this.#scrollSoon();
  };

  readonly #release = (event: PointerEvent): void => {
    if (event.pointerId !== this.#press?.pointer) return;
    const ids = this.#ids;
    const drop = ids.length > 0 ? this.#dropUnder(event) : null;
    this.#swallow = ids.length > 0;
    this.#end();
    if (drop) this.#host.move(ids, drop);
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (this.#ids.length === 0) return;
    // The page does not hear of keys meanwhile: it would delete what is dragged, or take back the step before.
    event.stopPropagation();
    if (!takesBack(event)) return;
    event.preventDefault();
    this.#swallow = true;
    this.#end();
  };

  #end(): void {
    this.#press = null;
    this.#ids = [];
    this.#drop = null;
    this.#pointer = null;
    this.#window.cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#window.removeEventListener("pointermove", this.#move);
    this.#window.removeEventListener("pointerup", this.#release);
    this.#window.removeEventListener("pointercancel", this.#cancel);
    this.#window.removeEventListener("keydown", this.#key, { capture: true });
    this.#host.requestUpdate();
  }

  #scrollSoon(since = performance.now()): void {
    if (this.#frame !== 0 || this.#pastEdge() === 0) return;
    this.#frame = this.#window.requestAnimationFrame(() => {
      this.#frame = 0;
      this.#scroll(Math.min(LONGEST_FRAME_MS, performance.now() - since));
    });
  }

  /** While the pointer rests at an end of the list, the rows go on under it. */
  #scroll(milliseconds: number): void {
    const { list } = this.#host;
    if (!list || !this.#pointer) return;
    const before = list.scrollTop;
    // A whole pixel at least: browsers may take no less.
    const by = this.#pastEdge() * SCROLL_SHARE * (milliseconds / 1000) * 60;
    list.scrollTop += Math.sign(by) * Math.ceil(Math.abs(by));
    if (list.scrollTop === before) return;
    this.#drop = this.#dropUnder(this.#pointer);
    this.#host.requestUpdate();
    this.#scrollSoon();
  }

  /** Pixels; less than 0 above. */
  #pastEdge(): number {
    const { list } = this.#host;
    if (!list || !this.#pointer) return 0;
    const { clientY } = this.#pointer;
    const { top, bottom } = list.getBoundingClientRect();
    return Math.min(0, clientY - top - SCROLL_EDGE) + Math.max(0, clientY - bottom + SCROLL_EDGE);
  }

  /** Null where the layers cannot go: into one of themselves. */
  #dropUnder({ clientX, clientY }: Pointer): LayerDrop | null {
    const { list, content, rows, indent } = this.#host;
    if (!list || !content || rows.length === 0) return null;
    const { top, height } = content.getBoundingClientRect();
    const down = (rows.length * Math.max(0, clientY - top)) / height;
    const row = Math.min(rows.length, Math.floor(down));
    const share = row < rows.length ? down - row : 0;
    const { left, right } = list.getBoundingClientRect();
    const inward = getComputedStyle(list).direction === "rtl" ? right - clientX : clientX - left;
    // The row's own head is as wide as a level or two: a pointer within it means the outermost.
    const depth = 1 + Math.max(0, Math.floor((inward - 2 * indent) / indent));
    const drop = dropAt(rows, row, share, depth);
    return this.#isInside(drop.parentId) ? null : drop;
  }

  #isInside(parentId: string | null): boolean {
    const parents = new Map(this.#host.rows.map(({ layer, parentId: above }) => [layer.id, above]));
    for (let id = parentId; id !== null; id = parents.get(id) ?? null) if (this.#ids.includes(id)) return true;
    return false;
  }
}
