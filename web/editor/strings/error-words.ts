/** Errors as their users read them. The engine and the readers of files speak English; each language puts them into its words. */
import type { TexelcastErrorJson } from "../../core/texelcast-error.ts";

export interface ErrorWords {
  /** What is wrong, a whole sentence. */
  readonly message: string;
  /** What to do about it; "" where there is nothing to say. */
  readonly hint: string;
  /** What whoever looks into the file needs, as its reader said it, in English; left out where `message` says it all. */
  readonly exact?: string;
}

/** The error's own words. */
export const ownWords = ({ message, hint = "" }: TexelcastErrorJson): ErrorWords => ({ message, hint });
