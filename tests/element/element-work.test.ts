import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { Voice } from "../../web/element/element-voice.ts";
import { Work } from "../../web/element/element-work.ts";
import { english } from "../../web/element/words/english.ts";
import { elementStandIn } from "../support/element-stand-in.ts";

/** What the modes did, in order: each holds a worker and a WebGL context from "made" to "ended". */
const modes: string[] = [];
/** Called when what shows the model has been loaded, before a mode is made. */
let loaded = (): void => undefined;
vi.mock("../../web/element/shop/shop-mode.ts", () => ({
  get openMode() {
    loaded();
    return () => {
      modes.push("made");
      return {
        ...{ desk: null, materials: [], viewer: {}, styles: [] },
        open: async () => undefined,
        close: () => modes.push("ended"),
      };
    };
  },
}));

/** An element's work whose words come when the test says so, once for each start. */
function workThatWaits() {
  const words: (() => void)[] = [];
  const voice = {
    words: english,
    told: <T>(work: Promise<T>) => work,
    speak: () => new Promise<void>((resolve) => words.push(resolve)),
    dismiss: () => undefined,
    show: () => undefined,
  } as unknown as Voice;
  const element = elementStandIn();
  const shares: number[] = [];
  element.addEventListener("progress", (event) => shares.push((event as unknown as CustomEvent).detail.share));
  return { work: new Work({ element, voice, idle: () => undefined }), words, element, shares };
}

beforeEach(() => {
  modes.length = 0;
  loaded = () => undefined;
  vi.stubGlobal("ShadowRoot", class {});
  vi.stubGlobal("document", { baseURI: "http://shop/", createElement: () => ({ replaceChildren: () => undefined }) });
});
afterEach(() => vi.unstubAllGlobals());

describe("an element that is closed while it starts", () => {
  it("makes no mode when its words come after it was closed, and says that it was called off", async () => {
    const { work, words } = workThatWaits();
    const started = work.start();
    work.close();
    words[0]?.();
    await expect(started).rejects.toMatchObject({ code: "cancelled" });
    expect(modes).toEqual([]);
    expect(work.phase).toBe("idle");
  });

  it("makes one mode when it is started again meanwhile, and ends it when it is closed", async () => {
    const { work, words } = workThatWaits();
    const first = work.start();
    work.close();
    const second = work.start();
    for (const come of words) come();
    await expect(first).rejects.toMatchObject({ code: "cancelled" });
    await second;
    expect(work.phase).toBe("ready");
    expect(modes).toEqual(["made"]);
    work.close();
    expect(modes).toEqual(["made", "ended"]);
  });

  it("keeps the newer start where the older one's words come last", async () => {
    const { work, words } = workThatWaits();
    const first = work.start();
    work.close();
    const second = work.start();
    words[1]?.();
    await second;
    words[0]?.();
    await expect(first).rejects.toMatchObject({ code: "cancelled" });
    expect(work.phase).toBe("ready");
    expect(modes).toEqual(["made"]);
  });

  it("makes no mode when it is closed as soon as what shows the model has come", async () => {
    const { work, words } = workThatWaits();
    loaded = () => work.close();
    const started = work.start();
    words[0]?.();
    await expect(started).rejects.toMatchObject({ code: "cancelled" });
    expect(modes).toEqual([]);
  });

  it("tells no more of how far it has come once it was closed, though its model comes", async () => {
    const { work, words, element, shares } = workThatWaits();
    let come = (): void => undefined;
    const bytes = new Promise((resolve) => {
      come = () => resolve(new ArrayBuffer(1));
    });
    element.src = { [Symbol.toStringTag]: "Blob", arrayBuffer: () => bytes } as unknown as Blob;
    const started = work.start();
    words[0]?.();
    await expect.poll(() => modes).toEqual(["made"]);
    work.close();
    const told = [...shares];
    come();
    await expect(started).rejects.toMatchObject({ code: "cancelled" });
    expect(shares).toEqual(told);
  });
});

it("an element that cannot start for another reason calls its model off", async () => {
  const { work, words, element } = workThatWaits();
  let signal: AbortSignal | null | undefined;
  vi.stubGlobal("fetch", (_: URL, options: RequestInit) => {
    signal = options.signal;
    return new Promise(() => undefined);
  });
  element.src = "http://shop/mug.glb";
  loaded = () => {
    throw new Error("no graphics");
  };
  const started = work.start();
  words[0]?.();
  await expect(started).rejects.toThrow();
  expect(work.phase).toBe("failed");
  expect(signal?.aborted).toBe(true);
});
