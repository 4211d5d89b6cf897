/** New words can be read on what they are put on. */
import { expect, test } from "./support/editor-page.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

/** A product all in one colour. */
const inColor = (color: string) => ({
  format: "texelcast-design",
  version: 1,
  assets: {},
  layers: [{ type: "fill", id: "ground", color }],
});

const WHITE = "#ffffff";

for (const [mode, dark] of [
  ["shop", "#1a1a1a"],
  ["full", "#000000"],
] as const) {
  test(`words that a customer adds are white on a dark product and dark on a light one, in the ${mode} mode`, async ({
    page,
  }) => {
    await page.goto(`element.html?mode=${mode}&loading=eager&locale=en&size=128`);
    const element = page.locator("texelcast-editor");
    const colors = () =>
      element.evaluate(async (editor: Editor) => {
        const { design } = await editor.exportDesign();
        return design.layers.flatMap((layer) => (layer.type === "text" ? [layer.color] : []));
      });
    for (const [ground, words] of [
      ["#101820", WHITE],
      ["#fafad2", dark],
    ] as const) {
      await element.evaluate(async (editor: Editor, design) => {
        editor.design = design as NonNullable<Editor["design"]>;
        await editor.start();
        await editor.exportTexture();
      }, inColor(ground));
      await element.getByRole("button", { name: "Add text" }).click();
      await expect.poll(colors, ground).toEqual([words]);
    }
  });
}

test("words in the editor are white on a layer that was painted dark", async ({ editor }) => {
  await editor.open();
  const bytes = Buffer.from(JSON.stringify(inColor("#0b1d3a")));
  await editor.openDesign([{ name: "navy.json", mimeType: "application/json", buffer: bytes }]);
  await editor.page.getByRole("button", { name: "Add text" }).click();
  const text = async () => (await editor.design()).layers.find(({ type }) => type === "text");
  await expect.poll(text).toMatchObject({ color: WHITE });
});
