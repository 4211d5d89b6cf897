/** The outline of a chart's pattern. */
import type { Chart } from "./chart.ts";

/** Vertices round the chart, in order: along the edges that only one triangle has. For charts of one piece without holes. */
export function chartOutline(chart: Chart): number[] {
  const edges = new Map<string, readonly [number, number]>();
  for (const [a, b, c] of chart.triangles) {
    for (const [from, to] of [
      [a, b],
      [b, c],
      [c, a],
    ] as const) {
      if (!edges.delete(`${to} ${from}`)) edges.set(`${from} ${to}`, [from, to]);
    }
  }
  const next = new Map([...edges.values()]);
  const first = next.keys().next().value;
  if (first === undefined) throw new RangeError(`chartOutline: "${chart.name}" has no triangle`);
  const outline = [first];
  for (let vertex = next.get(first); vertex !== first; vertex = next.get(vertex)) {
    if (vertex === undefined || outline.length > next.size) {
      throw new RangeError(`chartOutline: "${chart.name}" has no single outline`);
    }
    outline.push(vertex);
  }
  return outline;
}
