/** What an element's work asks of its element, without a page. */
import { DEFAULTS } from "../../web/element/element-properties.ts";
import type { WorkParts } from "../../web/element/element-work.ts";

/** A mug in shop mode, and what is set beside. */
export const elementStandIn = (properties: object = {}): WorkParts["element"] =>
  Object.assign(new EventTarget(), DEFAULTS, {
    src: { name: "mug.glb", bytes: new Uint8Array(1) },
    updateComplete: Promise.resolve(true),
    requestUpdate: () => undefined,
    renderRoot: null,
    closest: () => null,
    getRootNode: () => null,
    ...properties,
  }) as unknown as WorkParts["element"];
