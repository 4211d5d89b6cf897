/**
 * Triangles in a tree of boxes: where a ray meets them, which one is nearest, which ones lie in a volume. The few questions that
 * the view asks, as fast as `three-mesh-bvh`; that package answers many more, and is 14 kB after gzip to a page
 * that is about to be touched.
 */
import { Box3, Ray, Triangle, Vector3 } from "three";

/** Indexed triangles: three numbers a vertex, three vertices a triangle. */
export interface Triangles {
  readonly positions: Float32Array;
  readonly index: Uint32Array;
}

/** Where a ray meets a triangle; `distance` in lengths of its direction. */
export interface RayHit {
  readonly triangle: number;
  readonly point: Vector3;
  readonly distance: number;
}

/** A question to all triangles. */
export interface TreeWalk {
  /** Whether a box is to be looked into; `depth` counts from the whole, 0. The box is good for this call alone. */
  enters(box: Box3, depth: number): boolean;
  /** Returns true to end the walk. The triangle is good for this call alone. */
  meets(triangle: Triangle, place: number): boolean;
}

const MOST_IN_LEAF = 8;
/** Boxes are widened for a ray by what its arithmetic may lose. */
const SLACK = 1 + 1e-12;
const MISSED = Number.POSITIVE_INFINITY;

export class TriangleTree {
  readonly #positions: Float32Array;
  readonly #index: Uint32Array;
  /** Triangles, those of a leaf side by side. */
  readonly #order: Uint32Array;
  /** Of each node: the first of its triangles in the order, and how many there are. */
  readonly #first: number[] = [];
  readonly #count: number[] = [];
  /** Of each node its second child; 0 of a leaf. The first one comes right after the node. */
  readonly #second: number[] = [];
  /** Six numbers a node: least and greatest. */
  readonly #boxes: Float32Array;
  readonly #triangle = new Triangle();
  readonly #box = new Box3();
  readonly #ray = new Ray();
  readonly #point = new Vector3();

