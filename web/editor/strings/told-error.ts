import { TexelcastError } from "../../core/texelcast-error.ts";

/** An error that the editor made with words of its own: it is in its user's language, and nothing translates it again. */
export class ToldError extends TexelcastError {}
