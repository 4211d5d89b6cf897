/** What a shop's page gives the iframe wrongly is told before anything is put into the page. */
import { expect, test } from "vitest";
import { mountTexelcast } from "../../web/embed/frame.ts";

test.each([
  ["page", { page: "/editor.html" }, "/editor.html"],
  ["beforeAccept", { page: "https://editor.example/embed.html", beforeAccept: "yes" }, "yes"],
])("a %s that cannot be used is refused by its name", async (field, options, value) => {
  const mounted = mountTexelcast(null as never, options as never);
  await expect(mounted).rejects.toMatchObject({ code: "bad-argument", field, value, hint: expect.any(String) });
});

test("a container that the page does not have is told as such", async () => {
  const mounted = mountTexelcast(null as never, { page: "https://editor.example/embed.html" });
  await expect(mounted).rejects.toMatchObject({ code: "bad-argument", field: "container", value: "null" });
});
