/** What the example shop sells: the demo's models, their words and their prices. */
import type { Product } from "../../../web/storefront/api/shop-api.ts";

export const SHOP_PRODUCTS: readonly Product[] = [
  {
    id: "mug",
    name: "Stoneware mug",
    tagline: "Your picture, all the way round",
    description:
      "Cream glaze outside, coral inside. The print goes round the wall and leaves the handle free, and it stays on in the dishwasher.",
    facts: [
      { name: "Height", value: "95 mm" },
      { name: "Diameter", value: "82 mm" },
      { name: "Print area", value: "210 × 74 mm" },
    ],
    model: "demo/mug.glb",
    zones: "shop/mug.zones.json",
    picture: "shop/mug.webp",
    poster: "shop/mug-plain.webp",
    material: 0,
    camera: "-28deg 76deg 105%",
    price: { currency: "EUR", base: 1490, perDecal: 150, perSquareCentimetre: 3 },
  },
  {
    id: "figure",
    name: "Desk figure",
    tagline: "A small someone in your team's colours",
    description:
      "Printed in full colour, 18 centimetres tall. Chest and back of the shirt are yours: a crest, a number, a name.",
    facts: [
      { name: "Height", value: "180 mm" },
      { name: "Scale", value: "1 : 10" },
      { name: "Print areas", value: "Chest and back" },
    ],
    model: "demo/avatar.glb",
    zones: "shop/figure.zones.json",
    picture: "shop/figure.webp",
    poster: "shop/figure-plain.webp",
    material: 0,
    camera: "22deg 82deg 105%",
    price: { currency: "EUR", base: 2490, perDecal: 200, perSquareCentimetre: 12 },
  },
  {
    id: "skateboard",
    name: "Maple skateboard",
    tagline: "Ride your own graphic",
    description:
      "A complete board, eight plies of maple, with trucks and wheels. The underside is printed up to its rounded edge.",
    facts: [
      { name: "Length", value: "792 mm" },
      { name: "Width", value: "205 mm" },
      { name: "Print area", value: "The whole underside" },
    ],
    model: "demo/skateboard.glb",
    zones: "shop/skateboard.zones.json",
    picture: "shop/skateboard.webp",
    poster: "shop/skateboard-plain.webp",
    material: 0,
    camera: "28deg 84deg 105%",
    price: { currency: "EUR", base: 7900, perDecal: 500, perSquareCentimetre: 2 },
  },
];
