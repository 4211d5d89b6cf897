/**
 * Lays rectangles side by side without overlap, largest first, each as low as the skyline of the ones before lets it,
 * and finds the largest common scale at which all fit.
 */

export interface PackItem {
  readonly name: string;
  /** Units of the pattern (metres times relative density). */
  readonly width: number;
  readonly height: number;
}

export interface PackPlace {
  /** Texels of the top left corner; whole numbers. */
  readonly x: number;
  readonly y: number;
}

export interface PackResult {
  /** Texels per unit. */
  readonly scale: number;
  readonly places: ReadonlyMap<string, PackPlace>;
}

export interface PackArea {
  /** Texels. */
  readonly width: number;
  readonly height: number;
  /** Texels kept free between rectangles and along the border. */
  readonly spacing: number;
}

/** No order is best for all sets of rectangles: each is tried, and the one that allows the largest scale is taken. */
const ORDERS: readonly ((item: PackItem) => number)[] = [
  (item) => item.height,
  (item) => item.width,
  (item) => item.width * item.height,
  (item) => Math.max(item.width, item.height),
];

/** Throws a RangeError if nothing fits at any scale. */
export function packRectangles(items: readonly PackItem[], area: PackArea): PackResult {
  const names = new Set(items.map((item) => item.name));
  if (names.size !== items.length) throw new RangeError("packRectangles: two rectangles have the same name");
  let best: PackResult | undefined;
  for (const order of ORDERS) {
    const sorted = [...items].sort(
      (a, b) => order(b) - order(a) || b.height - a.height || b.width - a.width || (a.name < b.name ? -1 : 1),
    );
    const result = packInOrder(sorted, area);
    if (result && result.scale > (best?.scale ?? 0)) best = result;
  }
  if (!best) throw new RangeError(`packRectangles: ${items.length} rectangles do not fit ${area.width}x${area.height}`);
  return best;
}

function packInOrder(sorted: readonly PackItem[], area: PackArea): PackResult | undefined {
  let low = 0;
  let high = area.width / Math.max(...sorted.map((item) => item.width));
  let best: PackResult | undefined;
  for (let round = 0; round < 18; round++) {
    const scale = (low + high) / 2;
    const places = packAtScale(sorted, area, scale);
    if (places) {
      best = { scale, places };
      low = scale;
    } else {
      high = scale;
    }
  }
  return best;
}

function packAtScale(sorted: readonly PackItem[], area: PackArea, scale: number): Map<string, PackPlace> | undefined {
  const { spacing } = area;
  const right = area.width;
  // One height per texel column: simple, and fast enough for some dozens of rectangles.
  const skyline = new Int32Array(right).fill(spacing);
  const places = new Map<string, PackPlace>();
  for (const pattern of sorted) {
    const item = {
      name: pattern.name,
      width: Math.ceil(pattern.width * scale) + spacing,
      height: Math.ceil(pattern.height * scale) + spacing,
    };
    let bestX = -1;
    let bestY = area.height - item.height + 1;
    for (let x = spacing; x + item.width <= right; x++) {
      const isStep = x === spacing || skyline[x] !== skyline[x - 1];
      if (!isStep) continue;
      let y = 0;
      for (let column = x; column < x + item.width; column++) y = Math.max(y, skyline[column] as number);
      if (y < bestY) {
        bestX = x;
        bestY = y;
      }
    }
    if (bestX < 0) return undefined;
    skyline.fill(bestY + item.height, bestX, bestX + item.width);
    places.set(item.name, { x: bestX, y: bestY });
  }
  return places;
}
