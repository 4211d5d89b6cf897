/** Carts and orders in SQLite: what is kept, and the few questions that are asked of it. */
import { randomBytes } from "node:crypto";
import sqlite from "node-sqlite3-wasm";
import type { CartLine, OrderLine, PrintStatus, ShopFault } from "../../web/storefront/api/shop-api.ts";
import { claimDatabase } from "./data-lock.ts";

const SCHEMA = `
CREATE TABLE IF NOT EXISTS carts (
  id TEXT PRIMARY KEY,
  created TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS cart_lines (
  place INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  cart TEXT NOT NULL REFERENCES carts(id) ON DELETE CASCADE,
  item TEXT NOT NULL
) STRICT;
CREATE INDEX IF NOT EXISTS cart_lines_of_cart ON cart_lines(cart);
CREATE TABLE IF NOT EXISTS orders (
  number INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  name TEXT NOT NULL,
  created TEXT NOT NULL
) STRICT;
CREATE TABLE IF NOT EXISTS ordered_carts (
  cart TEXT PRIMARY KEY REFERENCES carts(id) ON DELETE CASCADE,
  order_id TEXT NOT NULL REFERENCES orders(id)
) STRICT;
CREATE TABLE IF NOT EXISTS order_lines (
  place INTEGER PRIMARY KEY AUTOINCREMENT,
  id TEXT NOT NULL UNIQUE,
  order_id TEXT NOT NULL REFERENCES orders(id),
  item TEXT NOT NULL,
  status TEXT NOT NULL CHECK (status IN ('waiting', 'rendering', 'ready', 'held')),
  printed TEXT,
  fault TEXT
) STRICT;
CREATE INDEX IF NOT EXISTS order_lines_of_order ON order_lines(order_id);
`;

/** What a line is about, as it was when it was put into the cart; its price does not change after. */
export type Item = Omit<CartLine, "id"> & Pick<OrderLine, "productName">;

export interface StoredLine extends Item {
  readonly id: string;
}

export type StoredOrderLine = Omit<OrderLine, keyof Item> & StoredLine;

export interface StoredOrder {
  readonly id: string;
  readonly number: number;
  readonly name: string;
  readonly created: string;
  readonly lines: readonly StoredOrderLine[];
}

type Row = Record<string, string | number | null>;

/** Nobody guesses 144 bits: whoever has an id was given it. */
const newId = (): string => randomBytes(18).toString("base64url");

export class ShopDatabase {
  readonly #db: InstanceType<typeof sqlite.Database>;

  readonly #release: () => void;

  /**
   * @param file ":memory:" for one that is not kept
   * @throws TexelcastError "database-taken" while another server is at work on it.
   */
  constructor(file: string) {
    this.#release = file === ":memory:" ? () => {} : claimDatabase(file);
    try {
      this.#db = new sqlite.Database(file);
      this.#db.exec(SCHEMA);
    } catch (error) {
      this.#release();
      throw error;
    }
  }

  close(): void {
    this.#db.close();
    this.#release();
  }

  makeCart(): string {
    const id = newId();
    this.#db.run("INSERT INTO carts (id, created) VALUES (?, ?)", [id, now()]);
    return id;
  }

  hasCart(id: string): boolean {
    return this.#one("SELECT id FROM carts WHERE id = ?", [id]) !== null;
  }

  linesOf(cart: string): StoredLine[] {
    return this.#all("SELECT id, item FROM cart_lines WHERE cart = ? ORDER BY place", [cart]).map(readLine);
  }

  lineOf(cart: string, line: string): StoredLine | null {
    const row = this.#one("SELECT id, item FROM cart_lines WHERE cart = ? AND id = ?", [cart, line]);
    return row && readLine(row);
  }

