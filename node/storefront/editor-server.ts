/** The editor's page on an origin of its own, for product pages that frame it: it knows one shop, and serves files alone. */
import { readFile } from "node:fs/promises";
import type { AddressInfo } from "node:net";
import path from "node:path";
import helmet from "@fastify/helmet";
import serveStatic from "@fastify/static";
import Fastify, { type FastifyInstance } from "fastify";
import { answerInTurn } from "./answers-in-turn.ts";
import { EDITOR_POLICY, orNone } from "./content-policy.ts";
import { giveLastAnswers } from "./last-answers.ts";
import { answerNoAddress, patienceOf, REFUSALS, replyTo } from "./shop-error.ts";

/** Where the shop and its editor are, as browsers see them; null until they listen. */
export interface ShopOrigins {
  shop: string | null;
  editor: string | null;
}

/** Exact origins, with spaces between, in the page's `texelcast-shops`. */
const LISTED = 'name="texelcast-shops" content=""';
const PAGE = "/editor.html";

/** The address of the page that product pages frame; null until the editor's server listens. */
export const editorPageOf = (origins: ShopOrigins): string | null =>
  origins.editor === null ? null : `${origins.editor}${PAGE}`;

/** What browsers on this machine call a server that listens. @param host that it was told to listen on */
export function originOf(server: FastifyInstance, host: string): string {
  const name = ["0.0.0.0", "::"].includes(host) ? "localhost" : host;
  const [{ port }] = server.addresses() as [AddressInfo];
  return `http://${name.includes(":") ? `[${name}]` : name}:${port}`;
}

/** @param site the shop's built pages */
export async function createEditorServer(site: string, origins: ShopOrigins): Promise<FastifyInstance> {
  const app = Fastify({
    forceCloseConnections: true,
    return503OnClosing: false,
    ...patienceOf(),
    ...REFUSALS,
  });
  giveLastAnswers(app);
  answerInTurn(app);
  app.setErrorHandler((error, _request, reply) => {
    const { status, body } = replyTo(error);
    return reply.code(status).send(body);
  });
  app.setNotFoundHandler(answerNoAddress);
  await app.register(helmet, {
    contentSecurityPolicy: {
      useDefaults: false,
      directives: { ...EDITOR_POLICY, "frame-ancestors": [() => orNone(origins.shop)] },
    },
    strictTransportSecurity: false,
    // It knows no exact origins; `frame-ancestors` does.
    xFrameOptions: false,
  });
  await app.register(serveStatic, { root: site, cacheControl: false });
  app.get(PAGE, async (_request, reply) => {
    const page = await readFile(path.join(site, PAGE), "utf8");
    return reply
      .type("text/html; charset=utf-8")
      .send(page.replace(LISTED, LISTED.replace('""', `"${origins.shop ?? ""}"`)));
  });
  return app;
}
