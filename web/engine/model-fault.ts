/** Why a model's file cannot be used, as its owner can understand it. Loaded when one was refused. */
import { TexelcastError } from "../core/texelcast-error.ts";
import { gltfFault } from "./gltf-fault.ts";
import { type JsonObject, listOf, REPAIR, textAt } from "./gltf-json.ts";
import { isDataUri } from "./gltf-resources.ts";
import { namedPlace } from "./named-place.ts";

/** What the core says of a model that some member of its file may be the reason of. */
const OF_THE_FILE: readonly string[] = ["bad-model", "no-triangles"];

/**
 * The core knows bytes, not files: where no member of the file's JSON is at fault, this puts the model's name in front of what it
 * says, and what to do behind it.
 */
export function modelFault(error: unknown, json: JsonObject, name: string): unknown {
  if (!(error instanceof TexelcastError) || error.code === "engine-crashed") return error;
  const found = OF_THE_FILE.includes(error.code) ? gltfFault(json, name) : null;
  if (found !== null) return found;
  return new TexelcastError(error.code, `“${name}”: ${error.message}`, {
    subject: name,
    ...(error.code === "unsupported-model" ? requiredIn(error.message, json) : namedPlace(error.message, json)),
    ...(error.field !== undefined && { field: error.field }),
    ...(error.value !== undefined && { value: error.value }),
    hint: error.hint ?? (error.code === "out-of-budget" ? "Simplify the model." : REPAIR),
    ...(error.reason !== undefined && { reason: error.reason }),
    cause: error,
  });
}

/** Which of the required extensions it is that the core names. */
function requiredIn(message: string, { extensionsRequired }: JsonObject): { field: string; value: string } | undefined {
  if (!Array.isArray(extensionsRequired)) return undefined;
  const at = extensionsRequired.findIndex((name) => message.includes(`extension ${name};`));
  return at < 0 ? undefined : { field: `extensionsRequired[${at}]`, value: String(extensionsRequired[at]) };
}

/** For a picture of the file that cannot be decoded: `error`, with the image that it is. */
export function pictureFault(error: unknown, json: JsonObject, index: number, name: string): unknown {
  if (!(error instanceof TexelcastError) || error.code !== "bad-picture") return error;
  const image = listOf(json, "images", name)[index];
  const uri = textAt(image, "uri");
  const value = uri !== undefined && !isDataUri(uri) ? uri : textAt(image, "name") || textAt(image, "mimeType");
  return new TexelcastError(error.code, error.message, {
    ...error.toJSON(),
    ...{ field: `images[${index}]`, value: value || "(unnamed)", hint: error.hint ?? REPAIR },
    cause: error.cause,
  });
}

/** For a model that the engine has read, and a viewer cannot; `cause` is what that one said. */
export function notShown(json: JsonObject, name: string, cause: unknown): TexelcastError {
  return (
    gltfFault(json, name) ??
    new TexelcastError("bad-model", `“${name}” can be read, but not shown.`, { subject: name, hint: REPAIR, cause })
  );
}
