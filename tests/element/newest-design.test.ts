import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { AssetLibrary } from "../../web/editor/state/asset-library.ts";
import type { ErrorDetail } from "../../web/element/element-api.ts";
import { Voice } from "../../web/element/element-voice.ts";
import { Work } from "../../web/element/element-work.ts";
import { elementStandIn } from "../support/element-stand-in.ts";

/** Designs as they were taken, the newest last: what each mode was opened with, and what came later. */
const taken: unknown[] = [];
/** By address: what ends the fetch of a design. */
const coming = new Map<string, () => void>();
vi.mock("../../web/element/desk/read-design.ts", () => ({
  readDesign: (uri: string) =>
    new Promise((resolve, reject) => {
      const broken = new TexelcastError("bad-design", "It is broken.");
      coming.set(uri, () => (uri === "broken" ? reject(broken) : resolve({ uri, assets: {}, layers: [] })));
    }),
}));
vi.mock("../../web/element/shop/shop-mode.ts", () => ({
  openMode: () => {
    const desk = {
      design: null as unknown,
      library: { release: () => undefined },
      zones: null,
      store: { state: { selectedId: null } },
      session: {
        get steps() {
          return { recorded: { design: desk.design } };
        },
        resume: () => undefined,
      },
      takeDesign: (design: unknown) => {
        desk.design = design;
        taken.push(design);
      },
    };
    return {
      ...{ desk, materials: [], viewer: {}, styles: [] },
      takeDesk: async () => desk,
      open: async (_: unknown, readDesign: ((library: AssetLibrary) => Promise<unknown>) | null) => {
        desk.takeDesign(await readDesign?.(desk.library as unknown as AssetLibrary));
      },
      close: () => undefined,
    };
  },
}));

function workOn(properties: object) {
  const element = elementStandIn(properties);
  const work = new Work({ element, voice: new Voice(element), idle: () => undefined });
  /** As when the page sets it. */
  const set = (design: string | null): void => {
    Object.assign(element, { design });
    work.follow((...names) => names.includes("design"));
  };
  const errors: string[] = [];
  element.addEventListener("error", (event) => errors.push((event as unknown as CustomEvent<ErrorDetail>).detail.code));
  return { work, set, errors };
}

const come = async (uri: string): Promise<void> => {
  await expect.poll(() => coming.has(uri)).toBe(true);
  coming.get(uri)?.();
  await new Promise((resolve) => setTimeout(resolve));
};
const newest = (): unknown => (taken.at(-1) as { uri?: string }).uri ?? taken.at(-1);

beforeEach(() => {
  taken.length = 0;
  coming.clear();
  vi.stubGlobal("ShadowRoot", class {});
  vi.stubGlobal("navigator", { languages: ["en"] });
  vi.stubGlobal("document", { baseURI: "http://shop/", createElement: () => ({ replaceChildren: () => undefined }) });
});
afterEach(() => vi.unstubAllGlobals());

async function opened() {
  const { work, set, errors } = workOn({ design: "first" });
  const started = work.start();
  await come("first");
  await started;
  expect(newest()).toBe("first");
  return { work, set, errors };
}

it("of two designs that a page sets the newer one stays, whichever comes first", async () => {
  const { set } = await opened();
  set("slow");
  await expect.poll(() => coming.has("slow")).toBe(true);
  set("quick");
  await come("quick");
  await come("slow");
  expect(newest()).toBe("quick");
});

it("what a page asks for waits for the design that it has set before", async () => {
  const { work, set } = await opened();
  set("second");
  let asked = false;
  const desk = work.atDesk().then((mode) => {
    asked = true;
    return mode.desk;
  });
  await expect.poll(() => coming.has("second")).toBe(true);
  await new Promise((resolve) => setTimeout(resolve));
  expect(asked).toBe(false);
  await come("second");
  expect((await desk).design).toMatchObject({ uri: "second" });
  set("broken");
  await come("broken");
  expect((await work.atDesk()).desk.design).toMatchObject({ uri: "second" });
});

it("a design that was still being read when all was closed is opened the next time", async () => {
  const { work, set } = await opened();
  set("slow");
  await expect.poll(() => coming.has("slow")).toBe(true);
  work.close();
  coming.clear();
  const started = work.start();
  await come("slow");
  await started;
  expect(newest()).toBe("slow");
});

it("what was worked on stays where a newer design, still being read when all was closed, turns out broken", async () => {
  const { work, set, errors } = await opened();
  set("broken");
  await expect.poll(() => coming.has("broken")).toBe(true);
  work.close();
  coming.clear();
  // Closed again before it was read: it is still the newer one, and the older one still there.
  work.start().catch(() => undefined);
  await expect.poll(() => coming.has("broken")).toBe(true);
  work.close();
  coming.clear();
  const started = work.start();
  await come("broken");
  await started;
  expect(newest()).toBe("first");
  expect(errors).toEqual(["bad-design"]);
  work.close();
  await work.start();
  expect(newest()).toBe("first");
});

it("what was worked on is opened the next time where nothing else was being read", async () => {
  const { work, set } = await opened();
  set("second");
  await come("second");
  work.close();
  await work.start();
  expect(newest()).toBe("second");
});

it("no design empties the product, and does not bring the first one back", async () => {
  const { set } = await opened();
  set("second");
  await come("second");
  set(null);
  await expect.poll(() => taken.length).toBe(3);
  expect(taken.at(-1)).toMatchObject({ layers: [] });
  expect(newest()).not.toBe("first");
});