  addLine(cart: string, item: Item): string {
    const id = newId();
    this.#together(() => {
      this.#db.run("INSERT INTO cart_lines (id, cart, item) VALUES (?, ?, ?)", [id, cart, JSON.stringify(item)]);
      this.#db.run("DELETE FROM ordered_carts WHERE cart = ?", [cart]);
    });
    return id;
  }

  /** False where there is no such line. */
  replaceLine(cart: string, line: string, item: Item): boolean {
    const values = [JSON.stringify(item), cart, line];
    return this.#db.run("UPDATE cart_lines SET item = ? WHERE cart = ? AND id = ?", values).changes > 0;
  }

  /** False where there is no such line. */
  removeLine(cart: string, line: string): boolean {
    return this.#db.run("DELETE FROM cart_lines WHERE cart = ? AND id = ?", [cart, line]).changes > 0;
  }

  /** The order that emptied a cart; null where something was put in since. */
  lastOrderOf(cart: string): string | null {
    const row = this.#one("SELECT order_id FROM ordered_carts WHERE cart = ?", [cart]);
    return row && String(row.order_id);
  }

  /** Makes an order of all that is in the cart, which is empty afterwards: both or neither. Null for an empty cart. */
  order(cart: string, name: string): string | null {
    const lines = this.linesOf(cart);
    if (lines.length === 0) return null;
    const order = newId();
    this.#together(() => {
      this.#db.run("INSERT INTO orders (id, name, created) VALUES (?, ?, ?)", [order, name, now()]);
      for (const { id: _, ...item } of lines) {
        const values = [newId(), order, JSON.stringify(item)];
        this.#db.run("INSERT INTO order_lines (id, order_id, item, status) VALUES (?, ?, ?, 'waiting')", values);
      }
      this.#db.run("DELETE FROM cart_lines WHERE cart = ?", [cart]);
      this.#db.run("INSERT OR REPLACE INTO ordered_carts (cart, order_id) VALUES (?, ?)", [cart, order]);
    });
    return order;
  }

  orderOf(id: string): StoredOrder | null {
    const row = this.#one("SELECT id, number, name, created FROM orders WHERE id = ?", [id]);
    if (row === null) return null;
    const lines = this.#all("SELECT * FROM order_lines WHERE order_id = ? ORDER BY place", [id]).map(readOrderLine);
    return { id, number: Number(row.number), name: String(row.name), created: String(row.created), lines };
  }

  /** Lets lines wait again whose printing was broken off: by a server that ended, or by a fault of the database. */
  waitAgain(): void {
    this.#db.run("UPDATE order_lines SET status = 'waiting' WHERE status = 'rendering'");
  }

  /** The line that has waited longest for its print file. */
  nextToPrint(): StoredOrderLine | null {
    const row = this.#one("SELECT * FROM order_lines WHERE status = 'waiting' ORDER BY place LIMIT 1", []);
    return row && readOrderLine(row);
  }

  setPrint(line: string, status: PrintStatus, told: Partial<Pick<StoredOrderLine, "printed" | "fault">> = {}): void {
    const values = [status, toJson(told.printed), toJson(told.fault), line];
    this.#db.run("UPDATE order_lines SET status = ?, printed = ?, fault = ? WHERE id = ?", values);
  }

  /** Every file that a line of a cart or an order names: pictures, fonts, snapshots, print files. */
  filesInUse(): Set<string> {
    const rows = this.#all(
      `SELECT item, NULL AS printed FROM cart_lines
       UNION ALL SELECT item, CASE status WHEN 'ready' THEN printed END FROM order_lines`,
      [],
    );
    return new Set(rows.flatMap(({ item, printed }) => `${item} ${printed ?? ""}`.match(/\b[0-9a-f]{64}\b/g) ?? []));
  }

  #one(sql: string, values: string[]): Row | null {
    return this.#db.get(sql, values) as Row | null;
  }

  #all(sql: string, values: string[]): Row[] {
    return this.#db.all(sql, values) as Row[];
  }

  #together(work: () => void): void {
    this.#db.exec("BEGIN IMMEDIATE");
    try {
      work();
      this.#db.exec("COMMIT");
    } catch (error) {
      // A full disk makes SQLite take all of it back by itself.
      if (this.#db.inTransaction) this.#db.exec("ROLLBACK");
      throw error;
    }
  }
}

const now = (): string => new Date().toISOString();
const toJson = (value: unknown): string | null =>
  value === undefined || value === null ? null : JSON.stringify(value);

function readLine(row: Row): StoredLine {
  return { ...(JSON.parse(String(row.item)) as Item), id: String(row.id) };
}

function readOrderLine(row: Row): StoredOrderLine {
  return {
    ...readLine(row),
    status: row.status as PrintStatus,
    printed: row.printed === null ? null : (JSON.parse(String(row.printed)) as OrderLine["printed"]),
    fault: row.fault === null ? null : (JSON.parse(String(row.fault)) as ShopFault),
  };
}
