#include "mesh.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace txc {
namespace {

bool is_usable(const glm::vec3& p) {
    return std::fabs(p.x) <= kMaxCoordinate && std::fabs(p.y) <= kMaxCoordinate && std::fabs(p.z) <= kMaxCoordinate;
}

bool is_usable(const glm::vec2& uv) { return std::fabs(uv.x) <= kMaxUv && std::fabs(uv.y) <= kMaxUv; }

bool in_unit_square(const glm::vec2& uv) { return uv.x >= 0.0f && uv.x <= 1.0f && uv.y >= 0.0f && uv.y <= 1.0f; }

glm::vec3 unit_or_zero(const glm::vec3& v) {
    const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
    // Also false for NaN: a normal that says nothing gives way to the triangle's others.
    return length > 1e-20f && length < 1e20f ? v / length : glm::vec3(0.0f);
}

// Along an axis on which a model's centre is further than this many of its diagonals from model space's origin, floats from there lose
// 4 bits of it. (At 500 a map of such positions was 1.4 times as far off as spec section 2 allows.)
constexpr double kNearDiagonals = 16.0;

}  // namespace

TxcStatus place_primitive(Mesh& mesh, MeshSize& filled, const PrimitiveArrays& arrays, const char* name) {
    for (std::uint32_t i = 0; i < arrays.vertex_count; ++i) {
        if (!is_usable(arrays.positions[i])) {
            return fail(TXC_STATUS_BAD_GEOMETRY, "%s: position %u is (%g, %g, %g), which is not a usable number", name,
                        i, static_cast<double>(arrays.positions[i].x), static_cast<double>(arrays.positions[i].y),
                        static_cast<double>(arrays.positions[i].z));
        }
    }
    for (std::uint32_t i = 0; i < arrays.index_count; ++i) {
        if (arrays.indices[i] >= arrays.vertex_count) {
            return fail(TXC_STATUS_BAD_GEOMETRY, "%s: index %u is %u, but there are only %u vertices", name, i,
                        arrays.indices[i], arrays.vertex_count);
        }
    }
    const auto first = static_cast<std::uint32_t>(filled.vertices);
    for (std::uint32_t i = 0; i < arrays.vertex_count; ++i) {
        const auto at = static_cast<std::size_t>(filled.vertices++);
        mesh.positions[at] = arrays.positions[i] - arrays.origin;
        mesh.normals[at] = arrays.normals != nullptr ? unit_or_zero(arrays.normals[i]) : glm::vec3(0.0f);
        mesh.uvs[at] = arrays.uvs != nullptr ? arrays.uvs[i] : glm::vec2(0.0f);
        mesh.vertex_has_uv[at] = arrays.uvs != nullptr ? 1 : 0;
    }
    for (std::uint32_t i = 0; i + 2 < arrays.index_count; i += 3) {
        const auto at = static_cast<std::size_t>(filled.triangles++);
        mesh.triangles[at] = {first + arrays.indices[i], first + arrays.indices[i + 1], first + arrays.indices[i + 2]};
        mesh.triangle_materials[at] = arrays.material;
    }
    return TXC_STATUS_OK;
}

void Mesh::resize(const MeshSize& size) {
    // A vector that grows by itself gets room beyond what is asked for.
    const auto resize_to = [](auto& elements, std::uint64_t count) {
        std::remove_reference_t<decltype(elements)> longer(static_cast<std::size_t>(count));
        std::copy(elements.begin(), elements.end(), longer.begin());
        elements.swap(longer);
    };
    resize_to(positions, size.vertices);
    resize_to(normals, size.vertices);
    resize_to(uvs, size.vertices);
    resize_to(vertex_has_uv, size.vertices);
    resize_to(triangles, size.triangles);
    resize_to(triangle_materials, size.triangles);
}

