/** When a page that asks `<texelcast-editor>` to start is told that it has. */
import { expect, test } from "@playwright/test";

test("start() of an element that was just given another product resolves when that one is shown, and tells where it cannot be", async ({
  page,
}) => {
  await page.route("**/nothing.glb", (route) => route.fulfill({ status: 404 }));
  await page.goto("element.html?loading=lazy&size=256&locale=en");
  const found = await page
    .locator("texelcast-editor")
    .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
      await element.start();
      element.src = "demo/skateboard.glb";
      await element.start();
      const shown = element.loaded;
      element.src = "demo/nothing.glb";
      const refused = await element.start().then(
        () => "shown",
        ({ code }) => code as string,
      );
      return { shown, refused };
    });
  expect(found).toEqual({ shown: true, refused: "missing-file" });
});

test("an element whose product is taken back waits for another one without a word, and puts the design on that", async ({
  page,
}) => {
  await page.goto("element.html?loading=eager&size=256&locale=en");
  const element = page.locator("texelcast-editor");
  const taken = await element.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    const told: string[] = [];
    element.addEventListener("error", ({ detail }) => told.push(detail.code));
    await element.addText("kept");
    element.src = null;
    await element.updateComplete;
    await new Promise((resolve) => setTimeout(resolve, 50));
    return { told, loaded: element.loaded, alerts: element.shadowRoot?.querySelectorAll("[role=alert]").length };
  });
  expect(taken).toEqual({ told: [], loaded: false, alerts: 0 });
  await expect.poll(() => page.workers().length).toBe(0);
  const names = await element.evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
    element.src = "demo/skateboard.glb";
    await element.updateComplete;
    return (await element.exportDesign()).design.layers.map(({ name }) => name);
  });
  expect(names).toEqual(["kept"]);
});

test("an element that is started while it is in no page shows nothing there, and leaves no worker behind", async ({
  page,
}) => {
  await page.goto("element.html?loading=lazy&size=256&locale=en");
  const found = await page.evaluate(async () => {
    const element = document.querySelector("texelcast-editor") as HTMLElementTagNameMap["texelcast-editor"];
    element.remove();
    const rest = (): Promise<unknown> => new Promise((resolve) => setTimeout(resolve, 50));
    await rest();
    await element.start();
    await element.restart();
    const away = element.loaded;
    // Put back before it is done, it goes on.
    const started = element.start();
    document.body.append(element);
    await started;
    await rest();
    const back = element.loaded;
    element.remove();
    const never = document.createElement("texelcast-editor");
    Object.assign(never, { src: "demo/mug.glb", size: 256 });
    void never.start();
    await rest();
    return { away, back, never: never.loaded };
  });
  expect(found).toEqual({ away: false, back: true, never: false });
  await expect.poll(() => page.workers().length).toBe(0);
});

test("a shown product is not opened anew where a server's page is laid over it, or a framework takes back what says nothing", async ({
  page,
}) => {
  await page.goto("element.html?loading=lazy&size=256&locale=en");
  const found = await page
    .locator("texelcast-editor")
    .evaluate(async (element: HTMLElementTagNameMap["texelcast-editor"]) => {
      const written = element.getAttributeNames();
      await element.start();
      let loads = 0;
      element.addEventListener("load", () => loads++);
      // Turbo, htmx and Livewire take away what the server's tag does not have.
      const own = element.getAttributeNames().filter((name) => !written.includes(name));
      for (const name of [...own, "mode", "wasm-url"]) element.removeAttribute(name);
      await element.exportDesign();
      const anything = element as unknown as Record<string, unknown>;
      for (const nothing of [undefined, "shop", "", null, "shop"]) {
        anything.mode = nothing;
        anything.wasmUrl = nothing === "shop" ? "" : nothing;
        await element.exportDesign();
      }
      const still = loads;
      element.mode = "full";
      await element.start();
      element.removeAttribute("mode");
      await element.start();
      return { still, loads, own };
    });
  expect(found).toEqual({ still: 0, loads: 2, own: [] });
});
