import { describe, expect, it } from "vitest";
import { type Design, emptyDesign, makePaintLayer, makeStrokeLayer } from "../../web/editor/document/index.ts";
import { ProjectPacker } from "../../web/editor/storage/packed-project.ts";
import { stringsIn } from "../../web/editor/strings.ts";
import { FRONT } from "../support/layers.ts";

const BRUSH = { tip: "round", color: "#c02050", hardness: 0.5, flow: 0.5 } as const;
const stroke = (id: string, opacity = 1) =>
  makeStrokeLayer({ id, brush: BRUSH, opacity, dabs: [{ ...FRONT, flow: 1 }] });
const painted = (strokes: ReturnType<typeof stroke>[]): Design => ({
  ...emptyDesign(),
  layers: [makePaintLayer({ id: "paint", strokes })],
});

const pack = (packer: ProjectPacker, design: Design) =>
  packer.pack({
    name: "Mug",
    design,
    model: { source: null as never, title: "Mug", demoId: "mug" },
    targets: new Map(),
  });

describe("a design that is packed to be kept", () => {
  it("has what was packed before neither written nor read again: a stroke more costs that stroke", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    let asked = 0;
    const watched = ["a", "b", "c"].map((id) => {
      return new Proxy(stroke(id), {
        get: (layer, field) => {
          if (field === "dabs") asked += 1;
          return Reflect.get(layer, field);
        },
      });
    });
    await pack(packer, painted(watched));
    expect(asked).toBeGreaterThan(0);
    asked = 0;
    const { design } = await pack(packer, painted([...watched, stroke("d")]));
    expect(asked).toBe(0);
    const [paint] = JSON.parse(design).layers;
    expect(paint.strokes.map(({ id }: { id: string }) => id)).toEqual(["a", "b", "c", "d"]);
  });

  it("is refused where it could not be read again: by a new stroke, and by what strokes have to do with each other", async () => {
    const packer = new ProjectPacker(stringsIn("en"));
    const kept = [stroke("a"), stroke("b")];
    await pack(packer, painted(kept));
    const picture = makeStrokeLayer({
      id: "c",
      brush: { ...BRUSH, tip: "picture", asset: "gone", color: null },
      dabs: [],
    });
    const bad = [
      painted([...kept, stroke("c", 7)]),
      painted([...kept, stroke("b")]),
      painted([...kept, picture as ReturnType<typeof stroke>]),
      { ...emptyDesign(), layers: [...painted(kept).layers, makePaintLayer({ id: "more", strokes: kept })] },
    ];
    for (const design of bad) await expect(pack(packer, design)).rejects.toMatchObject({ code: "bad-design" });
  });
});
