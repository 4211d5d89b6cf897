/** A shop's product whose model is zipped, as it came from a library. */
import { expect, test } from "@playwright/test";
import { zipSync } from "fflate";
import { demoFile, squareGlb } from "./support/test-files.ts";

type Editor = HTMLElementTagNameMap["texelcast-editor"];

for (const mode of ["shop", "full"] as const) {
  test(`in ${mode} mode a zipped model is shown and painted, and of several the one behind the #`, async ({ page }) => {
    const pack = zipSync({ "cups/mug.glb": demoFile("mug.glb").buffer, "board/square.glb": squareGlb().buffer });
    await page.route("**/*.zip", (route) => route.fulfill({ body: Buffer.from(pack) }));
    await page.goto(`element.html?mode=${mode}&loading=lazy&size=128`);
    const outcome = await page.locator("texelcast-editor").evaluate(async (editor: Editor) => {
      editor.src = "demo/pack.zip";
      await editor.updateComplete;
      const refused = await editor.start().then(
        () => null,
        (error: { code: string; message: string }) => error,
      );
      editor.src = "demo/pack.zip#board/square.glb";
      await editor.updateComplete;
      await editor.start();
      await editor.addDecal("demo/decals/smiley.png");
      const glb = await editor.exportModel();
      return { code: refused?.code, message: refused?.message, bytes: glb.length };
    });
    expect(outcome).toMatchObject({
      code: "bad-archive",
      message: "“pack.zip” holds 2 models: “cups/mug.glb”, “board/square.glb”.",
    });
    expect(outcome.bytes).toBeGreaterThan(1000);
  });
}
