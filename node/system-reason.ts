/** What a system call complains of; the rest of its message repeats the path, however long, and those of files that nobody knows of. */
export const systemReason = (cause: unknown): string =>
  cause instanceof Error ? (/^[A-Z0-9]+: [^,]+/.exec(cause.message)?.[0] ?? cause.message) : String(cause);
