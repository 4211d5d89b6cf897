import { expect, it, vi } from "vitest";
import { startBasis } from "../../web/engine/basis-transcoder.ts";
import { decodeKtx2 } from "../../web/engine/ktx2-decoder.ts";
import { ktx2File, softPicture } from "../support/ktx2-file.ts";

vi.mock("../../web/engine/basis-transcoder.ts", { spy: true });

it("a decoder that does not start is not told as a damaged picture, and starts for the next one", async () => {
  const file = await ktx2File(softPicture(8, 8), "UASTC");
  const refused = new WebAssembly.CompileError("The page's policy allows no WebAssembly");
  vi.mocked(startBasis).mockRejectedValueOnce(refused);
  await expect(decodeKtx2(file, "soft")).rejects.toBe(refused);
  expect(await decodeKtx2(file, "soft")).toMatchObject({ width: 8, height: 8 });
});