  constructor({ positions, index }: Triangles) {
    this.#positions = positions;
    this.#index = index;
    this.#order = Uint32Array.from({ length: index.length / 3 }, (_, triangle) => triangle);
    if (this.#order.length > 0) this.#split(0, this.#order.length, this.#middles());
    this.#boxes = new Float32Array(this.#first.length * 6);
    this.refit();
  }

  /** The vertices have moved, and lie about as before. */
  refit(): void {
    const boxes = this.#boxes;
    // Children have higher numbers than what they are children of.
    for (let node = this.#first.length - 1; node >= 0; node--) {
      const at = node * 6;
      boxes.fill(Number.POSITIVE_INFINITY, at, at + 3).fill(Number.NEGATIVE_INFINITY, at + 3, at + 6);
      const second = this.#second[node] as number;
      if (second === 0) this.#encloseLeaf(node);
      else for (const child of [node + 1, second]) this.#grow(at, boxes, child * 6, child * 6 + 3);
    }
  }

  /** The nearest hit from `near` to `far`, from either side; null without one. */
  raycastFirst(ray: Ray, near: number, far: number): RayHit | null {
    let best: RayHit | null = null;
    this.#cast(ray, near, far, (hit) => {
      best = hit;
      return hit.distance;
    });
    return best;
  }

  /** All hits from `near` to `far`, in no order. */
  raycast(ray: Ray, near: number, far: number): RayHit[] {
    const hits: RayHit[] = [];
    this.#cast(ray, near, far, (hit) => {
      hits.push(hit);
      return far;
    });
    return hits;
  }

  /** The nearest point of all triangles, no farther than `within`; null without one. */
  closest(point: Vector3, within: number): RayHit | null {
    let square = within * within;
    let found: { triangle: number; point: Vector3 } | null = null;
    const on = new Vector3();
    const visit = (node: number): void => {
      if (this.#squareTo(node, point) >= square) return;
      const second = this.#second[node] as number;
      if (second > 0) {
        const isFirstNearer = this.#squareTo(node + 1, point) <= this.#squareTo(second, point);
        visit(isFirstNearer ? node + 1 : second);
        visit(isFirstNearer ? second : node + 1);
        return;
      }
      this.#eachOf(node, (triangle) => {
        this.#load(triangle).closestPointToPoint(point, on);
        const away = on.distanceToSquared(point);
        if (away < square) {
          square = away;
          found = { triangle, point: on.clone() };
        }
        return false;
      });
    };
    if (this.#first.length > 0) visit(0);
    return found && { ...(found as { triangle: number; point: Vector3 }), distance: Math.sqrt(square) };
  }

  walk({ enters, meets }: TreeWalk): void {
    const visit = (node: number, depth: number): boolean => {
      const box = this.#box;
      box.min.fromArray(this.#boxes, node * 6);
      box.max.fromArray(this.#boxes, node * 6 + 3);
      if (!enters(box, depth)) return false;
      const second = this.#second[node] as number;
      if (second > 0) return visit(node + 1, depth + 1) || visit(second, depth + 1);
      return this.#eachOf(node, (triangle) => meets(this.#load(triangle), triangle));
    };
    if (this.#first.length > 0) visit(0, 0);
  }

  /** Tells of each hit; `told` answers how far the ray still goes. */
  #cast(ray: Ray, near: number, far: number, told: (hit: RayHit) => number): void {
    this.#ray.copy(ray);
    const point = this.#point;
    let reach = far;
    const visit = (node: number, begin: number): void => {
      if (begin === MISSED || begin > reach) return;
      const second = this.#second[node] as number;
      if (second > 0) {
        const [one, other] = [this.#entry(node + 1, near, reach), this.#entry(second, near, reach)];
        const isFirstNearer = one <= other;
        visit(isFirstNearer ? node + 1 : second, isFirstNearer ? one : other);
        visit(isFirstNearer ? second : node + 1, isFirstNearer ? other : one);
        return;
      }
      this.#eachOf(node, (triangle) => {
        const { a, b, c } = this.#load(triangle);
        if (this.#ray.intersectTriangle(a, b, c, false, point) === null) return false;
        const distance = this.#ray.origin.distanceTo(point);
        if (distance >= near && distance <= reach) reach = told({ triangle, point: point.clone(), distance });
        return false;
      });
    };
    if (this.#first.length > 0) visit(0, this.#entry(0, near, reach));
  }

  /** Where the ray enters a node's box; MISSED where it does not between `near` and `far`. */
  #entry(node: number, near: number, far: number): number {
    const { origin, direction } = this.#ray;
    let begin = near;
    let end = far;
    for (let axis = 0; axis < 3; axis++) {
      const from = axis === 0 ? origin.x : axis === 1 ? origin.y : origin.z;
      const along = axis === 0 ? direction.x : axis === 1 ? direction.y : direction.z;
      const low = (this.#boxes[node * 6 + axis] as number) - from;
      const high = (this.#boxes[node * 6 + 3 + axis] as number) - from;
      if (along === 0) {
        if (low > 0 || high < 0) return MISSED;
        continue;
      }
      const [one, other] = [low / along, high / along];
      begin = Math.max(begin, Math.min(one, other));
      end = Math.min(end, Math.max(one, other) * SLACK);
    }
    return begin <= end ? begin : MISSED;
  }

  /** Lays out a node of triangles that stand side by side in the order, and all below it. */
  #split(first: number, count: number, middles: Float32Array): void {
    const node = this.#first.length;
    this.#first.push(first);
    this.#count.push(count);
    this.#second.push(0);
    if (count <= MOST_IN_LEAF) return;
    const half = this.#partition(first, count, middles);
    this.#split(first, half, middles);
    this.#second[node] = this.#first.length;
    this.#split(first + half, count - half, middles);
  }

  /** Brings the triangles below the middle of their longest side before the others. Returns how many they are. */
  #partition(first: number, count: number, middles: Float32Array): number {
    const order = this.#order;
    const least = [Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY, Number.POSITIVE_INFINITY];
    const most = [Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY, Number.NEGATIVE_INFINITY];
    for (let place = first; place < first + count; place++) {
      for (let axis = 0; axis < 3; axis++) {
        const value = middles[(order[place] as number) * 3 + axis] as number;
        if (value < (least[axis] as number)) least[axis] = value;
        if (value > (most[axis] as number)) most[axis] = value;
      }
    }
    const sides = most.map((value, axis) => value - (least[axis] as number));
    const axis = sides.indexOf(Math.max(...sides));
    const middle = ((least[axis] as number) + (most[axis] as number)) / 2;
    let low = first;
    let high = first + count - 1;
    while (low <= high) {
      const triangle = order[low] as number;
      if ((middles[triangle * 3 + axis] as number) < middle) low++;
      else {
        order[low] = order[high] as number;
        order[high--] = triangle;
      }
    }
    // Where all lie in one place, or have none, one half is as good as another.
    return low === first || low === first + count ? count >> 1 : low - first;
  }

  /** Middles of the triangles' boxes, twice over. */
  #middles(): Float32Array {
    const positions = this.#positions;
    const index = this.#index;
    const middles = new Float32Array(index.length);
    for (let corner = 0; corner < index.length; corner += 3) {
      for (let axis = 0; axis < 3; axis++) {
        const a = positions[(index[corner] as number) * 3 + axis] as number;
        const b = positions[(index[corner + 1] as number) * 3 + axis] as number;
        const c = positions[(index[corner + 2] as number) * 3 + axis] as number;
        middles[corner + axis] = Math.min(a, b, c) + Math.max(a, b, c);
      }
    }
    return middles;
  }

  #encloseLeaf(node: number): void {
    const from = this.#first[node] as number;
    const to = from + (this.#count[node] as number);
    for (let place = from; place < to; place++) {
      const corner = (this.#order[place] as number) * 3;
      for (let step = 0; step < 3; step++) {
        const vertex = (this.#index[corner + step] as number) * 3;
        this.#grow(node * 6, this.#positions, vertex, vertex);
      }
    }
  }

  /** Widens the box at a place of the boxes, to hold what lies between two points of some values. */
  #grow(at: number, values: Float32Array, low: number, high: number): void {
    const boxes = this.#boxes;
    for (let axis = 0; axis < 3; axis++) {
      const [least, most] = [values[low + axis] as number, values[high + axis] as number];
      if (least < (boxes[at + axis] as number)) boxes[at + axis] = least;
      if (most > (boxes[at + 3 + axis] as number)) boxes[at + 3 + axis] = most;
    }
  }

  /** Squared distance of a point to a node's box, 0 inside. */
  #squareTo(node: number, { x, y, z }: Vector3): number {
    const boxes = this.#boxes;
    const at = node * 6;
    const alongX = Math.max((boxes[at] as number) - x, 0, x - (boxes[at + 3] as number));
    const alongY = Math.max((boxes[at + 1] as number) - y, 0, y - (boxes[at + 4] as number));
    const alongZ = Math.max((boxes[at + 2] as number) - z, 0, z - (boxes[at + 5] as number));
    return alongX * alongX + alongY * alongY + alongZ * alongZ;
  }

  /** Returns whether `told` ended it. */
  #eachOf(node: number, told: (triangle: number) => boolean): boolean {
    const from = this.#first[node] as number;
    const to = from + (this.#count[node] as number);
    for (let place = from; place < to; place++) if (told(this.#order[place] as number)) return true;
    return false;
  }

  #load(triangle: number): Triangle {
    const { a, b, c } = this.#triangle;
    const corner = triangle * 3;
    a.fromArray(this.#positions, (this.#index[corner] as number) * 3);
    b.fromArray(this.#positions, (this.#index[corner + 1] as number) * 3);
    c.fromArray(this.#positions, (this.#index[corner + 2] as number) * 3);
    return this.#triangle;
  }
}
