// How a file may store its numbers and its triangles: types, strides, sparse values, strips and fans.
#include <doctest/doctest.h>

#include <array>
#include <cmath>

#include "support/glb_builder.h"
#include "support/read_model.h"

using namespace support;

namespace {

using Corners = std::array<std::uint32_t, 3>;

/// Six vertices: a zigzag (0, 0), (1, 1), (2, 0) and so on in the XY plane.
std::vector<float> zigzag() {
    std::vector<float> positions;
    for (int i = 0; i < 6; ++i)
        positions.insert(positions.end(), {static_cast<float>(i), static_cast<float>(i % 2), 0.0f});
    return positions;
}

ReadModel read_primitive(GlbBuilder& glb, const std::string& attributes, const std::string& more = "") {
    glb.mesh(R"({"attributes":{)" + attributes + "}" + more + "}");
    glb.add("nodes", R"({"mesh":0})");
    return read(glb.glb());
}

std::vector<Corners> triangles_of(const ReadModel& model) {
    std::vector<Corners> corners;
    for (const txc::Triangle& triangle : model.mesh.triangles)
        corners.push_back({triangle.vertex[0], triangle.vertex[1], triangle.vertex[2]});
    return corners;
}

template <typename Index>
std::vector<Corners> triangles_by_index(int component_type) {
    GlbBuilder glb;
    const int positions = glb.floats(zigzag(), 3);
    const int indices = glb.integers(std::vector<Index>{0, 2, 1, 5, 3, 4}, component_type, "SCALAR", 1);
    return triangles_of(read_primitive(glb, text(R"("POSITION":%d)", positions), text(R"(,"indices":%d)", indices)));
}

std::vector<Corners> triangles_by_mode(int mode, std::size_t vertices = 6) {
    GlbBuilder glb;
    std::vector<float> positions = zigzag();
    positions.resize(vertices * 3);
    const int accessor = glb.floats(positions, 3);
    return triangles_of(read_primitive(glb, text(R"("POSITION":%d)", accessor), text(R"(,"mode":%d)", mode)));
}

}  // namespace

TEST_CASE("Indices of 8, 16 and 32 bits name the same triangles") {
    const std::vector<Corners> expected{{0, 2, 1}, {5, 3, 4}};
    CHECK(triangles_by_index<std::uint8_t>(kUnsignedByte) == expected);
    CHECK(triangles_by_index<std::uint16_t>(kUnsignedShort) == expected);
    CHECK(triangles_by_index<std::uint32_t>(kUnsignedInt) == expected);
}

TEST_CASE("Without indices every three vertices are a triangle") {
    CHECK(triangles_by_mode(4) == std::vector<Corners>{{0, 1, 2}, {3, 4, 5}});
}

TEST_CASE("Vertices or indices beyond the last whole triangle are dropped") {
    CHECK(triangles_by_mode(4, 5) == std::vector<Corners>{{0, 1, 2}});
    CHECK(triangles_by_mode(5, 3) == std::vector<Corners>{{0, 1, 2}});
}

TEST_CASE("A strip turns every other triangle round, so that all face the same way") {
    CHECK(triangles_by_mode(5) == std::vector<Corners>{{0, 1, 2}, {1, 3, 2}, {2, 3, 4}, {3, 5, 4}});
}

TEST_CASE("A fan's triangles share its first vertex and their winding") {
    CHECK(triangles_by_mode(6) == std::vector<Corners>{{1, 2, 0}, {2, 3, 0}, {3, 4, 0}, {4, 5, 0}});
}

