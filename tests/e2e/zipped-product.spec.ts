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
      const usdz = await editor.exportModel({ format: "usdz" });
      const unknown = await editor.exportModel({ format: "obj" as "glb" }).then(
        () => null,
        ({ code, field, hint }: { code: string; field: string; hint: string }) => ({ code, field, hint }),
      );
      const begins = [glb, usdz].map((file) => String.fromCharCode(...file.subarray(0, 4)));
      return { code: refused?.code, message: refused?.message, begins, unknown };
    });
    expect(outcome).toMatchObject({
      code: "bad-archive",
      message: "“pack.zip” holds 2 models: “cups/mug.glb”, “board/square.glb”.",
    });
    expect(outcome.begins).toEqual(["glTF", "PK\u0003\u0004"]);
    expect(outcome.unknown).toEqual({ code: "bad-argument", field: "format", hint: '"glb", "usdz"' });
  });
}
