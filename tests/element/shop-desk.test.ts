import { expect, it } from "vitest";
import { type DecalLayer, emptyDesign, makeDecalLayer } from "../../web/editor/document/index.ts";
import { ShopDesk } from "../../web/element/shop/shop-desk.ts";
import type { OpenProduct, ShopProduct } from "../../web/element/shop/shop-product.ts";
import { english } from "../../web/element/words/english.ts";
import type { TargetInfo } from "../../web/engine/engine-api.ts";
import { FRONT } from "../support/layers.ts";

/** A desk with a decal on material 0, whose product opens another material's target when the test settles it. */
function deskWithDecal() {
  const asked: number[] = [];
  const settling: { readonly open: () => void; readonly refuse: () => void }[] = [];
  const failed: unknown[] = [];
  const targets = new Map([[0, {} as TargetInfo]]);
  const open = { source: { name: "mug.glb" }, info: { materials: [] }, material: 0 } as unknown as OpenProduct;
  const settings = { readonly: false, maxDecals: null, words: english };
  const product = {
    engine: { setLayers: () => undefined },
    viewer: { on: () => undefined, setDecals: () => undefined },
    hooks: { settings: () => settings, changed: () => undefined, selected: () => undefined },
    ...{ open, targets },
    canPaint: () => true,
    attempt: (work: Promise<unknown>) => void work.catch((thrown: unknown) => failed.push(thrown)),
    openTarget: (material: number) => {
      asked.push(material);
      return new Promise<void>((resolve, reject) => {
        settling.push({
          open: () => {
            targets.set(material, {} as TargetInfo);
            resolve();
          },
          refuse: () => reject(new Error("no memory")),
        });
      });
    },
  } as unknown as ShopProduct;
  const desk = new ShopDesk(product);
  const decal = makeDecalLayer({ id: "logo", asset: "logo", projector: FRONT });
  const assets = { logo: { type: "image/png", uri: "logo.png" } } as const;
  desk.begin(open, { ...emptyDesign(), assets, layers: [decal] });
  /** One move of a drag that has come to material 1; resolves when the desk's listeners were told of it. */
  const move = async (step: number): Promise<void> => {
    const [x, y, z] = FRONT.position;
    const projector = { ...FRONT, position: [x, y + step, z] } as const;
    desk.change<DecalLayer>("logo", { projector, material: 1 }, false);
    await new Promise<void>((told) => queueMicrotask(told));
  };
  return { move, asked, settling, failed };
}

it("a drag onto a material that is not open opens it once, however many moves come until it is", async () => {
  const { move, asked, settling, failed } = deskWithDecal();
  for (let step = 0; step < 30; step++) await move(step);
  expect(asked).toEqual([1]);
  settling[0]?.open();
  for (let step = 0; step < 30; step++) await move(step);
  expect(asked).toEqual([1]);
  expect(failed).toEqual([]);
});

it("a material that could not be opened is asked for again by the next move", async () => {
  const { move, asked, settling, failed } = deskWithDecal();
  await move(0);
  settling[0]?.refuse();
  await expect.poll(() => failed).toHaveLength(1);
  await move(1);
  expect(asked).toEqual([1, 1]);
});