TEST_CASE("Points and lines have no triangles; a file of nothing else has none") {
    for (const int mode : {0, 1, 2, 3, 7}) {
        CAPTURE(mode);
        GlbBuilder glb;
        const int positions = glb.floats(zigzag(), 3);
        const std::string lines = text(R"({"attributes":{"POSITION":%d},"mode":%d})", positions, mode);
        const std::string triangles = text(R"({"attributes":{"POSITION":%d}})", positions);
        GlbBuilder alone = glb;
        alone.mesh(lines);
        alone.add("nodes", R"({"mesh":0})");
        const ReadModel bare = try_read(alone.glb());
        CHECK(bare.status == TXC_STATUS_NO_TRIANGLES);
        CHECK(bare.detail == "the model's scene has only points and lines, or nothing");
        glb.mesh(lines + "," + triangles);
        glb.add("nodes", R"({"mesh":0})");
        CHECK(read(glb.glb()).mesh.triangles.size() == 2);
    }
}

TEST_CASE("A primitive without positions is not drawn") {
    GlbBuilder glb;
    const int positions = glb.floats(zigzag(), 3);
    glb.mesh(text(R"({"attributes":{"NORMAL":%d}},{"attributes":{"POSITION":%d}})", positions, positions));
    glb.add("nodes", R"({"mesh":0})");
    CHECK(read(glb.glb()).mesh.triangles.size() == 2);
}

TEST_CASE("Interleaved attributes are read by their stride and offset") {
    // Position, normal and UV of one vertex after another, and 4 bytes of something else.
    std::vector<float> mixed;
    for (int i = 0; i < 3; ++i) {
        const auto f = static_cast<float>(i);
        mixed.insert(mixed.end(), {f, f + 0.25f, f * f, 0.0f, 0.0f, 1.0f, f * 0.125f, 1.0f - f * 0.125f, 99.0f});
    }
    GlbBuilder glb;
    const int view = glb.view(mixed.data(), mixed.size() * 4, 36);
    const int positions = glb.accessor(view, kFloat, 3, "VEC3");
    const int normals = glb.accessor(view, kFloat, 3, "VEC3", R"(,"byteOffset":12)");
    const int uvs = glb.accessor(view, kFloat, 3, "VEC2", R"(,"byteOffset":24)");
    const ReadModel model =
        read_primitive(glb, text(R"("POSITION":%d,"NORMAL":%d,"TEXCOORD_0":%d)", positions, normals, uvs));
    for (std::size_t i = 0; i < 3; ++i) {
        const auto f = static_cast<double>(i);
        CHECK(near(model.position(i), f, f + 0.25, f * f, 0));
        CHECK(near(model.mesh.normals.at(i), 0, 0, 1, 0));
        CHECK(near(model.mesh.uvs.at(i), f * 0.125, 1 - f * 0.125, 0));
    }
}

TEST_CASE("Of attributes with a number too many the first ones count, and one too few is refused") {
    // Exporters that know depth in textures write texture coordinates of three numbers; renderers read the first two.
    GlbBuilder glb;
    const int positions = glb.floats({0, 0, 0, 9, 1, 0, 0, 9, 0, 1, 0, 9}, 4);
    const int uvs = glb.floats({0.25f, 0.5f, 9, 0.75f, 0.5f, 9, 0.25f, 1, 9}, 3);
    const ReadModel model = read_primitive(glb, text(R"("POSITION":%d,"TEXCOORD_0":%d)", positions, uvs));
    CHECK(near(model.position(2), 0, 1, 0, 0));
    CHECK(near(model.mesh.uvs.at(1), 0.75, 0.5, 0));
    CHECK(near(model.mesh.uvs.at(2), 0.25, 1, 0));

    GlbBuilder flat;
    const int two = flat.floats({0, 0, 1, 0, 0, 1}, 2);
    flat.mesh(text(R"({"attributes":{"POSITION":%d}})", two));
    flat.add("nodes", R"({"mesh":0})");
    CHECK(try_read(flat.glb()).status == TXC_STATUS_BAD_MODEL);
}

