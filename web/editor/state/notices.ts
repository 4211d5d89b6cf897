/** What the page tells its user: notices that stay until dismissed, and announcements for screen readers. */
import { TexelcastError } from "../../core/texelcast-error.ts";
import { ownWords } from "../strings/error-words.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";

export interface NoticeAction {
  readonly label: string;
  readonly run: () => void;
}

export interface Notice {
  readonly id: number;
  readonly tone: "error" | "info";
  /** What happened. */
  readonly title: string;
  /** A TexelcastError's code; "" for other notices. */
  readonly code: string;
  /** The file that it is about, which `message` may begin with; left out for none. */
  readonly subject?: string;
  readonly message: string;
  /** File, field and value. */
  readonly where: string;
  /** What to do. */
  readonly hint: string;
  /** What only those need who look into the file, in English; "" for nothing. */
  readonly exact: string;
  readonly action?: NoticeAction;
  /** Stays while the user works on, as errors do. */
  readonly stays?: boolean;
}

/** How browsers, in English whatever their language, say that a script which is fetched when it is needed cannot be had. */
const SCRIPT_MISSING = /dynamically imported module|Importing a module script failed/;

/** `title` says what was being done ("Could not open Fox.glb"); the error says why. */
export function noticeOf(id: number, title: string, thrown: unknown, strings: Strings): Notice {
  const error = plainly(thrown, strings);
  const { code, subject = "", field, value, reason } = error;
  const told = (error instanceof ToldError ? ownWords : strings.told)(error.toJSON());
  const { message, exact = "" } = told;
  // Whoever reads it has no say in the address, which the file's reader speaks of to a shop's developer.
  const hint = reason === "not-loaded" ? strings.errors.partMissingHint : told.hint;
  const where = [subject, field, value === undefined ? undefined : strings.notices.value(shortened(value))];
  return {
    id,
    tone: "error",
    title,
    code,
    subject,
    message,
    where: where.filter((part) => part !== undefined && part !== "" && !title.includes(part)).join(" · "),
    hint,
    exact,
  };
}

/** A line that is gone, or a page that has been renewed meanwhile, is no fault of the engine's. */
function plainly(thrown: unknown, { errors }: Strings): TexelcastError {
  const words = thrown instanceof Error ? thrown.message : String(thrown);
  const code = thrown instanceof TexelcastError ? thrown.code : "unexpected";
  if ((["internal", "unexpected"].includes(code) && SCRIPT_MISSING.test(words)) || lacksScript(thrown)) {
    const hint = errors.partMissingHint;
    return new ToldError("missing-file", errors.partMissing, { hint, reason: "not-loaded", cause: thrown });
  }
  return TexelcastError.wrap(thrown, "unexpected", words);
}

/** Whether the engine ended because its worker's script could not be fetched: that no step of the user's is the reason. */
export function lacksScript(thrown: unknown): boolean {
  if (!(thrown instanceof TexelcastError)) return false;
  const { code, message, cause } = thrown;
  if (code === "engine-halted") return lacksScript(cause);
  return code === "engine-crashed" && message.includes("worker-src");
}

export function isCancelled(thrown: unknown): boolean {
  return thrown instanceof Error && thrown.name === "AbortError";
}

function shortened(value: string): string {
  return value.length > 80 ? `${value.slice(0, 77)}…` : value;
}
