// Skins and morph targets at rest: the nodes' own pose, the default weights, no animation (spec section 1).
#include <doctest/doctest.h>

#include <cmath>

#include "support/glb_builder.h"
#include "support/read_model.h"

using namespace support;

namespace {

/// Three vertices at x = 0, 1 and 2 on the X axis (made a triangle by y), facing +Z.
Shape make_strip() {
    Shape shape;
    shape.add_vertex(0, 0, 0, 0, 1);
    shape.add_vertex(1, 0, 0, 1, 1);
    shape.add_vertex(2, 1, 0, 1, 0);
    for (int i = 0; i < 3; ++i) shape.add_normal(0, 0, 1);
    shape.add_triangle(0, 1, 2);
    return shape;
}

/// 4 joints and 4 weights a vertex.
template <typename Joint>
std::string skinned_primitive(GlbBuilder& glb, const std::vector<Joint>& joints, int joint_type,
                              const std::string& weights) {
    const Shape strip = make_strip();
    const int positions = glb.floats(strip.positions, 3);
    const int normals = glb.floats(strip.normals, 3);
    const int joint_accessor = glb.integers(joints, joint_type, "VEC4", 4);
    return text(R"({"attributes":{"POSITION":%d,"NORMAL":%d,"JOINTS_0":%d,%s}})", positions, normals, joint_accessor,
                weights.c_str());
}

/// Two joints: nodes 1 and 2, the second a child of the first. Node 0 carries the mesh and stands elsewhere.
void add_bones(GlbBuilder& glb, const char* second_joint = R"({"translation":[0,0,2]})",
               const char* inverse_bind = "") {
    glb.add("nodes", R"({"mesh":0,"skin":0,"translation":[1000,1000,1000]})");
    glb.add("nodes", R"({"children":[2],"translation":[0,5,0]})");
    glb.add("nodes", second_joint);
    glb.add("skins", text(R"({"joints":[1,2]%s})", inverse_bind));
    glb.add("scenes", R"({"nodes":[0,1]})");
}

using Bytes = std::vector<std::uint8_t>;

const Bytes kJoints = {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0};
const std::vector<float> kWeights = {1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 1, 0, 0, 0};

}  // namespace

TEST_CASE("A skinned mesh stands where its joints stand, not where its own node does") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats(kWeights, 4));
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte, weights));
    add_bones(glb);
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(0), 0, 5, 0));
    CHECK(near(model.position(1), 1, 5, 1));  // half of each
    CHECK(near(model.position(2), 2, 6, 2));
}

TEST_CASE("Inverse bind matrices take the vertex to its joint first") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats(kWeights, 4));
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte, weights));
    // In the bind pose the joints stood at (0, 1, 0) and (2, 0, 0).
    std::vector<float> inverse(32, 0.0f);
    for (const std::size_t joint : {std::size_t{0}, std::size_t{16}}) {
        for (const std::size_t diagonal : {0, 5, 10, 15}) inverse[joint + diagonal] = 1.0f;
    }
    inverse[13] = -1.0f;
    inverse[16 + 12] = -2.0f;
    add_bones(glb, R"({"translation":[0,0,2]})", text(R"(,"inverseBindMatrices":%d)", glb.floats(inverse, 16)).c_str());
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(0), 0, 4, 0));
    CHECK(near(model.position(2), 0, 6, 2));
}

TEST_CASE("A joint's turn turns the normals it holds") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats(kWeights, 4));
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte, weights));
    add_bones(glb, R"({"rotation":[0.70710678118654752,0,0,0.70710678118654752]})");  // +Z to -Y
    const ReadModel model = read(glb.glb());
    CHECK(near(model.mesh.normals.at(0), 0, 0, 1));
    CHECK(near(model.mesh.normals.at(2), 0, -1, 0));
}

TEST_CASE("Weights that do not add up to 1 are made to") {
    std::vector<float> weights = kWeights;
    for (float& weight : weights) weight *= 0.25f;
    GlbBuilder glb;
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte, text(R"("WEIGHTS_0":%d)", glb.floats(weights, 4))));
    add_bones(glb);
    CHECK(near(read(glb.glb()).position(1), 1, 5, 1));
}

