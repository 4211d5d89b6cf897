/**
 * A web server as far away as is asked for. The line is slow here and not in the browser, whose own throttling leaves workers
 * out: all that a page asks for, by whatever thread, shares one line, and is counted as it is sent.
 */
import { createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { setTimeout as pause } from "node:timers/promises";
import { promisify } from "node:util";
import { gzip } from "node:zlib";

export interface Answer {
  readonly status: number;
  readonly headers: Readonly<Record<string, string>>;
  readonly body: Uint8Array;
}

/** What stands behind an address. */
export type Source = (path: string) => Promise<Answer>;

/** Bytes a second, and milliseconds until an answer begins. Null: as fast as the machine is. */
export interface Line {
  readonly bytesPerSecond: number;
  readonly latency: number;
}

export interface Sent {
  readonly path: string;
  readonly type: string;
  /** As sent: compressed where a web server would. */
  readonly bytes: number;
}

/** As a packet or some: small enough that answers take turns. */
const PIECE = 8192;
const COMPRESSED = /^(text\/|application\/(javascript|json|wasm)|image\/svg)/;

export class SlowNetwork {
  line: Line | null = null;
  /** What was sent since this was last emptied. */
  sent: Sent[] = [];
  readonly #servers: ReturnType<typeof createServer>[] = [];
  readonly #compressed = new Map<string, Promise<Uint8Array>>();
  /** When the line has sent all that it was given, on `performance.now`'s clock. */
  #free = 0;

  /** @returns its origin */
  async serve(source: Source): Promise<string> {
    const at = this.#servers.length;
    const server = createServer(async (request, response) => {
      const path = request.url ?? "/";
      const { status, headers, body } = await source(path);
      const type = headers["content-type"] ?? "";
      const packed = COMPRESSED.test(type);
      const bytes = packed ? await this.#pack(`${at}${path}`, body) : body;
      if (this.line !== null) await pause(this.line.latency);
      response.writeHead(status, {
        ...headers,
        ...(packed && { "content-encoding": "gzip" }),
        "content-length": bytes.length,
      });
      for (let from = 0; from < bytes.length; from += PIECE) {
        const piece = bytes.subarray(from, from + PIECE);
        await this.#turn(piece.length);
        response.write(piece);
      }
      response.end();
      this.sent.push({ path, type, bytes: bytes.length });
    });
    this.#servers.push(server);
    await new Promise<void>((resolve) => server.listen(0, "localhost", resolve));
    return `http://localhost:${(server.address() as AddressInfo).port}`;
  }

  stop(): void {
    for (const server of this.#servers) {
      server.close();
      server.closeAllConnections();
    }
  }

  #pack(name: string, body: Uint8Array): Promise<Uint8Array> {
    const packed = this.#compressed.get(name) ?? promisify(gzip)(body, { level: 9 });
    this.#compressed.set(name, packed);
    return packed;
  }

  async #turn(bytes: number): Promise<void> {
    if (this.line === null) return;
    const now = performance.now();
    this.#free = Math.max(now, this.#free) + (bytes / this.line.bytesPerSecond) * 1000;
    await pause(this.#free - now);
  }
}
