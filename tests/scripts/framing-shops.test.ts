/** Which shops the built editor page lets frame it. */
import { readFileSync } from "node:fs";
import type { IndexHtmlTransformHook, Plugin, UserConfig } from "vite";
import { afterEach, expect, test } from "vitest";
import config from "../../vite.config.ts";

const page = readFileSync(new URL("../../web/app/embed.html", import.meta.url), "utf8");
const before = process.env.TEXELCAST_SHOPS;
afterEach(() => {
  if (before === undefined) delete process.env.TEXELCAST_SHOPS;
  else process.env.TEXELCAST_SHOPS = before;
});

/** What stands in the page's list. @param served by the development server */
function listed(shops: string | undefined, served = false): string | undefined {
  if (shops === undefined) delete process.env.TEXELCAST_SHOPS;
  else process.env.TEXELCAST_SHOPS = shops;
  const plugins = (config as UserConfig).plugins as Plugin[];
  const { transformIndexHtml } = plugins.find(({ name }) => name === "texelcast-shops") as Plugin;
  const html = (transformIndexHtml as IndexHtmlTransformHook).call(
    undefined as never,
    page,
    (served ? { server: {} } : {}) as never,
  );
  return /name="texelcast-shops" content="([^"]*)"/.exec(String(html))?.[1];
}

test("a build lets no shop frame the editor that it was not told of", () => {
  expect(listed(undefined)).toBe("");
  expect(listed("https://shop.example  https://other.example:8443")).toBe(
    "https://shop.example https://other.example:8443",
  );
});

test("the development server lets any", () => {
  expect(listed(undefined, true)).toBe("*");
});

test.each(["shop.example", "https://shop.example/", 'https://shop.example"><script>'])(
  "a build refuses %s, which is no exact origin",
  (shop) => {
    expect(() => listed(shop)).toThrow("is no exact origin");
  },
);
