/** How the shop refuses: a TexelcastError, and the HTTP status that goes with its code. */
import { STATUS_CODES } from "node:http";
import type { Socket } from "node:net";
import type { FastifyError, FastifyReply, FastifyRequest } from "fastify";
import { TexelcastError, type TexelcastErrorDetails, type TexelcastErrorJson } from "../../web/core/texelcast-error.ts";

/** Codes that are the shop's own; those of designs and pictures are the editor's. */
export type ShopErrorCode =
  | "bad-request"
  | "not-found"
  | "too-large"
  | "hash-mismatch"
  | "storage-full"
  | "price-changed"
  | "too-many-requests";

const STATUS_OF_CODE: Readonly<Record<string, number>> = {
  "bad-request": 400,
  "not-found": 404,
  "too-large": 413,
  "hash-mismatch": 422,
  "bad-design": 422,
  "bad-picture": 422,
  "bad-font": 422,
  "unsafe-file": 422,
  "storage-full": 507,
  "price-changed": 409,
  "too-many-requests": 429,
  // The press's own: it can be tried again.
  "press-failed": 503,
  timeout: 503,
  // The engine's own, about what it was given.
  "missing-file": 422,
  "bad-size": 422,
  "bad-argument": 422,
  "out-of-budget": 413,
};

/** A refusal in the shop's own words; its status goes by the code. */
export const shopError = (code: ShopErrorCode, message: string, details?: TexelcastErrorDetails): TexelcastError =>
  new TexelcastError(code, message, details);

/** @param id as it was asked for; cut after 80 characters */
export const notFound = (what: string, id: string): TexelcastError =>
  shopError("not-found", `there is no such ${what}`, {
    field: what,
    value: id.slice(0, 80),
    hint: "It may have been ordered or taken away: go back to the shop's first page.",
  });

/** @param wait milliseconds until somebody is heard again */
export const tooManyRequests = (wait: number): TexelcastError =>
  shopError("too-many-requests", "the shop was asked too often in a short time", {
    value: `${Math.ceil(wait / 1000)} s`,
    hint: `Try again in ${Math.ceil(wait / 1000)} seconds.`,
  });

export interface ErrorReply {
  readonly status: number;
  readonly body: { readonly error: TexelcastErrorJson };
  /** Nothing that the sender did: belongs into the log. */
  readonly unexpected: boolean;
}

/** The answer to anything thrown. What is not ours tells the sender nothing of the server's inside. */
export function replyTo(thrown: unknown): ErrorReply {
  if (thrown instanceof TexelcastError) {
    const status = STATUS_OF_CODE[thrown.code];
    if (status !== undefined) {
      // A disk that is full is the shopkeeper's to clear; its own limit is one that was set.
      const unexpected = thrown.code === "storage-full" && thrown.cause !== undefined;
      return { status, body: { error: thrown.toJSON() }, unexpected };
    }
  }
  const known = replyToFramework(thrown);
  if (known !== null) return { ...known, unexpected: false };
  const error = {
    code: "server-fault",
    message: "the shop could not do that",
    hint: "Try again in a moment; nothing of your cart is lost.",
  };
  return { status: 500, body: { error }, unexpected: true };
}

/** What Fastify itself refuses before a route is asked. */
function replyToFramework(thrown: unknown): Omit<ErrorReply, "unexpected"> | null {
  const { statusCode, code, message } = (thrown ?? {}) as { statusCode?: number; code?: string; message?: string };
  if (statusCode === undefined || statusCode < 400 || statusCode >= 500) return null;
  if (statusCode === 413) {
    const error = shopError("too-large", "the request has more bytes than the shop takes", {
      hint: "Use a smaller picture or a simpler design.",
    });
    return { status: 413, body: { error: error.toJSON() } };
  }
  const error = shopError("bad-request", message ?? "the request cannot be understood", {
    ...(code !== undefined && { value: code }),
    hint: "docs/storefront.md says what the server takes.",
  });
  return { status: statusCode, body: { error: error.toJSON() } };
}

/** Milliseconds in which a request must have come: the largest file's on a line of half a megabit a second. */
const REQUEST_PATIENCE_MS = 600_000;

/** A server's options that end requests which never come to their end; Fastify's own default is to wait for ever. */
export const patienceOf = (milliseconds = REQUEST_PATIENCE_MS) => ({
  requestTimeout: milliseconds,
  // Node's own, where they are not more: it takes the longer one for the whole request's.
  http: { headersTimeout: Math.min(milliseconds, 60_000), connectionsCheckingInterval: Math.min(milliseconds, 30_000) },
});

/** A server's options for what is refused before any route is asked, in the form of every refusal. */
export const REFUSALS = {
  /** An address that cannot be decoded. */
  frameworkErrors: (error: FastifyError, _request: FastifyRequest, reply: FastifyReply): void => {
    const { status, body } = replyTo(error);
    void reply.code(status).send(body);
  },
  /** What is no HTTP, or none that comes to an end: there is no request to reply to, so the answer is written by hand. */
  clientErrorHandler: (thrown: NodeJS.ErrnoException, socket: Socket): void => {
    if (thrown.code !== "ECONNRESET" && socket.writable) {
      const [statusCode, message] = NO_REQUEST.get(thrown.code ?? "") ?? [400, "that is no request of HTTP"];
      const { body } = replyTo({ statusCode, message });
      const text = JSON.stringify(body);
      const head = [
        `HTTP/1.1 ${statusCode} ${STATUS_CODES[statusCode]}`,
        "content-type: application/json; charset=utf-8",
        `content-length: ${Buffer.byteLength(text)}`,
        "connection: close",
      ];
      socket.write(`${head.join("\r\n")}\r\n\r\n${text}`);
    }
    socket.destroy();
  },
};

/** By Node's code of them. */
const NO_REQUEST: ReadonlyMap<string, readonly [status: number, message: string]> = new Map([
  ["HPE_HEADER_OVERFLOW", [431, "the request's head has more bytes than the shop takes"]],
  ["ERR_HTTP_REQUEST_TIMEOUT", [408, "the request did not come to its end in time"]],
]);

/** Answers who asks for an address that a server does not have, as any other fault is answered. */
export function answerNoAddress(request: FastifyRequest, reply: FastifyReply): FastifyReply {
  const { status, body } = replyTo(notFound("address", request.url));
  return reply.code(status).send(body);
}
