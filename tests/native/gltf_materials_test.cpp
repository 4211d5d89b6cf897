// What a material says of its texture: UV set, transform, picture, colour (spec section 1, "Paint target").
#include <doctest/doctest.h>

#include <cmath>

#include "support/glb_builder.h"
#include "support/read_model.h"
#include "support/test_session.h"

using namespace support;

namespace {

/// A plane with two UV sets (the second is the first, halved) and a material of the test's own with one texture.
GlbBuilder with_material(const std::string& material) {
    GlbBuilder glb;
    const Shape plane = make_plane();
    std::vector<float> second = plane.uvs;
    for (float& uv : second) uv *= 0.5f;
    glb.mesh(text(R"({"attributes":{"POSITION":%d,"TEXCOORD_0":%d,"TEXCOORD_1":%d},"indices":%d,"material":0})",
                  glb.floats(plane.positions, 3), glb.floats(plane.uvs, 2), glb.floats(second, 2),
                  glb.integers(plane.indices, kUnsignedInt, "SCALAR", 1)));
    glb.add("nodes", R"({"mesh":0})");
    glb.add("materials", material);
    glb.add("textures", R"({"source":1,"sampler":0})");
    glb.add("samplers", R"({"magFilter":9728})");
    glb.add("images", R"({"uri":"a.png"})");
    glb.add("images", R"({"uri":"b.png"})");
    return glb;
}

std::string base_texture(const char* more) {
    return text(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0%s}}})", more);
}

}  // namespace

TEST_CASE("A material without a texture paints on the first UV set") {
    const ReadModel model = read(with_material("{}").glb());
    const txc::Material& material = model.mesh.materials.at(0);
    CHECK(material.tex_coord == 0);
    CHECK(material.image == TXC_NONE);
    CHECK_FALSE(material.nearest_filter);
    CHECK(near(model.mesh.uvs.at(3), 1, 1));
}

TEST_CASE("The base colour texture names the UV set") {
    const ReadModel model = read(with_material(base_texture(R"(,"texCoord":1)")).glb());
    const txc::Material& material = model.mesh.materials.at(0);
    CHECK(material.tex_coord == 1);
    CHECK(material.image == 1);
    CHECK(material.nearest_filter);
    CHECK(near(model.mesh.uvs.at(3), 0.5, 0.5));
}

TEST_CASE(
    "A texture transform that is none refuses the model by its material: painted without it, all would lie elsewhere") {
    for (const char* transform :
         {R"("scale":["a",1])", R"("scale":[1])", R"("scale":2)", R"("offset":[0,null])", R"("offset":{"x":1})",
          R"("rotation":"90")", R"("rotation":[1])", R"("texCoord":true)"}) {
        const ReadModel model = try_read(
            with_material(base_texture(text(R"(,"extensions":{"KHR_texture_transform":{%s}})", transform).c_str()))
                .glb());
        CAPTURE(std::string(transform));
        CHECK(model.status == TXC_STATUS_BAD_MODEL);
        CHECK(model.detail == "materials[0]: KHR_texture_transform");
    }
}

TEST_CASE("A material whose UV set the mesh does not have cannot be painted") {
    TestSession session;
    session.load(with_material(base_texture(R"(,"texCoord":2)")).glb());
    CHECK(session.material_info().paint_status == TXC_STATUS_NO_UVS);
    CHECK(std::string(txc_error_detail()).find("TEXCOORD_2") != std::string::npos);
    TxcTargetDef def;
    txc_target_def_default(&def);
    TxcTarget target = 0;
    CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_NO_UVS);
}

