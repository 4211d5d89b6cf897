/** Renderer, scene, camera and the loop that draws a frame only when something asked for one. */
import {
  type Box3,
  NeutralToneMapping,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Sphere,
  SRGBColorSpace,
  Vector3,
  WebGLRenderer,
} from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import { anisotropyFor } from "./anisotropy.ts";
import { type CameraRig, StillRig } from "./camera-rig.ts";
import { captureScene, lensFor } from "./capture.ts";
import { ContactShadow } from "./contact-shadow.ts";
import { GpuPace } from "./gpu-pace.ts";
import { GroundLight } from "./ground-light.ts";
import { LostContext } from "./lost-context.ts";
import { MotionResolution } from "./motion-resolution.ts";
import { watchPixelRatio } from "./pixel-ratio.ts";
import { createStudioEnvironment } from "./studio-environment.ts";
import { OVERLAY_LAYER } from "./view-layers.ts";
import { windowOf } from "./window-of.ts";

/** A frame costs four times at 3 what it costs at 1.5, and nobody sees it. */
const MOST_PIXEL_RATIO = 2;
/** Measured on a matt ball: a colour that faces the camera is shown within 3 of 255 of what was picked. */
export const LIGHT = 0.95;
/** After this pause, milliseconds, the picture rests and is drawn with all its pixels. */
const REST_AFTER = 160;

export interface StageHooks {
  /** Before a frame is drawn; `delta` in seconds. Returns true while it animates and wants another frame. */
  beforeFrame(delta: number): boolean;
  /** Right after the scene was drawn: more may be drawn over it. */
  drawOver(): void;
  /** After a frame was drawn; `cameraMoved` tells whether screen positions changed. */
  afterFrame(cameraMoved: boolean): void;
  /** The GPU forgot everything; textures of one's own must be filled again. */
  contextRestored(): void;
  /** The GPU has been away for some seconds of looking at it. */
  contextGone(): void;
}

export class Stage {
  readonly renderer: WebGLRenderer;
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(lensFor(1), 1, 0.01, 100);
  readonly #still = new StillRig(this.camera);
  #rig: CameraRig = this.#still;
  /** Frames drawn so far. */
  frames = 0;
  readonly #root: HTMLElement;
  readonly #hooks: StageHooks;
  readonly #shadow: ContactShadow;
  readonly #ground = new GroundLight();
  readonly #bounds = new Sphere(new Vector3(), 1);
  readonly #resize: ResizeObserver;
  readonly #reducedMotion = matchMedia("(prefers-reduced-motion: reduce)");
  readonly #abort = new AbortController();
  readonly #theme = new MutationObserver(() => this.#updateTheme());
  readonly #environment = createStudioEnvironment();
  #frameRequest = 0;
  #lastTime = 0;
  #resized = true;
  #lost = false;
  readonly #resolution = new MotionResolution();
  readonly #pace: GpuPace;
  #frameEnd = Number.NEGATIVE_INFINITY;
  #moving = false;
  #inGesture = false;
  /** Share of the full resolution that the canvas has now. */
  #drawnScale = 1;
  #restTimer: ReturnType<typeof setTimeout> | undefined;
  readonly #waiting = new LostContext();

