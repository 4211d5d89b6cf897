/** `renderPrint` and `checkPrint`, however their callers hold what they give, and whenever they have enough of it. */
import { afterEach, describe, expect, it, vi } from "vitest";
import { checkPrint, type RenderPrintOptions, renderPrint } from "../../node/print.ts";
import { EngineHost } from "../../web/engine/engine-host.ts";
import { FACING_DOWN, plainPng, planeGlb } from "./plane-model.ts";

const projector = { kind: "planar", position: [0, 0.5, 0], rotation: FACING_DOWN, size: [1, 1, 0.2] };
const design = {
  format: "texelcast-design",
  version: 1,
  assets: { logo: { type: "image/png", uri: "logo.png" } },
  layers: [{ type: "decal", id: "logo", asset: "logo", projector }],
};
const LOGO = await plainPng(16, 16, [255, 0, 0, 255]);
const usual = (): RenderPrintOptions => ({
  model: planeGlb(),
  design,
  assets: [{ name: "logo.png", bytes: LOGO }],
  size: 16,
});

afterEach(() => {
  vi.restoreAllMocks();
});

describe("options that are not an object's own", () => {
  it("count as those that are: what a print is asked for is never left out", async () => {
    const asked = { ...usual(), size: [32, 16], base: "none" } as const;
    const { sha256, width, height } = await renderPrint(asked);
    class Order {
      readonly #asked = asked;
      get model() {
        return this.#asked.model;
      }
      get design() {
        return this.#asked.design;
      }
      get assets() {
        return this.#asked.assets;
      }
      get size() {
        return this.#asked.size;
      }
      get base() {
        return this.#asked.base;
      }
    }
    for (const options of [Object.create(asked) as typeof asked, new Order()]) {
      expect(await renderPrint(options)).toMatchObject({ sha256, width, height });
    }
  });

  it("are measured by as well", async () => {
    const asked = { model: planeGlb(), design, assets: usual().assets, size: 16 };
    const report = await checkPrint(asked as never);
    expect(await checkPrint(Object.create(asked) as never)).toEqual(report);
  });
});

it("a list of sizes or of files that its caller goes on to change is taken as it was given", async () => {
  const { sha256 } = await renderPrint({ ...usual(), size: [32, 16] });
  const size: [number, number] = [32, 16];
  const assets = [{ name: "logo.png", bytes: LOGO }];
  const print = renderPrint({ ...usual(), size, assets });
  size[0] = 64;
  assets.length = 0;
  expect((await print).sha256).toBe(sha256);
});

it("bytes that were handed to another thread are refused by the argument that has them", async () => {
  const handedOn = (): Uint8Array => {
    const bytes = Uint8Array.from(planeGlb());
    structuredClone(bytes, { transfer: [bytes.buffer] });
    return bytes;
  };
  const told = (field: string) => ({
    code: "bad-argument",
    field,
    value: "a Uint8Array whose memory was handed to another thread",
  });
  const refused = (fields: Partial<RenderPrintOptions>) => expect(renderPrint({ ...usual(), ...fields })).rejects;
  await refused({ model: handedOn() }).toMatchObject(told("model"));
  await refused({ assets: [{ name: "logo.png", bytes: handedOn() }] }).toMatchObject(told("assets[0].bytes"));
  await refused({ assets: handedOn }).toMatchObject(told("assets"));
});

describe("a print that is called off", () => {
  const cancelled = { name: "AbortError", code: "cancelled" };

  it("reads nothing where that was so from the beginning", async () => {
    const load = vi.spyOn(EngineHost.prototype, "loadModel");
    const signal = AbortSignal.abort();
    await expect(renderPrint({ ...usual(), model: "no-such.glb", signal })).rejects.toMatchObject(cancelled);
    await expect(renderPrint({ ...usual(), signal })).rejects.toMatchObject(cancelled);
    expect(load).not.toHaveBeenCalled();
  });

  it("does not wait for files that never come, and ends its engine", async () => {
    const ended = vi.spyOn(EngineHost.prototype, "dispose");
    const caller = new AbortController();
    const assets = (): Promise<Uint8Array> => {
      queueMicrotask(() => caller.abort());
      return new Promise(() => {});
    };
    await expect(renderPrint({ ...usual(), assets, signal: caller.signal })).rejects.toMatchObject(cancelled);
    expect(ended).toHaveBeenCalled();
  });

  it("asks for no further files", async () => {
    const caller = new AbortController();
    const asked: string[] = [];
    const assets = (uri: string): Uint8Array => {
      asked.push(uri);
      caller.abort();
      return LOGO;
    };
    const two = {
      ...design,
      assets: { ...design.assets, mark: { type: "image/png", uri: "mark.png" } },
      layers: [...design.layers, { type: "decal", id: "mark", asset: "mark", projector }],
    };
    const print = renderPrint({ ...usual(), design: two, assets, signal: caller.signal });
    await expect(print).rejects.toMatchObject(cancelled);
    expect(asked).toEqual(["logo.png"]);
  });

  it("leaves the signal without listeners when it is done", async () => {
    const { signal } = new AbortController();
    const added = vi.spyOn(signal, "addEventListener");
    const removed = vi.spyOn(signal, "removeEventListener");
    await renderPrint({ ...usual(), signal });
    expect(removed).toHaveBeenCalledTimes(added.mock.calls.length);
  });
});
