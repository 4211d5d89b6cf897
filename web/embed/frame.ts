/** `texelcast/embed`, the shop's side of the iframe: small, and without the editor's code. */
import { parseUrl } from "../core/parse-url.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import {
  FRAME_METHODS,
  FRAME_PROPERTIES,
  type FrameMethod,
  type FrameProperties,
  type MountOptions,
  type TexelcastFrame,
} from "./frame-api.ts";
import { FrameLink } from "./frame-link.ts";
import { ACCEPTANCE_PATIENCE_MS, SHOP_PARAMETER } from "./messages.ts";
import type { PortCalls } from "./port-calls.ts";

const PATIENCE_MS = 30_000;
const LONG_PATIENCE_MS = 120_000;
/** Of a browser's timer, 24 days; more of it is none at all. */
const MOST_PATIENCE_MS = 2 ** 31 - 1;
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

/** Options that are none of the editor's properties. */
const FOR_THE_FRAME = ["page", "title", "beforeAccept", "timeoutMs"] as const;

/**
 * Puts the editor's page into `container` and resolves when it has answered. Rejects with a TexelcastError: "bad-argument"
 * for an option that there is not, a page without an http(s) address, a `beforeAccept` that is no function, a `timeoutMs` that is no
 * time or a container that is not there, "timeout" when the page does not answer, "unsupported" when it speaks another version; the
 * iframe is then taken away again.
 */
export async function mountTexelcast(container: Element, options: MountOptions): Promise<TexelcastFrame> {
  checkNames(options, [...FRAME_PROPERTIES, ...FOR_THE_FRAME]);
  const { page, title = "Product designer" } = options;
  const beforeAccept = options.beforeAccept || null;
  const address = pageAddress(page);
  checkForTheFrame(container, beforeAccept, options.timeoutMs);
  const timeoutMs = options.timeoutMs && Math.min(options.timeoutMs, MOST_PATIENCE_MS);
  const iframe = container.ownerDocument.createElement("iframe");
  iframe.title = title;
  iframe.setAttribute("sandbox", SANDBOX);
  iframe.referrerPolicy = "origin";
  Object.assign(iframe.style, { width: "100%", height: "100%", border: "0", display: "block" });

  let ignored = 0;
  const events = new EventTarget();
  const tell = (name: string, detail: unknown): void => {
    events.dispatchEvent(new CustomEvent(name, { detail }));
  };
  const answer = async (method: string, args: readonly unknown[], end: AbortSignal): Promise<unknown> => {
    if (method !== "beforeAccept") throw new TexelcastError("bad-argument", `The shop's page has no “${method}”.`);
    // (AbortSignal.any is younger than browsers that customers still have.)
    const given = new AbortController();
    for (const one of [end, AbortSignal.timeout(ACCEPTANCE_PATIENCE_MS)]) {
      one.addEventListener("abort", () => given.abort(one.reason));
    }
    // Whatever it is, the element judges it: what is no answer refuses.
    return beforeAccept === null || (await beforeAccept(args[0] as never, { signal: given.signal }));
  };

  let held = propertiesOf(options);
  const give = (calls: PortCalls, properties: FrameProperties): Promise<unknown> =>
    calls.call("set", [properties, beforeAccept !== null], timeoutMs ?? PATIENCE_MS);
  const link = new FrameLink({
    iframe,
    address,
    answer,
    patienceMs: timeoutMs ?? LONG_PATIENCE_MS,
    loadedPatienceMs: timeoutMs ? null : PATIENCE_MS,
    onEvent: tell,
    onIgnored: () => {
      ignored += 1;
    },
    // The element took all of it once.
    connected: (calls, anew) => void (anew && give(calls, held).catch(() => undefined)),
    lost: (error) => {
      const { code, message, hint = "" } = error;
      tell("error", { error: error.toJSON(), code, message, hint });
    },
  });

  address.searchParams.set(SHOP_PARAMETER, location.origin);
  iframe.src = address.href;
  container.append(iframe);
  try {
    await give(await link.ready(), held);
  } catch (error) {
    link.end(new TexelcastError("disposed", "The editor could not be mounted."));
    iframe.remove();
    throw error;
  }

  /** As with the element: whoever does not wait for it causes no unhandled rejection. */
  const asked = (ask: (calls: PortCalls) => Promise<unknown>): Promise<unknown> => {
    const told = link.ready().then(ask);
    told.catch(() => undefined);
    return told;
  };
  const methods = Object.fromEntries(
    FRAME_METHODS.map((method) => [
      method,
      (...args: unknown[]) => asked((calls) => calls.call(method, args, timeoutMs ?? patienceFor(method))),
    ]),
  );
  const frame = Object.assign(events, methods, {
    iframe,
    set: (properties: FrameProperties): Promise<unknown> =>
      asked(async (calls) => {
        checkNames(properties, FRAME_PROPERTIES);
        const given = propertiesOf(properties);
        await give(calls, given);
        held = { ...held, ...given };
      }),
    unmount: (): void => {
      link.end(new TexelcastError("disposed", "The editor was taken from the page."));
      iframe.remove();
    },
  });
  Object.defineProperty(frame, "ignoredMessages", { get: () => ignored });
  return frame as unknown as TexelcastFrame;
}

function pageAddress(page: string | URL): URL {
  const address = parseUrl(page);
  if (address !== null && /^https?:$/.test(address.protocol)) return address;
  throw new TexelcastError("bad-argument", "The editor's page needs a whole http(s) address.", {
    field: "page",
    value: String(page),
    hint: 'Write it as "https://editor.example/embed.html".',
  });
}

function checkForTheFrame(
  container: Element,
  beforeAccept: MountOptions["beforeAccept"] | null,
  timeoutMs: number | undefined,
): void {
  if (timeoutMs !== undefined && !(timeoutMs > 0)) {
    throw new TexelcastError("bad-argument", "“timeoutMs” must be more than 0.", {
      field: "timeoutMs",
      value: String(timeoutMs),
      hint: "Give milliseconds, or leave it out.",
    });
  }
  // The shop's say must not be missed: its page would learn of it file by file.
  if (beforeAccept && typeof beforeAccept !== "function") {
    throw new TexelcastError("bad-argument", "“beforeAccept” must be a function.", {
      field: "beforeAccept",
      value: String(beforeAccept),
      hint: "Give a function that answers whether a file may be used, or leave it out.",
    });
  }
  if (!container?.ownerDocument) {
    throw new TexelcastError("bad-argument", "The editor needs an element of the page to be put into.", {
      field: "container",
      value: String(container),
      hint: "Call it when the page has that element.",
    });
  }
}

/** A slip of the pen is told: what was meant by it would be left out unheard. */
function checkNames(options: object, known: readonly string[]): void {
  if (typeof options !== "object" || options === null) {
    throw new TexelcastError("bad-argument", "The editor in an iframe needs an object of options.", {
      field: "options",
      value: String(options).slice(0, 80),
      hint: `There are ${known.join(", ")}.`,
    });
  }
  for (const [name, value] of Object.entries(options)) {
    if (value === undefined || known.includes(name)) continue;
    throw new TexelcastError("bad-argument", `The editor in an iframe has no option “${name}”.`, {
      field: name,
      value: String(value).slice(0, 80),
      hint: `There are ${known.join(", ")}.`,
    });
  }
}

/** Those that are given. */
function propertiesOf(options: FrameProperties): FrameProperties {
  const given = FRAME_PROPERTIES.filter((name) => options[name] !== undefined);
  return Object.fromEntries(given.map((name) => [name, options[name]]));
}
