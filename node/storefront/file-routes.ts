/** Files by their SHA-256: pictures, fonts and snapshots on their way in, and all that is stored on its way out. */
import type { FastifyInstance } from "fastify";
import { SHOP_LIMITS } from "../../web/storefront/api/shop-api.ts";
import { checkAsset } from "./asset-check.ts";
import { isSha256, sha256Of } from "./asset-store.ts";
import type { Shop } from "./shop.ts";
import { shopError } from "./shop-error.ts";

/** What a file is sent as: its content is what counts, so that no sender's word about it is asked for. */
const BYTES = "application/octet-stream";

/** `/api/files/SHA256`: takes a file in under the name of its bytes, and gives it out. */
export function addFileRoutes(app: FastifyInstance, { store }: Shop): void {
  app.addContentTypeParser(BYTES, { parseAs: "buffer", bodyLimit: SHOP_LIMITS.assetBytes }, (_request, body, done) => {
    done(null, body);
  });

  app.put<{ Params: { sha256: string } }>(
    "/api/files/:sha256",
    { bodyLimit: SHOP_LIMITS.assetBytes },
    async (request, reply) => {
      const { sha256 } = request.params;
      if (!isSha256(sha256)) {
        throw shopError("bad-request", "a file's name must be its SHA-256: 64 digits of 0 to 9 and a to f", {
          field: "sha256",
          value: sha256.slice(0, 80),
        });
      }
      if (!(request.body instanceof Uint8Array)) {
        throw shopError("bad-request", `a file must be sent as ${BYTES}`, { field: "content-type" });
      }
      const bytes = request.body;
      const found = sha256Of(bytes);
      if (found !== sha256) {
        throw shopError("hash-mismatch", "the file's bytes are not those that its name says", {
          field: "sha256",
          value: sha256,
          hint: `They are ${found}: send them again.`,
        });
      }
      const type = await checkAsset(bytes, sha256);
      await store.put(bytes);
      return reply.code(201).send({ sha256, type, bytes: bytes.length });
    },
  );

  app.get<{ Params: { sha256: string } }>("/api/files/:sha256", async (request, reply) => {
    const bytes = await store.read(request.params.sha256);
    const type = await checkAsset(bytes, request.params.sha256);
    // A drawing that is opened by itself is a document: it may run nothing and fetch nothing.
    reply.header("content-security-policy", "default-src 'none'; sandbox");
    reply.header("cache-control", "private, max-age=31536000, immutable");
    if (type === "image/svg+xml") reply.header("content-disposition", "attachment");
    return reply.type(type).send(bytes);
  });
}
