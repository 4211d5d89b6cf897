import { describe, expect, it } from "vitest";
import { type Design, emptyDesign, makeDecalLayer } from "../../web/editor/document/index.ts";
import type { OpenModel } from "../../web/editor/state/design-state.ts";
import { type EditorState, INITIAL_STATE } from "../../web/editor/state/editor-state.ts";
import { LostDecal } from "../../web/editor/state/lost-decal.ts";
import { NoticeBoard } from "../../web/editor/state/notice-board.ts";
import { Store } from "../../web/editor/state/store.ts";
import type { Projector } from "../../web/engine/engine-api.ts";

const label = (y: number): Projector => ({
  kind: "cylindrical",
  position: [0, y, 0],
  rotation: [0, 0, 0, 1],
  radius: 1,
  arc: 90,
  height: 1,
  depth: 0.1,
});

/** A model whose rim is at y = 0, and what is told of a label on it. */
function page() {
  const store = new Store<EditorState>(INITIAL_STATE);
  const lost = new LostDecal(
    {
      materialsReached: (projector) =>
        projector.kind === "cylindrical" && projector.position[1] - projector.height / 2 < 0 ? [0] : [],
    },
    new NoticeBoard(store),
  );
  const design = (projector: Projector, rest: object = {}): Design => ({
    ...emptyDesign(),
    layers: [makeDecalLayer({ id: "a", name: "Badge", asset: "logo", projector, material: 0, ...rest })],
  });
  const mug = {} as OpenModel;
  const move = (to: Design, model = mug): void => lost.follow(model, to, "a");
  return { design, move, titles: () => store.state.notices.map(({ title }) => title) };
}

describe("a decal that is moved beside the model", () => {
  it("is told once, from where a sliver of it is left, until it is back", () => {
    const { design, move, titles } = page();
    for (const [y, told] of [
      [-1, []],
      [0.3, []],
      [0.45, ["Badge lies beside the model"]],
      [3, ["Badge lies beside the model"]],
      [0, []],
    ] as const) {
      move(design(label(y)));
      expect(titles(), String(y)).toEqual(told);
    }
  });

  it("is not told where it lay there before, where it came so, or with another model", () => {
    const { design, move, titles } = page();
    move(design(label(3)));
    move(design(label(4)));
    expect(titles()).toEqual([]);
    move(design(label(-1)));
    move(design(label(3)), {} as OpenModel);
    expect(titles()).toEqual([]);
  });

  it("is told no more once it is deleted", () => {
    const { design, move, titles } = page();
    move(design(label(-1)));
    move(design(label(3)));
    move(emptyDesign());
    expect(titles()).toEqual([]);
  });

  it("is not told while its twin in the mirror lies on it, nor as a stamp, which lies in the texture", () => {
    const { design, move, titles } = page();
    move(design(label(-1)));
    move(design(label(3), { mirror: { axis: "y", offset: 0, readable: false } }));
    move(design({ kind: "uv", center: [0.5, 0.5], size: [1, 1], angle: 0 }));
    expect(titles()).toEqual([]);
  });
});
