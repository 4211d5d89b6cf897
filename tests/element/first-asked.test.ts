/** What an element begins while its model is still coming: on a phone's line, what waits for another answer waits long. */
import { afterEach, expect, test, vi } from "vitest";
import { Run, type RunParts } from "../../web/element/element-run.ts";
import type { ModeHost } from "../../web/element/mode.ts";
import { english } from "../../web/element/words/english.ts";
import { LEFT_HALF } from "../support/zones.ts";

/** What was asked of the mode, in order. */
const asked: string[] = [];
vi.mock("../../web/element/shop/shop-mode.ts", () => ({
  openMode: () => {
    asked.push("engine");
    const desk = { session: {}, useZones: async () => void asked.push("zones are used") };
    return {
      ...{ desk: null, materials: [], viewer: {}, styles: [] },
      takeDesk: async () => {
        asked.push("desk");
        return desk;
      },
      open: async () => void asked.push("model is opened"),
      close: () => asked.push("closed"),
    };
  },
}));

afterEach(() => {
  asked.length = 0;
  vi.unstubAllGlobals();
});

/** A run whose files come when they are told to, by the ends of their addresses. */
function runOf(properties: Partial<RunParts>) {
  const coming = new Map<string, (response: Response) => void>();
  vi.stubGlobal("fetch", (url: URL) => {
    const name = url.pathname.slice(1);
    asked.push(name);
    return new Promise((resolve) => coming.set(name, resolve));
  });
  const warnings: string[] = [];
  const host = {
    made: async () => undefined,
    hooks: { warn: ({ code }: { code: string }) => warnings.push(code) },
  } as unknown as ModeHost;
  const run = new Run({
    ...{ kind: "shop", src: "mug.glb", zones: null, base: "https://shop.example/", words: english, host },
    ...{ design: { given: null, kept: null, keptFirst: false }, limits: {}, progress: () => undefined },
    ...properties,
  } as RunParts);
  const come = async (name: string, body: BodyInit | null, status = 200): Promise<void> => {
    await expect.poll(() => coming.has(name)).toBe(true);
    coming.get(name)?.(new Response(body, { status }));
  };
  return { run, come, warnings };
}

test("the engine, the desk and the print zones are asked for while the model comes", async () => {
  const { run, come } = runOf({ zones: "zones.json" });
  const opened = run.open();
  await expect.poll(() => [...asked]).toEqual(["mug.glb", "engine", "desk", "zones.json"]);
  await come("zones.json", JSON.stringify({ texelcastZones: 1, zones: [LEFT_HALF] }));
  await come("mug.glb", "glTF");
  await opened;
  expect(asked.slice(4)).toEqual(["model is opened", "zones are used"]);
});

test("a model that does not come is told, though its engine had begun, and the engine is ended", async () => {
  const { run, come } = runOf({ zones: "zones.json" });
  const opened = run.open();
  await come("zones.json", "{}", 404);
  await come("mug.glb", null, 404);
  await expect(opened).rejects.toMatchObject({ code: "missing-file", reason: "http-404" });
  expect(asked).not.toContain("model is opened");
  expect(asked.at(-1)).toBe("closed");
});

test("zones that do not come are told when the product is there, which is shown without", async () => {
  const { run, come, warnings } = runOf({ zones: "zones.json" });
  const opened = run.open();
  await come("zones.json", null, 404);
  await come("mug.glb", "glTF");
  await opened;
  expect(warnings).toEqual(["missing-file"]);
  expect(run.mode).not.toBeNull();
  expect(asked).not.toContain("zones are used");
});
