/** Texts that lack characters are drawn, with a sign in their places: whoever writes a picture of them must know. */
import type { EngineLayer } from "../web/engine/engine-api.ts";
import type { EngineHost } from "../web/engine/engine-host.ts";
import { allPicturesOf } from "../web/engine/layer-picture.ts";
import { printable } from "./terminal-text.ts";

/** A line for each text in the layers with characters that no font has; "" where there is none. */
export async function missingCharacters(engine: EngineHost, layers: readonly EngineLayer[]): Promise<string> {
  const lines: string[] = [];
  for (const picture of allPicturesOf(layers)) {
    if (typeof picture === "string") continue;
    const { missing } = await engine.measureText(picture);
    if (missing.length === 0) continue;
    const text = JSON.stringify(picture.text.length > 60 ? `${picture.text.slice(0, 59)}…` : picture.text);
    lines.push(`texelcast: no font has ${printable(missing.join(" "))}, in the text ${printable(text)}\n`);
  }
  return lines.join("");
}
