/** Before what could not be fetched is asked for again by itself, with the next change: the connection may be back. */
export const RETRY_MS = 5_000;