TEST_CASE("A vertex without any weight goes with the skin's first joint") {
    std::vector<float> weights = kWeights;
    for (std::size_t i = 8; i < 12; ++i) weights[i] = 0.0f;
    GlbBuilder glb;
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte, text(R"("WEIGHTS_0":%d)", glb.floats(weights, 4))));
    add_bones(glb);
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(1), 1, 5, 1));
    CHECK(near(model.position(2), 2, 6, 0));
}

TEST_CASE("Weights as bytes and joints as shorts say the same") {
    const std::vector<std::uint16_t> joints(kJoints.begin(), kJoints.end());
    std::vector<std::uint8_t> weights;
    for (const float weight : kWeights)
        weights.push_back(weight == 0.5f ? 127 : static_cast<std::uint8_t>(weight * 255));
    GlbBuilder glb;
    const int weight_accessor = glb.integers(weights, kUnsignedByte, "VEC4", 4, R"(,"normalized":true)");
    glb.mesh(skinned_primitive(glb, joints, kUnsignedShort, text(R"("WEIGHTS_0":%d)", weight_accessor)));
    add_bones(glb);
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(1), 1, 5, 1));
    CHECK(near(model.position(2), 2, 6, 2));
}

TEST_CASE("A second set of joints and weights counts too") {
    GlbBuilder glb;
    std::vector<float> halves = kWeights;
    for (float& weight : halves) weight *= 0.5f;
    const int first = glb.floats(halves, 4);
    // The other half of every vertex hangs on the second joint.
    const int joints = glb.integers(std::vector<std::uint8_t>(12, 1), kUnsignedByte, "VEC4", 4);
    const int second = glb.floats({0.5f, 0, 0, 0, 0.5f, 0, 0, 0, 0.5f, 0, 0, 0}, 4);
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte,
                               text(R"("WEIGHTS_0":%d,"JOINTS_1":%d,"WEIGHTS_1":%d)", first, joints, second)));
    add_bones(glb);
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(0), 0, 5, 1));
    CHECK(near(model.position(1), 1, 5, 1.5));
    CHECK(near(model.position(2), 2, 6, 2));
}

TEST_CASE("A joint that mirrors keeps the fronts in front") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats({0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, 4));
    glb.mesh(skinned_primitive(glb, Bytes{0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0}, kUnsignedByte, weights));
    add_bones(glb, R"({"scale":[-1,1,1]})");
    const ReadModel model = read(glb.glb());
    CHECK(near(model.mesh.normals.at(0), 0, 0, 1));
    CHECK(near(model.mesh.flat_normal(model.mesh.triangles.at(0)), 0, 0, 1));
}

TEST_CASE("A joint that mirrors turns round its own triangles alone") {
    GlbBuilder glb;
    Shape two = make_strip();
    two.normals.clear();
    for (int i = 0; i < 3; ++i) two.add_vertex(i, i == 2 ? 1 : 0, 0, 0, 0);
    two.add_triangle(3, 4, 5);
    Bytes joints(24, 0);
    for (const std::size_t v : {3, 4, 5}) joints[v * 4] = 1;
    std::vector<float> weights(24, 0.0f);
    for (std::size_t v = 0; v < 6; ++v) weights[v * 4] = 1.0f;
    const int positions = glb.floats(two.positions, 3);
    const int indices = glb.integers(two.indices, kUnsignedInt, "SCALAR", 1);
    const int joint_accessor = glb.integers(joints, kUnsignedByte, "VEC4", 4);
    glb.mesh(text(R"({"attributes":{"POSITION":%d,"JOINTS_0":%d,"WEIGHTS_0":%d},"indices":%d})", positions,
                  joint_accessor, glb.floats(weights, 4), indices));
    add_bones(glb, R"({"scale":[-1,1,1]})");
    const ReadModel model = read(glb.glb());
    for (const txc::Triangle& triangle : model.mesh.triangles) CHECK(near(model.mesh.flat_normal(triangle), 0, 0, 1));
}

