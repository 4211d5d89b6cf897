/** The engine's core knows no files: what it refuses about a model is told with the model's name. */
import { TexelcastError } from "../web/core/texelcast-error.ts";

const HINT = "Unwrap the model with “texelcast unwrap”, or in a 3D program.";

/** What `work` gives; "bad-uvs" that says of no file which it is rejects with this one's name and what to do. */
export async function namingModel<Result>(name: string, work: Promise<Result>): Promise<Result> {
  try {
    return await work;
  } catch (thrown) {
    if (!(thrown instanceof TexelcastError) || thrown.code !== "bad-uvs" || thrown.subject !== undefined) throw thrown;
    throw new TexelcastError(thrown.code, thrown.message, {
      hint: HINT,
      ...thrown.toJSON(),
      subject: name,
      cause: thrown,
    });
  }
}
