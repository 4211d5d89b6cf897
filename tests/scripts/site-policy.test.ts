/** What the built pages may load and run. */
import { createHash } from "node:crypto";
import { expect, test } from "vitest";
import { withPolicy } from "../../scripts/site-policy.ts";

const HEAD = '<head>\n    <meta charset="utf-8" />\n    <title>A page</title>';

test("a page's policy stands before all that it is about, and lets no script in but the site's own", () => {
  const html = withPolicy(`${HEAD}<script type="module" src="./a.js"></script></head>`);
  expect(html.indexOf("Content-Security-Policy")).toBeLessThan(html.indexOf("<title>"));
  const policy = /http-equiv="Content-Security-Policy" content="([^"]*)"/.exec(html)?.[1] ?? "";
  expect(policy).toMatch(/^default-src 'none'; /);
  expect(policy).toContain("script-src 'self' 'wasm-unsafe-eval';");
  expect(policy).not.toContain("'unsafe-inline'");
});

test("of styles that stand in the page those are let in that the build put there", () => {
  const style = "body{margin:0}";
  const hash = createHash("sha256").update(style).digest("base64");
  expect(withPolicy(`${HEAD}<style>${style}</style></head>`)).toContain(`style-src 'self' 'sha256-${hash}';`);
});

test("a page that a policy cannot stand at the head of ends the build", () => {
  expect(() => withPolicy("<head></head>")).toThrow("charset");
});
