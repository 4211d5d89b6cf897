// A file through the glTF reader alone.
#pragma once

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "gltf_reader.h"

namespace support {

struct ReadModel {
    TxcStatus status = TXC_STATUS_OK;
    std::string detail;
    txc::Mesh mesh;

    /// Model space.
    glm::vec3 position(std::size_t vertex) const { return mesh.origin + mesh.positions.at(vertex); }
};

inline ReadModel try_read(const std::vector<std::uint8_t>& file, std::uint64_t budget_bytes = 64u << 20) {
    ReadModel model;
    txc::MemoryBudget budget(budget_bytes);
    txc::error_detail().clear();
    model.status = txc::read_gltf(file.data(), static_cast<std::uint32_t>(file.size()), budget, model.mesh);
    model.detail = txc::error_detail();
    return model;
}

inline ReadModel read(const std::vector<std::uint8_t>& file) {
    ReadModel model = try_read(file);
    INFO(model.detail);
    REQUIRE(model.status == TXC_STATUS_OK);
    return model;
}

inline bool near(const glm::vec3& a, double x, double y, double z, double tolerance = 1e-6) {
    return std::fabs(a.x - x) <= tolerance && std::fabs(a.y - y) <= tolerance && std::fabs(a.z - z) <= tolerance;
}
inline bool near(const glm::vec2& a, double x, double y, double tolerance = 1e-6) {
    return std::fabs(a.x - x) <= tolerance && std::fabs(a.y - y) <= tolerance;
}

}  // namespace support
