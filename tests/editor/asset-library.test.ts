import { afterEach, describe, expect, it, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import { type Design, emptyDesign, makeDecalLayer } from "../../web/editor/document/index.ts";
import { AssetLibrary, type LibraryPicture } from "../../web/editor/state/asset-library.ts";
import { DesignSession } from "../../web/editor/state/design-session.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { MEBIBYTE } from "../../web/editor/state/megabytes.ts";
import { Store } from "../../web/editor/state/store.ts";
import type { Engine, EngineLayer } from "../../web/engine/engine-api.ts";
import type { ModelViewer } from "../../web/viewer/viewer-api.ts";
import { brokenOff } from "../support/broken-off.ts";
import { FRONT } from "../support/layers.ts";
import { solidPng } from "../support/png-file.ts";

afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

/** An engine that knows which pictures it has, and takes each for one of that many pixels along a side. */
function keepingEngine(side: number) {
  const has = new Set<string>();
  let layers: readonly EngineLayer[] = [];
  let refuses = false;
  const engine = {
    setAsset: async (key: string) => {
      if (refuses) {
        refuses = false;
        throw new TexelcastError("out-of-budget", "Too large.");
      }
      has.add(key);
      return { width: side, height: side };
    },
    removeAsset: async (key: string) => void has.delete(key),
    setLayers: (given: readonly EngineLayer[]) => {
      layers = given;
    },
    expect: () => undefined,
  } as unknown as Engine;
  /** The next picture. */
  const refuse = (): void => {
    refuses = true;
  };
  return { engine, has, refuse, layers: () => layers };
}

/** A session whose every step puts another picture in the place of the one before, as a pixel tool does. */
function painting(side: number) {
  const { engine, has, refuse, layers } = keepingEngine(side);
  const library = new AssetLibrary(engine);
  const viewer = { setDecals: () => undefined } as unknown as ModelViewer;
  const store = new Store<EditorState>(INITIAL_STATE);
  const work: Promise<void>[] = [];
  const session = new DesignSession({ engine, viewer, library, store, later: (each) => void work.push(each) });
  const layer = makeDecalLayer({ id: "pixels", asset: "picture", projector: FRONT });
  return {
    ...{ session, library, has, refuse, layers },
    settled: () => Promise.all(work),
    async paint(shade: number): Promise<LibraryPicture> {
      const picture = await library.add("picture.png", solidPng(2, 2, [shade, 0, 0, 255]));
      const design: Design = { ...emptyDesign(), assets: { picture: picture.asset }, layers: [{ ...layer }] };
      session.record(design, `shade ${shade}`);
      return picture;
    },
  };
}

describe("the pictures of designs", () => {
  it("stay with the engine while the design or a step of the history may ask for them at once", async () => {
    const { paint, has } = painting(64);
    for (const shade of [1, 2, 3]) await paint(shade);
    expect([...has]).toEqual(["picture-1", "picture-2", "picture-3"]);
  });

  it("go once neither the design nor the history holds them, and an address that shows them goes too", async () => {
    const { paint, session, has, library } = painting(64);
    const revoke = vi.spyOn(URL, "revokeObjectURL");
    const first = await paint(1);
    const second = await paint(2);
    session.travelTo(1);
    await paint(3);
    expect([...has]).toEqual(["picture-1", "picture-3"]);
    expect(library.get(second.asset)).toBeUndefined();
    expect(library.get(first.asset)).toBe(first);
    expect(revoke).toHaveBeenCalledExactlyOnceWith(second.url);
  });

  it("are not taken away between being read and being used", async () => {
    const { paint, library, has } = painting(64);
    const coming = await library.add("coming.png", solidPng(2, 2, [9, 9, 9, 255]));
    await paint(1);
    await paint(2);
    expect(has.has(coming.engineKey)).toBe(true);
  });

  it("are taken in once where they are added twice at once", async () => {
    const { library, has } = painting(64);
    const png = solidPng(2, 2, [9, 9, 9, 255]);
    const show = vi.spyOn(URL, "createObjectURL");
    const [one, other] = await Promise.all([library.add("one.png", png), library.add("other.png", png)]);
    expect(other).toBe(one);
    expect([...has]).toEqual(["picture-1"]);
    expect(show).toHaveBeenCalledOnce();
  });

  it("can be added again where the engine refused them", async () => {
    const { library, refuse } = painting(64);
    const png = solidPng(2, 2, [9, 9, 9, 255]);
    refuse();
    await expect(library.add("one.png", png)).rejects.toMatchObject({ code: "out-of-budget" });
    await expect(library.add("one.png", png)).resolves.toMatchObject({ width: 64 });
  });

  it("go when what they were added for came to nothing, unless somebody else is about to use them", async () => {
    const { library, has } = painting(64);
    const revoke = vi.spyOn(URL, "revokeObjectURL");
    const png = solidPng(2, 2, [9, 9, 9, 255]);
    const { asset, url } = await library.add("one.png", png);
    await library.add("other.png", png);
    library.release([asset]);
    expect(library.get(asset)?.url).toBe(url);
    library.release([asset]);
    expect(library.get(asset)).toBeUndefined();
    expect([...has]).toEqual([]);
    expect(revoke).toHaveBeenCalledWith(url);
  });

  it("stay where a design has them, whoever gives them up", async () => {
    const { paint, library, has } = painting(64);
    const { asset } = await paint(1);
    library.release([asset]);
    library.release([asset]);
    expect([...has]).toEqual(["picture-1"]);
    expect(library.get(asset)).toBeDefined();
  });

  it("of a design that is only shown for a while go with it, also those that came back by their address", async () => {
    const { library, session, has, settled, paint } = painting(64);
    const { asset } = await library.add("one.png", solidPng(2, 2, [9, 9, 9, 255]));
    library.release([asset]);
    const shown = makeDecalLayer({ id: "shown", asset: "one", projector: FRONT });
    session.send({ ...emptyDesign(), assets: { one: asset }, layers: [shown] });
    await settled();
    expect([...has]).toEqual(["picture-2"]);
    await paint(1);
    expect([...has]).toEqual(["picture-3"]);
  });

  it("names what a design lacks as the file that it is: a font is no picture", async () => {
    const { library } = painting(64);
    const assets = { hand: { type: "font/ttf", uri: "fonts/hand.ttf" } } as const;
    await expect(library.adopt({ ...emptyDesign(), assets }, { path: "a.design.json" })).rejects.toMatchObject({
      message: "The design names the file fonts/hand.ttf, which is not part of it.",
      hint: "Open the design together with its files: choose or drop all of them at once.",
    });
  });

  it("of a design whose files are not all to be had go again", async () => {
    const { library, has } = painting(64);
    const png = `data:image/png;base64,${Buffer.from(solidPng(2, 2, [9, 9, 9, 255])).toString("base64")}`;
    const assets = { here: { type: "image/png", uri: png }, gone: { type: "image/png", uri: "gone.png" } } as const;
    const adopted = library.adopt({ ...emptyDesign(), assets }, { path: "a.design.json" });
    await expect(adopted).rejects.toMatchObject({ code: "missing-file" });
    expect([...has]).toEqual([]);
  });

  it.each([
    ["do not come", () => Promise.reject(new TypeError("Failed to fetch"))],
    ["break off on their way", async () => brokenOff()],
  ])(
    "of a design that lie elsewhere and %s are told as what did not come, and not as what was left out",
    async (_what, fetched) => {
      const { library } = painting(64);
      vi.stubGlobal("fetch", fetched);
      const assets = { far: { type: "image/png", uri: "decals/far.png" } } as const;
      const adopted = library.adopt(
        { ...emptyDesign(), assets },
        { path: "Avatar", baseUrl: "https://shop.example/demo/" },
      );
      await expect(adopted).rejects.toMatchObject({
        code: "missing-file",
        reason: "not-loaded",
        value: "decals/far.png",
      });
    },
  );

  it("of a design are fetched side by side, a few ahead, and have the order of the design whichever comes first", async () => {
    const { library } = painting(64);
    const files = Array.from({ length: 9 }, (_, shade) => solidPng(2, 2, [shade, 0, 0, 255]));
    const assets = Object.fromEntries(
      files.map((_, shade) => [`picture ${shade}`, { type: "image/png", uri: `${shade}.png` } as const]),
    );
    const waiting: { readonly shade: number; readonly answer: (response: Response) => void }[] = [];
    const asked = vi.fn((address: URL) => {
      const shade = Number(address.pathname.slice(1, -".png".length));
      return new Promise<Response>((answer) => waiting.push({ shade, answer }));
    });
    vi.stubGlobal("fetch", asked);
    const place = { path: "a.design.json", baseUrl: "https://shop.example/" };
    const adopting = library.adopt({ ...emptyDesign(), assets }, place);
    await vi.waitFor(() => expect(asked).toHaveBeenCalledTimes(6));
    for (const _ of files) {
      await vi.waitFor(() => expect(waiting).not.toHaveLength(0));
      const last = waiting.pop();
      last?.answer(new Response(files[last.shade] as Uint8Array<ArrayBuffer>));
    }
    const adopted = await adopting;
    expect(Object.entries(adopted.assets).map(([key, { uri }]) => [key, uri])).toEqual(
      files.map((file, shade) => [`picture ${shade}`, `data:image/png;base64,${Buffer.from(file).toString("base64")}`]),
    );
  });

  it("leave the engine, the oldest first, where the history's alone would fill it, and come back by an undo", async () => {
    const { paint, session, library, has, layers, settled } = painting(1024);
    for (const shade of [1, 2, 3, 4, 5, 6, 7, 8]) await paint(shade);
    // About 15 MiB each: four of them beside the newest are within the 64 MiB that are to spare.
    expect([...has]).toEqual(["picture-4", "picture-5", "picture-6", "picture-7", "picture-8"]);
    const shown = layers();
    session.travelTo(1);
    expect(layers()).toBe(shown);
    await settled();
    expect(has.has("picture-1")).toBe(true);
    expect(layers()).toMatchObject([{ asset: "picture-1" }]);
    expect(library.get(session.design.assets.picture)).toMatchObject({ width: 1024 });
  });

  it("shows the step that was travelled to last, however many of them had to wait for their pictures", async () => {
    const { paint, session, layers, settled } = painting(2048);
    for (const shade of [1, 2, 3, 4]) await paint(shade);
    session.travelTo(1);
    session.travelTo(2);
    session.travelTo(4);
    await settled();
    expect(layers()).toMatchObject([{ asset: "picture-4" }]);
  });
});

describe("the history's budget", () => {
  it("counts the pictures of the steps, and drops the oldest steps with theirs", async () => {
    const { engine, has } = keepingEngine(64);
    const library = new AssetLibrary(engine);
    const viewer = { setDecals: () => undefined } as unknown as ModelViewer;
    const store = new Store<EditorState>(INITIAL_STATE);
    const session = new DesignSession({ engine, viewer, library, store, later: () => undefined });
    session.setHistoryBudget(4 * MEBIBYTE);
    for (let step = 1; step <= 8; step++) {
      // A PNG may have any bytes after its end.
      const png = new Uint8Array(0.75 * MEBIBYTE);
      png.set(solidPng(2, 2, [step, 0, 0, 255]));
      const { asset } = await library.add("large.png", png);
      const layer = makeDecalLayer({ id: "pixels", asset: "large", projector: FRONT });
      session.record({ ...emptyDesign(), assets: { large: asset }, layers: [layer] }, `step ${step}`);
    }
    const { labels, dropped, heldBytes, budget } = store.state.history;
    // A mebibyte each as an address; the present one's own does not count.
    expect(labels).toEqual(["step 5", "step 6", "step 7", "step 8"]);
    expect(dropped).toBe(5);
    expect(heldBytes).toBeGreaterThan(3 * MEBIBYTE);
    expect(heldBytes).toBeLessThanOrEqual(budget);
    expect([...has]).toEqual(["picture-5", "picture-6", "picture-7", "picture-8"]);
  });
});
