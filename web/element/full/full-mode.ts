import type { Mode, ModeHost } from "../mode.ts";

export function openFull(_host: ModeHost): Mode {
  throw new Error("not yet");
}
