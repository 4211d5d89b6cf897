/**
 * Kinds of projection that were tried on a layer. One kind cannot hold what another says (a label round a mug has no box's
 * depth), so that going there and back would change a box that nobody meant to change: what was there before comes back
 * instead, for as long as the layer lies as the newest trial left it.
 */
import type { Projector } from "../../engine/engine-api.ts";
import type { PlacedLayer } from "../document/design.ts";

export type Placement = Pick<PlacedLayer, "projector" | "material" | "mirror">;

type Kinds = ReadonlyMap<Projector["kind"], Placement>;

export class TriedKinds {
  /** By the projector that a trial ended with: a layer that is changed since has another one. */
  readonly #kinds = new WeakMap<Projector, Kinds>();

  /** How the layer lay as that kind; undefined where it did not, or was moved since. */
  before({ projector }: Placement, kind: Projector["kind"]): Placement | undefined {
    return this.#kinds.get(projector)?.get(kind);
  }

  /** Notes that a layer which lay as `from` lies as `to` now. */
  note(from: Placement, to: Placement): void {
    const kinds = new Map(this.#kinds.get(from.projector)).set(from.projector.kind, from);
    this.#kinds.set(to.projector, kinds);
  }
}
