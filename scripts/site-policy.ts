/**
 * What the pages of the static site may load and run (Content-Security-Policy), written into them by the build: they open files
 * from anybody, and the host that serves them may send no such header. A worker's script is not bound by it, having its own.
 */
import { createHash } from "node:crypto";
import type { Plugin } from "vite";

/** Scripts are the site's own alone. Models, pictures and designs may come from any address that their user names. */
const POLICY: Readonly<Record<string, readonly string[]>> = {
  "default-src": ["'none'"],
  "script-src": ["'self'", "'wasm-unsafe-eval'"],
  "worker-src": ["'self'"],
  "style-src": ["'self'"],
  "font-src": ["'self'"],
  "img-src": ["*", "blob:", "data:"],
  "connect-src": ["*", "blob:", "data:"],
  "base-uri": ["'none'"],
  "form-action": ["'none'"],
};

/** Into built pages alone: the development server writes scripts and styles of its own into them. */
export const sitePolicy = (): Plugin => ({
  name: "texelcast-policy",
  apply: "build",
  // Last, when what stands inside of the page is what will be served.
  transformIndexHtml: { order: "post", handler: withPolicy },
});

/** The page with its policy; the styles that stand in it are allowed by their hashes. */
export function withPolicy(html: string): string {
  const inside = [...html.matchAll(/<style>([^<]*)<\/style>/g)].map(([, style = ""]) => `'sha256-${hashOf(style)}'`);
  const policy = { ...POLICY, "style-src": [...(POLICY["style-src"] ?? []), ...inside] };
  const content = Object.entries(policy)
    .map(([name, sources]) => `${name} ${sources.join(" ")}`)
    .join("; ");
  const charset = '<meta charset="utf-8" />';
  if (!html.includes(charset)) throw new Error("The page has no charset, after which its policy would stand.");
  // Before all that it is about.
  return html.replace(charset, `${charset}\n    <meta http-equiv="Content-Security-Policy" content="${content}" />`);
}

const hashOf = (text: string): string => createHash("sha256").update(text).digest("base64");
