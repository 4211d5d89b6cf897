/**
 * What Tab comes to is scrolled into sight whole, with its ring. Firefox leaves what is seen in part as it is; other browsers scroll by
 * themselves.
 */
export function keepTabInSight(root: EventTarget, signal: AbortSignal): void {
  const look = (event: Event): void => {
    const { key, ctrlKey, altKey, metaKey } = event as KeyboardEvent;
    // With one of them it has led here from another tab or window: what was looked at there before stays.
    if (key !== "Tab" || ctrlKey || altKey || metaKey) return;
    const path = event.composedPath().filter((each) => each instanceof Element);
    // A number's ring goes round its label, too.
    const ringed = path.find(({ localName }) => localName === "tc-number") ?? path[0];
    ringed?.scrollIntoView({ block: "nearest", inline: "nearest" });
  };
  // By now the keyboard is where the key has led it.
  root.addEventListener("keyup", look, { signal });
}
