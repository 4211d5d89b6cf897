/**
 * The channel to the editor's page in an iframe. A browser loads that page anew where the iframe is moved, and what it held is gone:
 * then what was on its way is called off, and the new page is given a channel of its own.
 */
import { TexelcastError } from "../core/texelcast-error.ts";
import { EMBED_VERSION, readGreeting } from "./messages.ts";
import { PortCalls, type PortCallsParts } from "./port-calls.ts";

export interface FrameLinkParts extends PortCallsParts {
  readonly iframe: HTMLIFrameElement;
  readonly address: URL;
  /** For the first word of the page, milliseconds. */
  readonly patienceMs: number;
  /** For the same, once the browser has loaded a page: also one that may not be framed, of which it does not tell. Null: as before. */
  readonly loadedPatienceMs: number | null;
  /** A page has taken its channel: the first, or after another one that was lost (`anew`). */
  readonly connected: (calls: PortCalls, anew: boolean) => void;
  /** The page is loaded anew, and what it held is gone. */
  readonly lost: (error: TexelcastError) => void;
}

export class FrameLink {
  readonly #parts: FrameLinkParts;
  readonly #end = new AbortController();
  /** Of the page that was connected last. */
  #page: { readonly calls: PortCalls; readonly window: Window | null; readonly nonce: string } | null = null;
  #isAnew = false;
  #ready = new FirstWord();
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(parts: FrameLinkParts) {
    this.#parts = parts;
    const { signal } = this.#end;
    addEventListener("message", (event) => this.#hear(event), { signal });
    parts.iframe.addEventListener("load", () => this.#loaded(), { signal });
    this.#wait(parts.patienceMs);
  }

  /** The channel to the page as it is now. Rejects with "timeout" or "unsupported" where there is none, "disposed" after the end. */
  ready(): Promise<PortCalls> {
    // Another place in the page is another window, before it has said a word.
    if (this.#page && this.#page.window !== this.#parts.iframe.contentWindow) this.#lose();
    return this.#ready.promise;
  }

  end(error: TexelcastError): void {
    this.#end.abort();
    clearTimeout(this.#timer);
    this.#page?.calls.end(error);
    this.#page = null;
    this.#ready.reject(error);
    this.#ready = new FirstWord();
    this.#ready.reject(error);
  }

  #wait(patienceMs: number): void {
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => this.#ready.reject(silent(this.#parts.address, patienceMs)), patienceMs);
  }

  #loaded(): void {
    const { loadedPatienceMs } = this.#parts;
    if (this.#page === null && loadedPatienceMs !== null && !this.#ready.isOver) this.#wait(loadedPatienceMs);
  }

  #lose(): void {
    const error = new TexelcastError("cancelled", "The editor's page was loaded anew, and what it held is gone.", {
      hint: "A browser does that where an iframe is moved: keep the design by “exportDesign” before, and set it after.",
    });
    this.#page?.calls.end(error);
    this.#page = null;
    this.#isAnew = true;
    this.#ready = new FirstWord();
    this.#wait(this.#parts.patienceMs);
    this.#parts.lost(error);
  }

  #hear(event: MessageEvent): void {
    const { iframe, address, onIgnored, connected } = this.#parts;
    const hello = readGreeting(event.data, "hello");
    const isFromFrame = event.source === iframe.contentWindow;
    // Other messages of the page's own traffic are none of ours.
    if (!isFromFrame && hello === null) return;
    if (!isFromFrame || event.origin !== address.origin || hello === null || hello.nonce === this.#page?.nonce) {
      onIgnored();
      return;
    }
    if (this.#page) this.#lose();
    // One that comes late is not too late for what is asked from then on.
    else if (this.#ready.isOver) this.#ready = new FirstWord();
    clearTimeout(this.#timer);
    if (hello.version !== EMBED_VERSION) {
      this.#ready.reject(otherVersion(hello.version));
      return;
    }
    const { port1, port2 } = new MessageChannel();
    const calls = new PortCalls(port1, this.#parts);
    const { nonce } = hello;
    const window = iframe.contentWindow;
    this.#page = { calls, window, nonce };
    window?.postMessage({ texelcast: "connect", version: EMBED_VERSION, nonce }, address.origin, [port2]);
    connected(calls, this.#isAnew);
    this.#ready.resolve(calls);
  }
}

/** Of a page: the channel that it is given for it. */
class FirstWord {
  resolve!: (calls: PortCalls) => void;
  #reject!: (error: TexelcastError) => void;
  /** It was given up. */
  isOver = false;
  readonly promise = new Promise<PortCalls>((resolve, reject) => {
    this.resolve = resolve;
    this.#reject = reject;
  });

  reject(error: TexelcastError): void {
    this.isOver = true;
    // Whoever asks is told.
    this.promise.catch(() => undefined);
    this.#reject(error);
  }
}

function silent(address: URL, patience: number): TexelcastError {
  return new TexelcastError("timeout", `The editor's page did not answer within ${patience / 1000} seconds.`, {
    subject: address.href,
    hint: "See whether the address is right, whether that page lists this shop's origin, and whether it may be framed (X-Frame-Options, frame-ancestors).",
  });
}

function otherVersion(version: number): TexelcastError {
  return new TexelcastError("unsupported", `The editor's page speaks version ${version} of the iframe's protocol.`, {
    field: "version",
    value: String(version),
    hint: `This shop's side speaks version ${EMBED_VERSION}: use both from the same release.`,
  });
}
