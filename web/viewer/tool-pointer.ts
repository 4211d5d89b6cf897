/**
 * Pointer events of a view for the tool that is chosen. Listens before the view's own input and keeps from it what the
 * tool takes; all else (background, other buttons, a second finger) stays the camera's.
 */
import { ClientCorner } from "./client-corner.ts";
import { FrameTask } from "./frame-task.ts";
import type { ToolInput, ToolSample, ToolView } from "./tool-input.ts";

export class ToolPointer {
  readonly #root: HTMLElement;
  readonly #view: ToolView;
  readonly #corner: ClientCorner;
  readonly #abort = new AbortController();
  /** What a tool remembers of the screen lies elsewhere on the surface in a view of another size: its gesture ends there. */
  readonly #size = new ResizeObserver(() => this.#end("lost"));
  readonly #hoverTask = new FrameTask(() => this.#hoverNow());
  #tool: ToolInput | null = null;
  #taken: PointerEvent | null = null;
  #hoverEvent: PointerEvent | null = null;
  #spaceHeld = false;
  /** Fingers on the view, the tool's and the camera's. */
  readonly #fingers = new Set<number>();
  /** A press that is handed to the camera after all comes by here a second time. */
  #passOn: Event | null = null;

  constructor(root: HTMLElement, view: ToolView) {
    this.#root = root;
    this.#view = view;
    this.#corner = new ClientCorner(root);
    this.#size.observe(root);
    const early = { capture: true, signal: this.#abort.signal };
    root.addEventListener("pointerdown", (event) => this.#onDown(event), early);
    root.addEventListener("pointermove", (event) => this.#onMove(event), early);
    root.addEventListener("pointerup", (event) => this.#onUp(event), early);
    root.addEventListener("pointercancel", (event) => this.#onLost(event), early);
    root.addEventListener("lostpointercapture", (event) => this.#onLost(event), early);
    root.addEventListener("pointerleave", () => this.#onLeave(), early);
    root.addEventListener("dblclick", (event) => this.#tool && event.stopImmediatePropagation(), early);
    window.addEventListener("keydown", (event) => this.#onKey(event, true), early);
    window.addEventListener("keyup", (event) => this.#onKey(event, false), early);
    window.addEventListener("blur", () => this.#setSpace(false), early);
  }

  get tool(): ToolInput | null {
    return this.#tool;
  }

  set tool(tool: ToolInput | null) {
    if (tool === this.#tool) return;
    this.#end("lost");
    this.#tool?.hover(null);
    this.#tool = tool;
    this.#showCursor();
  }

  dispose(): void {
    this.#abort.abort();
    this.#corner.dispose();
    this.#size.disconnect();
    this.#hoverTask.cancel();
  }

  #onDown(event: PointerEvent): void {
    if (event === this.#passOn) return;
    const isFinger = event.pointerType === "touch";
    const others = isFinger && this.#fingers.size > 0;
    if (isFinger) this.#fingers.add(event.pointerId);
    if (this.#tool === null) return;
    // The hand lies down before its pen does, and stays there between two strokes.
    if (event.pointerType === "pen" && this.#taken?.pointerType === "touch") this.#end("pinch");
    if (this.#taken !== null) {
      this.#onSecondPointer(this.#taken, event);
      return;
    }
    if (event.button !== 0 || this.#spaceHeld || others) return;
    if (!this.#tool.down(this.#sampleOf(event))) return;
    event.stopImmediatePropagation();
    this.#root.setPointerCapture(event.pointerId);
    this.#root.focus({ preventScroll: true });
    this.#taken = event;
  }

  /** Two fingers are the camera's: the first is handed over. A palm beside a pen is nobody's. */
  #onSecondPointer(first: PointerEvent, event: PointerEvent): void {
    const pinches = first.pointerType === "touch" && event.pointerType === "touch";
    if (!pinches || first.pointerId === event.pointerId) {
      event.stopImmediatePropagation();
      return;
    }
    this.#end("pinch");
    const again = new PointerEvent("pointerdown", first);
    this.#passOn = again;
    this.#root.dispatchEvent(again);
    this.#passOn = null;
  }

  #onMove(event: PointerEvent): void {
    if (this.#tool === null) return;
    if (this.#taken?.pointerId === event.pointerId) {
      event.stopImmediatePropagation();
      const parts = event.getCoalescedEvents?.() ?? [];
      this.#tool.move((parts.length > 0 ? parts : [event]).map((part) => this.#sampleOf(part, event)));
    } else if (this.#taken !== null) {
      event.stopImmediatePropagation();
    } else if (event.buttons === 0 && event.pointerType !== "touch") {
      this.#hoverEvent = event;
      this.#hoverTask.request();
    }
  }

  #onUp(event: PointerEvent): void {
    this.#fingers.delete(event.pointerId);
    if (this.#taken?.pointerId !== event.pointerId) return;
    event.stopImmediatePropagation();
    this.#taken = null;
    this.#tool?.up(this.#sampleOf(event));
  }

  #onLost(event: PointerEvent): void {
    this.#fingers.delete(event.pointerId);
    if (this.#taken?.pointerId === event.pointerId) this.#end("lost");
  }

  #onLeave(): void {
    this.#hoverEvent = null;
    this.#hoverTask.cancel();
    if (this.#taken === null) this.#tool?.hover(null);
  }

  #onKey(event: KeyboardEvent, down: boolean): void {
    if (event.code === "Space") this.#setSpace(down);
  }

  #setSpace(held: boolean): void {
    this.#spaceHeld = held;
    this.#showCursor();
  }

  /** The tool's cursor gives way to the camera's hand. */
  #showCursor(): void {
    this.#root.style.cursor = this.#spaceHeld ? "" : (this.#tool?.cursor ?? "");
  }

  #end(reason: "lost" | "pinch"): void {
    if (this.#taken === null) return;
    this.#taken = null;
    this.#tool?.interrupted(reason);
  }

  #hoverNow(): void {
    const event = this.#hoverEvent;
    if (event !== null && this.#taken === null) this.#tool?.hover(this.#sampleOf(event));
  }

  /** Coalesced events lack the keys of the event that brought them in some browsers. */
  #sampleOf(event: PointerEvent, keys: PointerEvent = event): ToolSample {
    const at = this.#corner.pointOf(event.clientX, event.clientY);
    const view = this.#view;
    return {
      view,
      at,
      hit: view.hitAt(at),
      pressure: event.pointerType === "pen" && event.buttons !== 0 ? event.pressure : 1,
      shift: keys.shiftKey,
      alt: keys.altKey,
      ctrl: keys.ctrlKey || keys.metaKey,
      time: event.timeStamp,
    };
  }
}
