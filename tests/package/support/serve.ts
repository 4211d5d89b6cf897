/** Static servers, and pages in a real Chromium with all that they complain of. */
import { existsSync, readFileSync, statSync } from "node:fs";
import { createServer, request as httpRequest, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import { extname, join, normalize } from "node:path";
import { type Browser, chromium, type Page } from "@playwright/test";
import { chromiumLaunch } from "../../../scripts/bootstrap/chromium.mjs";

const TYPES: Readonly<Record<string, string>> = {
  ".html": "text/html; charset=utf-8",
  ".css": "text/css",
  ".js": "text/javascript",
  ".mjs": "text/javascript",
  ".wasm": "application/wasm",
  ".json": "application/json",
  ".png": "image/png",
  ".glb": "model/gltf-binary",
};

/**
 * What a careful shop sends: no inline script, no eval, nothing of other origins. Not sent: COOP and COEP. Styles that
 * scripts set on elements are no styles to this policy, those in markup are.
 */
export const STRICT_POLICY =
  "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'; worker-src 'self'; connect-src 'self' blob:; " +
  "img-src 'self' blob: data:; style-src 'self'; font-src 'self'; base-uri 'none'; form-action 'none'";

export interface StaticServer {
  /** With its port, without a slash at the end. */
  readonly origin: string;
  /** Paths of the files that were asked for, in order. */
  readonly served: readonly string[];
  readonly stop: () => Promise<void>;
}

/** Answers some requests itself: true where it did, or will. */
export type Route = (request: IncomingMessage, response: ServerResponse, path: string) => boolean;

/**
 * Serves a folder as any web server would, with these headers.
 * @param host another name makes another origin @param route asked before the folder
 */
export async function serveFolder(
  folder: string,
  headers: Readonly<Record<string, string>> = {},
  host: "localhost" | "127.0.0.1" = "localhost",
  route: Route = () => false,
): Promise<StaticServer> {
  const served: string[] = [];
  const server = createServer((request, response) => {
    if (route(request, response, new URL(request.url ?? "/", "http://x").pathname)) return;
    const path = normalize(decodeURIComponent(new URL(request.url ?? "/", "http://x").pathname));
    const file = join(folder, path.endsWith("/") ? `${path}index.html` : path);
    if (!existsSync(file) || !statSync(file).isFile()) {
      response.writeHead(404).end();
      return;
    }
    served.push(path);
    response.writeHead(200, { "content-type": TYPES[extname(file)] ?? "application/octet-stream", ...headers });
    response.end(readFileSync(file));
  });
  await new Promise<void>((resolve) => server.listen(0, resolve));
  const { port } = server.address() as AddressInfo;
  return {
    origin: `http://${host}:${port}`,
    served,
    stop: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}

/** Passes requests below a path on to another server, as a shop's web server does. */
export function passOn(below: string, port: number, to = below): Route {
  return (request, response, path) => {
    if (!path.startsWith(below)) return false;
    const { method, headers } = request;
    const { search } = new URL(request.url ?? "/", "http://x");
    const passed = httpRequest({ port, path: to + path.slice(below.length) + search, method, headers }, (answer) => {
      response.writeHead(answer.statusCode ?? 502, answer.headers);
      answer.pipe(response);
    });
    passed.on("error", () => response.writeHead(502).end());
    request.pipe(passed);
    return true;
  };
}

/** Keeps a page's requests to an address back until they are let go. */
export async function holdBack(page: Page, address: RegExp): Promise<{ letGo: () => void }> {
  const gate = makeGate();
  await page.route(address, async (route) => {
    await gate.open;
    await route.continue();
  });
  return gate;
}

/** What waits for `open` goes on when it is let go. */
export function makeGate(): { readonly open: Promise<void>; readonly letGo: () => void } {
  let letGo = (): void => {};
  const open = new Promise<void>((resolve) => {
    letGo = resolve;
  });
  return { open, letGo };
}

export async function openBrowser(): Promise<Browser> {
  return await chromium.launch(chromiumLaunch());
}

/** Opens a page; what it and its workers report as errors comes in `complaints`. */
export async function openPage(browser: Browser, address: string): Promise<{ page: Page; complaints: string[] }> {
  const page = await browser.newPage();
  const complaints: string[] = [];
  page.on("pageerror", (error) => complaints.push(error.message));
  page.on("console", (message) => {
    if (message.type() === "error") complaints.push(message.text());
  });
  await page.goto(address);
  return { page, complaints };
}
