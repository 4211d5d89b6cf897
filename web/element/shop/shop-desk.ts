/** The shop's desk: one design with its history on a product that is shown, and no more of the editor than these need. */
import { type Design, emptyDesign } from "../../editor/document/design.ts";
import { AssetLibrary } from "../../editor/state/asset-library.ts";
import { usedMaterials } from "../../editor/state/design-edits.ts";
import { DesignSession } from "../../editor/state/design-session.ts";
import { type DesignState, INITIAL_DESIGN_STATE } from "../../editor/state/design-state.ts";
import { Store } from "../../editor/state/store.ts";
import type { HeldView } from "../../viewer/decal-viewer.ts";
import type { DecalGesture, DecalViewer, MapPicture } from "../../viewer/viewer-api.ts";
import { Desk } from "../desk/desk.ts";
import type { OpenProduct, ShopProduct } from "./shop-product.ts";

export class ShopDesk extends Desk {
  readonly #product: ShopProduct;
  readonly #held: { readonly view: HeldView | null };
  #shown: Pick<DesignState, "design" | "selectedId">;
  /** Materials whose targets were asked for and are not open yet: a drag asks with every move. */
  readonly #coming = new Set<number>();

  constructor(product: ShopProduct) {
    const { engine, viewer, hooks } = product;
    const store = new Store<DesignState>(INITIAL_DESIGN_STATE);
    const library = new AssetLibrary(engine);
    const later = (work: Promise<void>): void => product.attempt(this.during(work));
    const session = new DesignSession({ engine, viewer, library, store, later });
    const held: { view: HeldView | null } = { view: null };
    const loadHands = async (): Promise<HeldView> => {
      const { HeldView, kindsFor } = await import("../../viewer/decal-viewer.ts");
      const kinds = await kindsFor(viewer.decals);
      product.checkOpen();
      const view = new HeldView(viewer, kinds, (thrown) => product.fail(thrown));
      held.view = view;
      // Without it decals slide as they are led.
      import("./shop-lines.ts").then(({ alignDecals }) => alignDecals(view, product, this)).catch(() => undefined);
      return view;
    };
    super({ engine, viewer, loadHands, library, store, session, hooks });
    this.#held = held;
    this.#product = product;
    this.#shown = store.state;
    product.changed = () => this.#tellTargets();
    viewer.on("select", ({ id }) => this.select(id));
    viewer.on("gesture", (gesture) => this.#follow(gesture));
    store.subscribe(() => this.#show());
  }

  /** Takes up what is shown as the beginning of the history: with this design, or with nothing on it. */
  begin({ source, info, material }: OpenProduct, design: Design = emptyDesign()): void {
    const ref = { source, title: source.name, demoId: null };
    this.store.set({ model: { ref, info }, material });
    this.#tellTargets();
    this.session.recordModel(ref, design, "");
    this.opened();
  }

  override async takeHands(): Promise<DecalViewer> {
    const hands = await super.takeHands();
    this.configure();
    return hands;
  }

  /** Shows pictures in place of the textures, by material; null shows the textures again. */
  async showMaps(pictures: ReadonlyMap<number, MapPicture> | null): Promise<void> {
    if (pictures !== null) await this.takeHands();
    await this.#held.view?.showMaps(pictures);
  }

  /** Takes up what the element's settings are now. */
  configure(): void {
    const { readonly } = this.settings;
    if (this.#held.view) this.#held.view.lookOnly = readonly;
    if (!readonly) return;
    // Nobody may record it any more.
    this.session.cancelPreview();
    this.session.select(null);
  }

  override close(): void {
    super.close();
    this.#product.close();
  }

  #tellTargets(): void {
    const { open, targets } = this.#product;
    this.store.set({ targets: new Map(targets), ...(open && { material: open.material }) });
  }

  #follow({ id, phase, projector, material: onto }: DecalGesture): void {
    if (phase === "start") this.select(id);
    else if (phase === "cancel") this.session.cancelPreview();
    else this.place(id, projector, phase === "end", undefined, onto);
  }

  #show(): void {
    const { design, selectedId } = this.store.state;
    const before = this.#shown;
    this.#shown = { design, selectedId };
    if (this.closed || this.#product.open === null) return;
    if (design !== before.design) this.#ensureTargets(design);
    if (selectedId !== before.selectedId) this.session.expectChange();
  }

  #ensureTargets(design: Design): void {
    const product = this.#product;
    for (const material of usedMaterials(design)) {
      if (product.targets.has(material) || this.#coming.has(material) || !product.canPaint(material)) continue;
      this.#coming.add(material);
      product.attempt(product.openTarget(material).finally(() => this.#coming.delete(material)));
    }
  }
}
