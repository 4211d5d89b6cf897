import { describe, expect, it } from "vitest";
import type { EngineLayer } from "../../web/engine/engine-api.ts";
import { LayerReceiver, LayerSender } from "../../web/engine/sent-layers.ts";
import { fill, group, stroke } from "../support/layers.ts";

/** Both ends of the way to a worker, and the size of the newest message. */
function way() {
  const [sender, receiver] = [new LayerSender(), new LayerReceiver()];
  let parts = 0;
  const send = (layers: readonly EngineLayer[]): EngineLayer[] => {
    const sent = structuredClone(sender.pack(layers));
    parts = JSON.stringify(sent).split('"id"').length - 1;
    return receiver.unpack(sent);
  };
  return { send, parts: () => parts };
}

const strokes = (count: number): EngineLayer[] => Array.from({ length: count }, (_, i) => stroke(`s${i}`, []));

describe("layers on their way to the worker", () => {
  it("are sent as what is new: of a stroke more it is that one, however many there were", () => {
    const { send, parts } = way();
    const many = strokes(1000);
    const before = send([fill("f", [0, 0, 0, 1]), group("g", many)]);
    expect(parts()).toBe(1002);
    const after = send([fill("f", [0, 0, 0, 1]), group("g", [...many, stroke("new", [])])]);
    // The fill, the group, the strokes that there were, and the new one.
    expect(parts()).toBe(4);
    const held = (layers: EngineLayer[]) => (layers[1]?.type === "group" ? layers[1].layers : []);
    expect(held(after).slice(0, -1)).toEqual(many);
    expect(held(after).every((layer, at) => at === many.length || layer === held(before)[at])).toBe(true);
  });

  it("arrive as they are after any of them was moved, taken out, put into another or changed", () => {
    const { send } = way();
    const [a, b, c, d] = strokes(4) as [EngineLayer, EngineLayer, EngineLayer, EngineLayer];
    const masked = { ...b, mask: { invert: false, layers: [d] } } as EngineLayer;
    const lists = [
      [a, b, c, d],
      [b, a, c],
      [group("g", [c, b]), d, a],
      [a, group("g", [c]), masked],
      [masked, group("g", []), { ...c, opacity: 0.5 } as EngineLayer, a],
      [d, c, b, a],
      [],
      [a, b, c, d],
    ];
    for (const layers of lists) expect(send(layers)).toEqual(layers);
  });
});
