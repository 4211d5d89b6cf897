/** The cart: what was personalised, how many of it, and the order. */
import { html, nothing } from "lit";
import { repeat } from "lit/directives/repeat.js";
import { type Cart, type CartLine, type LineRequest, type Product, SHOP_LIMITS } from "../api/shop-api.ts";
import { formatPrice } from "../formats.ts";
import { findCart } from "../my-cart.ts";
import { openFrame, startPage } from "../page-frame.ts";
import { fileAddress, ShopError, shopClient } from "../shop-client.ts";
import { words } from "../words.ts";

const frame = openFrame(words.cartTitle, (found) => {
  // It was left while the order that it waited for was shown, or a line edited.
  cart = found;
  busy = false;
  draw();
});
let cart: Cart | null = null;
let products = new Map<string, Product>();
/** The line that was taken out last: it can be put back. */
let removed: CartLine | null = null;
let busy = false;
let nameMissing = false;

startPage(frame, async () => {
  products = new Map((await shopClient.products()).map((product) => [product.id, product]));
  cart = await findCart();
  draw();
});

const nameOf = (line: CartLine): string => products.get(line.product)?.name ?? line.product;

function draw(): void {
  frame.setCart(cart);
  frame.show(html`
    <h1>${words.cartTitle}</h1>
    <div class="notice-place" role="status">
      ${
        removed === null
          ? nothing
          : html`<p class="notice">
              <span>${words.removed(nameOf(removed))}</span>
              <button type="button" class="plain" @click=${putBack}>${words.undo}</button>
            </p>`
      }
    </div>
    ${cart === null || cart.lines.length === 0 ? empty() : filled(cart)}
  `);
}

const empty = () => html`
  <div class="empty">
    <p>${words.cartEmpty} <span class="quiet">${words.cartEmptyLead}</span></p>
    <a class="button" href="./index.html">${words.toShop}</a>
  </div>
`;

const filled = ({ lines, currency, total }: Cart) => html`
  <div class="checkout">
    <ul class="lines">
      ${repeat(
        lines,
        ({ id }) => id,
        (line) => lineRow(line, currency),
      )}
    </ul>
    <form class="panel" novalidate @submit=${order}>
      <p class="total"><span>${words.total}</span><strong>${formatPrice(total, currency)}</strong></p>
      <label for="name">${words.name}</label>
      <input
        id="name"
        name="name"
        autocomplete="name"
        maxlength=${SHOP_LIMITS.nameLength}
        aria-describedby="name-hint"
        aria-invalid=${nameMissing ? "true" : "false"}
      />
      <p id="name-hint" class=${nameMissing ? "wrong" : "quiet"}>${nameMissing ? words.nameMissing : words.nameHint}</p>
      <button class="button wide" aria-disabled=${busy ? "true" : "false"}>${busy ? words.ordering : words.order}</button>
    </form>
  </div>
`;

function lineRow(line: CartLine, currency: string) {
  const name = nameOf(line);
  const editing = new URLSearchParams({ product: line.product, line: line.id });
  return html`
    <li class="line">
      <img src=${fileAddress(line.snapshot)} alt=${words.snapshotOf(name)} width="144" height="144" />
      <div class="line-words">
        <h2>${name}</h2>
        <p class="quiet">
          ${words.priceDecals(line.decals)} · ${words.each(formatPrice(line.unitPrice, currency))}
        </p>
        <p class="line-actions">
          <a href="./product.html?${editing}" aria-label=${words.editOf(name)}>${words.edit}</a>
          <button type="button" class="plain" aria-label=${words.removeOf(name)} @click=${() => remove(line)}>
            ${words.remove}
          </button>
        </p>
      </div>
      <label class="line-quantity">
        <span class="quiet">${words.quantity}</span>
        <input
          type="number"
          inputmode="numeric"
          min="1"
          max=${SHOP_LIMITS.quantity}
          aria-label=${words.piecesOf(name)}
          .value=${String(line.quantity)}
          @change=${(event: Event) => setQuantity(line, event.target as HTMLInputElement)}
        />
      </label>
      <p class="line-price">${formatPrice(line.unitPrice * line.quantity, currency)}</p>
    </li>
  `;
}

/** Asks the server and shows the cart that it answers with; a fault leaves the cart as it was. */
async function change(work: (id: string) => Promise<{ readonly cart: Cart }>): Promise<boolean> {
  if (cart === null || busy) return false;
  frame.setFault(null);
  busy = true;
  try {
    cart = (await work(cart.id)).cart;
    return true;
  } catch (thrown) {
    frame.setFault(thrown);
    return false;
  } finally {
    busy = false;
    draw();
  }
}

async function setQuantity(line: CartLine, field: HTMLInputElement): Promise<void> {
  const asked = Math.round(field.valueAsNumber);
  const quantity = Math.min(SHOP_LIMITS.quantity, Math.max(1, Number.isNaN(asked) ? line.quantity : asked));
  field.value = String(quantity);
  const done = quantity === line.quantity || (await change((id) => shopClient.setQuantity(id, line.id, quantity)));
  if (!done) field.value = String(line.quantity);
}

async function remove(line: CartLine): Promise<void> {
  if (!(await change((id) => shopClient.removeLine(id, line.id)))) return;
  removed = line;
  draw();
  // What had the focus is gone with its line.
  document.querySelector<HTMLElement>(".notice button")?.focus();
}

async function putBack(): Promise<void> {
  if (removed === null) return;
  const { product, design, approved, snapshot, unitPrice, quantity } = removed;
  const request: LineRequest = { product, design, assets: [], approved, snapshot, unitPrice, quantity };
  if (!(await change((id) => shopClient.addLine(id, request)))) return;
  removed = null;
  draw();
  document.querySelector<HTMLElement>(".line:last-child a")?.focus();
}

async function order(event: SubmitEvent): Promise<void> {
  event.preventDefault();
  const field = (event.target as HTMLFormElement).elements.namedItem("name") as HTMLInputElement;
  const name = field.value.trim();
  nameMissing = name === "";
  draw();
  if (nameMissing) {
    field.focus();
    return;
  }
  if (cart === null || busy) return;
  busy = true;
  frame.setFault(null);
  draw();
  try {
    const id = await orderedId(cart.id, name);
    location.assign(`./order.html?order=${encodeURIComponent(id)}`);
  } catch (thrown) {
    busy = false;
    frame.setFault(thrown);
    draw();
  }
}

/** Also of an order that was made already, and whose answer was lost on the way. */
async function orderedId(cart: string, name: string): Promise<string> {
  try {
    return (await shopClient.order(cart, name)).id;
  } catch (thrown) {
    const { code, field, value } = thrown instanceof ShopError ? thrown.fault : {};
    if (code === "bad-request" && field === "cart" && value !== undefined) return value;
    throw thrown;
  }
}
