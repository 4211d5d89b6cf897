#include "uv_projector.h"

#include <cmath>

#include "exact_math.h"
#include "mesh.h"

namespace txc {

TxcStatus UvProjector::from_def(const TxcLayerDef& def, UvProjector& out) {
    for (int c = 0; c < 2; ++c) {
        if (!(std::fabs(def.uv_center[c]) <= kMaxCoordinate)) {
            return fail(TXC_STATUS_BAD_ARGUMENT, "uv_center[%d] is %g; it must be a finite number", c,
                        static_cast<double>(def.uv_center[c]));
        }
        if (const TxcStatus status = check_length(def.uv_size[c], c == 0 ? "uv_size[0]" : "uv_size[1]");
            status != TXC_STATUS_OK)
            return status;
    }
    if (!(std::fabs(def.uv_angle_degrees) <= kMaxCoordinate)) {
        return fail(TXC_STATUS_BAD_ARGUMENT, "uv_angle_degrees is %g; it must be a finite number of degrees",
                    static_cast<double>(def.uv_angle_degrees));
    }
    out.center = {def.uv_center[0], def.uv_center[1]};
    out.size = {def.uv_size[0], def.uv_size[1]};
    const auto degrees = static_cast<double>(def.uv_angle_degrees);
    const double within_turn = degrees - 360.0 * std::floor(degrees / 360.0);
    exact_sin_cos(within_turn * (3.14159265358979323846 / 180.0), out.sine, out.cosine);
    return TXC_STATUS_OK;
}

PictureSight UvProjector::look(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height) const {
    const glm::dvec2 at = turn((x + 0.5) / width - center.x, (y + 0.5) / height - center.y);
    const glm::dvec2 across = turn(1.0 / width, 0.0);
    const glm::dvec2 down = turn(0.0, 1.0 / height);
    return {at.x, at.y, across.x, across.y, down.x, down.y};
}

bool UvProjector::may_touch(std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1, std::uint32_t width,
                            std::uint32_t height, const PictureMargin& margin) const {
    const double half_u = 0.5 * (x1 - x0) / width;
    const double half_v = 0.5 * (y1 - y0) / height;
    const glm::dvec2 middle = glm::abs(turn(static_cast<double>(x0) / width + half_u - center.x,
                                            static_cast<double>(y0) / height + half_v - center.y));
    const glm::dvec2 reach = glm::abs(turn(half_u, 0.0)) + glm::abs(turn(0.0, half_v));
    return middle.x - reach.x <= 0.5 + margin.x + 1e-9 * middle.x &&
           middle.y - reach.y <= 0.5 + margin.y + 1e-9 * middle.y;
}

}  // namespace txc
