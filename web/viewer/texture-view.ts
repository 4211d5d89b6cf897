/** The 2D view: a material's unfolded texture, live, with UV outlines over it. */
import { TexelcastError } from "../core/texelcast-error.ts";
import type { MapView, TargetInfo, TargetUpdate } from "../engine/engine-api.ts";
import { adoptStyle } from "./adopt-style.ts";
import { BoundTexture, type OverlayColors } from "./bound-texture.ts";
import { readCssColor } from "./css-color.ts";
import { EventHub } from "./event-hub.ts";
import type { TexelRegion } from "./finest-level.ts";
import { FrameTask } from "./frame-task.ts";
import { GIZMO_STYLE } from "./gizmo-style.ts";
import { GpuPace } from "./gpu-pace.ts";
import { LostContext } from "./lost-context.ts";
import { scaleOf } from "./page-scale.ts";
import { PanZoomInput } from "./pan-zoom-input.ts";
import { watchPixelRatio } from "./pixel-ratio.ts";
import type { ScreenPoint } from "./screen-space.ts";
import { StampGizmo } from "./stamp-gizmo.ts";
import { TextureCamera } from "./texture-camera.ts";
import { TextureGuide } from "./texture-guide.ts";
import { type PaintColors, type PaintedTexture, TexturePainter } from "./texture-painter.ts";
import { TexturePointer } from "./texture-pointer.ts";
import { TextureTools } from "./texture-tools.ts";
import type { ToolInput } from "./tool-input.ts";
import { TOOL_STYLE } from "./tool-style.ts";
import { UpdateQueue } from "./update-queue.ts";
import type {
  FindStamps,
  GuideEntry,
  MapPicture,
  SurfaceHit,
  TextureHover,
  TextureView,
  TextureViewEvents,
  ViewerDecal,
} from "./viewer-api.ts";
import { VIEW_STYLE } from "./viewer-style.ts";
import { windowOf } from "./window-of.ts";

export interface TextureViewOptions {
  /** Accessible name of the view; default "Texture". */
  readonly label?: string;
  /** The GPU lost a target's picture: give a full update again. */
  readonly onNeedsFullUpdate?: (material: number) => void;
  /**
   * Reads texels of a target, RGBA, as `Engine.readTexels` does. With it the finest mip level is uploaded only while it is
   * seen; without it always.
   */
  readonly readTexels?: (material: number, x: number, y: number, width: number, height: number) => Promise<Uint8Array>;
}

/** Builds a texture view that fills `host`, which must have a size of its own. Throws a TexelcastError without WebGL 2. */
export function createTextureView(host: HTMLElement, options: TextureViewOptions = {}): TextureView {
  return new GlTextureView(host, options);
}

