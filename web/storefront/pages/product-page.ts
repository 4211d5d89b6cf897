/** A product with the editor on it: personalised here, priced as it changes, and put into the cart with all that prints it. */
import { html, nothing } from "lit";
import { ref } from "lit/directives/ref.js";
import type { ChangeDetail, PrintReport, SubmitDetail } from "../../element/element-api.ts";
import { type PrintedAmount, unitPriceOf } from "../api/price.ts";
import { type CartLine, type Product, SHOP_LIMITS } from "../api/shop-api.ts";
import { formatCount, formatPrice } from "../formats.ts";
import { findCart } from "../my-cart.ts";
import { openFrame, startPage } from "../page-frame.ts";
import { type PrintFinding, printFindings } from "../print-findings.ts";
import {
  type ProductEditor,
  type ProductEditorParts,
  placeElement,
  placeFrame,
  wantsFrame,
} from "../product-editor.ts";
import { designOf, putInCart } from "../put-in-cart.ts";
import { ShopError, shopClient } from "../shop-client.ts";
import { words } from "../words.ts";

/** Milliseconds without a change before the design is looked at with the printer's eyes: it takes some of its own. */
const VALIDATE_AFTER = 500;
/** Pixels of the cart's picture. */
const SNAPSHOT = { width: 480, height: 480 } as const;

const parameters = new URLSearchParams(location.search);
const frame = openFrame(words.shop, (cart) => {
  if (editor === null) return;
  // It was left on its way into the cart. A line that was ordered or taken out since is a new one when it goes there again.
  step = "";
  line = cart?.lines.find(({ id }) => id === line?.id) ?? null;
  draw();
});
/** Where the editor goes, once it is drawn. */
const { promise: place, resolve: foundPlace } = promiseOfPlace();

let editor: ProductEditor | null = null;
let product: Product;
/** The cart's line that is edited; null for a new one. */
let line: CartLine | null = null;
let amount: PrintedAmount = { decals: 0, area: 0 };
/** The server's price, where it was another than the page's. */
let told: number | null = null;
let names: ReadonlyMap<string, string> = new Map();
let findings: readonly PrintFinding[] = [];
/** What was said, and taken, as it is. */
let taken: readonly PrintFinding[] = [];
let step: "" | "preparing" | "sending" = "";
/** There is work on the product that is in no cart yet. */
let unsaved = false;
let waiting = 0;

startPage(frame, async () => {
  const parts = readPage();
  parts.catch(() => undefined);
  editor = wantsFrame(parameters)
    ? await placeFrame(await shopClient.editorPage(), place, parts)
    : await placeElement(place, parts);
});

async function readPage(): Promise<ProductEditorParts> {
  const products = await shopClient.products();
  const found = products.find(({ id }) => id === parameters.get("product"));
  if (found === undefined) throw new ShopError({ code: "not-found", message: words.noProduct });
  product = found;
  document.title = words.title(product.name);
  const asked = parameters.get("line");
  if (asked !== null) line = (await findCart())?.lines.find(({ id }) => id === asked) ?? null;
  // What the line's design was when it was put into the cart.
  const design = line === null ? null : await designOf(line);
  // No change tells of it before the first edit.
  if (line !== null) amount = line;
  draw();
  return { product, design, label: words.editorOf(product.name), onChange: changed, onSubmit: submitted };
}

function promiseOfPlace(): { promise: Promise<Element>; resolve: (place: Element) => void } {
  let resolve: (place: Element) => void = () => undefined;
  const promise = new Promise<Element>((done) => {
    resolve = done;
  });
  return { promise, resolve };
}

addEventListener("beforeunload", (event) => {
  if (unsaved) event.preventDefault();
});

function draw(): void {
  frame.show(html`
    <div class="product">
      <div class="editor-place" ${ref((element) => element && foundPlace(element))}></div>
      <section class="panel buy" aria-labelledby="product-name">
        <p class="crumb">
          <a href=${line === null ? "./index.html" : "./cart.html"}>${line === null ? words.back : words.backToCart}</a>
        </p>
        <h1 id="product-name">${product.name}</h1>
        <p class="quiet">${product.description}</p>
        <dl class="facts">
          ${product.facts.map(({ name, value }) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}
        </dl>
        ${findings.length === 0 ? nothing : checks()}
        <div class="price-place">${price()}</div>
        <form class="buy-bar" @submit=${buy}>
          <label class="pieces">
            <span>${words.quantity}</span>
            <input
              name="quantity"
              type="number"
              inputmode="numeric"
              required
              min="1"
              max=${SHOP_LIMITS.quantity}
              value=${line?.quantity ?? 1}
            />
          </label>
          <button class="button" aria-disabled=${step === "" ? "false" : "true"}>
            ${line === null ? words.addToCart : words.saveToCart}
            <span class="bar-price" aria-hidden="true">${formatPrice(unitPrice(), product.price.currency)}</span>
          </button>
        </form>
        <p class="step quiet" role="status">${step === "" ? nothing : words[step]}</p>
      </section>
    </div>
  `);
}

