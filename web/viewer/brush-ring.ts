/** A brush's preview in the 3D view: rings draped over the surface, drawn in the view's pixels so that they stay thin. */
import { Quaternion, Vector3 } from "three";
import { UP_MODEL, uprightFrame } from "./decal-pose.ts";
import { FrameTask } from "./frame-task.ts";
import type { ScreenSpace } from "./screen-space.ts";
import type { SurfaceQuery } from "./surface-query.ts";
import { makeOverlay, makeSvg } from "./svg-overlay.ts";
import type { BrushRing } from "./tool-input.ts";

const POINTS = 40;
/** Rings that would be drawn closer to each other than this, pixels, are one. */
const RINGS_APART = 2.5;
/** Below this radius, pixels, a cross marks the place: such a ring is a dot. */
const LEAST_RADIUS = 3;

/** An SVG layer of rings, used by both views: what differs is how a ring becomes pixels. */
export class RingOverlay {
  readonly #element = makeOverlay("tcv-ring");
  readonly #paths: readonly { readonly element: SVGPathElement; drawn: string }[];

  constructor(root: HTMLElement) {
    this.#paths = ["tcv-ring-casing", "tcv-ring-line", "tcv-ring-inner"].map((name) => {
      const element = makeSvg("path", { class: name });
      this.#element.append(element);
      return { element, drawn: "" };
    });
    root.append(this.#element);
  }

  /** SVG path data, CSS pixels; "" draws nothing. */
  draw(outer: string, inner: string): void {
    const data = [outer, outer, inner];
    for (const [index, line] of this.#paths.entries()) {
      const path = data[index] as string;
      if (line.drawn === path) continue;
      line.drawn = path;
      line.element.setAttribute("d", path);
    }
  }

  dispose(): void {
    this.#element.remove();
  }
}

/** The ring of the 3D view. */
export class SurfaceRing {
  readonly #overlay: RingOverlay;
  readonly #screen: ScreenSpace;
  readonly #toDrawn: (point: Vector3) => Vector3;
  readonly #task = new FrameTask(() => this.drawNow());
  #query: SurfaceQuery | null = null;
  #ring: BrushRing | null = null;

  /** @param toDrawn where a point of the resting surface is drawn: an animation may have posed the model */
  constructor(root: HTMLElement, screen: ScreenSpace, toDrawn: (point: Vector3) => Vector3) {
    this.#overlay = new RingOverlay(root);
    this.#screen = screen;
    this.#toDrawn = toDrawn;
  }

  setSurface(query: SurfaceQuery | null): void {
    this.#query = query;
    this.show(null);
  }

  show(ring: BrushRing | null): void {
    if (ring === this.#ring) return;
    this.#ring = ring;
    this.#task.request();
  }

  /** Draws in this turn: the camera has moved and the frame is being shown. */
  drawNow(): void {
    this.#task.cancel();
    const ring = this.#ring;
    if (ring === null || this.#query === null) {
      this.#overlay.draw("", "");
      return;
    }
    if (ring.corners !== undefined) {
      this.#overlay.draw(closedPath(ring.corners.map((corner) => this.#screen.project(new Vector3(...corner)))), "");
      return;
    }
    const centre = new Vector3(...ring.hit.position);
    const pixels = ring.radius / this.#screen.metresPerPixel(this.#toDrawn(centre));
    if (pixels < LEAST_RADIUS) {
      this.#overlay.draw(this.#cross(centre), "");
      return;
    }
    const apart = pixels * (1 - ring.inner) >= RINGS_APART && ring.inner > 0;
    this.#overlay.draw(
      this.#path(this.#query, ring, ring.radius),
      apart ? this.#path(this.#query, ring, ring.radius * ring.inner) : "",
    );
  }

  dispose(): void {
    this.#task.cancel();
    this.#overlay.dispose();
  }

  #path(query: SurfaceQuery, { hit }: BrushRing, radius: number): string {
    const points = drapedCircle(query, new Vector3(...hit.position), new Vector3(...hit.normal), radius);
    return closedPath(points.map((point) => this.#screen.project(this.#toDrawn(point))));
  }

  #cross(centre: Vector3): string {
    const at = this.#screen.project(this.#toDrawn(centre));
    return at === null ? "" : crossPath(at);
  }
}

/** Points around a place of the surface, each where the surface lies below or above the tangent plane, if it does. */
export function drapedCircle(query: SurfaceQuery, centre: Vector3, normal: Vector3, radius: number): Vector3[] {
  const frame = uprightFrame(normal, UP_MODEL) ?? uprightFrame(normal, new Vector3(0, 0, 1)) ?? new Quaternion();
  const inward = normal.clone().negate();
  return Array.from({ length: POINTS }, (_, step) => {
    const angle = (2 * Math.PI * step) / POINTS;
    const flat = new Vector3(Math.cos(angle) * radius, Math.sin(angle) * radius, 0).applyQuaternion(frame).add(centre);
    const above = flat.clone().addScaledVector(normal, radius);
    return query.raycast(above, inward, 2 * radius)?.position ?? flat;
  });
}

/** A closed line through points of a view; nothing where one of them lies behind the camera. */
export function closedPath(points: readonly ({ readonly x: number; readonly y: number } | null)[]): string {
  if (points.some((point) => point === null)) return "";
  return `M${points.map((point) => `${point?.x.toFixed(1)} ${point?.y.toFixed(1)}`).join("L")}Z`;
}

export function crossPath({ x, y }: { readonly x: number; readonly y: number }): string {
  const arm = 6;
  const gap = 2;
  const [left, top] = [x.toFixed(1), y.toFixed(1)];
  return `M${left} ${top}m${-arm} 0h${arm - gap}m${2 * gap} 0h${arm - gap}M${left} ${top}m0 ${-arm}v${arm - gap}m0 ${2 * gap}v${arm - gap}`;
}
