/** What a shop's page gives the iframe wrongly is told before anything is put into the page. */
import { expect, test } from "vitest";
import { mountTexelcast } from "../../web/embed/frame.ts";

test.each([
  ["page", { page: "/editor.html" }, "/editor.html"],
  ["beforeAccept", { page: "https://editor.example/embed.html", beforeAccept: "yes" }, "yes"],
  ["timeoutMs", { page: "https://editor.example/embed.html", timeoutMs: -5 }, "-5"],
  ["timeoutMs", { page: "https://editor.example/embed.html", timeoutMs: "soon" }, "soon"],
])("a %s that cannot be used is refused by its name", async (field, options, value) => {
  const mounted = mountTexelcast(null as never, options as never);
  await expect(mounted).rejects.toMatchObject({ code: "bad-argument", field, value, hint: expect.any(String) });
});

test("a container that the page does not have is told as such", async () => {
  const mounted = mountTexelcast(null as never, { page: "https://editor.example/embed.html" });
  await expect(mounted).rejects.toMatchObject({ code: "bad-argument", field: "container", value: "null" });
});

test("an option that there is not is told with its value and those that there are", async () => {
  const options = { page: "https://editor.example/embed.html", sorce: "/mug.glb", src: undefined };
  await expect(mountTexelcast(null as never, options as never)).rejects.toMatchObject({
    code: "bad-argument",
    field: "sorce",
    value: "/mug.glb",
    hint: expect.stringMatching(/src,.*page, title, beforeAccept, timeoutMs\.$/),
  });
});

test.each([undefined, null, "https://editor.example/embed.html"])(
  "%s in the options' place is told as such",
  async (options) => {
    const mounted = mountTexelcast(null as never, options as never);
    await expect(mounted).rejects.toMatchObject({
      code: "bad-argument",
      field: "options",
      value: String(options),
      hint: expect.stringMatching(/page/),
    });
  },
);
