/**
 * The other end of a pen: pressed on a view it is the eraser's, whatever tool is chosen, and that one is chosen again once it
 * is lifted.
 */
import type { ToolId } from "./tool.ts";
import type { Toolbox } from "./toolbox.ts";

/** What browsers tell of that end; no tool and no camera takes it. */
const ERASER_BUTTON = 5;

/** Listens on what is around the views, before them. */
export function watchEraserEnd(
  around: EventTarget,
  views: readonly HTMLElement[],
  tools: Pick<Toolbox, "active" | "choose">,
  signal: AbortSignal,
): void {
  let pen: number | null = null;
  let before: ToolId | undefined;
  const erases = (): boolean => tools.active?.id === "eraser";
  const press = (event: PointerEvent): void => {
    const path = event.composedPath();
    if (event.button !== ERASER_BUTTON || pen !== null || !views.some((view) => path.includes(view))) return;
    before = tools.active?.id;
    tools.choose("eraser");
    // In a design that is only looked at.
    if (!erases()) return;
    pen = event.pointerId;
    event.stopImmediatePropagation();
    path[0]?.dispatchEvent(asPress(event));
  };
  const lift = ({ pointerId }: PointerEvent): void => {
    if (pointerId !== pen) return;
    pen = null;
    // By a key another one may have been chosen meanwhile.
    if (before !== undefined && erases()) tools.choose(before);
  };
  const listen = (type: string, act: (event: PointerEvent) => void, capture: boolean): void =>
    around.addEventListener(type, (event) => act(event as PointerEvent), { capture, signal });
  listen("pointerdown", press, true);
  // What a tool has taken it keeps to itself, but for this, which comes last.
  listen("lostpointercapture", lift, true);
  listen("pointerup", lift, false);
  listen("pointercancel", lift, false);
}

function asPress(event: PointerEvent): PointerEvent {
  const { bubbles, cancelable, composed, pointerId, pointerType, isPrimary, pressure } = event;
  const { clientX, clientY, shiftKey, altKey, ctrlKey, metaKey } = event;
  return new PointerEvent("pointerdown", {
    ...{ bubbles, cancelable, composed, pointerId, pointerType, isPrimary, pressure },
    ...{ clientX, clientY, shiftKey, altKey, ctrlKey, metaKey, button: 0, buttons: 1 },
  });
}
