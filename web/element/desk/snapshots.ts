/** Pictures of the product for a cart: from named sides, or from wherever the page says. */
import { ToldError } from "../../editor/strings/told-error.ts";
import { type Orbit, parseOrbit } from "../../viewer/camera-orbit.ts";
import type { SnapshotOptions, SnapshotView } from "../element-api.ts";
import type { Mode } from "../mode.ts";
import type { Words } from "../words/words.ts";
import { checkNames } from "./unknown-option.ts";

const SIDE = 512;
const MOST = 4096;

const NAMED: Readonly<Record<string, string | null>> = {
  current: null,
  front: "0deg 90deg",
  right: "90deg 90deg",
  back: "180deg 90deg",
  left: "-90deg 90deg",
  top: "0deg 0deg",
  bottom: "0deg 180deg",
};

const VIEWS = `${Object.keys(NAMED).join(", ")}, 30deg 75deg 105%`;

/** Here and not among the element's other words: nothing else says it. */
const NO_GRAPHICS = {
  en: {
    message: "The picture could not be drawn: the graphics are not there.",
    hint: "Wait a moment and try again.",
  },
  de: {
    message: "Das Bild ließ sich nicht zeichnen: Die Grafik ist nicht da.",
    hint: "Warte einen Moment und versuche es noch einmal.",
  },
};

/** A picture of the one view, or one of each of several. Throws as `takeSnapshots`. */
export async function snapshot(
  mode: Pick<Mode, "viewer" | "idle">,
  views: SnapshotView | readonly SnapshotView[],
  options: SnapshotOptions,
  words: Words,
): Promise<Blob | Blob[]> {
  if (typeof views !== "string") return await takeSnapshots(mode, views, options, words);
  const [picture] = await takeSnapshots(mode, [views], options, words);
  return picture as Blob;
}

/** PNGs, one for each view. Throws "bad-argument" for a view or a size that is none, "unsupported" without graphics. */
export async function takeSnapshots(
  mode: Pick<Mode, "viewer" | "idle">,
  views: readonly SnapshotView[],
  options: SnapshotOptions,
  words: Words,
): Promise<Blob[]> {
  const refuse = (field: string, value: unknown, hint: string): never => {
    throw new ToldError("bad-argument", words.errors.badOption(field), { field, value: String(value), hint });
  };
  if (typeof options !== "object" || options === null) refuse("options", options, "{ width, height }");
  checkNames(options, ["width", "height"], words);
  const { width = SIDE, height = SIDE } = options;
  for (const [field, value] of Object.entries({ width, height })) {
    if (!Number.isInteger(value) || value < 1 || value > MOST) refuse(field, value, `1 – ${MOST}`);
  }
  const orbitOf = (view: unknown): Orbit | null => {
    if (typeof view !== "string") return refuse("view", view, VIEWS);
    const place = Object.hasOwn(NAMED, view) ? NAMED[view] : view;
    try {
      return place === null || place === undefined ? null : parseOrbit(place, "view");
    } catch {
      return refuse("view", view, VIEWS);
    }
  };
  const orbits = Array.isArray(views) ? views.map(orbitOf) : refuse("view", views, VIEWS);
  await mode.idle();
  // The view takes up what the engine reported with its next frame.
  await new Promise((resolve) => requestAnimationFrame(resolve));
  const pictures: Blob[] = [];
  for (const orbit of orbits) {
    const picture = await mode.viewer.capture(orbit, width, height);
    if (picture === null) {
      const { message, hint } = { ...NO_GRAPHICS[words.language], ...words.own?.noGraphics };
      throw new ToldError("unsupported", message, { hint });
    }
    pictures.push(picture);
  }
  return pictures;
}
