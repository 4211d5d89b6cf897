/** What an error is about, beside its message: all of it may be shown to a user. */
export interface TexelcastErrorDetails {
  /** The file at fault, as the user knows it. */
  readonly subject?: string;
  /** JSON path or argument at fault. */
  readonly field?: string;
  /** The value found there. */
  readonly value?: string;
  /** What the user can do about it. */
  readonly hint?: string;
  /** Which of the faults of one code it is, for programs and stable ("cmyk", "animated", …): a translation goes by it. */
  readonly reason?: string;
  readonly cause?: unknown;
}

/** A TexelcastError as plain data: structured-cloneable, so that it can cross a worker's border. */
export interface TexelcastErrorJson {
  readonly code: string;
  readonly message: string;
  readonly subject?: string;
  readonly field?: string;
  readonly value?: string;
  readonly hint?: string;
  readonly reason?: string;
}

/**
 * The one error type of Texelcast. `message` is a whole sentence for the user; `code` is for programs and stable: a
 * status name of the core in lower case with dashes ("no-uvs", "bad-model", "out-of-budget", …), or one of
 * "bad-picture", "bad-font", "bad-design", "unsupported", "bad-argument", "missing-file", "outside-folder", "cancelled",
 * "disposed", "engine-crashed", "engine-halted", "bad-container", "bad-project", "bad-archive", "storage-full", "storage-refused",
 * "storage-conflict", "graphics-lost", "too-large", "unsafe-file", "refused", "too-many-decals", "bad-zones", "no-model", "timeout",
 * "bad-origin", "cannot-write".
 */
export class TexelcastError extends Error {
  readonly code: string;
  declare readonly subject?: string;
  declare readonly field?: string;
  declare readonly value?: string;
  declare readonly hint?: string;
  declare readonly reason?: string;

  constructor(code: string, message: string, details: TexelcastErrorDetails = {}) {
    super(message, "cause" in details ? { cause: details.cause } : undefined);
    // DOM code tells a cancelled call by this name alone, whatever library it came from.
    this.name = code === "cancelled" ? "AbortError" : "TexelcastError";
    this.code = code;
    Object.assign(this, given(details));
  }

  toJSON(): TexelcastErrorJson {
    return { code: this.code, message: this.message, ...given(this) };
  }

  static from(json: TexelcastErrorJson): TexelcastError {
    return new TexelcastError(json.code, json.message, json);
  }

  /** Any thrown value as a TexelcastError; what is not one yet becomes `code` with its own message as the cause. */
  static wrap(thrown: unknown, code: string, message: string, details: TexelcastErrorDetails = {}): TexelcastError {
    if (thrown instanceof TexelcastError) return thrown;
    return new TexelcastError(code, message, { ...details, cause: thrown });
  }
}

const DETAILS = ["subject", "field", "value", "hint", "reason"] as const;

/** Those that are there: what is sent, shown or compared has no others. */
const given = (details: TexelcastErrorDetails): Omit<TexelcastErrorDetails, "cause"> =>
  Object.fromEntries(DETAILS.flatMap((name) => (details[name] === undefined ? [] : [[name, details[name]]])));
