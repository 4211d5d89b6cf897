/** How many of the screen's pixels one of the page's has: another number once the window was moved to another screen. */

/**
 * Calls `changed` whenever it is another one, until `signal`. No size changes by that, so no observer of sizes tells of it; of how many
 * it is a query can only ask whether it is this one.
 */
export function watchPixelRatio(changed: () => void, signal: AbortSignal): void {
  const again = (): void => {
    changed();
    watchPixelRatio(changed, signal);
  };
  matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener("change", again, { once: true, signal });
}
