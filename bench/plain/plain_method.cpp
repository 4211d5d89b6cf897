#include "plain_method.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace {

/* Bilinear, clamped to the picture's edge; channels 0 to 255. */
void sample_bilinear(const uint8_t* picture, uint32_t width, uint32_t height, float x, float y, float* out_rgba) {
    const float left = std::floor(x - 0.5f);
    const float top = std::floor(y - 0.5f);
    const float to_right = x - 0.5f - left;
    const float to_bottom = y - 0.5f - top;
    const int last_x = static_cast<int>(width) - 1;
    const int last_y = static_cast<int>(height) - 1;
    const int x0 = std::clamp(static_cast<int>(left), 0, last_x);
    const int x1 = std::clamp(static_cast<int>(left) + 1, 0, last_x);
    const int y0 = std::clamp(static_cast<int>(top), 0, last_y);
    const int y1 = std::clamp(static_cast<int>(top) + 1, 0, last_y);
    const uint8_t* p00 = picture + (static_cast<uint32_t>(y0) * width + static_cast<uint32_t>(x0)) * 4;
    const uint8_t* p10 = picture + (static_cast<uint32_t>(y0) * width + static_cast<uint32_t>(x1)) * 4;
    const uint8_t* p01 = picture + (static_cast<uint32_t>(y1) * width + static_cast<uint32_t>(x0)) * 4;
    const uint8_t* p11 = picture + (static_cast<uint32_t>(y1) * width + static_cast<uint32_t>(x1)) * 4;
    for (int channel = 0; channel < 4; ++channel) {
        const float upper = p00[channel] + (p10[channel] - p00[channel]) * to_right;
        const float lower = p01[channel] + (p11[channel] - p01[channel]) * to_right;
        out_rgba[channel] = upper + (lower - upper) * to_bottom;
    }
}

}  // namespace

uint32_t plain_bake(const float* positions, const float* normals, const float* uvs, const uint32_t* indices,
                    uint32_t index_count, uint32_t size, float* out_positions, float* out_normals) {
    const std::size_t map_bytes = static_cast<std::size_t>(size) * size * 3 * sizeof(float);
    std::memset(out_positions, 0, map_bytes);
    std::memset(out_normals, 0, map_bytes);
    const float scale = static_cast<float>(size);
    const int last = static_cast<int>(size) - 1;
    uint32_t written = 0;
    for (uint32_t first = 0; first + 2 < index_count; first += 3) {
        const uint32_t corners[3] = {indices[first], indices[first + 1], indices[first + 2]};
        float x[3];
        float y[3];
        for (int corner = 0; corner < 3; ++corner) {
            x[corner] = uvs[corners[corner] * 2] * scale;
            y[corner] = uvs[corners[corner] * 2 + 1] * scale;
        }
        const float area = (x[1] - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[1] - y[0]);
        if (area == 0.0f) continue;
        const float inverse_area = 1.0f / area;
        const int min_x = std::max(0, static_cast<int>(std::floor(std::min({x[0], x[1], x[2]}) - 0.5f)));
        const int max_x = std::min(last, static_cast<int>(std::ceil(std::max({x[0], x[1], x[2]}))));
        const int min_y = std::max(0, static_cast<int>(std::floor(std::min({y[0], y[1], y[2]}) - 0.5f)));
        const int max_y = std::min(last, static_cast<int>(std::ceil(std::max({y[0], y[1], y[2]}))));
        for (int row = min_y; row <= max_y; ++row) {
            const float center_y = static_cast<float>(row) + 0.5f;
            for (int column = min_x; column <= max_x; ++column) {
                const float center_x = static_cast<float>(column) + 0.5f;
                const float b1 = ((center_x - x[0]) * (y[2] - y[0]) - (x[2] - x[0]) * (center_y - y[0])) * inverse_area;
                const float b2 = ((x[1] - x[0]) * (center_y - y[0]) - (center_x - x[0]) * (y[1] - y[0])) * inverse_area;
                const float b0 = 1.0f - b1 - b2;
                if (b0 < 0.0f || b1 < 0.0f || b2 < 0.0f) continue;
                const std::size_t at = (static_cast<std::size_t>(row) * size + static_cast<std::size_t>(column)) * 3;
                float normal[3];
                for (int axis = 0; axis < 3; ++axis) {
                    const uint32_t i0 = corners[0] * 3 + static_cast<uint32_t>(axis);
                    const uint32_t i1 = corners[1] * 3 + static_cast<uint32_t>(axis);
                    const uint32_t i2 = corners[2] * 3 + static_cast<uint32_t>(axis);
                    out_positions[at + axis] = b0 * positions[i0] + b1 * positions[i1] + b2 * positions[i2];
                    normal[axis] = b0 * normals[i0] + b1 * normals[i1] + b2 * normals[i2];
                }
                const float length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
                for (int axis = 0; axis < 3; ++axis) out_normals[at + axis] = normal[axis] / length;
                ++written;
            }
        }
    }
    return written;
}

uint32_t plain_project(const float* map_positions, const float* map_normals, uint32_t size,
                       const float* decal_from_model, const float* direction_model, const uint8_t* decal,
                       uint32_t decal_width, uint32_t decal_height, const uint8_t* base, uint8_t* out) {
    const float* m = decal_from_model;
    const std::size_t texel_count = static_cast<std::size_t>(size) * size;
    uint32_t painted = 0;
    for (std::size_t texel = 0; texel < texel_count; ++texel) {
        const float* n = map_normals + texel * 3;
        if (n[0] * direction_model[0] + n[1] * direction_model[1] + n[2] * direction_model[2] <= 0.0f) continue;
        const float* p = map_positions + texel * 3;
        const float x = m[0] * p[0] + m[1] * p[1] + m[2] * p[2] + m[3];
        if (x < -0.5f || x > 0.5f) continue;
        const float y = m[4] * p[0] + m[5] * p[1] + m[6] * p[2] + m[7];
        if (y < -0.5f || y > 0.5f) continue;
        const float z = m[8] * p[0] + m[9] * p[1] + m[10] * p[2] + m[11];
        if (z < -0.5f || z > 0.5f) continue;
        float source[4];
        sample_bilinear(decal, decal_width, decal_height, (x + 0.5f) * static_cast<float>(decal_width),
                        (0.5f - y) * static_cast<float>(decal_height), source);
        const float source_alpha = source[3] / 255.0f;
        const float base_alpha = static_cast<float>(base[texel * 4 + 3]) / 255.0f;
        const float alpha = source_alpha + base_alpha * (1.0f - source_alpha);
        for (int channel = 0; channel < 3; ++channel) {
            const float under = static_cast<float>(base[texel * 4 + channel]) * base_alpha * (1.0f - source_alpha);
            const float color = alpha > 0.0f ? (source[channel] * source_alpha + under) / alpha : 0.0f;
            out[texel * 4 + channel] = static_cast<uint8_t>(color + 0.5f);
        }
        out[texel * 4 + 3] = static_cast<uint8_t>(alpha * 255.0f + 0.5f);
        ++painted;
    }
    return painted;
}