TEST_CASE("A vertex that names a joint the skin does not have is an error, on every machine") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats(kWeights, 4));
    glb.mesh(skinned_primitive(glb, Bytes{0, 0, 0, 0, 0, 2, 0, 0, 1, 0, 0, 0}, kUnsignedByte, weights));
    add_bones(glb);
    const ReadModel model = try_read(glb.glb());
    CHECK(model.status == TXC_STATUS_BAD_MODEL);
    CHECK(model.detail == "meshes[0].primitives[0]: vertex 1 names joint 2 of 2");

    // As float or signed the joint could be negative or not a number, which machines turn into different integers.
    for (const int type : {kByte, kShort, kFloat}) {
        CAPTURE(type);
        GlbBuilder odd;
        const std::string odd_weights = text(R"("WEIGHTS_0":%d)", odd.floats(kWeights, 4));
        odd.mesh(skinned_primitive(odd, std::vector<float>(12, -1.0f), type, odd_weights));
        add_bones(odd);
        CHECK(try_read(odd.glb()).status == TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("A skin without joints is an error, also where no vertex has a weight") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats(std::vector<float>(12, 0.0f), 4));
    glb.mesh(skinned_primitive(glb, Bytes(12, 0), kUnsignedByte, weights));
    glb.add("nodes", R"({"mesh":0,"skin":0})");
    glb.add("skins", R"({"joints":[]})");
    const ReadModel model = try_read(glb.glb());
    CHECK(model.status == TXC_STATUS_BAD_MODEL);
    CHECK(model.detail == "skins[0]: there is no joint nodes[-1]");
}

TEST_CASE("A skin with fewer inverse bind matrices than joints is an error") {
    GlbBuilder glb;
    const std::string weights = text(R"("WEIGHTS_0":%d)", glb.floats(kWeights, 4));
    glb.mesh(skinned_primitive(glb, kJoints, kUnsignedByte, weights));
    add_bones(glb, "{}", text(R"(,"inverseBindMatrices":%d)", glb.floats(std::vector<float>(16, 0.0f), 16)).c_str());
    const ReadModel model = try_read(glb.glb());
    CHECK(model.status == TXC_STATUS_BAD_MODEL);
    CHECK(model.detail == "skins[0] has 2 joints but 1 inverse bind matrices");
}

namespace {

/// The strip with two morph targets: the first moves all by (1, 0, 0), the second by (0, 0, 1) and tilts the normals.
GlbBuilder make_morphed(const char* mesh_weights, const char* node_weights) {
    GlbBuilder glb;
    const Shape strip = make_strip();
    const int positions = glb.floats(strip.positions, 3);
    const int normals = glb.floats(strip.normals, 3);
    const int along_x = glb.floats({1, 0, 0, 1, 0, 0, 1, 0, 0}, 3);
    const int along_z = glb.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    const int tilt = glb.floats({1, 0, -1, 1, 0, -1, 1, 0, -1}, 3);
    glb.mesh(
        text(R"({"attributes":{"POSITION":%d,"NORMAL":%d},"targets":[{"POSITION":%d},{"POSITION":%d,"NORMAL":%d}]})",
             positions, normals, along_x, along_z, tilt),
        mesh_weights);
    glb.add("nodes", text(R"({"mesh":0%s})", node_weights));
    return glb;
}

}  // namespace

TEST_CASE("Morph targets are applied by the mesh's own weights") {
    const ReadModel model = read(make_morphed(R"(,"weights":[0.5,2])", "").glb());
    CHECK(near(model.position(0), 0.5, 0, 2));
    CHECK(near(model.position(2), 2.5, 1, 2));
}

TEST_CASE("A node's weights go before the mesh's") {
    const ReadModel model = read(make_morphed(R"(,"weights":[0.5,2])", R"(,"weights":[1,0])").glb());
    CHECK(near(model.position(0), 1, 0, 0));
    CHECK(near(model.mesh.normals.at(0), 0, 0, 1));
}

TEST_CASE("Without weights no morph target moves anything") {
    CHECK(near(read(make_morphed("", "").glb()).position(0), 0, 0, 0));
}

TEST_CASE("A morph target bends the normals as well") {
    const ReadModel model = read(make_morphed(R"(,"weights":[0,1])", "").glb());
    CHECK(near(model.mesh.normals.at(0), 1, 0, 0));
}

TEST_CASE("A morph target of another length is an error") {
    GlbBuilder glb;
    const int positions = glb.floats(make_strip().positions, 3);
    const int delta = glb.floats({1, 0, 0}, 3);
    glb.mesh(text(R"({"attributes":{"POSITION":%d},"targets":[{"POSITION":%d}]})", positions, delta),
             R"(,"weights":[1])");
    glb.add("nodes", R"({"mesh":0})");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_BAD_MODEL);
}
