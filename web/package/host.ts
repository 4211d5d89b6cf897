/** `texelcast/host`: for the editor's page inside the iframe, on an origin of one's own. */
export { TexelcastError, type TexelcastErrorDetails, type TexelcastErrorJson } from "../core/texelcast-error.ts";
export * from "../embed/host.ts";
