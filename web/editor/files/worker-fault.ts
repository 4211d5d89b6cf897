/** Why a worker of the page's own could not do its work. */
import { ToldError } from "../strings/told-error.ts";
import type { Strings } from "../strings.ts";

/**
 * Of a worker's "error" event: what broke in it, "internal"; or "missing-file" where its script could not be fetched, which browsers
 * tell by an event without a message.
 *
 * @param failed the sentence for what broke
 * @param subject name of the file that it worked on
 */
export function workerFault(
  { message }: Pick<ErrorEvent, "message">,
  failed: (reason: string) => string,
  subject: string,
  { errors }: Strings,
): ToldError {
  if (message) return new ToldError("internal", failed(message), { subject });
  return new ToldError("missing-file", errors.partMissing, {
    hint: errors.partMissingHint,
    reason: "not-loaded",
    subject,
  });
}
