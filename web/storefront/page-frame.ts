/** What all pages have: the bar with the cart, the place for faults, the page's own part, the line at the foot. */
import { html, nothing, render, type TemplateResult } from "lit";
import type { Cart, ShopFault } from "./api/shop-api.ts";
import { asSentence } from "./formats.ts";
import { findCart, piecesIn } from "./my-cart.ts";
import { ShopError } from "./shop-client.ts";
import { words } from "./words.ts";

export interface PageFrame {
  /** Draws the page's own part. */
  show(content: TemplateResult): void;
  /** The bar's count. */
  setCart(cart: Cart | null): void;
  /** Tells what went wrong; the page stays as it is. Null takes it away. */
  setFault(thrown: unknown): void;
}

/**
 * @param title of the browser's tab, without the shop's name
 * @param back called where the browser gives the page back as it was left (its cache for back and forward), with the cart of now
 */
export function openFrame(title: string, back?: (cart: Cart | null) => void): PageFrame {
  document.title = words.title(title);
  let content: TemplateResult = html`<p class="quiet" role="status">${words.loading}</p>`;
  let pieces = 0;
  let fault: ShopFault | null = null;
  const draw = (): void => {
    render(
      frame(content, pieces, fault, () => frameApi.setFault(null)),
      document.body,
    );
  };
  const frameApi: PageFrame = {
    show(next) {
      content = next;
      draw();
    },
    setCart(cart) {
      pieces = piecesIn(cart);
      draw();
    },
    setFault(thrown) {
      fault = thrown === null ? null : faultOf(thrown);
      draw();
    },
  };
  draw();
  findCart().then(frameApi.setCart, frameApi.setFault);
  addEventListener("pageshow", ({ persisted }) => {
    if (!persisted) return;
    findCart().then((cart) => {
      frameApi.setCart(cart);
      back?.(cart);
    }, frameApi.setFault);
  });
  return frameApi;
}

/** Runs the page's start; what it throws is shown in the page. */
export function startPage(frame: PageFrame, start: () => Promise<void>): void {
  start().catch((thrown: unknown) => {
    frame.show(html``);
    frame.setFault(thrown);
  });
}

function faultOf(thrown: unknown): ShopFault {
  if (thrown instanceof ShopError) return thrown.fault;
  const { code = "page-fault", message = String(thrown), hint } = (thrown ?? {}) as Partial<ShopFault>;
  // Customers have no say in addresses; the editor's own `error` event has them.
  if (message.includes("://")) return { code, message: words.partMissing, hint: words.offlineHint };
  return { code, message, ...(hint !== undefined && { hint }) };
}

function frame(content: TemplateResult, pieces: number, fault: ShopFault | null, close: () => void): TemplateResult {
  return html`
    <a class="skip" href="#content">${words.skip}</a>
    <header class="bar">
      <a class="mark" href="./index.html"><span class="dot" aria-hidden="true"></span>${words.shopName}</a>
      <nav>
        <a href="./index.html">${words.shop}</a>
        <a class="cart-link" href="./cart.html" aria-label=${words.cartWith(pieces)}>
          ${words.cart} ${pieces > 0 ? html`<span class="count" aria-hidden="true">${pieces}</span>` : nothing}
        </a>
      </nav>
    </header>
    <div class="fault-place" role="alert">
      ${
        fault === null
          ? nothing
          : html`<div class="fault">
              <p><strong>${asSentence(fault.message)}</strong> ${fault.hint ?? nothing}</p>
              <button type="button" class="plain" @click=${close}>${words.closeFault}</button>
            </div>`
      }
    </div>
    <main id="content" tabindex="-1">${content}</main>
    <footer><p>${words.footer}</p></footer>
  `;
}