TEST_CASE("A texture transform scales first, then turns counter-clockwise as seen with v down, then moves") {
    const double angle = 0.6435011087932844;  // cosine 0.8, sine 0.6
    const ReadModel model = read(
        with_material(
            base_texture(
                text(R"(,"extensions":{"KHR_texture_transform":{"offset":[0.25,-0.5],"rotation":%.17g,"scale":[2,3]}})",
                     angle)
                    .c_str()))
            .glb());
    const double corners[4][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    for (std::size_t i = 0; i < 4; ++i) {
        const double u = corners[i][0] * 2;
        const double v = corners[i][1] * 3;
        CHECK(near(model.mesh.uvs.at(i), 0.8 * u + 0.6 * v + 0.25, -0.6 * u + 0.8 * v - 0.5));
    }
}

TEST_CASE("A texture transform may name another UV set than the texture does") {
    const ReadModel model = read(
        with_material(
            base_texture(R"(,"texCoord":0,"extensions":{"KHR_texture_transform":{"texCoord":1,"offset":[0.5,0]}})"))
            .glb());
    CHECK(model.mesh.materials.at(0).tex_coord == 1);
    CHECK(near(model.mesh.uvs.at(3), 1.0, 0.5));
}

TEST_CASE("A required texture transform is known") {
    GlbBuilder glb = with_material(base_texture(R"(,"extensions":{"KHR_texture_transform":{"scale":[0.5,0.5]}})"));
    glb.set("extensionsUsed", R"(["KHR_texture_transform"])");
    glb.set("extensionsRequired", R"(["KHR_texture_transform"])");
    CHECK(near(read(glb.glb()).mesh.uvs.at(3), 0.5, 0.5));
}

TEST_CASE("Extensions of looks may be required; one that changes geometry is refused by name") {
    for (const std::string known :
         {"KHR_materials_unlit", "KHR_mesh_quantization", "EXT_texture_webp", "KHR_lights_punctual"}) {
        CAPTURE(known);
        GlbBuilder glb = with_material("{}");
        glb.set("extensionsRequired", text(R"(["%s"])", known.c_str()));
        CHECK(try_read(glb.glb()).status == TXC_STATUS_OK);
    }
    for (const std::string unknown :
         {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "EXT_mesh_gpu_instancing", "ACME"}) {
        GlbBuilder glb = with_material("{}");
        glb.set("extensionsRequired", text(R"(["%s"])", unknown.c_str()));
        const ReadModel model = try_read(glb.glb());
        CHECK(model.status == TXC_STATUS_UNSUPPORTED_MODEL);
        CHECK(model.detail.find(unknown) != std::string::npos);
    }
}

TEST_CASE("A picture in a WebP extension is found") {
    GlbBuilder glb = make_model(make_plane());
    glb.add("materials", base_texture(""));
    glb.add("textures", R"({"extensions":{"EXT_texture_webp":{"source":1}}})");
    glb.add("images", R"({"uri":"a.png"})");
    glb.add("images", R"({"uri":"b.webp"})");
    CHECK(read(glb.glb()).mesh.materials.at(1).image == 1);
}

TEST_CASE("A base colour texture that the file does not have is an error where something wears the material") {
    for (const bool worn : {true, false}) {
        CAPTURE(worn);
        GlbBuilder glb;
        glb.mesh(glb.primitive(make_plane(), worn ? R"(,"material":0)" : ""));
        glb.add("nodes", R"({"mesh":0})");
        glb.add("materials", R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":7}}})");
        CHECK(try_read(glb.glb()).status == (worn ? TXC_STATUS_BAD_MODEL : TXC_STATUS_OK));
    }
}

TEST_CASE("A base colour texture without an index is refused by its path, whatever an extension calls so") {
    const auto status_of = [](const char* material) {
        GlbBuilder glb = make_model(make_plane());
        glb.add("textures", "{}");
        glb.add("materials", material);
        return try_read(glb.glb());
    };
    for (const std::string texture : {"{}", R"({"texCoord":0})", R"({"extensions":{"A":{"index":0}}})"}) {
        CAPTURE(texture);
        const ReadModel model =
            status_of(text(R"({"pbrMetallicRoughness":{"baseColorTexture":%s}})", texture.c_str()).c_str());
        CHECK(model.status == TXC_STATUS_BAD_MODEL);
        CHECK(model.detail.find("materials[1].pbrMetallicRoughness.baseColorTexture has no index") !=
              std::string::npos);
    }
    CHECK(status_of(R"({"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}})").status == TXC_STATUS_OK);
    CHECK(status_of(R"({"extensions":{"A":{"baseColorTexture":{}}}})").status == TXC_STATUS_OK);
}

TEST_CASE("A picture that the file does not have is no picture") {
    for (const std::string texture : {R"({"source":9})", R"({"extensions":{"EXT_texture_webp":{"source":9}}})",
                                      R"({"extensions":{"EXT_texture_webp":{"source":"x"}}})"}) {
        CAPTURE(texture);
        GlbBuilder glb = make_model(make_plane());
        glb.add("materials", base_texture(""));
        glb.add("textures", texture);
        CHECK(read(glb.glb()).mesh.materials.at(1).image == TXC_NONE);
    }
}