TEST_CASE("Sparse values replace those of the base") {
    for (const int type : {kUnsignedByte, kUnsignedShort, kUnsignedInt}) {
        CAPTURE(type);
        GlbBuilder glb;
        const std::vector<float> base = zigzag();
        const std::vector<float> values{10, 11, 12, 20, 21, 22};
        // 1 and 4 in each width.
        const std::vector<std::uint8_t> places8{1, 4};
        const std::vector<std::uint16_t> places16{1, 4};
        const std::vector<std::uint32_t> places32{1, 4};
        const int base_view = glb.view(base.data(), base.size() * 4);
        const int place_view = type == kUnsignedByte    ? glb.view(places8.data(), 2)
                               : type == kUnsignedShort ? glb.view(places16.data(), 4)
                                                        : glb.view(places32.data(), 8);
        const int value_view = glb.view(values.data(), values.size() * 4);
        const int positions = glb.accessor(
            base_view, kFloat, 6, "VEC3",
            text(R"(,"sparse":{"count":2,"indices":{"bufferView":%d,"componentType":%d},"values":{"bufferView":%d}})",
                 place_view, type, value_view));
        const ReadModel model = read_primitive(glb, text(R"("POSITION":%d)", positions));
        CHECK(near(model.position(0), 0, 0, 0));
        CHECK(near(model.position(1), 10, 11, 12));
        CHECK(near(model.position(4), 20, 21, 22));
        CHECK(near(model.position(5), 5, 1, 0));
    }
}

TEST_CASE("Sparse values without a base lie on zeros") {
    GlbBuilder glb;
    const std::vector<std::uint16_t> places{0, 2};
    const std::vector<float> values{1, 2, 3, 4, 5, 6};
    const int place_view = glb.view(places.data(), 4);
    const int value_view = glb.view(values.data(), 24);
    const int positions = glb.add(
        "accessors",
        text(
            R"({"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":2,"indices":{"bufferView":%d,"componentType":5123},"values":{"bufferView":%d}}})",
            place_view, value_view));
    const ReadModel model = read_primitive(glb, text(R"("POSITION":%d)", positions));
    CHECK(near(model.position(0), 1, 2, 3));
    CHECK(near(model.position(1), 0, 0, 0));
    CHECK(near(model.position(2), 4, 5, 6));
}

TEST_CASE("Sparse values replace those of a list of indices") {
    GlbBuilder glb;
    const int positions = glb.floats(zigzag(), 3);
    const std::vector<std::uint16_t> base{0, 1, 2, 3, 4, 5};
    const std::vector<std::uint8_t> places{1, 2, 3, 5};
    const std::vector<std::uint16_t> values{2, 1, 5, 3};
    const int base_view = glb.view(base.data(), base.size() * 2);
    const int place_view = glb.view(places.data(), places.size());
    const int value_view = glb.view(values.data(), values.size() * 2);
    const int indices = glb.accessor(
        base_view, kUnsignedShort, 6, "SCALAR",
        text(R"(,"sparse":{"count":4,"indices":{"bufferView":%d,"componentType":5121},"values":{"bufferView":%d}})",
             place_view, value_view));
    const ReadModel model = read_primitive(glb, text(R"("POSITION":%d)", positions), text(R"(,"indices":%d)", indices));
    CHECK(triangles_of(model) == std::vector<Corners>{{0, 2, 1}, {5, 4, 3}});
}

TEST_CASE("A list of indices without a base is zeros but for its sparse ones") {
    GlbBuilder glb;
    const int positions = glb.floats(zigzag(), 3);
    const std::vector<std::uint8_t> places{1, 2, 3, 4, 5};
    const std::vector<std::uint16_t> values{1, 2, 3, 4, 5};
    const int place_view = glb.view(places.data(), places.size());
    const int value_view = glb.view(values.data(), values.size() * 2);
    const int indices = glb.add(
        "accessors",
        text(
            R"({"componentType":5123,"count":6,"type":"SCALAR","sparse":{"count":5,"indices":{"bufferView":%d,"componentType":5121},"values":{"bufferView":%d}}})",
            place_view, value_view));
    const ReadModel model = read_primitive(glb, text(R"("POSITION":%d)", positions), text(R"(,"indices":%d)", indices));
    CHECK(triangles_of(model) == std::vector<Corners>{{0, 1, 2}, {3, 4, 5}});
}

