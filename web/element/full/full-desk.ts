/** The desk of the whole editor: what its page says holds, whatever the panels show. */
import type { Design } from "../../editor/document/design.ts";
import { Desk } from "../desk/desk.ts";

export class FullDesk extends Desk {
  /** What is printed; the panels follow the chosen layer to other materials, and that is no reason to print those. */
  printed = 0;

  override get material(): number {
    return this.printed;
  }

  /** A page may show another design, also one that nobody else may change. */
  override takeDesign(design: Design): void {
    this.store.set({ readonly: false });
    super.takeDesign(design);
    this.store.set({ readonly: this.settings.readonly });
  }
}