TEST_CASE("Primitives without a material make one more after the last") {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_plane(), R"(,"material":1)") + "," + glb.primitive(make_plane()));
    glb.add("nodes", R"({"mesh":0})");
    glb.add("materials", "{}");
    glb.add("materials", "{}");
    const ReadModel model = read(glb.glb());
    CHECK(model.mesh.has_default_material);
    REQUIRE(model.mesh.materials.size() == 3);
    CHECK(model.mesh.materials[0].triangles.empty());
    CHECK(model.mesh.materials[1].triangles == std::vector<std::uint32_t>{0, 1});
    CHECK(model.mesh.materials[2].triangles == std::vector<std::uint32_t>{2, 3});
}

TEST_CASE("Where every primitive has a material there is no default one") {
    TestSession session;
    session.load(make_model(make_plane()).glb());
    const TxcModelInfo info = session.model_info();
    CHECK(info.material_count == 1);
    CHECK(info.has_default_material == 0);
    CHECK(info.triangle_count == 2);
    CHECK(info.vertex_count == 4);
}

TEST_CASE("A material that no triangle uses cannot be painted, and says so") {
    GlbBuilder glb = make_model(make_plane());
    glb.add("materials", "{}");
    TestSession session;
    session.load(glb.glb());
    CHECK(session.material_info(1).paint_status == TXC_STATUS_NO_TRIANGLES);
    CHECK(session.material_info(1).triangle_count == 0);
    TxcMaterialInfo info{};
    CHECK(txc_material_info(session.id(), 2, &info) == TXC_STATUS_NO_MATERIAL);
}

TEST_CASE("A material's counts tell of UVs outside the texture") {
    Shape shape = make_plane(1.0, 0.0, {-0.5, 0.0, 0.5, 1.0});
    shape.append(make_plane());
    TestSession session;
    session.load(make_model(shape).glb());
    const TxcMaterialInfo info = session.material_info();
    CHECK(info.paint_status == TXC_STATUS_OK);
    CHECK(info.triangle_count == 4);
    CHECK(info.out_of_range_uv_triangles == 2);
    CHECK(info.degenerate_uv_triangles == 0);
    CHECK(info.uv_min[0] == -0.5f);
    CHECK(info.uv_max[0] == 1.0f);
}

TEST_CASE("The UV triangles come out as the reader placed them") {
    TestSession session;
    session.load(with_material(base_texture(R"(,"texCoord":1)")).glb());
    std::vector<float> uvs(12, -1.0f);
    must(txc_material_uvs(session.id(), 0, uvs.data(), 2));
    CHECK(uvs == std::vector<float>{0, 0, 0, 0.5f, 0.5f, 0, 0.5f, 0, 0, 0.5f, 0.5f, 0.5f});
    CHECK(txc_material_uvs(session.id(), 0, uvs.data(), 1) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_material_uvs(session.id(), 1, uvs.data(), 2) == TXC_STATUS_NO_MATERIAL);
}

TEST_CASE("The base colour factor is read as it stands in the file") {
    const ReadModel model =
        read(with_material(R"({"pbrMetallicRoughness":{"baseColorFactor":[0.25,0.5,0.75,0.125]}})").glb());
    CHECK(model.mesh.materials.at(0).base_color_factor == glm::vec4(0.25f, 0.5f, 0.75f, 0.125f));
}

TEST_CASE("A material whose triangles all lie on points or lines of the texture owns no texel, and cannot be painted") {
    // As models do that take each part's colour from one pixel of a palette.
    GlbBuilder glb;
    const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0}, 3);
    const auto status_with = [&](const std::vector<float>& uvs) {
        GlbBuilder one = glb;
        const int set = one.floats(uvs, 2);
        const int indices = one.integers(std::vector<std::uint8_t>{0, 1, 2, 2, 1, 3}, kUnsignedByte, "SCALAR", 1);
        one.mesh(text(R"({"attributes":{"POSITION":%d,"TEXCOORD_0":%d},"indices":%d})", positions, set, indices));
        one.add("nodes", R"({"mesh":0})");
        const ReadModel model = read(one.glb());
        return model.mesh.materials.at(0).paint_status(0);
    };
    CHECK(status_with({0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f, 0.5f}) == TXC_STATUS_BAD_UVS);
    CHECK(status_with({0.25f, 0.5f, 0.5f, 0.5f, 0.75f, 0.5f, 1, 0.5f}) == TXC_STATUS_BAD_UVS);
    CHECK(status_with({0, 0, 1, 0, 0, 1, 0, 1}) == TXC_STATUS_OK);
}
