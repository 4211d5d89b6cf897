// Which nodes a model is gathered from, and where they put it (spec section 1).
#include <doctest/doctest.h>

#include <cmath>

#include "support/glb_builder.h"
#include "support/read_model.h"

using namespace support;

namespace {

/// One triangle at (1, 2, 3), (2, 2, 3), (1, 3, 3), facing +Z.
Shape make_corner(bool with_normals = false) {
    Shape shape;
    shape.add_vertex(1, 2, 3, 0, 1);
    shape.add_vertex(2, 2, 3, 1, 1);
    shape.add_vertex(1, 3, 3, 0, 0);
    if (with_normals) {
        for (int i = 0; i < 3; ++i) shape.add_normal(0, 0, 1);
    }
    shape.add_triangle(0, 1, 2);
    return shape;
}

/// The corner in nodes and scenes of the test's own.
GlbBuilder with_nodes(std::initializer_list<const char*> nodes, const char* scene = R"({"nodes":[0]})",
                      bool with_normals = false) {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_corner(with_normals)));
    for (const char* node : nodes) glb.add("nodes", node);
    if (scene != nullptr) glb.add("scenes", scene);
    return glb;
}

}  // namespace

TEST_CASE("A node scales first, then turns, then moves") {
    // Scale (2, 3, 4), a quarter turn about Z, then (10, 20, 30).
    const GlbBuilder glb = with_nodes(
        {R"({"mesh":0,"translation":[10,20,30],"rotation":[0,0,0.70710678118654752,0.70710678118654752],"scale":[2,3,4]})"});
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(0), 10 - 6, 20 + 2, 30 + 12));
    CHECK(near(model.position(1), 10 - 6, 20 + 4, 30 + 12));
    CHECK(near(model.position(2), 10 - 9, 20 + 2, 30 + 12));
}

TEST_CASE("A rotation that is no unit quaternion is refused by its node, one that is off by rounding is read") {
    for (const std::string rotation : {"0,0,0,2", "0,0,0,0", "0,0,0,0.99", "0.5,0.5,0.5,0.52"}) {
        CAPTURE(rotation);
        const ReadModel model = try_read(
            with_nodes({R"({"children":[1]})", text(R"({"mesh":0,"rotation":[%s]})", rotation.c_str()).c_str()}).glb());
        CHECK(model.status == TXC_STATUS_BAD_MODEL);
        CHECK(model.detail.find("nodes[1].rotation is no unit quaternion") != std::string::npos);
    }
    for (const std::string rotation : {"0,0,0,1.005", "0,0,0,-0.995", "0.707,0,0,0.707", "0.5,0.5,-0.5,0.503"}) {
        CAPTURE(rotation);
        CHECK(try_read(with_nodes({text(R"({"mesh":0,"rotation":[%s]})", rotation.c_str()).c_str()}).glb()).status ==
              TXC_STATUS_OK);
    }
}

TEST_CASE("A zero is one with any exponent, and with any number of decimals") {
    for (const std::string zero :
         {"0e23", "0e30", "0E+100", "0e308", "0.000e40", "-0e30", "0e-25", "0.00000000000000000000000"}) {
        CAPTURE(zero);
        const ReadModel model =
            try_read(with_nodes({text(R"({"mesh":0,"translation":[4,%s,0]})", zero.c_str()).c_str()}).glb());
        REQUIRE(model.status == TXC_STATUS_OK);
        CHECK(near(model.position(0), 5, 2, 3));
    }
}

TEST_CASE("A node's matrix is read column by column") {
    const GlbBuilder glb = with_nodes({R"({"mesh":0,"matrix":[0,1,0,0, -1,0,0,0, 0,0,1,0, 5,6,7,1]})"});
    CHECK(near(read(glb.glb()).position(0), 5 - 2, 6 + 1, 7 + 3));
}

TEST_CASE("A child is placed within its parents, however deep") {
    const GlbBuilder glb = with_nodes({R"({"children":[1],"translation":[100,0,0]})",
                                       R"({"children":[2],"scale":[2,2,2]})", R"({"mesh":0,"translation":[0,0,1]})"});
    CHECK(near(read(glb.glb()).position(0), 102, 4, 8));
}

TEST_CASE("A chain of ten thousand nodes is followed to its end") {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_corner()));
    for (int n = 0; n < 9999; ++n) glb.add("nodes", text(R"({"children":[%d],"translation":[0.125,0,0]})", n + 1));
    glb.add("nodes", R"({"mesh":0})");
    glb.add("scenes", R"({"nodes":[0]})");
    CHECK(near(read(glb.glb()).position(0), 1 + 9999 * 0.125, 2, 3, 1e-3));
}

TEST_CASE("A mesh that two nodes use is there twice") {
    const GlbBuilder glb = with_nodes({R"({"mesh":0})", R"({"mesh":0,"translation":[0,0,5]})"}, R"({"nodes":[0,1]})");
    const ReadModel model = read(glb.glb());
    REQUIRE(model.mesh.triangles.size() == 2);
    CHECK(near(model.position(0), 1, 2, 3));
    CHECK(near(model.position(3), 1, 2, 8));
}

TEST_CASE("A node that the scene names twice, or as a child too, is there once") {
    const GlbBuilder twice = with_nodes({R"({"mesh":0})"}, R"({"nodes":[0,0]})");
    CHECK(read(twice.glb()).mesh.triangles.size() == 1);
    const GlbBuilder child = with_nodes({R"({"children":[1]})", R"({"mesh":0})"}, R"({"nodes":[1,0]})");
    CHECK(read(child.glb()).mesh.triangles.size() == 1);
}

