// Small models whose geometry a test knows in closed form.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace support {

inline constexpr double kPi = 3.14159265358979323846;

/// One mesh's arrays as txc_model_add_mesh takes them. Fronts are counter-clockwise.
struct Shape {
    std::vector<float> positions;  // 3 a vertex, metres
    std::vector<float> normals;    // 3 a vertex, or none
    std::vector<float> uvs;        // 2 a vertex, or none
    std::vector<std::uint32_t> indices;

    std::uint32_t vertex_count() const { return static_cast<std::uint32_t>(positions.size() / 3); }
    std::uint32_t triangle_count() const { return static_cast<std::uint32_t>(indices.size() / 3); }

    void add_vertex(double x, double y, double z, double u, double v) {
        for (const double p : {x, y, z}) positions.push_back(static_cast<float>(p));
        for (const double t : {u, v}) uvs.push_back(static_cast<float>(t));
    }
    void add_normal(double x, double y, double z) {
        for (const double n : {x, y, z}) normals.push_back(static_cast<float>(n));
    }
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { indices.insert(indices.end(), {a, b, c}); }

    /// Joins another shape to this one. Both have normals, or neither.
    void append(const Shape& other) {
        const std::uint32_t first = vertex_count();
        positions.insert(positions.end(), other.positions.begin(), other.positions.end());
        normals.insert(normals.end(), other.normals.begin(), other.normals.end());
        uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
        for (const std::uint32_t index : other.indices) indices.push_back(first + index);
    }
};

/// Where in the texture a chart lies.
struct UvRect {
    double left = 0.0;
    double top = 0.0;
    double right = 1.0;
    double bottom = 1.0;
};

/// A vertex grid over the chart. `place(s, t, position, normal)`: s runs from 0 to 1 along u, t along v (down).
template <typename Place>
Shape make_grid(std::uint32_t columns, std::uint32_t rows, const UvRect& chart, Place&& place) {
    Shape shape;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double s = static_cast<double>(column) / columns;
            const double t = static_cast<double>(row) / rows;
            double p[3];
            double n[3];
            place(s, t, p, n);
            shape.add_vertex(p[0], p[1], p[2], chart.left + (chart.right - chart.left) * s,
                             chart.top + (chart.bottom - chart.top) * t);
            shape.add_normal(n[0], n[1], n[2]);
        }
    }
    for (std::uint32_t row = 0; row < rows; ++row) {
        for (std::uint32_t column = 0; column < columns; ++column) {
            const std::uint32_t a = row * (columns + 1) + column;
            const std::uint32_t below = a + columns + 1;
            shape.add_triangle(a, below, a + 1);
            shape.add_triangle(a + 1, below, below + 1);
        }
    }
    return shape;
}

/// The square [-size/2, size/2]^2 at height z, facing +Z, its texture upright: u to the right, v down.
inline Shape make_plane(double size = 1.0, double z = 0.0, const UvRect& chart = {}) {
    return make_grid(1, 1, chart, [=](double s, double t, double(&p)[3], double(&n)[3]) {
        p[0] = (s - 0.5) * size;
        p[1] = (0.5 - t) * size;
        p[2] = z;
        n[0] = n[1] = 0.0;
        n[2] = 1.0;
    });
}

/// A sphere around the origin: u runs round the equator from -Z over -X, +Z and +X, v from the north pole (+Y) down, so
/// the texture stands upright and unmirrored where it is seen from outside.
inline Shape make_sphere(double radius, std::uint32_t columns = 32, std::uint32_t rows = 16, const UvRect& chart = {}) {
    return make_grid(columns, rows, chart, [=](double s, double t, double(&p)[3], double(&n)[3]) {
        const double around = s * 2.0 * kPi;
        const double down = t * kPi;
        n[0] = -std::sin(around) * std::sin(down);
        n[1] = std::cos(down);
        n[2] = -std::cos(around) * std::sin(down);
        for (int c = 0; c < 3; ++c) p[c] = n[c] * radius;
    });
}

