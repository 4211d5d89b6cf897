/** The command line tool: one run, one command, one exit code (docs/command-line.md). */
import { CommanderError } from "commander";
import { TexelcastError } from "../web/core/texelcast-error.ts";
import { EXIT_OK, EXIT_USAGE } from "./exit-codes.ts";
import { createProgram } from "./program.ts";
import { reportError } from "./report-error.ts";

process.stdout.on("error", (cause: NodeJS.ErrnoException) => {
  // A reader such as `head` that has seen enough is no fault, and no reason to answer what `check` did not find.
  if (cause.code === "EPIPE") return;
  const error = new TexelcastError("cannot-write", `cannot be written: ${cause.message}`, {
    subject: "stdout",
    hint: "Send it to another place, or make room there.",
    cause,
  });
  process.exit(reportError(error));
});
// Where not even an error can be told, the exit code alone tells it.
process.stderr.on("error", () => {});

try {
  await createProgram().parseAsync();
} catch (error) {
  // Commander has told already what was wrong, or printed the help or version that it was asked for.
  if (error instanceof CommanderError) process.exitCode = error.exitCode === 0 ? EXIT_OK : EXIT_USAGE;
  else process.exitCode = reportError(error);
}
