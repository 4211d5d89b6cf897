import { afterEach, beforeEach, expect, it, onTestFinished, vi } from "vitest";
import { TexelcastError } from "../../web/core/texelcast-error.ts";
import type { Desk } from "../../web/element/desk/desk.ts";
import { askShop } from "../../web/element/desk/placing.ts";
import type { BeforeAccept, CandidateAsset } from "../../web/element/element-api.ts";
import { english } from "../../web/element/words/english.ts";

const ASSET = { name: "cat.png", bytes: Uint8Array.of(1) } as unknown as CandidateAsset;

/** A shop that is asked and never answers; `signals` are those that it was given. */
function silentShop() {
  const signals: AbortSignal[] = [];
  const closing = new AbortController();
  const beforeAccept: BeforeAccept = (_, { signal }) => {
    signals.push(signal);
    return new Promise(() => {});
  };
  const desk = { settings: { beforeAccept, words: english }, signal: closing.signal } as unknown as Desk;
  const told = askShop(desk, ASSET).catch((thrown: unknown) => thrown);
  const close = (): void => closing.abort(new TexelcastError("disposed", "The product was closed."));
  return { signals, told, close };
}

beforeEach(() => void vi.useFakeTimers());
afterEach(() => void vi.useRealTimers());

it("a shop that does not answer within two minutes has refused, and may stop asking its own", async () => {
  const { signals, told } = silentShop();
  await vi.advanceTimersByTimeAsync(119_000);
  expect(signals[0]?.aborted).toBe(false);
  await vi.advanceTimersByTimeAsync(1_000);
  expect(signals[0]?.aborted).toBe(true);
  expect(await told).toMatchObject({
    code: "refused",
    subject: "cat.png",
    cause: { code: "timeout", value: "120000" },
  });
});

it("a product that is closed while the shop makes up its mind waits for it no longer", async () => {
  const { signals, told, close } = silentShop();
  await Promise.resolve();
  close();
  expect(signals[0]?.aborted).toBe(true);
  expect(await told).toMatchObject({ code: "disposed" });
  expect(vi.getTimerCount()).toBe(0);
});

it("a shop that throws at once has refused, and a product that is closed afterwards leaves nothing unheard", async () => {
  const unheard: unknown[] = [];
  const hear = (reason: unknown): void => void unheard.push(reason);
  process.on("unhandledRejection", hear);
  onTestFinished(() => void process.off("unhandledRejection", hear));
  vi.useRealTimers();
  const closing = new AbortController();
  const beforeAccept = (): never => {
    throw new Error("the shop's own fault");
  };
  const desk = { settings: { beforeAccept, words: english }, signal: closing.signal } as unknown as Desk;
  await expect(askShop(desk, ASSET)).rejects.toMatchObject({ code: "refused", subject: "cat.png" });
  closing.abort(new TexelcastError("disposed", "The product was closed."));
  // Node tells of them once its other work is done.
  await new Promise((resolve) => setImmediate(resolve));
  expect(unheard).toEqual([]);
});
