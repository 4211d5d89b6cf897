/** Errors as the command line tells them: on stderr, one line of what is wrong and one of what to do. */
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { EXIT_INTERNAL, exitCodeOf } from "./exit-codes.ts";
import { printable } from "./terminal-text.ts";

/** Writes the error and gives the exit code that it asks for. */
export function reportError(error: unknown): number {
  if (error instanceof TexelcastError) {
    // The engine's messages name the file themselves, for places that show the message alone.
    const isNamed = error.subject === undefined || error.message.includes(`“${error.subject}”`);
    const subject = isNamed ? "" : `${printable(error.subject)}: `;
    const hint = error.hint === undefined ? "" : `  ${printable(error.hint)}\n`;
    process.stderr.write(`texelcast: ${subject}${printable(error.message)}\n${hint}`);
    return exitCodeOf(error);
  }
  const told = error instanceof Error ? (error.stack ?? error.message) : String(error);
  process.stderr.write(`texelcast: a fault of Texelcast's own; please report it with the lines below\n${told}\n`);
  return EXIT_INTERNAL;
}
