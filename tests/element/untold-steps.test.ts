import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { Voice } from "../../web/element/element-voice.ts";
import { Work } from "../../web/element/element-work.ts";
import type { ModeHost } from "../../web/element/mode.ts";
import { elementStandIn } from "../support/element-stand-in.ts";

/** Of each mode that was opened: makes a step. */
const steps: (() => void)[] = [];
/** By call: ends the measuring of a change, or lets it fail. */
const measures: { resolve: (detail: unknown) => void; reject: (thrown: unknown) => void }[] = [];
vi.mock("../../web/element/desk/hand-over.ts", () => ({
  changeDetail: () => new Promise((resolve, reject) => measures.push({ resolve, reject })),
}));
vi.mock("../../web/element/shop/shop-mode.ts", () => ({
  openMode: ({ hooks }: ModeHost) => {
    steps.push(() => hooks.changed());
    const desk = {
      design: { layers: [] },
      zones: null,
      atRest: true,
      store: { state: { selectedId: null } },
      session: { steps: { recorded: { design: {} } }, resume: () => undefined },
    };
    return {
      ...{ desk, materials: [], viewer: {}, styles: [] },
      open: async () => undefined,
      idle: async () => undefined,
      close: () => undefined,
    };
  },
}));

/** An element's work that is open, and the changes that the page was told. */
async function opened() {
  const element = elementStandIn();
  const told: unknown[] = [];
  element.addEventListener("change", (event) => told.push((event as unknown as CustomEvent).detail));
  const work = new Work({ element, voice: new Voice(element), idle: () => undefined });
  await work.start();
  return { work, told };
}

const measured = (count: number): Promise<void> => expect.poll(() => measures.length).toBe(count);

beforeEach(() => {
  steps.length = 0;
  measures.length = 0;
  vi.stubGlobal("ShadowRoot", class {});
  vi.stubGlobal("navigator", { languages: ["en"] });
  vi.stubGlobal("document", { baseURI: "http://shop/", createElement: () => ({ replaceChildren: () => undefined }) });
});
afterEach(() => vi.unstubAllGlobals());

it("a step is told that was made right before the element begins anew", async () => {
  const { work, told } = await opened();
  steps[0]?.();
  work.close();
  await work.start();
  await measured(1);
  measures[0]?.resolve("of the step");
  await expect.poll(() => told).toEqual(["of the step"]);
});

it("a step is told whose measuring ended with the product that it was made on", async () => {
  const { work, told } = await opened();
  steps[0]?.();
  await measured(1);
  work.close();
  measures[0]?.reject(new DOMException("The engine was ended.", "AbortError"));
  await work.start();
  await measured(2);
  measures[1]?.resolve("of the step");
  await expect.poll(() => told).toEqual(["of the step"]);
});

it("a step that was told is none to an element that begins anew", async () => {
  const { work, told } = await opened();
  steps[0]?.();
  await measured(1);
  measures[0]?.resolve("of the step");
  await expect.poll(() => told).toEqual(["of the step"]);
  work.close();
  await work.start();
  await new Promise((resolve) => setTimeout(resolve));
  expect(measures).toHaveLength(1);
});
