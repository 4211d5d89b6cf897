/** What a shop's customer hears of the keys that move, turn and size what is chosen. */
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import type { Desk } from "../../web/element/desk/desk.ts";
import { KeyReport } from "../../web/element/shop/key-report.ts";
import { sizeOf, turnOf } from "../../web/element/shop/layer-fields.ts";
import { english } from "../../web/element/words/english.ts";
import { german } from "../../web/element/words/german.ts";
import { FRONT } from "../support/layers.ts";

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
});

function reportIn(words = english, printScale?: number) {
  const said: string[] = [];
  const projector = { ...FRONT, kind: "planar", size: [0.08, 0.04, 0.1] };
  const desk = {
    selected: { id: "a", type: "decal", projector },
    settings: { words },
    zones: printScale === undefined ? null : { printScale },
    hooks: { announce: (text: string) => void said.push(text) },
    closed: false,
  };
  return { said, desk, report: new KeyReport(desk as unknown as Desk, { sizeOf, turnOf }) };
}

it("steps that follow each other are one way, told once they rest", () => {
  const { said, report } = reportIn();
  for (let step = 0; step < 3; step += 1) {
    report.after({ kind: "nudge", right: -0.002, up: 0 });
    vi.advanceTimersByTime(300);
  }
  report.after({ kind: "nudge", right: 0, up: 0.001 });
  expect(said).toEqual([]);
  vi.advanceTimersByTime(1000);
  expect(said).toEqual(["0.6 cm to the left, 0.1 cm up"]);
  report.after({ kind: "nudge", right: 0.01, up: 0 });
  vi.advanceTimersByTime(1000);
  expect(said[1]).toBe("1.0 cm to the right");
});

it("a turn and a size are told as the fields have them, in the customer's language and the print's measure", () => {
  const { said, report } = reportIn(german, 0.5);
  report.after({ kind: "spin", right: 0, up: 0 });
  vi.advanceTimersByTime(1000);
  report.after({ kind: "scale", right: 0, up: 0 });
  vi.advanceTimersByTime(1000);
  report.after({ kind: "nudge", right: 0, up: -0.01 });
  vi.advanceTimersByTime(1000);
  expect(said).toEqual(["Drehung 0,0°", "Breite 4,0 cm, Höhe 2,0 cm", "0,5 cm nach unten"]);
});

it("nothing is told of what is no longer chosen, or of a product that was closed", () => {
  for (const after of [{ selected: undefined }, { selected: { id: "b" } }, { closed: true }]) {
    const { said, desk, report } = reportIn();
    report.after({ kind: "nudge", right: 0.01, up: 0 });
    Object.assign(desk, after);
    vi.advanceTimersByTime(1000);
    expect(said).toEqual([]);
  }
});
