/**
 * What the shop's pages and its order server say to each other: JSON below `/api`, and files by their SHA-256. Types alone;
 * the server checks what arrives (`node/storefront`). docs/storefront.md has it as a table.
 */

/** SHA-256 as 64 lower-case hex digits. */
export type Sha256 = string;

/** Amounts in the currency's smallest unit (cents). */
export interface PriceRule {
  /** ISO 4217. */
  readonly currency: string;
  /** One piece, not personalised. */
  readonly base: number;
  /** Each picture or text on it. */
  readonly perDecal: number;
  /** Printed surface. */
  readonly perSquareCentimetre: number;
}

export interface Product {
  readonly id: string;
  readonly name: string;
  /** A few words under the name. */
  readonly tagline: string;
  readonly description: string;
  readonly facts: readonly { readonly name: string; readonly value: string }[];
  /** Addresses relative to the shop's root. */
  readonly model: string;
  readonly zones: string;
  /** With a design on it. */
  readonly picture: string;
  /** As it is before anybody puts something on it. */
  readonly poster: string;
  /** glTF index of the material that is printed. */
  readonly material: number;
  /** Where the first look comes from, as the editor's `camera-orbit` has it. */
  readonly camera: string;
  readonly price: PriceRule;
}

/** Where the editor's page is that may be framed: an origin of its own. */
export interface EditorReply {
  readonly page: string;
}

/** A file of a design: a key of the design's `assets`, and the stored file that holds its bytes. */
export interface AssetReference {
  readonly key: string;
  readonly sha256: Sha256;
}

/** What the customer saw and agreed to: the print file's hash, as the page made it. */
export interface Approval {
  readonly sha256: Sha256;
  /** Texels. */
  readonly width: number;
  readonly height: number;
}

/** What the page sends to put a personalised product into a cart, or in the place of one that is there. */
export interface LineRequest {
  readonly product: string;
  /** A design document; the server reads it with the editor's own parser. */
  readonly design: unknown;
  /** One for each of the design's assets but the fonts that come with Texelcast. Their files are stored before. */
  readonly assets: readonly AssetReference[];
  readonly approved: Approval;
  /** The stored picture of the product, for the cart. */
  readonly snapshot: Sha256;
  /** What the page showed for one piece, in the currency's smallest unit: refused with "price-changed" where it is another. */
  readonly unitPrice: number;
  readonly quantity: number;
}

export interface CartLine {
  readonly id: string;
  readonly product: string;
  /** The design as it was read, its assets' addresses those of the stored files: can be edited again. */
  readonly design: unknown;
  readonly approved: Approval;
  readonly snapshot: Sha256;
  readonly quantity: number;
  /** Pictures and texts, counted by the server. */
  readonly decals: number;
  /** Printed surface of one piece, square centimetres, measured by the server. */
  readonly area: number;
  /** Of one piece, in the currency's smallest unit. */
  readonly unitPrice: number;
}

export interface Cart {
  readonly id: string;
  readonly lines: readonly CartLine[];
  readonly currency: string;
  readonly total: number;
}

/** "held": the print file is not what was approved, or could not be made; nothing is printed. */
export type PrintStatus = "waiting" | "rendering" | "ready" | "held";

export interface OrderLine extends CartLine {
  readonly productName: string;
  readonly status: PrintStatus;
  /** The print file's hash, as the server made it; null until then. */
  readonly printed: (Approval & { readonly bytes: number }) | null;
  /** Why it is held. */
  readonly fault: ShopFault | null;
}

export interface Order {
  readonly id: string;
  /** For people: rises by one an order. */
  readonly number: number;
  /** Who ordered, as written on the parcel. */
  readonly name: string;
  /** ISO 8601. */
  readonly created: string;
  readonly lines: readonly OrderLine[];
  readonly currency: string;
  readonly total: number;
}

/** A TexelcastError as it comes over the wire, in `{ "error": … }`; written out, as this contract imports nothing. */
export interface ShopFault {
  readonly code: string;
  readonly message: string;
  readonly subject?: string;
  readonly field?: string;
  readonly value?: string;
  readonly hint?: string;
}

/** What the server takes; more is refused with "too-large". */
export const SHOP_LIMITS = {
  /** Bytes of a picture or font. */
  assetBytes: 32 * 2 ** 20,
  /** Pixels of a picture. */
  assetPixels: 64 * 2 ** 20,
  /** Bytes of a request that is JSON, the design in it. */
  jsonBytes: 2 * 2 ** 20,
  /** Files that one design uses. */
  assetsPerDesign: 64,
  /** Layers of one design, those within others included; of a stroke, as many as its dabs cover the product, at least 1/50 a dab. */
  layersPerDesign: 200,
  linesPerCart: 50,
  quantity: 999,
  nameLength: 120,
  /** Bytes of all stored files. */
  storedBytes: 4 * 2 ** 30,
  /** Days that a file is kept which no line of a cart or an order names. */
  unusedDays: 14,
  /** From one address, below `/api`. */
  requestsPerMinute: 600,
  /** Of those, the ones that the press works for: lines put into carts. */
  linesPerMinute: 60,
} as const;
