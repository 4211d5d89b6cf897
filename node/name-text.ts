/** The engine knows a text by its letters alone: what it refuses of one is told with the design's file and the layer's field. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { formatPath } from "../web/editor/document/design-problem.ts";
import { type Design, walkLayers } from "../web/editor/document/index.ts";
import { cleanText } from "../web/engine/text-runs.ts";

/** What `work` gives; "too-many-points" rejects with the first text of the design that has these letters. */
export async function namingText<Result>(design: Design, file: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (thrown) {
    if (!(thrown instanceof TexelcastError) || thrown.reason !== "too-many-points") throw thrown;
    // A long text comes as its first letters and a sign for the rest.
    const [letters, isWhole] = [thrown.subject?.replace(/…$/, "") ?? "", !thrown.subject?.endsWith("…")];
    for (const { layer, path, shown } of walkLayers(design)) {
      if (layer.type !== "text" || !shown) continue;
      const text = cleanText(layer.text);
      if (isWhole ? text !== letters : !text.startsWith(letters)) continue;
      const field = formatPath([...path, "text"]);
      throw new TexelcastError(thrown.code, `${field}: ${thrown.message.replace(/\.$/, "")}`, {
        ...thrown.toJSON(),
        subject: file,
        field,
        value: letters,
        cause: thrown,
      });
    }
    throw thrown;
  }
}
