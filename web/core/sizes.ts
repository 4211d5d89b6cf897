/** How large textures may be, as wasm/texelcast.h has it: apart from the ABI, so that what checks sizes need not load all of that. */

/** Texels along one side of a target or an image, at most. */
export const MAX_SIZE = 8192;
/** Texels along one side of a texture that is painted by windows, at most. */
export const MAX_TEXTURE_SIZE = 16384;