/// An open cylinder around the Y axis, its texture laid round it as the sphere's is.
inline Shape make_cylinder(double radius, double height, std::uint32_t columns = 48, const UvRect& chart = {}) {
    return make_grid(columns, 1, chart, [=](double s, double t, double(&p)[3], double(&n)[3]) {
        const double around = s * 2.0 * kPi;
        n[0] = -std::sin(around);
        n[1] = 0.0;
        n[2] = -std::cos(around);
        p[0] = n[0] * radius;
        p[1] = (0.5 - t) * height;
        p[2] = n[2] * radius;
    });
}

/// A cube around the origin without vertex normals: six charts of a 3 x 2 atlas with a margin between them, so that
/// every edge is a seam. Faces in the order +X, -X, +Y, -Y, +Z, -Z.
inline Shape make_cube(double size = 1.0) {
    Shape cube;
    const double h = size / 2;
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2;
        const double side = face % 2 == 0 ? 1.0 : -1.0;
        double normal[3] = {0, 0, 0};
        double up[3] = {0, 0, 0};
        normal[axis] = side;
        up[(axis + 1) % 3] = 1.0;
        // right = up x normal, so that right x up = normal: the front.
        const double right[3] = {up[1] * normal[2] - up[2] * normal[1], up[2] * normal[0] - up[0] * normal[2],
                                 up[0] * normal[1] - up[1] * normal[0]};
        const double left_u = (face % 3) / 3.0 + 1.0 / 24;
        const double top_v = (face / 3) / 2.0 + 1.0 / 16;
        const std::uint32_t first = cube.vertex_count();
        for (int corner = 0; corner < 4; ++corner) {
            const double s = corner % 2;
            const double t = corner / 2;
            double p[3];
            for (int c = 0; c < 3; ++c) p[c] = h * (normal[c] + right[c] * (2 * s - 1) + up[c] * (1 - 2 * t));
            cube.add_vertex(p[0], p[1], p[2], left_u + s * 0.25, top_v + t * 0.375);
        }
        cube.add_triangle(first, first + 2, first + 1);
        cube.add_triangle(first + 1, first + 2, first + 3);
    }
    return cube;
}

/// A floor (y = 0) and a wall that rises from its far edge, each in a chart of its own.
inline Shape make_inner_corner() {
    Shape room;
    const auto add_quad = [&room](const double(&p)[4][3], const double(&n)[3], const UvRect& chart) {
        const std::uint32_t first = room.vertex_count();
        const double uv[4][2] = {
            {chart.left, chart.top}, {chart.right, chart.top}, {chart.right, chart.bottom}, {chart.left, chart.bottom}};
        for (int c = 0; c < 4; ++c) {
            room.add_vertex(p[c][0], p[c][1], p[c][2], uv[c][0], uv[c][1]);
            room.add_normal(n[0], n[1], n[2]);
        }
        room.add_triangle(first, first + 3, first + 1);
        room.add_triangle(first + 1, first + 3, first + 2);
    };
    // The top edge of each chart in the order: left, right; below it the near or lower edge.
    add_quad({{-0.5, 0, 0}, {0.5, 0, 0}, {0.5, 0, 1}, {-0.5, 0, 1}}, {0, 1, 0}, {0.05, 0.1, 0.45, 0.9});
    add_quad({{-0.5, 1, 0}, {0.5, 1, 0}, {0.5, 0, 0}, {-0.5, 0, 0}}, {0, 0, 1}, {0.55, 0.1, 0.95, 0.9});
    return room;
}

/// A copy with every vertex moved.
inline Shape moved(Shape shape, double x, double y, double z) {
    const double by[3] = {x, y, z};
    for (std::size_t i = 0; i < shape.positions.size(); ++i)
        shape.positions[i] = static_cast<float>(shape.positions[i] + by[i % 3]);
    return shape;
}

}  // namespace support