  constructor(root: HTMLElement, hooks: StageHooks) {
    this.#root = root;
    this.#hooks = hooks;
    this.renderer = makeRenderer();
    this.renderer.outputColorSpace = SRGBColorSpace;
    // Neutral keeps base colours as they were picked; filmic curves (ACES) turn a brand's red into another red.
    this.renderer.toneMapping = NeutralToneMapping;
    this.renderer.setClearColor(0x000000, 0);
    this.canvas.classList.add("tcv-canvas");
    this.#pace = new GpuPace(this.renderer.getContext() as WebGL2RenderingContext, (milliseconds) =>
      this.#resolution.note(milliseconds),
    );
    root.append(this.canvas);
    this.scene.environment = this.#environment;
    this.scene.environmentIntensity = LIGHT;
    this.camera.layers.enable(OVERLAY_LAYER);
    this.#shadow = new ContactShadow(this.renderer);
    this.scene.add(this.#shadow.mesh, this.#ground.mesh);
    this.#shadow.mesh.layers.set(OVERLAY_LAYER);
    this.#ground.mesh.layers.set(OVERLAY_LAYER);

    this.#resize = new (windowOf(root).ResizeObserver)(this.#fit);
    this.#resize.observe(root);
    watchPixelRatio(this.#fit, this.#abort.signal);
    this.#listen(this.canvas, "webglcontextlost", (event) => {
      event.preventDefault();
      this.#lost = true;
      this.#waiting.wait(this.#hooks.contextGone);
    });
    this.#listen(this.canvas, "webglcontextrestored", () => this.#restore());
    this.#listen(this.#reducedMotion, "change", () => this.#rig.setEased(this.animates));
    this.#watchTheme();
  }

  get canvas(): HTMLCanvasElement {
    return this.renderer.domElement;
  }

  get bounds(): Readonly<Sphere> {
    return this.#bounds;
  }

  /** Whether movements of the view's own may be animated. */
  get animates(): boolean {
    return !this.#reducedMotion.matches;
  }

  get rig(): CameraRig {
    return this.#rig;
  }

  /** Gives the camera into other hands, which go on from where it stands. */
  hold<Rig extends CameraRig>(make: (still: StillRig) => Rig): Rig {
    const rig = make(this.#still);
    rig.setEased(this.animates);
    this.#rig = rig;
    this.requestFrame();
    return rig;
  }

  requestFrame(): void {
    if (this.#frameRequest === 0 && !this.#lost) {
      // Asked soon after the last frame, whenever this one comes: where frames are slow, they come late.
      this.#moving = this.#inGesture || performance.now() - this.#frameEnd < REST_AFTER;
      this.#frameRequest = requestAnimationFrame((time) => this.#frame(time));
    }
  }

  /** Runs a task once the GPU is done with what it was given so far. */
  whenGpuDone(task: () => void): void {
    this.#pace.mark({ flush: true });
    this.#pace.whenDone(task);
  }

  /** A gesture counts as movement throughout, however slowly its pictures come. */
  set inGesture(value: boolean) {
    this.#inGesture = value;
    this.requestFrame();
  }

  /** Takes a model's size as the measure of the view: distances, speeds, clipping, shadow. */
  show(model: Object3D, bounds: Box3): void {
    this.scene.add(model);
    bounds.getBoundingSphere(this.#bounds);
    this.#bounds.radius = Math.max(this.#bounds.radius, 1e-6);
    this.#rig.limit({ minDistance: this.#bounds.radius * 0.05, maxDistance: this.#bounds.radius * 12 });
    this.#rig.enclose(bounds.clone().expandByScalar(this.#bounds.radius));
    // The model's shaders, begun before the shadow's own are waited for.
    this.renderer.compile(model, this.camera, this.scene);
    this.castShadow(model, bounds);
    this.requestFrame();
  }

  /** Draws the ground's shadow, for the model at rest. */
  castShadow(model: Object3D, bounds: Box3): void {
    this.#shadow.cast(model, bounds);
    this.#ground.place(bounds);
  }

  /** The scene through another camera, PNG on a clear ground; null while the context is lost. */
  async capture(camera: PerspectiveCamera, width: number, height: number): Promise<Blob | null> {
    if (this.#lost) {
      return null;
    }
    this.#fitClipping(camera);
    const picture = captureScene(this.renderer, this.scene, camera, width, height);
    // The view's own picture is drawn again before anybody sees this one.
    this.#resized = true;
    this.#applySize();
    this.draw();
    this.requestFrame();
    return await picture;
  }

  dispose(): void {
    cancelAnimationFrame(this.#frameRequest);
    this.#frameRequest = -1;
    clearTimeout(this.#restTimer);
    this.#waiting.end();
    this.#pace.dispose();
    this.#resize.disconnect();
    this.#theme.disconnect();
    this.#abort.abort();
    this.#rig.dispose();
    this.#shadow.dispose();
    this.#ground.dispose();
    this.#environment.dispose();
    this.renderer.dispose();
    // A browser has few contexts to give, and would keep this one until it tidies up.
    this.renderer.forceContextLoss();
    this.canvas.remove();
  }

  /** Its size in the page is another, or how many pixels that has on the screen. */
  readonly #fit = (): void => {
    this.#resized = true;
    this.requestFrame();
  };

  #frame(time: number): void {
    this.#frameRequest = 0;
    // After a pause the first step is one frame long, else animations would jump.
    const delta = Math.min((time - this.#lastTime) / 1000, 1 / 15);
    this.#lastTime = time;
    this.#setScale(this.#moving ? this.#resolution.scale : 1);
    const resized = this.#applySize();
    const moved = this.#rig.update(delta);
    const animates = this.draw(delta);
    this.frames += 1;
    if (this.#resolution.asksFor(this.frames)) {
      this.#pace.mark({ flush: false });
    }
    this.#restSoon();
    this.#hooks.afterFrame(moved || resized);
    this.#frameEnd = performance.now();
    if (moved || animates) {
      this.requestFrame();
    }
  }

  /** Draws a frame at once, `delta` seconds after the last one. Returns whether another is wanted. */
  draw(delta = 0): boolean {
    const animates = this.#hooks.beforeFrame(delta);
    this.#fitClipping();
    this.camera.updateMatrixWorld();
    this.renderer.render(this.scene, this.camera);
    this.#hooks.drawOver();
    return animates;
  }

  #setScale(scale: number): void {
    if (scale !== this.#drawnScale) {
      this.#drawnScale = scale;
      this.#resized = true;
    }
  }

  /** The last frame of a movement is followed by one with all pixels. */
  #restSoon(): void {
    clearTimeout(this.#restTimer);
    if (this.#drawnScale < 1 && !this.#inGesture) {
      this.#restTimer = setTimeout(() => this.requestFrame(), REST_AFTER * 1.25);
    }
  }

  #applySize(): boolean {
    if (!this.#resized) {
      return false;
    }
    this.#resized = false;
    const width = Math.max(1, this.#root.clientWidth);
    const height = Math.max(1, this.#root.clientHeight);
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, MOST_PIXEL_RATIO) * this.#drawnScale);
    // The editor's reaches beyond the view.
    this.renderer.setSize(this.canvas.offsetWidth || 1, this.canvas.offsetHeight || 1, false);
    this.camera.aspect = width / height;
    this.camera.fov = lensFor(this.camera.aspect);
    this.camera.updateProjectionMatrix();
    // A view that was built outside the document has its style from here on.
    this.#readTheme();
    return true;
  }

  /** The clipping planes hug the model: depth stays precise for models of centimetres and of hundreds of metres. */
  #fitClipping(camera = this.camera): void {
    const distance = camera.position.distanceTo(this.#bounds.center);
    const { radius } = this.#bounds;
    camera.near = Math.max(distance - radius * 2.5, radius * 0.01);
    camera.far = distance + radius * 4;
    camera.updateProjectionMatrix();
  }

  #restore(): void {
    this.#lost = false;
    this.#waiting.end();
    this.#hooks.contextRestored();
    this.#fit();
  }

  /** The page's theme reaches the scene through two custom properties: strengths of the shadow and of the ground's light. */
  #watchTheme(): void {
    this.#theme.observe(document.documentElement, {
      attributes: true,
      attributeFilter: ["class", "style", "data-theme"],
    });
    this.#listen(matchMedia("(prefers-color-scheme: dark)"), "change", () => this.#updateTheme());
    this.#updateTheme();
  }

  #updateTheme(): void {
    this.#readTheme();
    this.requestFrame();
  }

  #readTheme(): void {
    const style = getComputedStyle(this.#root);
    const read = (property: string, fallback: number) => {
      const value = Number.parseFloat(style.getPropertyValue(property));
      return Number.isFinite(value) ? value : fallback;
    };
    this.#shadow.strength = read("--viewer-shadow", 0.36);
    this.#ground.strength = read("--viewer-ground", 0);
  }

  #listen(target: EventTarget, type: string, listener: (event: Event) => void): void {
    target.addEventListener(type, listener, { signal: this.#abort.signal });
  }
}

function makeRenderer(): WebGLRenderer {
  try {
    const renderer = new WebGLRenderer({ antialias: true, alpha: true, powerPreference: "high-performance" });
    // Both are kept. Asked for once the model is being drawn, the page's thread would wait for the GPU until it is.
    renderer.capabilities.getMaxAnisotropy();
    anisotropyFor(renderer);
    return renderer;
  } catch (cause) {
    throw new TexelcastError("unsupported", "This browser cannot show 3D: WebGL 2 is switched off or missing.", {
      hint: "Switch on hardware acceleration in the browser's settings, or use another browser.",
      reason: "no-webgl",
      cause,
    });
  }
}
