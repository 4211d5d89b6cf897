/** The editor's side of the iframe: lets one shop, of one exact origin, drive one element. */
import { parseUrl } from "../core/parse-url.ts";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { Acceptance, BeforeAccept, TexelcastEditorApi } from "../element/element-api.ts";
import { FRAME_EVENTS, FRAME_METHODS, FRAME_PROPERTIES } from "./frame-api.ts";
import { ACCEPTANCE_PATIENCE_MS, EMBED_VERSION, makeNonce, readGreeting, SHOP_PARAMETER } from "./messages.ts";
import { PortCalls } from "./port-calls.ts";

export interface HostOptions {
  /** Exact origins that may frame the page, as "https://shop.example"; null: any that names itself. */
  readonly shops: readonly string[] | null;
}

export interface EditorHost {
  /** Messages from a wrong origin or window, repeated or malformed; none of them did anything. */
  readonly ignoredMessages: number;
  stop(): void;
}

/**
 * Says hello to the shop that framed this page and does what it asks of the element. Throws a TexelcastError of code
 * "bad-argument" for `shops` that are no list of exact origins, "bad-origin" where the page is not framed, or by a shop that is
 * not among them.
 */
export function hostEditor(editor: HTMLElement & TexelcastEditorApi, options: HostOptions): EditorHost {
  const shops = checkedShops(options?.shops);
  const shop = shopOrigin(new URL(location.href).searchParams.get(SHOP_PARAMETER), shops);
  const nonce = makeNonce();
  const end = new AbortController();
  let ignored = 0;
  let calls: PortCalls | null = null;
  const onIgnored = (): void => {
    ignored += 1;
  };

  const beforeAccept: BeforeAccept = async (asset) =>
    (await calls?.call("beforeAccept", [asset], ACCEPTANCE_PATIENCE_MS)) as Acceptance;
  const answer = (method: string, args: readonly unknown[]): unknown => {
    if (method === "set") return setProperties(editor, args[0], args[1] === true ? beforeAccept : null);
    const known = FRAME_METHODS.find((name) => name === method);
    if (known === undefined) throw new TexelcastError("bad-argument", `The editor has no “${method}” for a shop.`);
    return (editor[known] as (...args: readonly unknown[]) => unknown)(...args);
  };

  addEventListener(
    "message",
    (event) => {
      const connect = readGreeting(event.data, "connect");
      if (event.source !== parent && connect === null) return;
      const [port] = event.ports;
      const isOurs = event.source === parent && event.origin === shop && connect?.nonce === nonce;
      if (!isOurs || connect.version !== EMBED_VERSION || port === undefined || calls !== null) {
        onIgnored();
        return;
      }
      calls = new PortCalls(port, { answer, onEvent: onIgnored, onIgnored });
    },
    { signal: end.signal },
  );
  for (const name of FRAME_EVENTS) {
    // What the browser says of its own events is nothing to a shop, and not all of it can be sent.
    const tell = (event: Event): void => calls?.tell(name, event instanceof CustomEvent ? event.detail : null);
    editor.addEventListener(name, tell, { signal: end.signal });
  }
  parent.postMessage({ texelcast: "hello", version: EMBED_VERSION, nonce }, shop);
  return {
    get ignoredMessages() {
      return ignored;
    },
    stop() {
      end.abort();
      calls?.end(new TexelcastError("disposed", "The editor's page was closed."));
    },
  };
}

/** A text would let in whoever's origin is a part of it, and an address that is no origin nobody. */
function checkedShops(shops: HostOptions["shops"]): HostOptions["shops"] {
  if (shops === null) return null;
  const wrong = Array.isArray(shops) ? shops.findIndex((shop) => parseUrl(shop)?.origin !== shop) : null;
  if (wrong === -1) return shops;
  throw new TexelcastError("bad-argument", "The shops that may frame this page are not exact origins.", {
    field: wrong === null ? "shops" : `shops[${wrong}]`,
    value: String(wrong === null ? shops : shops[wrong]).slice(0, 80),
    hint: 'List each as ["https://shop.example"], without a path or a slash at its end.',
  });
}

function shopOrigin(named: string | null, shops: readonly string[] | null): string {
  const isExact = named !== null && parseUrl(named)?.origin === named;
  if (parent !== window && isExact && (shops === null || shops.includes(named))) return named;
  throw new TexelcastError("bad-origin", "This page works inside the page of a shop that it knows.", {
    field: SHOP_PARAMETER,
    ...(named !== null && { value: named }),
    hint: "Mount it by texelcast/embed, and list the shop's exact origin in the page's “texelcast-shops”, or in the “shops” of hostEditor.",
  });
}

function setProperties(editor: TexelcastEditorApi, properties: unknown, beforeAccept: BeforeAccept | null): void {
  editor.beforeAccept = beforeAccept;
  for (const [name, value] of Object.entries(properties ?? {})) {
    const known = FRAME_PROPERTIES.find((property) => property === name);
    if (known === undefined) {
      throw new TexelcastError("bad-argument", `The editor has no property “${name}” for a shop.`, { field: name });
    }
    Object.assign(editor, { [known]: value });
  }
}
