// A slow bake in double precision, written from spec.md section 2 and sharing no code with the core: every texel asks
// every triangle's box by barycentric coordinates.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "shapes.h"

namespace support {

struct Vec3 {
    double x = 0, y = 0, z = 0;
};

inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec3 operator*(const Vec3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const Vec3& v) { return std::sqrt(dot(v, v)); }
inline Vec3 unit(const Vec3& v) { return v * (1.0 / length(v)); }
inline Vec3 vec3(const float* from) { return {from[0], from[1], from[2]}; }

/// The angle between two directions, degrees.
inline double degrees_between(const Vec3& a, const Vec3& b) {
    return std::atan2(length(cross(a, b)), dot(a, b)) * 180.0 / kPi;
}

/// One texel's owner by the specification.
struct ReferenceTexel {
    int triangle = -1;  // the lowest index that covers the centre, or -1
    int claims = 0;     // triangles that cover it
    bool sure = true;   // no triangle's edge runs through the centre
    double u = 0;       // the centre where that triangle has it: not wrapped
    double v = 0;
};

class ReferenceMap {
public:
    ReferenceMap(const Shape& shape, std::uint32_t map_width, std::uint32_t map_height)
        : width(map_width), height(map_height), shape_(shape), texels_(static_cast<std::size_t>(width) * height) {
        for (std::uint32_t t = 0; t < shape.triangle_count(); ++t) add(static_cast<int>(t));
    }

    const std::uint32_t width;
    const std::uint32_t height;

    const ReferenceTexel& at(std::uint32_t x, std::uint32_t y) const { return texels_[y * width + x]; }

    /// The triangle's own affine map, continued beyond it.
    Vec3 position(int triangle, double u, double v) const {
        double weights[3];
        barycentric(triangle, u, v, weights);
        return corner(triangle, 0) * weights[0] + corner(triangle, 1) * weights[1] + corner(triangle, 2) * weights[2];
    }
    /// Unit; the flat one where the shape has none.
    Vec3 normal(int triangle, double u, double v) const {
        if (shape_.normals.empty()) return flat_normal(triangle);
        double weights[3];
        barycentric(triangle, u, v, weights);
        Vec3 sum;
        for (int c = 0; c < 3; ++c) sum = sum + vec3(shape_.normals.data() + vertex(triangle, c) * 3) * weights[c];
        return unit(sum);
    }
    Vec3 flat_normal(int triangle) const {
        const Vec3 a = corner(triangle, 0);
        return unit(cross(corner(triangle, 1) - a, corner(triangle, 2) - a));
    }
    Vec3 corner(int triangle, int c) const { return vec3(shape_.positions.data() + vertex(triangle, c) * 3); }

    /// The shape's bounding-box diagonal, metres.
    double diagonal() const {
        Vec3 low = corner(0, 0);
        Vec3 high = low;
        for (std::size_t i = 0; i < shape_.positions.size(); i += 3) {
            const Vec3 p = vec3(shape_.positions.data() + i);
            low = {std::fmin(low.x, p.x), std::fmin(low.y, p.y), std::fmin(low.z, p.z)};
            high = {std::fmax(high.x, p.x), std::fmax(high.y, p.y), std::fmax(high.z, p.z)};
        }
        return length(high - low);
    }

private:
    std::uint32_t vertex(int triangle, int c) const {
        return shape_.indices[static_cast<std::size_t>(triangle) * 3 + static_cast<std::size_t>(c)];
    }
    double u_of(int triangle, int c) const { return shape_.uvs[vertex(triangle, c) * 2]; }
    double v_of(int triangle, int c) const { return shape_.uvs[vertex(triangle, c) * 2 + 1]; }

    void barycentric(int triangle, double u, double v, double (&weights)[3]) const {
        const double au = u_of(triangle, 0), av = v_of(triangle, 0);
        const double bu = u_of(triangle, 1) - au, bv = v_of(triangle, 1) - av;
        const double cu = u_of(triangle, 2) - au, cv = v_of(triangle, 2) - av;
        const double area = bu * cv - bv * cu;
        weights[1] = ((u - au) * cv - (v - av) * cu) / area;
        weights[2] = (bu * (v - av) - bv * (u - au)) / area;
        weights[0] = 1.0 - weights[1] - weights[2];
    }

    void add(int triangle) {
        double low_u = 1e9, high_u = -1e9, low_v = 1e9, high_v = -1e9;
        for (int c = 0; c < 3; ++c) {
            low_u = std::fmin(low_u, u_of(triangle, c));
            high_u = std::fmax(high_u, u_of(triangle, c));
            low_v = std::fmin(low_v, v_of(triangle, c));
            high_v = std::fmax(high_v, v_of(triangle, c));
        }
        const double area = (u_of(triangle, 1) - u_of(triangle, 0)) * (v_of(triangle, 2) - v_of(triangle, 0)) -
                            (v_of(triangle, 1) - v_of(triangle, 0)) * (u_of(triangle, 2) - u_of(triangle, 0));
        if (area == 0.0) return;
        const auto w = static_cast<std::int64_t>(width);
        const auto h = static_cast<std::int64_t>(height);
        for (auto y = static_cast<std::int64_t>(std::floor(low_v * static_cast<double>(h))) - 1;
             static_cast<double>(y) <= high_v * static_cast<double>(h) + 1; ++y) {
            for (auto x = static_cast<std::int64_t>(std::floor(low_u * static_cast<double>(w))) - 1;
                 static_cast<double>(x) <= high_u * static_cast<double>(w) + 1; ++x) {
                const double u = (static_cast<double>(x) + 0.5) / static_cast<double>(w);
                const double v = (static_cast<double>(y) + 0.5) / static_cast<double>(h);
                double weights[3];
                barycentric(triangle, u, v, weights);
                const double least = std::fmin(weights[0], std::fmin(weights[1], weights[2]));
                if (least < -1e-7) continue;
                ReferenceTexel& texel = texels_[static_cast<std::size_t>(((y % h + h) % h) * w + (x % w + w) % w)];
                if (least < 1e-7) texel.sure = false;
                if (least < 0.0) continue;
                ++texel.claims;
                if (texel.triangle >= 0) continue;
                texel.triangle = triangle;
                texel.u = u;
                texel.v = v;
            }
        }
    }

    const Shape& shape_;
    std::vector<ReferenceTexel> texels_;
};

}  // namespace support
