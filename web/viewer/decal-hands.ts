/** What takes hold of decals in a 3D view, whichever view it is: the gizmo, the pointer, places on the surface. */
import { Vector3 } from "three";
import { TexelcastError } from "../core/texelcast-error.ts";
import type { PlanarProjector, Projector, Vec3 } from "../engine/engine-api.ts";
import { adoptStyle } from "./adopt-style.ts";
import type { HeldRig } from "./camera-rig.ts";
import { DecalGizmo, type GizmoHost, type PosedView } from "./decal-gizmo.ts";
import { GIZMO_STYLE } from "./gizmo-style.ts";
import type { HeldModel } from "./held-model.ts";
import { ModelPlacement } from "./model-placement.ts";
import { reachVolume } from "./reached-materials.ts";
import { type ScreenPoint, ScreenSpace } from "./screen-space.ts";
import type { StillView } from "./still-view.ts";
import { hitOf } from "./surface-hit.ts";
import type { SurfaceSample } from "./surface-query.ts";
import type { ThrownKinds } from "./thrown-kinds.ts";
import { ViewInput } from "./view-input.ts";
import type { SurfaceHit } from "./viewer-api.ts";

export interface DecalHandsParts {
  readonly view: StillView;
  readonly rig: HeldRig;
  /** Null while none is shown. */
  model(): HeldModel | null;
  /** Null while they are not there. */
  thrown(): ThrownKinds | null;
  /** How an animation has posed the model; null at rest. */
  posed(): PosedView | null;
  readonly aligned?: GizmoHost["aligned"];
}

export class DecalHands {
  readonly screen: ScreenSpace;
  readonly gizmo: DecalGizmo;
  readonly #parts: DecalHandsParts;
  #input: ViewInput | null = null;

  constructor(parts: DecalHandsParts) {
    const { element: root, events, stage } = parts.view;
    this.#parts = parts;
    adoptStyle(root, GIZMO_STYLE);
    this.screen = new ScreenSpace(stage.camera, root);
    this.gizmo = new DecalGizmo({
      root,
      screen: this.screen,
      gesture: (gesture) => events.emit("gesture", gesture),
      dragging: (active) => {
        stage.inGesture = active;
      },
      posed: () => parts.posed(),
      thrown: () => parts.thrown(),
      aligned: parts.aligned,
    });
  }

  /** Listens to pointer and keys; what listened before comes first. */
  listen(): void {
    const { rig, view, posed } = this.#parts;
    const { element: root, events } = view;
    const early = { capture: true, passive: true };
    const zoom = ({ clientX, clientY }: MouseEvent, nearer: boolean, toPointer?: boolean): void =>
      this.#beforeZoom(this.screen.pointOf(clientX, clientY), nearer, toPointer);
    root.addEventListener("wheel", (event) => zoom(event, event.deltaY < 0), early);
    root.addEventListener("pointerdown", (event) => event.isPrimary || zoom(event, true, true), early);
    this.#input = new ViewInput(root, this.gizmo, this.screen, {
      pick: (ray) => this.#parts.model()?.pick(ray) ?? null,
      isPosed: () => posed() !== null,
      select: (id) => events.emit("select", { id }),
      hover: (sample) => events.emit("hover", { hit: sample && hitOf(sample) }),
      setPanning: (pans) => rig.setPanning(pans),
    });
  }

  /** Off while the pointer is somebody else's: decals are neither pressed nor shown with handles. */
  set suspended(value: boolean) {
    if (this.#input) this.#input.suspended = value;
    this.gizmo.enabled = !value;
  }

  #beforeZoom(at: ScreenPoint, nearer: boolean, toPointer?: boolean): void {
    const { rig, posed } = this.#parts;
    const under = this.sampleAt(at);
    const seen = under ?? this.sampleAt(this.#middle);
    const surface = seen && (posed()?.toPosed(seen.position) ?? seen.position);
    // Beside the model a wheel that kept what is under the pointer would bring nearer what is not there, and lose the model.
    rig.beforeZoom({ surface, toPointer: toPointer ?? under !== null, nearer });
  }

  get #middle(): ScreenPoint {
    const { width, height } = this.screen.size;
    return { x: width / 2, y: height / 2 };
  }

  sampleAt(point: ScreenPoint): SurfaceSample | null {
    return this.#parts.model()?.pick(this.screen.rayThrough(point)) ?? null;
  }

  surfaceAtCentre(): SurfaceHit | null {
    const { width, height } = this.screen.size;
    // Outwards in rings: the first that meets the model is nearest to the middle, to within a ring's width.
    for (let ring = 0; ring <= 12; ring++) {
      const around = ring === 0 ? 1 : 6 + ring * 2;
      for (let step = 0; step < around; step++) {
        const angle = (2 * Math.PI * step) / around;
        const reach = (ring / 12) * 0.5;
        const hit = this.sampleAt({
          x: width * (0.5 + reach * Math.sin(angle)),
          y: height * (0.5 + reach * Math.cos(angle)),
        });
        if (hit !== null) {
          return hitOf(hit);
        }
      }
    }
    return null;
  }

  surfaceAtPointer(clientX: number, clientY: number): SurfaceHit | null {
    const sample = this.sampleAt(this.screen.pointOf(clientX, clientY));
    return sample && hitOf(sample);
  }

  near(position: Vec3): SurfaceHit | null {
    const sample = this.#parts.model()?.query.closest(new Vector3(...position)) ?? null;
    return sample && hitOf(sample);
  }

  atUv(material: number, uv: readonly [number, number]): SurfaceHit | null {
    const query = this.#parts.model()?.query;
    const place = query?.triangleAtUv(material, uv) ?? null;
    return query && place ? hitOf(query.at(place.triangle, place.shares)) : null;
  }

  projectorAt(hit: SurfaceHit, width: number, aspect: number, keep?: PlanarProjector): PlanarProjector {
    return this.#placement.at(hit, width, aspect, keep);
  }

  nudge(projector: Projector, rightMetres: number, upMetres: number): Projector {
    return this.#placement.nudged(projector, rightMetres, upMetres, this.#parts.thrown());
  }

  resized(before: Projector, after: Projector): Projector {
    return this.#placement.resized(before, after);
  }

  materialsReached(projector: Projector, backfaces: boolean): readonly number[] {
    const volume = reachVolume(projector, backfaces);
    return (volume && this.#parts.model()?.whole.materialsWithin(volume)) ?? [];
  }

  clickAt(clientX: number, clientY: number): void {
    this.#input?.clickAt(clientX, clientY);
  }

  /** The arrow keys are the selected decal's, which the editor moves; without one they turn the camera. */
  key(event: KeyboardEvent): void {
    const { view, rig } = this.#parts;
    const plain = !event.ctrlKey && !event.metaKey && !event.altKey && !event.defaultPrevented;
    if (!plain || this.gizmo.selectedDecal !== null) {
      return;
    }
    if (/^[+=-]$/.test(event.key)) this.#beforeZoom(this.#middle, event.key !== "-");
    if (event.key === "0") {
      view.frameModel();
    } else if (rig.step(event.key, view.stage.animates)) {
      view.stage.requestFrame();
    } else {
      return;
    }
    event.preventDefault();
  }

  dispose(): void {
    this.#input?.dispose();
    this.gizmo.dispose();
    this.screen.dispose();
  }

  get #placement(): ModelPlacement {
    const model = this.#parts.model();
    if (model === null) {
      throw new TexelcastError("no-model", "There is no model to place a decal on.", { hint: "Open a model first." });
    }
    return new ModelPlacement(model, this.screen);
  }
}
