// Shapes as the core's own mesh, for claims about its inner parts.
#pragma once

#include <memory>

#include "map_baker.h"
#include "mesh.h"
#include "projector.h"
#include "random.h"
#include "test_session.h"

namespace support {

inline txc::Mesh make_core_mesh(const Shape& shape) {
    txc::Mesh mesh;
    txc::PrimitiveArrays arrays;
    arrays.positions = reinterpret_cast<const glm::vec3*>(shape.positions.data());
    arrays.normals = shape.normals.empty() ? nullptr : reinterpret_cast<const glm::vec3*>(shape.normals.data());
    arrays.uvs = shape.uvs.empty() ? nullptr : reinterpret_cast<const glm::vec2*>(shape.uvs.data());
    arrays.vertex_count = shape.vertex_count();
    arrays.indices = shape.indices.data();
    arrays.index_count = static_cast<std::uint32_t>(shape.indices.size());
    mesh.materials.resize(1);
    mesh.resize({arrays.vertex_count, arrays.index_count / 3});
    txc::MeshSize filled;
    must(txc::place_primitive(mesh, filled, arrays, "the shape"));
    mesh.summarise();
    return mesh;
}

inline txc::PlanarProjector make_projector(const TxcLayerDef& def) {
    txc::PlanarProjector projector;
    must(txc::PlanarProjector::from_def(def, glm::vec3(0.0f), projector));
    return projector;
}

/// Triangles without UVs, corners anywhere in the cube of the given half side.
inline Shape make_random_triangles(Random& random, std::uint32_t count, double half_side, double triangle_size) {
    Shape shape;
    for (std::uint32_t t = 0; t < count; ++t) {
        const double middle[3] = {random.between(-half_side, half_side), random.between(-half_side, half_side),
                                  random.between(-half_side, half_side)};
        for (int corner = 0; corner < 3; ++corner) {
            for (const double m : middle)
                shape.positions.push_back(static_cast<float>(m + random.between(-triangle_size, triangle_size)));
        }
        shape.add_triangle(t * 3, t * 3 + 1, t * 3 + 2);
    }
    return shape;
}

}  // namespace support
