// A model's triangles at rest, gathered into model space: what the bake and the occlusion test read. Positions are counted from
// the mesh's `origin`, as everything is that the core makes of them; what comes in from outside, and what goes out, is from model
// space's own.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "memory_budget.h"
#include "status.h"

namespace txc {

struct Bounds {
    glm::vec3 min{0.0f};
    glm::vec3 max{0.0f};
    bool empty = true;

    void add(const glm::vec3& point) {
        min = empty ? point : glm::min(min, point);
        max = empty ? point : glm::max(max, point);
        empty = false;
    }
    float diagonal() const { return empty ? 0.0f : glm::length(max - min); }
};

/// Corners in the order that makes the front counter-clockwise; what a node or joint mirrors is already turned round.
struct Triangle {
    std::uint32_t vertex[3];
};

/// What the file says of one material's base colour texture, and what its triangles are like.
struct Material {
    std::uint32_t tex_coord = 0;
    std::uint32_t image = TXC_NONE;
    bool nearest_filter = false;
    glm::vec4 base_color_factor{1.0f};

    std::vector<std::uint32_t> triangles;  // indices into Mesh::triangles, ascending
    std::uint32_t degenerate_uv_triangles = 0;
    std::uint32_t out_of_range_uv_triangles = 0;
    std::uint32_t triangles_without_uv = 0;
    bool has_unusable_uv = false;
    glm::vec2 uv_min{0.0f};
    glm::vec2 uv_max{0.0f};
    Bounds bounds;

    /// OK, or why the material cannot take decals (fills in the error detail).
    TxcStatus paint_status(std::uint32_t index) const;
};

/// How long a mesh's arrays are.
struct MeshSize {
    std::uint64_t vertices = 0;
    std::uint64_t triangles = 0;

    /// What they hold.
    std::uint64_t byte_count() const;
};

struct Mesh {
    // Where `positions` begin, model space: 0 but for models that stand far from there (see come_near).
    glm::vec3 origin{0.0f};
    std::vector<glm::vec3> positions;  // from `origin`, metres
    std::vector<glm::vec3> normals;    // unit, or zero: the triangle's others hold, or else its flat one
    std::vector<glm::vec2> uvs;        // as painted: after KHR_texture_transform, not yet wrapped
    std::vector<Triangle> triangles;
    std::vector<std::uint32_t> triangle_materials;
    std::vector<std::uint8_t> vertex_has_uv;
    std::vector<Material> materials;
    bool has_default_material = false;
    Bounds bounds;  // from `origin`, as the materials'

    MeshSize size() const { return {positions.size(), triangles.size()}; }

    /// Gives the arrays this size, and no room beyond it, which the budget would not count.
    void resize(const MeshSize& size);

    /// Fills the materials' triangle lists, counts and bounds, and the mesh's bounds, from the arrays.
    void summarise();

    /// After summarise(): gives a mesh that stands far from model space's origin one of its own, once, from which floats are fine
    /// steps. True where it did: all positions are then to be read again.
    bool come_near();

    /// Front-facing unit normal; +Y for a triangle without area.
    glm::vec3 flat_normal(const Triangle& triangle) const;
};

/// Coordinates beyond this would overflow the arithmetic behind them; metres.
inline constexpr float kMaxCoordinate = 1e12f;
/// What is divided by less than this, in a projector, would too.
inline constexpr float kMinLength = 1e-12f;
/// A texture coordinate beyond this has no fraction left worth painting.
inline constexpr float kMaxUv = 65536.0f;

/// One primitive's arrays. `normals` and `uvs` may be null.
struct PrimitiveArrays {
    const glm::vec3* positions = nullptr;
    glm::vec3 origin{0.0f};  // where the mesh's positions begin, in those of the arrays
    const glm::vec3* normals = nullptr;
    const glm::vec2* uvs = nullptr;
    std::uint32_t vertex_count = 0;
    const std::uint32_t* indices = nullptr;  // triangle list
    std::uint32_t index_count = 0;
    std::uint32_t material = 0;
};

/// Checks the arrays and writes them behind what is `filled` of the mesh's, where there must be room, and counts them to it.
/// BAD_GEOMETRY names the first bad vertex or index; `name` says whose it is.
TxcStatus place_primitive(Mesh& mesh, MeshSize& filled, const PrimitiveArrays& arrays, const char* name);

}  // namespace txc
