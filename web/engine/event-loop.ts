/** Turns of the event loop, in the browser, in workers and in Node alike. */

type Callback = () => void;

const waiting: Callback[] = [];
let channel: MessageChannel | null = null;

/**
 * Calls back in a later turn, after messages that are already waiting. A timer would be held back to 4 ms (or a second
 * in a hidden tab), a promise would not let messages through.
 */
export function callLater(callback: Callback): void {
  // Node's own way: there an open MessageChannel would keep the process alive.
  if (typeof setImmediate === "function") {
    setImmediate(callback);
    return;
  }
  if (channel === null) {
    channel = new MessageChannel();
    channel.port1.onmessage = () => waiting.shift()?.();
  }
  waiting.push(callback);
  channel.port2.postMessage(null);
}

/** Resolves in a later turn, after messages that are already waiting. */
export function nextTurn(): Promise<void> {
  return new Promise((resolve) => callLater(resolve));
}
