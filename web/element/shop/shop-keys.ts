/** Keys inside the element. What has the focus comes first: a text field keeps every key, a choice its arrows. */

import { isPlaced } from "../../editor/document/design.ts";
import { bracketOf } from "../../editor/state/bracket-key.ts";
import { diagonalOf } from "../../editor/state/design-state.ts";
import { hasFittingLengths } from "../../editor/state/fitting-lengths.ts";
import { letterOf } from "../../editor/state/letter-key.ts";
import { scaledProjector, spunProjector } from "../../editor/state/projector-steps.ts";
import type { Desk } from "../desk/desk.ts";
import type { KeyStep } from "./key-report.ts";

/** Of the model's diagonal. */
const NUDGE_SHARE = 0.002;
const COARSE = 10;

/** True when the key was ours, and its default must not happen. */
export function handleKey(event: KeyboardEvent, desk: Desk, report: (step: KeyStep) => void): boolean {
  if (event.defaultPrevented || event.isComposing || event.altKey) return false;
  const [target] = event.composedPath();
  const typing =
    target instanceof HTMLTextAreaElement || (target instanceof HTMLInputElement && target.type !== "color");
  if (event.ctrlKey || event.metaKey) {
    // A choice has no undo of its own: the browser would take back letters of the field before it, which is no step.
    if (typing) return false;
    const letter = letterOf(event);
    if (letter !== "z" && letter !== "y") return false;
    void desk.step(letter === "y" || event.shiftKey ? 1 : -1);
    return true;
  }
  if (typing || target instanceof HTMLSelectElement) return false;
  const { selected } = desk;
  if (selected === undefined) return false;
  if (event.key === "Escape") return desk.select(null);
  if (event.key === "Delete" || event.key === "Backspace") return desk.remove(selected.id);
  if (!isPlaced(selected)) return false;
  // Arrows on a button belong to whoever walks over buttons with them.
  if (target instanceof HTMLButtonElement && event.key.startsWith("Arrow")) return false;
  const steps = event.shiftKey ? COARSE : 1;
  const { projector } = selected;
  const place = (kind: KeyStep["kind"], changed: typeof projector, right = 0, up = 0): true => {
    desk.place(selected.id, changed, true, kind);
    report({ kind, right, up });
    return true;
  };
  const step = NUDGE_SHARE * diagonalOf(desk.store.state.model) * steps;
  const nudge = (right: number, up: number): boolean =>
    desk.hands !== null && place("nudge", desk.hands.nudge(projector, right, up), right, up);
  const scale = (factor: number): true => {
    const scaled = scaledProjector(projector, factor);
    // A key that is held for long ends where a design's lengths do, and is ours still.
    return !hasFittingLengths(scaled) || place("scale", scaled);
  };
  const bracket = bracketOf(event);
  if (bracket !== null) return place("spin", spunProjector(projector, -bracket * steps));
  switch (event.key) {
    case "ArrowLeft":
      return nudge(-step, 0);
    case "ArrowRight":
      return nudge(step, 0);
    case "ArrowUp":
      return nudge(0, step);
    case "ArrowDown":
      return nudge(0, -step);
    case "+":
    case "=":
      return scale(1.02);
    case "-":
      return scale(1 / 1.02);
    default:
      return false;
  }
}
