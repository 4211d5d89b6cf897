/** The engine's core knows no files, nor does JavaScript: what they refuse about a model is told with the model's name. */
import { constants } from "node:buffer";
import { TexelcastError } from "../web/core/texelcast-error.ts";

const HINT = "Unwrap the model with “texelcast unwrap”, or in a 3D program.";

/**
 * What `work` gives; "bad-uvs" that says of no file which it is rejects with this one's name and what to do, and a text that no string
 * of JavaScript's holds as "bad-container".
 */
export async function namingModel<Result>(name: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (thrown) {
    if (thrown instanceof Error && "code" in thrown && thrown.code === "ERR_STRING_TOO_LONG")
      throw tooLong(name, thrown);
    if (!(thrown instanceof TexelcastError) || thrown.code !== "bad-uvs" || thrown.subject !== undefined) throw thrown;
    throw new TexelcastError(thrown.code, thrown.message, {
      hint: HINT,
      ...thrown.toJSON(),
      subject: name,
      cause: thrown,
    });
  }
}

function tooLong(name: string, cause: Error): TexelcastError {
  const most = constants.MAX_STRING_LENGTH;
  return new TexelcastError(
    "bad-container",
    `“${name}” is not a sound glTF file: its JSON is longer than the ${most} letters that can be read.`,
    { subject: name, hint: "Save it as .glb, whose buffers and pictures are no part of the JSON.", cause },
  );
}
