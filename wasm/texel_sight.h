// What passes between a projector and the painting of texels one by one: where a texel is, and what it sees.
#pragma once

#include <glm/glm.hpp>

namespace txc {

/// A texel's centre and how it moves, in a projector's view space, metres.
struct TexelPlace {
    glm::dvec3 position;
    glm::dvec3 across;  // a texel to the right
    glm::dvec3 down;    // a texel down
};

/// Where a texel's ray meets the decal (decal space, x and y), and the derivatives of that by the texel's column and
/// row: together the footprint, as a parallelogram.
struct PictureSight {
    double x = 0.0, y = 0.0;
    double across_x = 0.0, across_y = 0.0;
    double down_x = 0.0, down_y = 0.0;
};

struct TexelSight {
    PictureSight picture;
    glm::dvec3 ray;  // view space, unit, towards the projector
};

}  // namespace txc