TEST_CASE("The file's own scene is the one that is read") {
    GlbBuilder glb = with_nodes({R"({"mesh":0})", R"({"mesh":0,"translation":[0,0,5]})"});
    glb.add("scenes", R"({"nodes":[1]})");
    CHECK(near(read(glb.glb()).position(0), 1, 2, 3));  // none named: the first
    glb.set("scene", "1");
    const ReadModel second = read(glb.glb());
    CHECK(second.mesh.triangles.size() == 1);
    CHECK(near(second.position(0), 1, 2, 8));
}

TEST_CASE("Without scenes every node without a parent is read, and what hangs on it") {
    const GlbBuilder glb = with_nodes(
        {R"({"mesh":0})", R"({"children":[2],"translation":[0,0,1]})", R"({"mesh":0,"translation":[0,0,1]})"}, nullptr);
    const ReadModel model = read(glb.glb());
    REQUIRE(model.mesh.triangles.size() == 2);
    CHECK(near(model.position(3), 1, 2, 5));
}

TEST_CASE("A mirrored node keeps its fronts in front and its normals outward") {
    for (const bool with_normals : {false, true}) {
        CAPTURE(with_normals);
        const GlbBuilder glb = with_nodes({R"({"mesh":0,"scale":[-1,1,1]})"}, R"({"nodes":[0]})", with_normals);
        const ReadModel model = read(glb.glb());
        CHECK(near(model.position(0), -1, 2, 3));
        CHECK(near(model.mesh.flat_normal(model.mesh.triangles.at(0)), 0, 0, 1));
        if (with_normals) CHECK(near(model.mesh.normals.at(0), 0, 0, 1));
    }
}

TEST_CASE("Two mirrorings make none") {
    const GlbBuilder glb = with_nodes({R"({"children":[1],"scale":[1,-1,1]})", R"({"mesh":0,"scale":[-1,1,1]})"});
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(0), -1, -2, 3));
    CHECK(near(model.mesh.flat_normal(model.mesh.triangles.at(0)), 0, 0, 1));
}

TEST_CASE("A mirrored closed shape has all its normals outward after the bake too") {
    for (const std::string scale : {"[1,1,1]", "[-1,1,1]", "[1,-2,1]", "[-1,-1,-3]"}) {
        CAPTURE(scale);
        for (const bool flat : {false, true}) {
            Shape sphere = make_sphere(1.0, 16, 8);
            if (flat) sphere.normals.clear();
            GlbBuilder glb;
            glb.mesh(glb.primitive(sphere));
            glb.add("nodes", text(R"({"mesh":0,"scale":%s})", scale.c_str()));
            glb.add("scenes", R"({"nodes":[0]})");
            const ReadModel model = read(glb.glb());
            std::uint32_t inward = 0;
            for (const txc::Triangle& triangle : model.mesh.triangles) {
                const glm::vec3 middle = model.position(triangle.vertex[0]) + model.position(triangle.vertex[1]) +
                                         model.position(triangle.vertex[2]);
                const glm::vec3 a = model.position(triangle.vertex[1]) - model.position(triangle.vertex[0]);
                const glm::vec3 b = model.position(triangle.vertex[2]) - model.position(triangle.vertex[0]);
                if (glm::length(glm::cross(a, b)) < 1e-6f) continue;  // at the poles
                inward += glm::dot(model.mesh.flat_normal(triangle), middle) <= 0.0f ? 1 : 0;
                if (flat) continue;
                for (const std::uint32_t v : triangle.vertex)
                    inward += glm::dot(model.mesh.normals.at(v), model.position(v)) <= 0.0f ? 1 : 0;
            }
            CHECK(inward == 0);
        }
    }
}

TEST_CASE("Uneven scale tilts normals as the surface tilts") {
    // The plane x + y = 0 with normal (1, 1, 0), squeezed along x: the normal turns towards x.
    Shape shape = make_corner();
    shape.positions = {0, 0, 0, 1, -1, 0, 0, 0, 1};
    const auto half = static_cast<float>(std::sqrt(0.5));
    for (int i = 0; i < 3; ++i) shape.normals.insert(shape.normals.end(), {half, half, 0.0f});
    GlbBuilder glb;
    glb.mesh(glb.primitive(shape));
    glb.add("nodes", R"({"mesh":0,"scale":[0.25,1,1]})");
    const ReadModel model = read(glb.glb());
    const double length = std::sqrt(17.0);
    CHECK(near(model.mesh.normals.at(0), 4 / length, 1 / length, 0));
}

TEST_CASE("A node flattened to a plane keeps usable normals") {
    const GlbBuilder glb = with_nodes({R"({"mesh":0,"scale":[1,1,0]})"}, R"({"nodes":[0]})", true);
    const ReadModel model = read(glb.glb());
    CHECK(near(model.position(0), 1, 2, 0));
    CHECK(near(model.mesh.normals.at(0), 0, 0, 1));
}

TEST_CASE("The model's and the material's bounds are those of the placed triangles") {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_corner(), R"(,"material":0)"));
    glb.mesh(glb.primitive(make_corner(), R"(,"material":1)"));
    glb.add("nodes", R"({"mesh":0})");
    glb.add("nodes", R"({"mesh":1,"translation":[10,0,0]})");
    glb.add("materials", "{}");
    glb.add("materials", "{}");
    const ReadModel model = read(glb.glb());
    CHECK(near(model.mesh.bounds.min, 1, 2, 3));
    CHECK(near(model.mesh.bounds.max, 12, 3, 3));
    CHECK(near(model.mesh.materials.at(1).bounds.min, 11, 2, 3));
    CHECK(near(model.mesh.materials.at(1).bounds.max, 12, 3, 3));
}
