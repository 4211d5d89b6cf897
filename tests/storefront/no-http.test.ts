/** What reaches neither a route nor Fastify's hooks, on both servers: it is told as any other refusal. */
import { once } from "node:events";
import fs, { type ReadStream } from "node:fs";
import { connect } from "node:net";
import path from "node:path";
import type { FastifyInstance } from "fastify";
import { afterAll, describe, expect, it, vi } from "vitest";
import { createEditorServer, originOf } from "../../node/storefront/editor-server.ts";
import { openShop } from "./shop-fixture.ts";

const { app: shop, folder } = await openShop();
const editor = await createEditorServer(path.join(folder, "site"), { shop: null, editor: null });
afterAll(() => editor.close());

it("a body that never comes to its end is refused in time, and nothing waits for it", async () => {
  const { app } = await openShop({ requestPatience: 100 });
  await app.listen({ port: 0, host: "127.0.0.1" });
  const head = "POST /api/carts HTTP/1.1\r\nHost: shop\r\nContent-Type: application/json\r\nContent-Length: 9\r\n\r\n";
  const answer = await answerTo(app, `${head}{`);
  expect(answer).toMatch(/^HTTP\/1.1 408 /);
  expect(answer).toContain('"code":"bad-request"');
});

it("somebody who hangs up before they are answered leaves nothing in the log", async () => {
  const { app, reported } = await openShop();
  await app.listen({ port: 0, host: "127.0.0.1" });
  const gone = connect(portOf(app), "127.0.0.1", () => {
    gone.write("GET /api/products HTTP/1.1\r\nHost: shop\r\n\r\n".repeat(20));
    setImmediate(() => gone.resetAndDestroy());
  });
  await once(gone, "close");
  // Whoever comes after them is answered, when all of theirs has been looked at.
  expect(await answerTo(app, "GET /api/products HTTP/1.1\r\nHost: shop\r\nConnection: close\r\n\r\n")).toMatch(
    / 200 OK/,
  );
  expect(reported).toEqual([]);
});

/** All that the server answers to these bytes before it hangs up. */
function answerTo(server: FastifyInstance, bytes: string): Promise<string> {
  return new Promise((resolve, reject) => {
    let answer = "";
    const socket = connect(portOf(server), "127.0.0.1", () => socket.write(bytes));
    socket.setEncoding("utf8").on("data", (part) => {
      answer += part;
    });
    socket.on("end", () => resolve(answer)).on("error", reject);
  });
}

const portOf = (server: FastifyInstance): number => Number(new URL(originOf(server, "127.0.0.1")).port);

describe.each([
  ["the shop", shop],
  ["the editor's server", editor],
])("%s", (_name, server) => {
  it("waits for no request for ever", () => expect(server.server.requestTimeout).toBeGreaterThan(0));

  it("answers what is asked in one go in its turn, and keeps no file open for whom hangs up", async () => {
    fs.writeFileSync(path.join(folder, "site/large.bin"), Buffer.alloc(4 * 2 ** 20));
    const opening = vi.spyOn(fs, "createReadStream").mockClear();
    const open = (): ReadStream[] =>
      opening.mock.results.map(({ value }) => value as ReadStream).filter(({ closed }) => !closed);
    if (!server.server.listening) await server.listen({ port: 0, host: "127.0.0.1" });
    const ask = (file: string, head = ""): string => `GET /${file} HTTP/1.1\r\nHost: shop\r\n${head}\r\n`;
    const answers = await answerTo(
      server,
      ask("index.html") + ask("none.html") + ask("index.html", "Connection: close\r\n"),
    );
    expect(answers.match(/HTTP\/1\.1 \d+/g)).toEqual(["HTTP/1.1 200", "HTTP/1.1 404", "HTTP/1.1 200"]);
    const gone = connect(portOf(server), "127.0.0.1", () => gone.write(ask("large.bin").repeat(5)));
    await once(gone, "readable");
    gone.destroy();
    expect(await answerTo(server, ask("index.html", "Connection: close\r\n"))).toMatch(/ 200 OK/);
    expect(opening).toHaveBeenCalled();
    await expect.poll(() => open().length).toBe(0);
  });

  it.each([
    ["what is no HTTP", "Guten Tag\r\n\r\n", 400],
    ["a method that HTTP does not know", "SHOP / HTTP/1.1\r\nHost: shop\r\n\r\n", 400],
    ["a head that is too long", `GET / HTTP/1.1\r\nHost: shop\r\nX: ${"x".repeat(20_000)}\r\n\r\n`, 431],
    ["an address that cannot be decoded", "GET /%ff HTTP/1.1\r\nHost: shop\r\nConnection: close\r\n\r\n", 400],
  ])("refuses %s in its own form", async (_what, bytes, status) => {
    if (server.addresses().length === 0) await server.listen({ port: 0, host: "127.0.0.1" });
    const [head = "", body = ""] = (await answerTo(server, bytes)).split("\r\n\r\n");
    expect(head).toMatch(new RegExp(`^HTTP/1.1 ${status} `));
    expect(head).toMatch(/^content-type: application\/json/im);
    expect(Number(/^content-length: (\d+)$/im.exec(head)?.[1])).toBe(Buffer.byteLength(body));
    const { error } = JSON.parse(body);
    expect(error).toMatchObject({ code: "bad-request", hint: expect.stringContaining("docs/storefront.md") });
    expect(error.message).toMatch(/\w/);
  });
});