const areaNow = (): number => (product.price.perSquareCentimetre > 0 ? amount.area : 0);
const unitPrice = (): number => told ?? unitPriceOf(product.price, { decals: amount.decals, area: areaNow() });

function price() {
  const { currency, base, perDecal } = product.price;
  const [decals, area, unit] = [amount.decals, areaNow(), unitPrice()];
  return html`
    <dl class="price" aria-live="polite">
      <div><dt>${words.priceBase}</dt><dd>${formatPrice(base, currency)}</dd></div>
      ${
        decals === 0
          ? nothing
          : html`<div><dt>${words.priceDecals(decals)}</dt><dd>${formatPrice(perDecal * decals, currency)}</dd></div>`
      }
      ${
        area === 0
          ? nothing
          : html`<div>
              <dt>${words.priceArea(formatCount(Math.ceil(area)))}</dt>
              <dd>${formatPrice(unit - base - perDecal * decals, currency)}</dd>
            </div>`
      }
      <div class="sum"><dt>${words.price}</dt><dd>${formatPrice(unit, currency)}</dd></div>
    </dl>
  `;
}

/** What the printer would say; what must not be printed so asks for a word of the customer's. */
function checks() {
  const hints = findings.length - graveOnes().length;
  return html`
  <section class="checks" aria-labelledby="checks-title">
    <h2 id="checks-title">${words.checkTitle}</h2>
    <ul>
      ${graveOnes().map(({ layer, message, hint }) => html`<li class="grave"><strong>${layer}</strong> ${message} ${hint}</li>`)}
    </ul>
    ${hints === 0 ? nothing : html`<p>${words.hints(hints)}</p>`}
    ${
      mustBeSeen()
        ? html`<label class="seen">
            <input type="checkbox" .checked=${isTaken()} @change=${take} />
            <span>${words.printAnyway}</span>
          </label>`
        : nothing
    }
  </section>
`;
}

const graveOnes = (): PrintFinding[] => findings.filter(({ grave }) => grave);
const mustBeSeen = (): boolean => graveOnes().length > 0;
const isTaken = (): boolean => JSON.stringify(graveOnes()) === JSON.stringify(taken);

function take(event: Event): void {
  taken = (event.target as HTMLInputElement).checked ? graveOnes() : [];
  draw();
}

/** False where the customer has not taken yet what the printer would say. */
function confirmed(): boolean {
  if (!mustBeSeen() || isTaken()) return true;
  step = "";
  frame.setFault({ code: "not-seen", message: words.confirmFirst });
  draw();
  document.querySelector<HTMLElement>(".seen input")?.focus();
  return false;
}

function changed(detail: ChangeDetail): void {
  amount = { decals: detail.counts.decals + detail.counts.texts, area: detail.totalArea };
  told = null;
  names = new Map(detail.areas.map(({ id, name }) => [id, name]));
  unsaved = detail.canUndo;
  draw();
  clearTimeout(waiting);
  waiting = window.setTimeout(() => void check(), VALIDATE_AFTER);
}

function amountOf({ layers, whole }: PrintReport): PrintedAmount {
  return { decals: layers.filter(({ type }) => type === "decal").length, area: whole.areaCm2 };
}

async function check(): Promise<void> {
  // A design that cannot be looked at says so by the element's own `error` event.
  const report = await editor?.validate().catch(() => null);
  findings = report ? printFindings(report, names) : [];
  draw();
}

/** The button only asks; the editor's own button comes by the same way, to `submitted`. */
async function buy(event: SubmitEvent): Promise<void> {
  event.preventDefault();
  if (step !== "" || editor === null || !confirmed()) return;
  frame.setFault(null);
  step = "preparing";
  draw();
  try {
    await editor.submit();
  } catch (thrown) {
    step = "";
    frame.setFault(thrown);
    draw();
  }
}

async function submitted({ design, assets, texture, report }: SubmitDetail): Promise<void> {
  if (step === "sending" || editor === null) return;
  // What is handed in may hold an edit whose `change` is still to come.
  if (report !== null) {
    amount = amountOf(report);
    names = new Map(design.layers.map(({ id, name }) => [id, name]));
    findings = printFindings(report, names);
  }
  if (!confirmed()) return;
  step = "sending";
  // Of what is handed in, whatever is changed while it is on its way.
  const paid = unitPrice();
  draw();
  try {
    const snapshot = await editor.snapshot("current", SNAPSHOT);
    const field = document.querySelector<HTMLInputElement>('[name="quantity"]');
    const quantity = Math.max(1, field?.valueAsNumber || 1);
    const made = { product: product.id, design, assets, texture, snapshot, unitPrice: paid, quantity };
    await putInCart(made, line?.id ?? null);
    unsaved = false;
    location.assign("./cart.html");
  } catch (thrown) {
    step = "";
    if (thrown instanceof ShopError && thrown.fault.code === "price-changed") told = Number(thrown.fault.value);
    frame.setFault(thrown);
    draw();
  }
}
