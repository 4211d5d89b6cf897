/** `texelcast/embed`: the editor in an iframe of another origin, from the shop's side. */
export { TexelcastError, type TexelcastErrorDetails, type TexelcastErrorJson } from "../core/texelcast-error.ts";
export { mountTexelcast } from "../embed/frame.ts";
export type * from "../embed/frame-api.ts";