const MOST_PIXEL_RATIO = 2;
class GlTextureView implements TextureView {
  readonly element: HTMLElement;
  readonly #canvas = document.createElement("canvas");
  readonly #marker = document.createElement("div");
  readonly #options: TextureViewOptions;
  readonly #gl: WebGL2RenderingContext;
  readonly #camera = new TextureCamera();
  readonly #stamp: StampGizmo;
  #stampDecal: ViewerDecal | null = null;
  #findStamps: FindStamps = () => null;
  readonly #tools: TextureTools;
  readonly #guide: TextureGuide;
  readonly #pointer: TexturePointer;
  readonly #events = new EventHub<TextureViewEvents>();
  readonly #input: PanZoomInput;
  readonly #resize: ResizeObserver;
  readonly #drawTask = new FrameTask(() => this.#draw());
  readonly #abort = new AbortController();
  readonly #themeObserver = new MutationObserver(() => this.#readColors());
  readonly #pace: GpuPace;
  readonly #waiting = new LostContext();
  readonly #updates = new UpdateQueue(
    (update) => this.#applyNow(update),
    (task) => this.#whenFree(task),
  );
  // The queue and the task know these, too; asked there they would weigh on product pages, which share both and have no 20 bytes left.
  #isWaiting = false;
  #isUndrawn = false;
  /** Answers that will be drawn are on their way from the engine. */
  #asked = 0;
  #painter: TexturePainter;
  #target: BoundTexture | null = null;
  /** The first target, while the view has never had room in the page, as on a phone: nothing of it is on the GPU yet. */
  #unseen: Parameters<TextureView["bindTarget"]> | null = null;
  #map: { readonly picture: MapPicture; texture: PaintedTexture } | null = null;
  #outlines = true;
  #markedUv: readonly [number, number] | null = null;
  /** 0 while the view has no room in the page: it takes updates, without the finest level, and draws nothing. */
  #pixelRatio = 0;
  #colors: (PaintColors & OverlayColors) | null = null;

  constructor(host: HTMLElement, options: TextureViewOptions) {
    this.#options = options;
    adoptStyle(host, VIEW_STYLE);
    adoptStyle(host, GIZMO_STYLE);
    adoptStyle(host, TOOL_STYLE);
    const root = document.createElement("div");
    root.className = "tcv-root tcv-texture";
    root.tabIndex = 0;
    root.setAttribute("role", "application");
    root.setAttribute("aria-label", options.label ?? "Texture");
    this.#canvas.className = "tcv-canvas";
    this.#marker.className = "tcv-marker";
    this.#marker.hidden = true;
    root.append(this.#canvas, this.#marker);
    host.append(root);
    this.element = root;
    this.#gl = contextOf(this.#canvas);
    this.#pace = new GpuPace(this.#gl);
    this.#painter = new TexturePainter(this.#gl);
    this.#guide = new TextureGuide(root);
    // Before the other inputs, from which it keeps what it takes.
    this.#stamp = new StampGizmo(root, {
      pixelOf: (uv) => this.#camera.pixelOf(uv),
      uvOf: (x, y) => this.#camera.uvOf(x, y),
      holds: (at, margin) => this.#camera.holds(at, margin),
      isSeen: () => this.#pixelRatio > 0,
      gesture: (gesture) => this.#events.emit("gesture", gesture),
      others: (id) => this.#findStamps(id),
      chartAt: (uv) => this.#target?.chartAt(uv) ?? null,
    });
    this.#pointer = new TexturePointer(root, {
      hover: (at) => this.#events.emit("hover", at && this.#hoverOf(at)),
      click: (at) => this.#events.emit("click", this.#hoverOf(at)),
    });
    // Before the panning input, which it keeps from what a tool takes.
    this.#tools = new TextureTools(root, this.#camera);
    this.#input = new PanZoomInput(root, this.#camera, {
      changed: () => this.#drawSoon(),
      fit: () => this.resetZoom(),
    });
    this.#resize = new (windowOf(root).ResizeObserver)(() => this.#applySize());
    this.#resize.observe(root);
    watchPixelRatio(() => this.#applySize(), this.#abort.signal);
    this.#watch();
  }

  bindTarget(info: TargetInfo, uvTriangles: Float32Array): void {
    this.#camera.setTexture(info);
    if (this.#pixelRatio === 0 && this.#target === null && this.#options.readTexels !== undefined) {
      this.#unseen = [info, uvTriangles];
      return;
    }
    this.#target = new BoundTexture(this.#painter, info, uvTriangles, this.#target);
    this.#drawSoon();
  }

  applyUpdate(update: TargetUpdate): boolean {
    const isBrought = this.#updates.push(update);
    this.#isWaiting = !isBrought;
    return isBrought;
  }

  get isBehind(): boolean {
    // Without room, or in a tab that nobody sees, there is nothing on the screen, and no frame that would draw it.
    const isSeen = this.#pixelRatio > 0 && !document.hidden;
    return this.#isWaiting || (isSeen && (this.#isUndrawn || this.#asked > 0));
  }

  setMode(mode: "texture" | MapView, picture?: MapPicture): void {
    if (this.#map !== null) {
      this.#painter.freeTexture(this.#map.texture);
      this.#map = null;
    }
    if (mode !== "texture" && picture !== undefined) {
      this.#map = { picture, texture: this.#painter.makePicture(picture) };
    }
    this.#drawSoon();
  }

  setOutlinesVisible(visible: boolean): void {
    this.#outlines = visible;
    this.#drawSoon();
  }

  highlightChart(uv: readonly [number, number] | null): void {
    if (this.#target?.light(uv)) {
      this.#drawSoon();
    }
  }

  setGuide(guide: readonly GuideEntry[]): void {
    this.#guide.show(guide);
    this.#guide.place(this.#camera);
  }

  on<K extends keyof TextureViewEvents>(type: K, listener: (event: TextureViewEvents[K]) => void): () => void {
    return this.#events.on(type, listener);
  }

  setMarker(uv: readonly [number, number] | null): void {
    this.#markedUv = uv;
    this.#placeMarker();
  }

  setTool(input: ToolInput | null, pick: (uv: readonly [number, number]) => SurfaceHit | null): void {
    this.#tools.set(input, pick);
    this.#showStamp();
  }

  setRing(outlines: readonly (readonly (readonly [number, number])[])[] | null): void {
    this.#tools.showRing(outlines);
  }

  setStamp(decal: ViewerDecal | null): void {
    this.#stampDecal = decal;
    this.#showStamp();
  }

  setSurroundings(find: FindStamps): void {
    this.#findStamps = find;
  }

  resetZoom(): void {
    this.#camera.fit();
    this.#drawSoon();
  }

  uvAtPointer(clientX: number, clientY: number): readonly [number, number] | null {
    const { left, top, right, bottom } = this.element.getBoundingClientRect();
    const isInside = clientX >= left && clientX < right && clientY >= top && clientY < bottom;
    // Of its own pixels for one of the window's, where a part of the page around it is scaled.
    const scale = scaleOf(this.element, right - left);
    const point = [(clientX - left) * scale, (clientY - top) * scale] as const;
    return isInside && this.#target !== null ? this.#camera.uvOf(...point) : null;
  }

  dispose(): void {
    this.#abort.abort();
    this.#waiting.end();
    this.#themeObserver.disconnect();
    this.#resize.disconnect();
    this.#input.dispose();
    this.#tools.dispose();
    this.#stamp.dispose();
    this.#guide.dispose();
    this.#pointer.dispose();
    this.#drawTask.cancel();
    this.#pace.dispose();
    this.#isWaiting = false;
    this.#isUndrawn = false;
    this.#gl.getExtension("WEBGL_lose_context")?.loseContext();
    this.element.remove();
  }

  #applyNow(update: TargetUpdate): void {
    this.#isWaiting = false;
    if (this.#target?.takes(update) && !this.#gl.isContextLost()) {
      this.#target.upload(update, this.#options.readTexels !== undefined && !this.#showsFinest());
      this.#showSoon();
    }
  }

  /**
   * While the hand is elsewhere, in the 3D view as a rule, every second frame will do: each costs the page's own thread a canvas more
   * to hand on (the median frame of such a drag takes 3.5 ms instead of 4.1).
   */
  #showSoon(): void {
    if (this.#pointer.isHere) {
      this.#drawSoon();
    } else {
      this.#isUndrawn = true;
      this.#drawTask.requestLater();
    }
  }

  #drawSoon(): void {
    this.#isUndrawn = true;
    this.#drawTask.request();
  }

  /** At half its size a texture is drawn from its second level on. */
  #showsFinest(): boolean {
    return this.#camera.scale * this.#pixelRatio > 0.5;
  }

  /** Texels of a target, which are to be drawn. */
  async #readTexels(material: number, { x, y, width, height }: TexelRegion): Promise<Uint8Array> {
    this.#asked += 1;
    try {
      return (await this.#options.readTexels?.(material, x, y, width, height)) ?? new Uint8Array();
    } finally {
      this.#asked -= 1;
    }
  }

  /** Has what was left out brought where it is seen now. */
  async #completeFinest(target: BoundTexture): Promise<void> {
    const region = this.#showsFinest() ? target.missing() : null;
    if (region === null) {
      return;
    }
    const { texture } = target;
    try {
      const bytes = await this.#readTexels(target.info.material, region);
      if (this.#target?.texture === texture && !this.#gl.isContextLost()) {
        this.#target.complete(region, bytes);
        this.#drawSoon();
      }
    } catch {
      // The engine was ended or started anew; what it tells again comes as an update.
      target.complete(region, null);
    }
  }

  /** The GPU serves all of the page: a fence of this view's own is passed when the 3D view's frame is done, too. */
  #whenFree(task: () => void): void {
    this.#pace.mark({ flush: true });
    this.#pace.whenDone(task);
  }

  #draw(): void {
    this.#isUndrawn = false;
    if (this.#pixelRatio === 0 || this.#gl.isContextLost()) {
      return;
    }
    this.#painter.clear();
    const target = this.#target;
    if (target !== null) {
      this.#colors ??= this.#computeColors();
      target.drawFromNewest();
      void this.#completeFinest(target);
      this.#painter.drawPicture(
        this.#map?.texture ?? target.texture,
        this.#cameraFor(),
        this.#colors,
        this.#pixelRatio,
      );
      if (this.#outlines) {
        target.drawOutlines(this.#colors, this.#camera, this.#pixelRatio);
      }
      target.drawLit(this.#colors, this.#camera, this.#pixelRatio);
    }
    this.#placeMarker();
    this.#tools.place(this.#target !== null);
    this.#guide.place(this.#camera);
    this.#stamp.draw();
  }

  #hoverOf({ x, y }: ScreenPoint): TextureHover {
    const uv = this.#camera.uvOf(x, y);
    const { width = 0, height = 0 } = this.#target?.info ?? {};
    const [column, row] = [Math.floor(uv[0] * width), Math.floor(uv[1] * height)];
    const inside = column >= 0 && row >= 0 && column < width && row < height;
    return { uv, texel: inside ? [column, row] : null };
  }

  /** A map view of another size than the target covers the same ground. */
  #cameraFor(): TextureCamera {
    const map = this.#map?.texture;
    const target = this.#target?.texture;
    if (map === undefined || target === undefined || map.width === target.width) {
      return this.#camera;
    }
    return Object.assign(new TextureCamera(), {
      x: this.#camera.x,
      y: this.#camera.y,
      scale: (this.#camera.scale * target.width) / map.width,
    });
  }

  #showStamp(): void {
    this.#stamp.decal = this.#tools.active ? null : this.#stampDecal;
  }

  #placeMarker(): void {
    const hidden = this.#markedUv === null || this.#target === null;
    if (this.#marker.hidden !== hidden) {
      this.#marker.hidden = hidden;
    }
    if (this.#markedUv !== null) {
      const { x, y } = this.#camera.pixelOf(this.#markedUv);
      this.#marker.style.transform = `translate(${x.toFixed(1)}px, ${y.toFixed(1)}px)`;
    }
  }

  #applySize(): void {
    const width = this.element.clientWidth;
    const height = this.element.clientHeight;
    if (width === 0 || height === 0) {
      this.#pixelRatio = 0;
      return;
    }
    this.#pixelRatio = Math.min(devicePixelRatio, MOST_PIXEL_RATIO);
    this.#canvas.width = Math.round(width * this.#pixelRatio);
    this.#canvas.height = Math.round(height * this.#pixelRatio);
    this.#camera.setView({ width, height });
    this.#colors = null;
    void this.#bindUnseen();
    // A canvas that was resized is empty until it is drawn again.
    this.#draw();
  }

  /** The first room: the target that waits for it, and its picture, which came when there was nothing to take it. */
  async #bindUnseen(): Promise<void> {
    if (this.#unseen === null) {
      return;
    }
    const [info, uvTriangles] = this.#unseen;
    this.#unseen = null;
    this.bindTarget(info, uvTriangles);
    const { material, width, height } = info;
    try {
      const bytes = await this.#readTexels(material, { x: 0, y: 0, width, height });
      if (this.#target?.info === info && !this.#gl.isContextLost()) {
        this.#target.upload({ rects: [{ x: 0, y: 0, width, height, level: 0, byteOffset: 0 }], bytes }, false);
        this.#drawSoon();
      }
    } catch {
      // The engine was ended or started anew; what it tells again comes as an update.
    }
  }

  #watch(): void {
    const { signal } = this.#abort;
    const lose = (event: Event): void => {
      event.preventDefault();
      this.#waiting.wait(() => this.#events.emit("graphics", { lost: true }));
    };
    this.#canvas.addEventListener("webglcontextlost", lose, { signal });
    this.#canvas.addEventListener("webglcontextrestored", () => this.#restore(), { signal });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.#readColors(), { signal });
    this.#themeObserver.observe(document.documentElement, {
      attributes: true,
      attributeFilter: ["class", "style", "data-theme"],
    });
  }

  #restore(): void {
    this.#waiting.end();
    this.#events.emit("graphics", { lost: false });
    this.#painter = new TexturePainter(this.#gl);
    if (this.#target !== null) {
      this.#target.restore(this.#painter);
      this.#options.onNeedsFullUpdate?.(this.#target.info.material);
    }
    if (this.#map !== null) {
      this.#map.texture = this.#painter.makePicture(this.#map.picture);
    }
    this.#drawSoon();
  }

  #readColors(): void {
    this.#colors = null;
    this.#drawSoon();
  }

  #computeColors() {
    return {
      checkerA: readCssColor(this.element, "--viewer-checker-a", "rgb(255 255 255)"),
      checkerB: readCssColor(this.element, "--viewer-checker-b", "rgb(224 227 232)"),
      border: readCssColor(this.element, "--viewer-outline", "var(--viewer-accent, rgb(61 126 255))"),
      glow: readCssColor(this.element, "--tcv-accent", "rgb(61 126 255)"),
    };
  }
}

function contextOf(canvas: HTMLCanvasElement): WebGL2RenderingContext {
  const gl = canvas.getContext("webgl2", { antialias: true, alpha: true, depth: false });
  if (gl === null) {
    throw new TexelcastError(
      "unsupported",
      "This browser cannot show the texture: WebGL 2 is switched off or missing.",
      {
        hint: "Switch on hardware acceleration in the browser's settings, or use another browser.",
        reason: "no-webgl",
      },
    );
  }
  return gl;
}
