/**
 * `texelcast`: what a page, a server and a test share. Importing it has no side effects and needs no browser: the element's
 * name, the one error type, and all types of the element. `texelcast/define` registers the element.
 */
export { TexelcastError, type TexelcastErrorDetails } from "../core/texelcast-error.ts";
export * from "../element/element-api.ts";
