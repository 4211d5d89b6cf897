/** three.js layers: meshes of the model are on the first; ground, shadow and highlight on the second. */
export const MODEL_LAYER = 0;
export const OVERLAY_LAYER = 1;
/** No camera looks at this one. */
export const HIDDEN_LAYER = 31;
