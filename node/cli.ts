/** The command line tool: one run, one command, one exit code (docs/command-line.md). */
import { CommanderError } from "commander";
import { EXIT_OK, EXIT_USAGE } from "./exit-codes.ts";
import { createProgram } from "./program.ts";
import { reportError } from "./report-error.ts";

// A reader such as `head` that has seen enough is no fault.
process.stdout.on("error", (error: NodeJS.ErrnoException) => {
  if (error.code !== "EPIPE") throw error;
  process.exit(EXIT_OK);
});

try {
  await createProgram().parseAsync();
} catch (error) {
  // Commander has told already what was wrong, or printed the help or version that it was asked for.
  if (error instanceof CommanderError) process.exitCode = error.exitCode === 0 ? EXIT_OK : EXIT_USAGE;
  else process.exitCode = reportError(error);
}
