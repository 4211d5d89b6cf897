/** Lines and rectangles on the texel grid. */

export type Texel = readonly [x: number, y: number];

/** Bresenham's line, both ends included, from the first to the last. */
export function texelLine([fromX, fromY]: Texel, [toX, toY]: Texel): Texel[] {
  const [width, height] = [Math.abs(toX - fromX), -Math.abs(toY - fromY)];
  const [stepX, stepY] = [fromX < toX ? 1 : -1, fromY < toY ? 1 : -1];
  const line: Texel[] = [];
  let error = width + height;
  for (let [x, y] = [fromX, fromY]; ; ) {
    line.push([x, y]);
    if (x === toX && y === toY) return line;
    const doubled = 2 * error;
    if (doubled >= height) {
      error += height;
      x += stepX;
    }
    if (doubled <= width) {
      error += width;
      y += stepY;
    }
  }
}

/** The rectangle between two corners, which belong to it. */
export function texelRectangle([ax, ay]: Texel, [bx, by]: Texel, filled: boolean): Texel[] {
  const [left, right] = [Math.min(ax, bx), Math.max(ax, bx)];
  const [top, bottom] = [Math.min(ay, by), Math.max(ay, by)];
  const texels: Texel[] = [];
  for (let y = top; y <= bottom; y++) {
    for (let x = left; x <= right; x++) {
      if (filled || x === left || x === right || y === top || y === bottom) texels.push([x, y]);
    }
  }
  return texels;
}

/** Where a shape with Shift held ends: a square; of lines those level, upright and at half a right angle. */
export function squared([fromX, fromY]: Texel, [toX, toY]: Texel, line: boolean): Texel {
  const [x, y] = [toX - fromX, toY - fromY];
  if (line && Math.abs(x) > 2 * Math.abs(y)) return [toX, fromY];
  if (line && Math.abs(y) > 2 * Math.abs(x)) return [fromX, toY];
  const side = Math.max(Math.abs(x), Math.abs(y));
  return [fromX + (x < 0 ? -side : side), fromY + (y < 0 ? -side : side)];
}

/** Left and top of a square pencil's tip about a place that is given in texels with their fractions. */
export function tipCorner(x: number, y: number, size: number): Texel {
  return [Math.floor(x - (size - 1) / 2), Math.floor(y - (size - 1) / 2)];
}
