/* The benchmark's yardstick: the two steps of the reverse projection paper (doi 10.1145/3588028.3603653) in the plainest
 * way that does them, scalar and single-threaded. It leaves out what Texelcast adds (gutter, overlap count, antialiased
 * edges, angle fade, occlusion, dirty rectangles), so a ratio to it compares our whole step with the bare one.
 *
 * Maps are two arrays of 3 floats a texel, row 0 at the top; a texel that no triangle covers has the normal (0, 0, 0). */
#ifndef TEXELCAST_BENCH_PLAIN_METHOD_H
#define TEXELCAST_BENCH_PLAIN_METHOD_H

#include <stdint.h>

#ifdef __EMSCRIPTEN__
#define PLAIN_API __attribute__((used, visibility("default")))
#else
#define PLAIN_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Fills both maps (size x size) by a walk over each triangle's bounding box with three edge functions. UVs lie in [0, 1].
 * Returns the number of texels written, texels on a shared edge twice. */
PLAIN_API uint32_t plain_bake(const float* positions, const float* normals, const float* uvs, const uint32_t* indices,
                              uint32_t index_count, uint32_t size, float* out_positions, float* out_normals);

/* Visits every texel: back-face test, test against the decal's box, bilinear sample of the decal (RGBA, straight alpha),
 * source-over on `base` into `out` (RGBA). Texels outside the decal are not touched.
 * `decal_from_model`: 3 rows of 4, to the box [-1/2, 1/2]^3. `direction_model`: the box's +Z, unit. Returns the number of
 * texels painted. */
PLAIN_API uint32_t plain_project(const float* map_positions, const float* map_normals, uint32_t size,
                                 const float* decal_from_model, const float* direction_model, const uint8_t* decal,
                                 uint32_t decal_width, uint32_t decal_height, const uint8_t* base, uint8_t* out);

#ifdef __cplusplus
}
#endif

#endif