TEST_CASE("Normalised integers run from -1 or 0 to 1, plain ones are what they are") {
    const std::string normalized = R"(,"normalized":true)";
    {
        GlbBuilder glb;
        // Padded to 4 bytes a vertex, as the extension for quantised attributes asks.
        const std::vector<std::int8_t> bytes{-128, -127, 0, 0, 127, 64, 1, 0, 0, 0, 127, 0};
        const int view = glb.view(bytes.data(), bytes.size(), 4);
        const int positions = glb.accessor(view, kByte, 3, "VEC3", normalized);
        const std::vector<std::uint8_t> uv_bytes{0, 255, 0, 0, 51, 102, 0, 0, 255, 0, 0, 0};
        const int uvs =
            glb.accessor(glb.view(uv_bytes.data(), uv_bytes.size(), 4), kUnsignedByte, 3, "VEC2", normalized);
        const ReadModel model = read_primitive(glb, text(R"("POSITION":%d,"TEXCOORD_0":%d)", positions, uvs));
        CHECK(near(model.position(0), -1, -1, 0));
        CHECK(near(model.position(1), 1, 64.0 / 127, 1.0 / 127));
        CHECK(near(model.mesh.uvs.at(0), 0, 1));
        CHECK(near(model.mesh.uvs.at(1), 0.2, 0.4));
    }
    {
        GlbBuilder glb;
        const std::vector<std::int16_t> shorts{-32768, 32767, 0, 0, 100, -100, 7, 0, 0, 1, 2, 0};
        const int view = glb.view(shorts.data(), shorts.size() * 2, 8);
        const int positions = glb.accessor(view, kShort, 3, "VEC3");
        const std::vector<std::uint16_t> uv_shorts{0, 65535, 13107, 26214, 65535, 0};
        const int uvs =
            glb.accessor(glb.view(uv_shorts.data(), uv_shorts.size() * 2), kUnsignedShort, 3, "VEC2", normalized);
        const int normals = glb.accessor(view, kShort, 3, "VEC3", normalized);
        const ReadModel model =
            read_primitive(glb, text(R"("POSITION":%d,"NORMAL":%d,"TEXCOORD_0":%d)", positions, normals, uvs));
        CHECK(near(model.position(0), -32768, 32767, 0));
        CHECK(near(model.position(1), 100, -100, 7));
        CHECK(near(model.mesh.normals.at(0), -std::sqrt(0.5), std::sqrt(0.5), 0, 1e-4));
        CHECK(near(model.mesh.uvs.at(1), 0.2, 0.4));
    }
}

TEST_CASE("A file of JSON with its buffer inside reads as the GLB does") {
    const GlbBuilder glb = make_model(make_sphere(1.0, 8, 4));
    const ReadModel binary = read(glb.glb());
    const ReadModel json = read(glb.gltf());
    CHECK(binary.mesh.positions == json.mesh.positions);
    CHECK(binary.mesh.uvs == json.mesh.uvs);
    CHECK(binary.mesh.triangles.size() == json.mesh.triangles.size());
}

TEST_CASE("A file and raw arrays of the same mesh give the same map") {
    const Shape sphere = make_sphere(1.0, 16, 8);
    const ReadModel model = read(make_model(sphere).glb());
    CHECK(model.mesh.positions.size() == sphere.vertex_count());
    std::uint32_t different = 0;
    for (std::size_t v = 0; v < model.mesh.positions.size(); ++v) {
        const float* p = sphere.positions.data() + v * 3;
        different += near(model.position(v), p[0], p[1], p[2], 0) ? 0 : 1;
    }
    CHECK(different == 0);
}
