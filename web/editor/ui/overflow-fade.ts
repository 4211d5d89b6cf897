/** Where a row or a column that scrolls goes on, it fades out; and a plain wheel moves a row, too. */
import type { ReactiveController, ReactiveControllerHost } from "lit";
import { windowOf } from "../../viewer/window-of.ts";

/** How far the fade reaches in, CSS length. */
const REACH = "2.5rem";
/** Pixels that rounding may hide. */
const SLACK = 2;

type Host = ReactiveControllerHost & { readonly renderRoot: HTMLElement | DocumentFragment };

/** Watches what a selector finds in its host, as long as that stands in the page. */
export class OverflowFade implements ReactiveController {
  readonly #host: Host;
  readonly #selector: string;
  #list: HTMLElement | null = null;
  #end = new AbortController();

  constructor(host: Host, selector: string) {
    this.#host = host;
    this.#selector = selector;
    host.addController(this);
  }

  /** Put back into the page, it is watched anew. */
  hostConnected(): void {
    this.#host.requestUpdate();
  }

  hostUpdated(): void {
    const list = this.#host.renderRoot.querySelector<HTMLElement>(this.#selector);
    if (list !== this.#list) this.#watch(list);
  }

  hostDisconnected(): void {
    this.#watch(null);
  }

  #watch(list: HTMLElement | null): void {
    this.#list = list;
    this.#end.abort();
    this.#end = new AbortController();
    if (list) fadeOverflow(list, this.#end.signal);
  }
}

/** The children of one that scrolls only, not what they hold. */
function fadeOverflow(list: HTMLElement, signal: AbortSignal): void {
  const update = (): void => {
    list.style.maskImage = maskOf(list);
  };
  list.addEventListener("scroll", update, { passive: true, signal });
  list.addEventListener("wheel", (event) => moveRow(list, event), { signal });
  const size = new (windowOf(list).ResizeObserver)(update);
  const children = new MutationObserver(update);
  size.observe(list);
  children.observe(list, { childList: true, characterData: true, subtree: true });
  signal.addEventListener("abort", () => {
    size.disconnect();
    children.disconnect();
  });
  update();
}

function maskOf(list: HTMLElement): string {
  const down = list.scrollHeight - list.clientHeight > SLACK;
  const hidden = down ? list.scrollHeight - list.clientHeight : list.scrollWidth - list.clientWidth;
  const before = Math.abs(down ? list.scrollTop : list.scrollLeft);
  const start = before > SLACK ? REACH : "0px";
  const end = hidden - before > SLACK ? REACH : "0px";
  if (start === end && start === "0px") return "none";
  const towards = down ? "bottom" : getComputedStyle(list).direction === "rtl" ? "left" : "right";
  return `linear-gradient(to ${towards}, transparent, #000 ${start}, #000 calc(100% - ${end}), transparent)`;
}

function moveRow(list: HTMLElement, event: WheelEvent): void {
  if (list.scrollWidth - list.clientWidth <= SLACK || event.deltaX !== 0 || event.ctrlKey) return;
  event.preventDefault();
  list.scrollBy({ left: event.deltaY });
}
