import type { AlignedSlides } from "./aligned-slide.ts";
import { DecalHands } from "./decal-hands.ts";
import { tupleOf } from "./decal-pose.ts";
import { HeldModel } from "./held-model.ts";
import type { ModelLook } from "./model-look.ts";
import { OrbitCamera } from "./orbit-camera.ts";
import type { ScreenSpace } from "./screen-space.ts";
import type { StillModel } from "./still-model.ts";
import type { StillView } from "./still-view.ts";
import type { SurfaceQuery } from "./surface-query.ts";
import type { ThrownKinds } from "./thrown-kinds.ts";
import { ViewInHands } from "./view-in-hands.ts";
import type { Landing, MapPicture, SurfacePlaces, ViewerDecal } from "./viewer-api.ts";

/** What some decals of a design need beside the hands; null where all are boxes. */
export async function kindsFor(decals: readonly ViewerDecal[]): Promise<ThrownKinds | null> {
  const boxes = decals.every(({ projector }) => projector.kind === "planar");
  return boxes ? null : (await import("./thrown-kinds.ts")).THROWN;
}

export class HeldView extends ViewInHands {
  readonly surface: SurfacePlaces;
  protected readonly hands: DecalHands;
  readonly #failed: (thrown: unknown) => void;
  #thrown: ThrownKinds | null;
  #model: { readonly still: StillModel; readonly held: HeldModel } | null = null;
  #look: ModelLook | null = null;
  #slides: AlignedSlides | null = null;
  #lookOnly = false;

  /**
   * Takes hold of a view, once: what it shows stays as it is, and it may be used as before.
   *
   * @param thrown of `kindsFor` the view's decals; decals that come later bring theirs
   * @param failed told where they do not come
   */
  constructor(view: StillView, thrown: ThrownKinds | null, failed: (thrown: unknown) => void) {
    super(view);
    const { element: root, stage } = view;
    this.#thrown = thrown;
    this.#failed = failed;
    const rig = stage.hold((still) => new OrbitCamera(stage.camera, root, still, () => stage.requestFrame()));
    const hands = new DecalHands({
      view,
      rig,
      model: () => this.#model?.held ?? null,
      thrown: () => this.#thrown,
      posed: () => null,
      aligned: (slide, decal) => this.#slides?.over(slide, decal) ?? slide,
    });
    this.hands = hands;
    hands.listen();
    root.addEventListener("keydown", (event) => hands.key(event));
    const { screen } = hands;
    this.surface = {
      near: (position) => hands.near(position),
      atUv: (material, uv) => hands.atUv(material, uv),
      lookAt: () => ({ eye: tupleOf(screen.eye), up: tupleOf(screen.axes.up) }),
    };
    view.take({
      modelShown: (still) => this.#modelShown(still),
      modelGone: () => this.#modelGone(),
      setDecals: (decals, selectedId) => this.#setDecals(decals, selectedId),
      beforeFrame: () => false,
      drawOver: () => undefined,
      cameraMoved: () => {
        hands.gizmo.drawNow();
        this.#slides?.hideLines();
      },
      letGo: () => {
        hands.dispose();
        this.#slides?.dispose();
      },
    });
  }

  /** Decals stay where they are; the view can be turned all the same. */
  set lookOnly(value: boolean) {
    this.#lookOnly = value;
    this.hands.suspended = value;
    this.element.style.cursor = value ? "grab" : "";
  }

  async landing(width: number, aspect: number): Promise<Landing | null> {
    const { landingOn } = await import("./landing-on-view.ts");
    return this.#model && landingOn(this.hands, this.#model.held.query, width, aspect);
  }

  /** Has what `make` makes bring decals into line as they slide, once; it goes with the view. */
  align(make: (screen: ScreenSpace, query: () => SurfaceQuery | null) => AlignedSlides): void {
    const slides = make(this.hands.screen, () => this.#model?.held.query ?? null);
    this.#slides = slides;
    this.on("gesture", ({ phase }) => phase !== "move" && slides.hideLines());
  }

  /** Shows pictures in place of the textures, by material (others grey), as flat colours; null shows the textures again. */
  async showMaps(pictures: ReadonlyMap<number, MapPicture> | null): Promise<void> {
    const { ModelLook } = await import("./model-look.ts");
    if (this.#model === null) return;
    this.#look ??= new ModelLook(this.#model.still.scene);
    this.#look.setMaps(pictures);
    this.view.stage.requestFrame();
  }

  #modelShown(still: StillModel): void {
    const held = new HeldModel(still);
    this.#model = { still, held };
    this.hands.gizmo.setSurface(held.query);
    this.hands.gizmo.enabled = !this.#lookOnly;
  }

  #modelGone(): void {
    this.hands.gizmo.setSurface(null);
    this.#look?.dispose();
    this.#look = null;
    this.#model = null;
  }

  #setDecals(decals: readonly ViewerDecal[], selectedId: string | null): void {
    this.hands.gizmo.setDecals(decals, selectedId);
    if (this.#thrown === null) void this.#bringKinds(decals).catch(this.#failed);
  }

  async #bringKinds(decals: readonly ViewerDecal[]): Promise<void> {
    this.#thrown = (await kindsFor(decals)) ?? this.#thrown;
    if (this.#thrown !== null) this.hands.gizmo.drawNow();
  }
}
