import type { ReactiveControllerHost } from "lit";
import { describe, expect, it } from "vitest";
import { Store, StoreController } from "../../web/editor/state/store.ts";

/** An element that shows a number, as Lit drives it: told when it comes, when it goes, and before each render. */
function element() {
  const store = new Store({ value: 0 });
  let asked = 0;
  const host = {
    addController: () => {},
    removeController: () => {},
    requestUpdate: () => asked++,
    updateComplete: Promise.resolve(true),
  } satisfies ReactiveControllerHost;
  let given = false;
  const controller = new StoreController(
    host,
    () => (given ? store : undefined),
    ({ value }) => [value],
  );
  /** How often it is asked to render for a change of the number. */
  const change = async (): Promise<number> => {
    asked = 0;
    store.set({ value: store.state.value + 1 });
    await Promise.resolve();
    return asked;
  };
  return { controller, change, give: () => (given = true) };
}

describe("an element that shows the state", () => {
  it("hears of changes while it is there, and again when it comes back", async () => {
    const { controller, change, give } = element();
    give();
    controller.hostConnected();
    expect(await change()).toBe(1);
    controller.hostDisconnected();
    expect(await change()).toBe(0);
    controller.hostConnected();
    expect(await change()).toBe(1);
  });

  it("hears of them though it is given the state only after it has come", async () => {
    const { controller, change, give } = element();
    controller.hostConnected();
    give();
    controller.hostUpdate();
    expect(await change()).toBe(1);
  });

  it("is let go though it was taken away with a render still to come", async () => {
    const { controller, change, give } = element();
    give();
    controller.hostConnected();
    controller.hostDisconnected();
    controller.hostUpdate();
    expect(await change()).toBe(0);
  });
});
