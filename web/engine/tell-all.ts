/**
 * Tells all of `listeners`. What one of them throws keeps the others from nothing, nor the engine that tells them: the page or the
 * program hears of it as of a promise's rejection that nobody handles.
 */
export function tellAll<Told>(listeners: Iterable<(told: Told) => unknown>, told: Told): void {
  // Of an async function the part before its first await is run at once.
  for (const listener of listeners) void (async () => listener(told))();
}
