/** `texelcast/embed`, the shop's side of the iframe: small, and without the editor's code. */
import { TexelcastError } from "../core/texelcast-error.ts";
import {
  FRAME_METHODS,
  FRAME_PROPERTIES,
  type FrameMethod,
  type FrameProperties,
  type MountOptions,
  type TexelcastFrame,
} from "./frame-api.ts";
import { EMBED_VERSION, readGreeting, SHOP_PARAMETER } from "./messages.ts";
import { PortCalls } from "./port-calls.ts";

const PATIENCE_MS = 30_000;
const LONG_PATIENCE_MS = 120_000;
/** What loads or prints, and what the shop itself is asked about meanwhile. */
const LONG: ReadonlySet<FrameMethod> = new Set([
  "addDecal",
  "addText",
  "start",
  "restart",
  "exportDesign",
  "exportModel",
  "exportTexture",
  "snapshot",
  "submit",
  "validate",
]);

/** How long an answer to this may take, milliseconds, where the shop does not say. */
export const patienceFor = (method: FrameMethod): number => (LONG.has(method) ? LONG_PATIENCE_MS : PATIENCE_MS);

/**
 * Scripts, because the editor is one; its own origin, because exact origins are what both sides check, and an opaque one has
 * none; downloads, for the user's own copy. Not: the top window, pop-ups, forms.
 */
const SANDBOX = "allow-scripts allow-same-origin allow-downloads";

/**
 * Puts the editor's page into `container` and resolves when it has answered. Rejects with a TexelcastError: "bad-argument"
 * for a page without an http(s) address, "timeout" when the page does not answer, "unsupported" when it speaks another
 * version; the iframe is then taken away again.
 */
export async function mountTexelcast(container: Element, options: MountOptions): Promise<TexelcastFrame> {
  const { page, title = "Product designer", timeoutMs } = options;
  const beforeAccept = options.beforeAccept ?? null;
  const address = pageAddress(page);
  const iframe = container.ownerDocument.createElement("iframe");
  iframe.title = title;
  iframe.setAttribute("sandbox", SANDBOX);
  iframe.referrerPolicy = "origin";
  Object.assign(iframe.style, { width: "100%", height: "100%", border: "0", display: "block" });

  let ignored = 0;
  const onIgnored = (): void => {
    ignored += 1;
  };
  const events = new EventTarget();
  const answer = async (method: string, args: readonly unknown[]): Promise<unknown> => {
    if (method !== "beforeAccept") throw new TexelcastError("bad-argument", `The shop's page has no “${method}”.`);
    // Whatever it is, the element judges it: what is no answer refuses.
    return beforeAccept === null || (await beforeAccept(args[0] as never));
  };
  const onEvent = (name: string, detail: unknown): void => {
    events.dispatchEvent(new CustomEvent(name, { detail }));
  };

  const greeting = new AbortController();
  const connected = new Promise<PortCalls>((resolve, reject) => {
    const patience = timeoutMs ?? LONG_PATIENCE_MS;
    const timer = setTimeout(() => reject(silent(address, patience)), patience);
    let isConnected = false;
    const listen = (event: MessageEvent): void => {
      const hello = readGreeting(event.data, "hello");
      const isFromFrame = event.source === iframe.contentWindow;
      // Other messages of the page's own traffic are none of ours.
      if (!isFromFrame && hello === null) return;
      if (!isFromFrame || event.origin !== address.origin || hello === null || isConnected) {
        onIgnored();
        return;
      }
      isConnected = true;
      clearTimeout(timer);
      if (hello.version !== EMBED_VERSION) {
        reject(otherVersion(hello.version));
        return;
      }
      const { port1, port2 } = new MessageChannel();
      const calls = new PortCalls(port1, { answer, onEvent, onIgnored });
      iframe.contentWindow?.postMessage(
        { texelcast: "connect", version: EMBED_VERSION, nonce: hello.nonce },
        address.origin,
        [port2],
      );
      resolve(calls);
    };
    addEventListener("message", listen, { signal: greeting.signal });
  });

  address.searchParams.set(SHOP_PARAMETER, location.origin);
  iframe.src = address.href;
  container.append(iframe);
  let calls: PortCalls;
  try {
    calls = await connected;
    await calls.call("set", [propertiesOf(options), beforeAccept !== null], timeoutMs ?? PATIENCE_MS);
  } catch (error) {
    greeting.abort();
    iframe.remove();
    throw error;
  }

  const methods = Object.fromEntries(
    FRAME_METHODS.map((method) => [
      method,
      (...args: unknown[]): Promise<unknown> => calls.call(method, args, timeoutMs ?? patienceFor(method)),
    ]),
  );
  const frame = Object.assign(events, methods, {
    iframe,
    set: async (properties: FrameProperties): Promise<void> => {
      await calls.call("set", [propertiesOf(properties), beforeAccept !== null], timeoutMs ?? PATIENCE_MS);
    },
    unmount: (): void => {
      greeting.abort();
      calls.end(new TexelcastError("disposed", "The editor was taken from the page."));
      iframe.remove();
    },
  });
  Object.defineProperty(frame, "ignoredMessages", { get: () => ignored });
  return frame as unknown as TexelcastFrame;
}

function pageAddress(page: string | URL): URL {
  const address = URL.canParse(page) ? new URL(page) : null;
  if (address !== null && /^https?:$/.test(address.protocol)) return address;
  throw new TexelcastError("bad-argument", "The editor's page needs a whole http(s) address.", {
    field: "page",
    value: String(page),
    hint: 'Write it as "https://editor.example/embed.html".',
  });
}

/** Those that are given, and nothing else: an options object may hold what cannot be sent. */
function propertiesOf(options: FrameProperties): FrameProperties {
  const given = FRAME_PROPERTIES.filter((name) => options[name] !== undefined);
  return Object.fromEntries(given.map((name) => [name, options[name]]));
}

function silent(address: URL, patience: number): TexelcastError {
  return new TexelcastError("timeout", `The editor's page did not answer within ${patience / 1000} seconds.`, {
    subject: address.href,
    hint: "See whether the address is right, and whether that page lists this shop's origin.",
  });
}

function otherVersion(version: number): TexelcastError {
  return new TexelcastError("unsupported", `The editor's page speaks version ${version} of the iframe's protocol.`, {
    field: "version",
    value: String(version),
    hint: `This shop's side speaks version ${EMBED_VERSION}: use both from the same release.`,
  });
}
