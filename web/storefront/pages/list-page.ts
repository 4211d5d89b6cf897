/** The shop's first page: what there is. */
import { html } from "lit";
import type { Product } from "../api/shop-api.ts";
import { formatPrice } from "../formats.ts";
import { openFrame, startPage } from "../page-frame.ts";
import { shopClient } from "../shop-client.ts";
import { words } from "../words.ts";

const frame = openFrame(words.listTitle);
startPage(frame, async () => {
  const products = await shopClient.products();
  frame.show(html`
    <section class="lead">
      <h1>${words.listTitle}</h1>
      <p>${words.listLead}</p>
    </section>
    <ul class="cards">${products.map(card)}</ul>
  `);
});

const card = (product: Product) => html`
  <li class="card">
    <a href="./product.html?product=${encodeURIComponent(product.id)}">
      <img src=${product.picture} alt="" width="720" height="720" />
      <h2>${product.name}</h2>
      <p class="quiet">${product.tagline}</p>
      <p class="card-foot">
        <span>${words.from(formatPrice(product.price.base, product.price.currency))}</span>
        <span class="go" aria-hidden="true">${words.personalise}</span>
      </p>
    </a>
  </li>
`;
