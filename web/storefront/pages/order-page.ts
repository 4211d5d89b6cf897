/** An order: the hash of what was approved beside that of the print file, and the file itself. */
import { html, nothing } from "lit";
import type { Order, OrderLine } from "../api/shop-api.ts";
import { asSentence, formatBytes, formatDate, formatPrice } from "../formats.ts";
import { openFrame, startPage } from "../page-frame.ts";
import { fileAddress, printFileAddress, shopClient } from "../shop-client.ts";
import { words } from "../words.ts";

/** Milliseconds between two questions whether the print files are done. */
const PATIENCE = 800;
/** The same after one that was not answered, which many may have asked at once. */
const PATIENCE_AFTER_FAULT = 3000;

const frame = openFrame(words.order);
startPage(frame, async () => {
  const id = new URLSearchParams(location.search).get("order");
  if (id === null) throw new Error(words.noOrder);
  let order = await shopClient.orderOf(id);
  for (;;) {
    document.title = words.title(words.orderTitle(order.number));
    show(order);
    if (order.lines.every(({ status }) => status === "ready" || status === "held")) return;
    order = await nextOf(order);
  }
});

/** The order as it is a moment later. A server that does not answer meanwhile takes nothing from the page, and is asked again. */
async function nextOf({ id }: Order): Promise<Order> {
  for (let failed = false; ; failed = true) {
    await new Promise((resolve) => setTimeout(resolve, failed ? PATIENCE_AFTER_FAULT : PATIENCE));
    try {
      const order = await shopClient.orderOf(id);
      if (failed) frame.setFault(null);
      return order;
    } catch (thrown) {
      frame.setFault(thrown);
    }
  }
}

function show(order: Order): void {
  frame.show(html`
    <section class="lead">
      <p class="quiet">${words.orderTitle(order.number)} · ${formatDate(order.created)}</p>
      <h1>${words.orderThanks(order.name)}</h1>
      <p role="status">${stateOf(order)}</p>
    </section>
    <ul class="lines ordered">${order.lines.map((line) => orderedLine(order, line))}</ul>
    <p class="total order-total"><span>${words.total}</span><strong>${formatPrice(order.total, order.currency)}</strong></p>
  `);
}

function stateOf({ lines }: Order): string {
  if (lines.some(({ status }) => status === "held")) return words.orderHeld;
  return lines.every(({ status }) => status === "ready") ? words.orderReady : words.orderWaiting;
}

function orderedLine(order: Order, line: OrderLine) {
  const { approved, printed, fault, status } = line;
  const same = printed !== null && printed.sha256 === approved.sha256;
  return html`
    <li class="line" data-status=${status}>
      <img src=${fileAddress(line.snapshot)} alt=${words.snapshotOf(line.productName)} width="144" height="144" />
      <div class="line-words">
        <h2>${line.quantity} × ${line.productName}</h2>
        <p class="state">${words.status[status]}</p>
        <dl class="hashes">
          <dt>${words.approved}</dt>
          <dd class="hash" data-hash="approved">${approved.sha256}</dd>
          <dt>${words.printed}</dt>
          <dd class="hash" data-hash="printed">${printed?.sha256 ?? "…"}</dd>
        </dl>
        ${printed === null ? nothing : html`<p class=${same ? "same" : "wrong"}>${same ? words.same : words.notSame}</p>`}
        ${fault === null ? nothing : html`<p class="wrong">${asSentence(fault.message)} ${fault.hint ?? nothing}</p>`}
        ${status === "ready" && printed !== null ? download(order, line, printed) : nothing}
      </div>
    </li>
  `;
}

const download = (order: Order, line: OrderLine, printed: NonNullable<OrderLine["printed"]>) => html`
  <p class="file">
    <a
      class="button"
      href=${printFileAddress(order.id, line.id)}
      download
      aria-label=${words.downloadOf(line.productName)}
      >${words.download}</a
    >
    <span class="quiet">${words.fileFacts(printed.width, printed.height, formatBytes(printed.bytes))}</span>
  </p>
`;
