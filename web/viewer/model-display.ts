/** What is shown with the model and is no part of its texture: its look, the chart that is pointed at, a marked place. */
import { Color, MathUtils, Vector3 } from "three";
import { ChartGlow } from "./chart-glow.ts";
import { type CssColor, readCssColor } from "./css-color.ts";
import type { ScreenSpace } from "./screen-space.ts";
import type { ShownModel } from "./shown-model.ts";
import { LIGHT, type Stage } from "./stage.ts";
import type { SurfaceChart } from "./surface-charts.ts";
import type { MapPicture, ModelLook, TexturePlace } from "./viewer-api.ts";

/** Seconds that the turntable takes for one turn. */
const TURN_SECONDS = 24;

export const USUAL_LOOK: ModelLook = {
  shading: "lit",
  wireframe: false,
  lightTurn: 0,
  lightStrength: 1,
  turntable: false,
};

export class ModelDisplay {
  readonly #root: HTMLElement;
  readonly #stage: Stage;
  readonly #screen: ScreenSpace;
  readonly #glow = new ChartGlow();
  readonly #marker = document.createElement("div");
  #model: ShownModel | null = null;
  #look = USUAL_LOOK;
  #chart: SurfaceChart | null = null;
  /** The pose that the chart was lit in. */
  #chartPose = -1;
  #marked: TexturePlace | null = null;
  #wireColor = new Color();
  #wireOpacity = 1;

  constructor(root: HTMLElement, stage: Stage, screen: ScreenSpace) {
    this.#root = root;
    this.#stage = stage;
    this.#screen = screen;
    this.#marker.className = "tcv-marker";
    this.#marker.hidden = true;
    root.append(this.#marker);
    stage.scene.add(this.#glow.group);
  }

  setModel(model: ShownModel | null): void {
    this.#model = model;
    this.highlight(null);
    this.mark(null);
    this.setLook(this.#look);
  }

  setLook(look: ModelLook): void {
    this.#look = look;
    const { scene } = this.#stage;
    scene.environmentRotation.y = MathUtils.degToRad(look.lightTurn);
    scene.environmentIntensity = LIGHT * look.lightStrength;
    if (this.#model !== null) {
      this.#model.look.unlit = look.shading === "unlit";
      this.#model.look.wireframe = look.wireframe;
    }
    if (look.wireframe) {
      const [red, green, blue, alpha] = readCssColor(this.#root, "--viewer-wire", "rgb(20 24 32 / 0.4)");
      this.#wireColor.setRGB(red, green, blue, "srgb");
      this.#wireOpacity = alpha;
    }
    this.#stage.requestFrame();
  }

  setMaps(pictures: ReadonlyMap<number, MapPicture> | null): void {
    this.#model?.look.setMaps(pictures);
    this.#stage.requestFrame();
  }

  highlight(place: TexturePlace | null): void {
    const chart = (place && this.#model?.chartAt(place)) ?? null;
    if (chart === this.#chart) {
      return;
    }
    this.#chart = chart;
    this.#chartPose = -1;
    if (chart === null) {
      this.#glow.hide();
    } else {
      this.#glow.color = colorOf(readCssColor(this.#root, "--tcv-accent", "rgb(61 126 255)"));
    }
    this.#stage.requestFrame();
  }

  mark(place: TexturePlace | null): void {
    this.#marked = place;
    this.#placeMarker();
  }

  /** The model's parts changed: what was lit may be hidden now. */
  partsChanged(): void {
    this.#chart = null;
    this.#glow.hide();
    this.#placeMarker();
  }

  /** Radians that the turntable takes the view round the model in so many seconds; 0 while it stands. */
  turned(seconds: number): number {
    // Still, too, while a decal is dragged.
    const turns = this.#look.turntable && this.#root.dataset.gesture === undefined;
    return turns ? (2 * Math.PI * seconds) / TURN_SECONDS : 0;
  }

  beforeFrame(): void {
    const model = this.#model;
    model?.look.update();
    if (model === null || this.#chart === null) {
      return;
    }
    // In a clip that runs the chart would run after the pointer; it lights up where the clip is stopped.
    if (model.animation.playing) {
      this.#glow.hide();
      this.#chartPose = -1;
    } else if (this.#chartPose !== model.animation.pose) {
      this.#glow.show(model.drawnPositions, this.#chart.triangles, this.#chart.borders);
      this.#chartPose = model.animation.pose;
    }
  }

  /** Right after the scene was drawn. */
  drawOver(): void {
    const { renderer, scene, camera } = this.#stage;
    this.#model?.look.drawWires(renderer, scene, camera, this.#wireColor, this.#wireOpacity);
  }

  /** Screen positions have changed. */
  moved(): void {
    this.#placeMarker();
  }

  dispose(): void {
    this.#glow.group.removeFromParent();
    this.#glow.dispose();
    this.#marker.remove();
  }

  #placeMarker(): void {
    const place = this.#marked;
    const found = place && this.#model?.query.triangleAtUv(place.material, place.uv);
    if (!found || this.#model === null) {
      this.#marker.hidden = true;
      return;
    }
    const position = this.#model.toPosed(this.#model.query.at(found.triangle, found.shares).position);
    const at = this.#screen.project(position);
    this.#marker.hidden = at === null;
    if (at !== null) {
      this.#marker.style.transform = `translate(${at.x.toFixed(1)}px, ${at.y.toFixed(1)}px)`;
      this.#marker.toggleAttribute(
        "data-behind",
        !this.#model.drawn.isClear(position, new Vector3().copy(this.#screen.eye)),
      );
    }
  }
}

function colorOf([red, green, blue]: CssColor): Color {
  return new Color().setRGB(red, green, blue, "srgb");
}
