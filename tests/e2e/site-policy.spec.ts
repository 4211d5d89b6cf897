/** The built pages under their own policy; that the editor's stories break none of it, each of them sees by its console. */
import { expect, test } from "@playwright/test";

for (const address of ["./", "element.html?mode=full&loading=eager", "element.html?loading=eager", "embed.html"]) {
  test(`${address} runs under its policy, and nothing else does`, async ({ page }) => {
    const broken: string[] = [];
    page.on("console", (message) => {
      if (/Content Security Policy/.test(message.text())) broken.push(message.text());
    });
    await page.goto(address);
    if (address !== "embed.html") {
      await expect(page.getByRole("application").first()).toBeVisible();
      await page.evaluate(() => document.querySelector("texelcast-editor")?.start() ?? window.texelcast.ready);
    }
    expect(broken).toEqual([]);

    const ran = await page.evaluate(async () => {
      const script = document.createElement("script");
      script.textContent = "document.title = 'run'";
      const picture = document.createElement("img");
      picture.setAttribute("onerror", "document.title = 'run'");
      picture.src = "data:,";
      document.body.append(script, picture);
      await new Promise((done) => setTimeout(done, 200));
      return document.title === "run";
    });
    expect(ran).toBe(false);
  });
}
