/** Why the browser would not keep something, in words for its user. */

import { TexelcastError } from "../../core/texelcast-error.ts";
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";

/** The browser did not say in time whether it keeps anything. */
export class StorageSilence extends ToldError {
  /** Settles when it has answered after all. */
  readonly answered: Promise<unknown>;

  constructor(message: string, answered: Promise<unknown>) {
    super("storage-refused", message);
    this.answered = answered;
  }
}

/**
 * "storage-full" where the browser's space is used up, "storage-refused" for every other reason (a private window, a
 * policy, a broken database). TexelcastErrors stay as they are.
 */
export function storageError(thrown: unknown, strings: Strings): TexelcastError {
  if (thrown instanceof TexelcastError) return thrown;
  const words = strings.storage;
  if (isQuotaError(thrown)) {
    return new ToldError("storage-full", words.full, { hint: words.fullHint, cause: thrown });
  }
  const reason = thrown instanceof Error ? thrown.message : String(thrown);
  return new ToldError("storage-refused", words.refused(reason), { hint: words.refusedHint, cause: thrown });
}

function isQuotaError(thrown: unknown): boolean {
  // Firefox has a name of its own for a full disk.
  const names = ["QuotaExceededError", "NS_ERROR_DOM_INDEXEDDB_QUOTA_ERR", "NS_ERROR_FILE_NO_DEVICE_SPACE"];
  return thrown instanceof Error && names.includes(thrown.name);
}