void Mesh::summarise() {
    bounds = Bounds{};
    std::vector<std::uint32_t> counts(materials.size());
    for (const std::uint32_t material : triangle_materials) ++counts[material];
    for (std::size_t m = 0; m < materials.size(); ++m) {
        Material& material = materials[m];
        material.triangles.clear();
        material.triangles.reserve(counts[m]);
        material.degenerate_uv_triangles = 0;
        material.out_of_range_uv_triangles = 0;
        material.triangles_without_uv = 0;
        material.has_unusable_uv = false;
        material.uv_min = material.uv_max = glm::vec2(0.0f);
        material.bounds = Bounds{};
    }
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        const Triangle& triangle = triangles[t];
        Material& material = materials[triangle_materials[t]];
        bool has_uv = true;
        bool in_range = true;
        bool usable = true;
        for (const std::uint32_t v : triangle.vertex) {
            bounds.add(positions[v]);
            material.bounds.add(positions[v]);
            has_uv = has_uv && vertex_has_uv[v] != 0;
            in_range = in_range && in_unit_square(uvs[v]);
            usable = usable && is_usable(uvs[v]);
        }
        const bool first_with_uv = material.triangles.size() == material.triangles_without_uv;
        material.triangles.push_back(t);
        if (!has_uv) {
            ++material.triangles_without_uv;
            continue;
        }
        if (!usable) {
            material.has_unusable_uv = true;
            continue;
        }
        if (!in_range) ++material.out_of_range_uv_triangles;
        const glm::vec2 a = uvs[triangle.vertex[0]];
        const glm::vec2 b = uvs[triangle.vertex[1]];
        const glm::vec2 c = uvs[triangle.vertex[2]];
        const glm::dvec2 ab = glm::dvec2(b) - glm::dvec2(a);
        const glm::dvec2 ac = glm::dvec2(c) - glm::dvec2(a);
        if (ab.x * ac.y - ab.y * ac.x == 0.0) ++material.degenerate_uv_triangles;
        const glm::vec2 low = glm::min(a, glm::min(b, c));
        const glm::vec2 high = glm::max(a, glm::max(b, c));
        material.uv_min = first_with_uv ? low : glm::min(material.uv_min, low);
        material.uv_max = first_with_uv ? high : glm::max(material.uv_max, high);
    }
}

bool Mesh::come_near() {
    if (origin != glm::vec3(0.0f)) return false;
    const double near = kNearDiagonals * static_cast<double>(bounds.diagonal());
    bool is_far = false;
    for (int axis = 0; axis < 3; ++axis) {
        const double centre = (static_cast<double>(bounds.min[axis]) + static_cast<double>(bounds.max[axis])) * 0.5;
        if (!(std::fabs(centre) > near)) continue;
        origin[axis] = static_cast<float>(centre);
        is_far = true;
    }
    return is_far;
}

TxcStatus Material::paint_status(std::uint32_t index) const {
    if (triangles.empty())
        return fail(TXC_STATUS_NO_TRIANGLES, "material %u is used by no triangle of the scene", index);
    if (triangles_without_uv == triangles.size()) {
        return fail(TXC_STATUS_NO_UVS,
                    "material %u: none of its %zu triangles has the texture coordinates TEXCOORD_%u; unwrap the model "
                    "in a 3D editor first",
                    index, triangles.size(), tex_coord);
    }
    if (has_unusable_uv || triangles_without_uv + degenerate_uv_triangles == triangles.size()) {
        return fail(TXC_STATUS_BAD_UVS,
                    "material %u has a texture coordinate that is not a number or lies beyond %g, or only triangles "
                    "without area in the texture: unwrap it anew",
                    index, static_cast<double>(kMaxUv));
    }
    return TXC_STATUS_OK;
}

glm::vec3 Mesh::flat_normal(const Triangle& triangle) const {
    const glm::dvec3 a(positions[triangle.vertex[0]]);
    const glm::dvec3 b(positions[triangle.vertex[1]]);
    const glm::dvec3 c(positions[triangle.vertex[2]]);
    const glm::dvec3 cross = glm::cross(b - a, c - a);
    const double length = std::sqrt(cross.x * cross.x + cross.y * cross.y + cross.z * cross.z);
    return length > 0.0 ? glm::vec3(cross / length) : glm::vec3(0.0f, 1.0f, 0.0f);
}

std::uint64_t MeshSize::byte_count() const {
    // Positions, normals, UVs and a flag a vertex; corners, material and a place in the material's list a triangle.
    return vertices * (12 + 12 + 8 + 1) + triangles * (12 + 4 + 4);
}

}  // namespace txc
