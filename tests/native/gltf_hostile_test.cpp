// Files that are broken or mean harm: always a status with a detail, never a crash (run under ASan and UBSan too).
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "support/glb_builder.h"
#include "support/random.h"
#include "support/read_model.h"
#include "support/test_session.h"

using namespace support;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const std::string& letters) { return {letters.begin(), letters.end()}; }

void put_word(Bytes& file, std::size_t at, std::uint32_t word) {
    for (std::size_t b = 0; b < 4; ++b) file[at + b] = static_cast<std::uint8_t>(word >> (8 * b));
}

/// A quad whose POSITION accessor says what the test wants.
Bytes with_positions(const std::string& accessor, std::vector<float> positions = {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
    GlbBuilder glb;
    const int view = glb.view(positions.data(), positions.size() * 4);
    REQUIRE(view == 0);
    glb.add("accessors", accessor);
    glb.mesh(R"({"attributes":{"POSITION":0}})");
    glb.add("nodes", R"({"mesh":0})");
    return glb.glb();
}

/// A triangle with three indices of the test's own.
Bytes with_indices(const std::vector<std::uint32_t>& indices, int component_type, const char* type = "SCALAR",
                   const std::string& more = "") {
    GlbBuilder glb;
    const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
    const int accessor =
        glb.accessor(glb.view(indices.data(), indices.size() * 4), component_type, indices.size(), type, more);
    glb.mesh(text(R"({"attributes":{"POSITION":%d},"indices":%d})", positions, accessor));
    glb.add("nodes", R"({"mesh":0})");
    return glb.glb();
}

void check_refused(const Bytes& file, TxcStatus status, const std::string& detail_part = "") {
    const ReadModel model = try_read(file);
    INFO(model.detail);
    CHECK(model.status == status);
    CHECK_FALSE(model.detail.empty());
    CHECK(model.detail.find(detail_part) != std::string::npos);
}

/// Loads whatever it is and, where that works, bakes and paints it too.
void survive(const Bytes& file) {
    TestSession session(64);
    const TxcStatus status = session.try_load(file);
    const bool said_why = status == TXC_STATUS_OK || txc_error_detail()[0] != '\0';
    CHECK_UNARY(status < TXC_STATUS_COUNT);
    CHECK_UNARY(status != TXC_STATUS_INTERNAL);
    CHECK_UNARY(said_why);
    if (status != TXC_STATUS_OK) return;
    TxcTargetDef target_def;
    txc_target_def_default(&target_def);
    target_def.width = target_def.height = 16;
    TxcTarget target = 0;
    if (txc_target_create(session.id(), &target_def, &target) != TXC_STATUS_OK) return;
    TxcStatus baked = TXC_STATUS_PENDING;
    for (int step = 0; step < 200 && baked == TXC_STATUS_PENDING; ++step)
        baked = txc_target_bake(session.id(), target, 100000, nullptr);
    if (baked != TXC_STATUS_OK) return;
    TxcLayerDef def = decal_def(session.image(make_checker(8, 8, 2)));
    def.occlusion = TXC_OCCLUSION_SELF;
    session.layer(target, def);
    TxcUpdate update{};
    CHECK_UNARY(txc_target_update(session.id(), target, TXC_NONE, &update) == TXC_STATUS_OK);
}

}  // namespace

TEST_CASE("A file cut short at any length is refused") {
    const Bytes file = make_model(make_plane()).glb();
    for (std::size_t length = 0; length < file.size(); ++length) {
        const Bytes part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length));
        const ReadModel model = try_read(part);
        CAPTURE(length);
        CHECK_UNARY(model.status == TXC_STATUS_BAD_MODEL);
        CHECK_UNARY(!model.detail.empty());
    }
}

TEST_CASE("A file cut short behind its header is told how much of it there is") {
    const Bytes file = make_model(make_plane()).glb();
    for (std::size_t length = 20; length < file.size(); ++length) {
        const Bytes part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length));
        const std::string detail = try_read(part).detail;
        CAPTURE(length);
        CAPTURE(detail);
        CHECK_UNARY(detail.find("cut short") != std::string::npos);
        CHECK_UNARY(detail.find(std::to_string(file.size()) + " bytes, there are " + std::to_string(length)) !=
                    std::string::npos);
    }
}

TEST_CASE("A file cut short at any length, whose header owns up to it, is survived") {
    const Bytes file = make_model(make_plane()).glb();
    for (std::size_t length = 20; length < file.size(); ++length) {
        Bytes part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length));
        put_word(part, 8, static_cast<std::uint32_t>(length));
        CAPTURE(length);
        survive(part);
    }
}

TEST_CASE("Any bytes changed at random are survived, through bake and painting") {
    Shape shape = make_plane();
    shape.append(make_plane(0.5, 0.25, {0.25, 0.25, 0.5, 0.5}));
    const Bytes file = make_model(shape).glb();
    Random random(30);
    for (int round = 0; round < 3000; ++round) {
        Bytes changed = file;
        for (std::uint32_t flips = 1 + random.below(3); flips > 0; --flips) {
            const std::uint32_t at = random.below(static_cast<std::uint32_t>(changed.size()));
            changed[at] = random.coin() ? static_cast<std::uint8_t>(random.next())
                                        : static_cast<std::uint8_t>(changed[at] ^ 1u << random.below(8));
        }
        CAPTURE(round);
        survive(changed);
    }
}

TEST_CASE("Random words in the binary chunk are survived, through bake and painting") {
    const GlbBuilder glb = make_model(make_sphere(1.0, 4, 3));
    Random random(31);
    for (int round = 0; round < 300; ++round) {
        GlbBuilder changed = glb;
        for (std::uint32_t words = 1 + random.below(8); words > 0; --words) {
            const std::uint32_t at = random.below(static_cast<std::uint32_t>(changed.binary().size() / 4)) * 4;
            put_word(changed.binary(), at, random.next());
        }
        CAPTURE(round);
        survive(changed.glb());
    }
}

TEST_CASE("Files that are no model are told apart from broken ones") {
    check_refused(bytes_of("These are only some words.\n"), TXC_STATUS_BAD_MODEL, "neither with glTF (a GLB)");
    check_refused(bytes_of("\x89PNG\r\n\x1a\n"), TXC_STATUS_BAD_MODEL, "neither with glTF (a GLB)");
    check_refused(bytes_of("{ \"asset\": "), TXC_STATUS_BAD_MODEL);
    check_refused(bytes_of("{}"), TXC_STATUS_BAD_MODEL);
    check_refused(bytes_of("glTF"), TXC_STATUS_BAD_MODEL, "ends inside the GLB header");
    check_refused(bytes_of("   \n"), TXC_STATUS_BAD_MODEL);
    check_refused(Bytes(1000, 0), TXC_STATUS_BAD_MODEL);
}

TEST_CASE("An empty file is refused") {
    TestSession session;
    const std::uint8_t byte = 0;
    CHECK(txc_model_load_glb(session.id(), &byte, 0) == TXC_STATUS_BAD_MODEL);
}

TEST_CASE("Other versions of glTF are refused by their number") {
    for (const std::uint32_t version : {0u, 1u, 3u, 0x02000000u}) {
        Bytes file = make_model(make_plane()).glb();
        put_word(file, 4, version);
        check_refused(file, TXC_STATUS_BAD_MODEL, "version is " + std::to_string(version));
    }
    check_refused(GlbBuilder::pack(R"({"asset":{"version":"1.0"}})", {}), TXC_STATUS_BAD_MODEL, "1.0");
    check_refused(GlbBuilder::pack(R"({"asset":{}})", {}), TXC_STATUS_BAD_MODEL, "asset");
}

TEST_CASE("Chunks that do not fit the file are refused") {
    const Bytes file = make_model(make_plane()).glb();
    const std::uint32_t json_length = file[12] | file[13] << 8;
    for (const std::uint32_t length :
         {0u, 1u, json_length - 4, json_length + 4, 0x7fffffffu, 0xfffffff0u, 0xffffffffu}) {
        Bytes changed = file;
        put_word(changed, 12, length);
        check_refused(changed, TXC_STATUS_BAD_MODEL);
    }
    const std::size_t binary_header = 20 + json_length;
    const auto binary_length = static_cast<std::uint32_t>(file.size() - binary_header - 8);
    // 8 more than there are is just what a check that forgets the chunk's own header lets through.
    for (const std::uint32_t length : {binary_length + 4, binary_length + 8, 0x7ffffffcu, 0xfffffffcu}) {
        CAPTURE(length);
        Bytes changed = file;
        put_word(changed, binary_header, length);
        check_refused(changed, TXC_STATUS_BAD_MODEL);
    }
    Bytes other_kind = file;
    put_word(other_kind, binary_header + 4, 0x12345678u);
    check_refused(other_kind, TXC_STATUS_BAD_MODEL);
    Bytes json_elsewhere = file;
    put_word(json_elsewhere, 16, 0x004E4942u);
    check_refused(json_elsewhere, TXC_STATUS_BAD_MODEL);
}

TEST_CASE("A buffer longer than its chunk is refused, even by as little as the chunk's header") {
    const GlbBuilder glb = make_model(make_plane());
    for (const int more : {1, 4, 8, 1000000}) {
        GlbBuilder changed = glb;
        changed.set("buffers",
                    text(R"([{"byteLength":%zu}])", changed.binary().size() + static_cast<std::size_t>(more)));
        CAPTURE(more);
        check_refused(changed.glb(), TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("Accessors beyond their buffer view are refused") {
    const char* const accessors[] = {
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})",
        R"({"bufferView":0,"byteOffset":4,"componentType":5126,"count":3,"type":"VEC3"})",
        R"({"bufferView":0,"byteOffset":36,"componentType":5126,"count":1,"type":"VEC3"})",
        R"({"bufferView":0,"byteOffset":4294967292,"componentType":5126,"count":1,"type":"VEC3"})",
        R"({"bufferView":0,"byteOffset":18446744073709551612,"componentType":5126,"count":1,"type":"VEC3"})",
        R"({"bufferView":1,"componentType":5126,"count":3,"type":"VEC3"})",
        R"({"bufferView":2147483647,"componentType":5126,"count":3,"type":"VEC3"})",
    };
    for (const char* accessor : accessors) check_refused(with_positions(accessor), TXC_STATUS_BAD_MODEL);
}

TEST_CASE("Counts that overflow an address are refused before anything is allocated") {
    for (const std::string count :
         {"4294967295", "4294967296", "4294967299", "1431655766", "1537228672809129302", "4611686018427387904",
          "6148914691236517206", "9223372036854775807", "18446744073709551615"}) {
        CAPTURE(count);
        for (const std::string view : {R"("bufferView":0,)", ""}) {
            const ReadModel model = try_read(
                with_positions("{" + view + R"("componentType":5126,"count":)" + count + R"(,"type":"VEC3"})"));
            CHECK_UNARY((model.status == TXC_STATUS_BAD_MODEL || model.status == TXC_STATUS_OUT_OF_BUDGET));
            CHECK_UNARY(!model.detail.empty());
        }
        GlbBuilder glb;
        const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
        const int indices =
            glb.add("accessors", R"({"bufferView":0,"componentType":5125,"count":)" + count + R"(,"type":"SCALAR"})");
        glb.mesh(text(R"({"attributes":{"POSITION":%d},"indices":%d})", positions, indices));
        glb.add("nodes", R"({"mesh":0})");
        const ReadModel model = try_read(glb.glb());
        CHECK_UNARY((model.status == TXC_STATUS_BAD_MODEL || model.status == TXC_STATUS_OUT_OF_BUDGET));
    }
}

TEST_CASE("An accessor without data is all zeros, as many as the budget holds") {
    // Each of these takes 33 bytes a vertex; five pass a budget of 16 MiB.
    std::string primitives;
    GlbBuilder glb;
    const int zeros = glb.add("accessors", R"({"componentType":5126,"count":120000,"type":"VEC3"})");
    for (int i = 0; i < 5; ++i) primitives += text(R"(%s{"attributes":{"POSITION":%d}})", i > 0 ? "," : "", zeros);
    glb.mesh(primitives);
    glb.add("nodes", R"({"mesh":0})");
    CHECK(try_read(glb.glb(), 16u << 20).status == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(try_read(glb.glb(), 64u << 20).status == TXC_STATUS_OK);
}

TEST_CASE("A mesh of many empty parts in many places is refused, and not gone through") {
    std::string parts;
    for (int i = 0; i < 1100; ++i) parts += i > 0 ? R"(,{"attributes":{}})" : R"({"attributes":{}})";
    GlbBuilder glb;
    glb.mesh(parts);
    for (int i = 0; i < 1000; ++i) glb.add("nodes", R"({"mesh":0})");
    const ReadModel model = try_read(glb.glb());
    CHECK(model.status == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(model.detail == "nodes[953]: up to it, the meshes' parts are in 1049400 places");
}

TEST_CASE("Buffer views beyond their buffer are refused") {
    for (const std::string view :
         {R"({"buffer":0,"byteLength":37})", R"({"buffer":0,"byteOffset":4,"byteLength":36})",
          R"({"buffer":0,"byteOffset":18446744073709551615,"byteLength":36})",
          R"({"buffer":0,"byteLength":18446744073709551615})", R"({"buffer":1,"byteLength":36})",
          R"({"buffer":-1,"byteLength":36})", R"({"buffer":0,"byteLength":36,"byteStride":8})",
          R"({"buffer":0,"byteLength":36,"byteStride":4000000000})"}) {
        CAPTURE(view);
        GlbBuilder glb;
        glb.binary().resize(36);
        glb.add("bufferViews", view);
        glb.add("accessors", R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})");
        glb.mesh(R"({"attributes":{"POSITION":0}})");
        glb.add("nodes", R"({"mesh":0})");
        check_refused(glb.glb(), TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("Sparse values that do not fit are refused") {
    const std::string good_values = R"("values":{"bufferView":0})";
    const char* const sparse[] = {
        R"("count":4,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0})",
        R"("count":-1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0})",
        R"("count":2,"indices":{"bufferView":9,"componentType":5121},"values":{"bufferView":0})",
        R"("count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":-2})",
        R"("count":2,"indices":{"bufferView":1,"byteOffset":-1,"componentType":5121},"values":{"bufferView":0})",
        R"("count":2,"indices":{"bufferView":1,"componentType":5126},"values":{"bufferView":0})",
        R"("count":2,"indices":{"bufferView":1,"componentType":7},"values":{"bufferView":0})",
        R"("count":1,"indices":{"bufferView":1,"componentType":5125},"values":{"bufferView":0})",
        R"("count":3,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0})",
    };
    for (const char* members : sparse) {
        CAPTURE(std::string(members));
        GlbBuilder glb;
        const std::vector<float> positions(9, 0.0f);
        const Bytes places{0, 1, 200, 0};
        glb.view(positions.data(), 36);
        glb.view(places.data(), 4);
        glb.add("accessors",
                text(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{%s}})", members));
        glb.mesh(R"({"attributes":{"POSITION":0}})");
        glb.add("nodes", R"({"mesh":0})");
        check_refused(glb.glb(), TXC_STATUS_BAD_MODEL, "accessors[0]");
    }
}

TEST_CASE("Attributes of another type or length than their use asks for are refused") {
    check_refused(with_positions(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})"),
                  TXC_STATUS_BAD_MODEL);
    check_refused(with_positions(R"({"bufferView":0,"componentType":5130,"count":1,"type":"VEC3"})"),
                  TXC_STATUS_BAD_MODEL);
    check_refused(with_positions(R"({"bufferView":0,"componentType":99,"count":1,"type":"VEC3"})"),
                  TXC_STATUS_BAD_MODEL);
    for (const std::string attribute : {"NORMAL", "TEXCOORD_0"}) {
        CAPTURE(attribute);
        GlbBuilder glb;
        const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
        const int shorter = attribute == "NORMAL" ? glb.floats({0, 0, 1}, 3) : glb.floats({0, 0}, 2);
        glb.mesh(text(R"({"attributes":{"POSITION":%d,"%s":%d}})", positions, attribute.c_str(), shorter));
        glb.add("nodes", R"({"mesh":0})");
        check_refused(glb.glb(), TXC_STATUS_BAD_MODEL, attribute.substr(0, 6));
    }
}

TEST_CASE("Positions that are not finite are named") {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                            -std::numeric_limits<float>::infinity(), 1e13f}) {
        check_refused(with_positions(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})",
                                     {0, 0, 0, 1, bad, 0, 0, 1, 0}),
                      TXC_STATUS_BAD_GEOMETRY, "position 1 is");
    }
}

TEST_CASE("A node's place that is beyond all numbers is a typed error") {
    for (const std::string node : {R"({"mesh":0,"scale":[1e300,1,1]})", R"({"mesh":0,"translation":[1e39,0,0]})",
                                   R"({"mesh":0,"matrix":[1e308,0,0,0,0,1e308,0,0,0,0,1e308,0,1e308,0,0,1]})"}) {
        CAPTURE(node);
        GlbBuilder glb;
        glb.mesh(glb.primitive(make_plane()));
        glb.add("nodes", node);
        check_refused(glb.glb(), TXC_STATUS_BAD_GEOMETRY);
    }
}

TEST_CASE("UVs that are not finite, or far out of range, make the material unpaintable but not the model") {
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e6f}) {
        Shape plane = make_plane();
        plane.uvs[3] = bad;
        TestSession session;
        session.load(make_model(plane).glb());
        CHECK(session.material_info().paint_status == TXC_STATUS_BAD_UVS);
        TxcTargetDef def;
        txc_target_def_default(&def);
        TxcTarget target = 0;
        CHECK(txc_target_create(session.id(), &def, &target) == TXC_STATUS_BAD_UVS);
    }
}

TEST_CASE("Indices beyond the vertices are named, and so is the primitive") {
    check_refused(with_indices({0, 1, 3}, kUnsignedInt), TXC_STATUS_BAD_GEOMETRY,
                  "meshes[0].primitives[0]: index 2 is 3, but there are only 3 vertices");
    check_refused(with_indices({0, 1, 0xffffffffu}, kUnsignedInt), TXC_STATUS_BAD_GEOMETRY);
}

TEST_CASE("Indices of a signed, broken or vector type are refused") {
    for (const int type : {int{kByte}, int{kShort}, int{kFloat}, 5124, 5130, 0, -1})
        check_refused(with_indices({0, 1, 2}, type), TXC_STATUS_BAD_MODEL);
    check_refused(with_indices({0, 1, 2, 0, 1, 2, 0, 1, 2}, kUnsignedInt, "VEC3"), TXC_STATUS_BAD_MODEL);
}

TEST_CASE("Indices that nothing in the file says are refused") {
    GlbBuilder glb;
    const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
    const int indices = glb.add("accessors", R"({"componentType":5123,"count":3,"type":"SCALAR"})");
    glb.mesh(text(R"({"attributes":{"POSITION":%d},"indices":%d})", positions, indices));
    glb.add("nodes", R"({"mesh":0})");
    check_refused(glb.glb(), TXC_STATUS_BAD_MODEL, "accessors[1]: indices without a bufferView");
}

TEST_CASE("References to objects that are not there are refused") {
    const std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
    struct Case {
        const char* nodes;
        const char* scenes;
        const char* primitive;
        const char* more;
    };
    const Case cases[] = {
        {R"([{"mesh":1}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})", ""},
        {R"([{"mesh":0}])", R"([{"nodes":[1]}])", R"({"attributes":{"POSITION":0}})", ""},
        {R"([{"mesh":0}])", R"([{"nodes":[-1]}])", R"({"attributes":{"POSITION":0}})", ""},
        {R"([{"mesh":0,"children":[7]}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})", ""},
        {R"([{"mesh":0,"children":[-1]}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})", ""},
        {R"([{"mesh":0,"skin":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})", ""},
        {R"([{"mesh":0,"skin":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})",
         R"(,"skins":[{"joints":[4]}])"},
        {R"([{"mesh":0,"skin":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})",
         R"(,"skins":[{"joints":[0],"inverseBindMatrices":9}])"},
        {R"([{"mesh":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":5}})", ""},
        {R"([{"mesh":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0,"NORMAL":5}})", ""},
        {R"([{"mesh":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0},"indices":5})", ""},
        {R"([{"mesh":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0},"material":2})", ""},
        {R"([{"mesh":0}])", R"([{"nodes":[0]}])", R"({"attributes":{"POSITION":0}})", R"(,"scene":3)"},
        {R"([{"mesh":0,"weights":[1]}])", R"([{"nodes":[0]}])",
         R"({"attributes":{"POSITION":0},"targets":[{"POSITION":6}]})", ""},
    };
    for (const Case& c : cases) {
        const std::string json = text(
            R"({"asset":{"version":"2.0"},"nodes":%s,"scenes":%s,"meshes":[{"primitives":[%s]}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36}]%s})",
            c.nodes, c.scenes, c.primitive, c.more);
        CAPTURE(json);
        check_refused(GlbBuilder::pack(json, Bytes(36, 0)), TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("Nodes in a ring, and nodes with two parents, are refused") {
    const auto with_nodes = [](std::initializer_list<const char*> nodes, const char* scene) {
        GlbBuilder glb = make_model(make_plane());
        for (const char* node : nodes) glb.add("nodes", node);
        glb.add("scenes", scene);
        glb.set("scene", "1");
        return glb.glb();
    };
    check_refused(with_nodes({R"({"children":[1]})"}, R"({"nodes":[1]})"), TXC_STATUS_BAD_MODEL, "its own ancestor");
    check_refused(with_nodes({R"({"children":[2]})", R"({"children":[3]})", R"({"children":[1]})"}, R"({"nodes":[2]})"),
                  TXC_STATUS_BAD_MODEL, "its own ancestor");
    check_refused(with_nodes({R"({"children":[3]})", R"({"children":[3]})", "{}"}, R"({"nodes":[1]})"),
                  TXC_STATUS_BAD_MODEL, "nodes[3] has two parents");
    check_refused(with_nodes({R"({"children":[2,2]})", "{}"}, R"({"nodes":[1]})"), TXC_STATUS_BAD_MODEL, "two parents");
}

TEST_CASE("A ring that the scene does not use does no harm") {
    GlbBuilder glb = make_model(make_plane());
    glb.add("nodes", R"({"children":[2]})");
    glb.add("nodes", R"({"children":[1]})");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_OK);
}

TEST_CASE("A long chain whose every node the scene names is read in no time") {
    GlbBuilder glb;
    glb.mesh(glb.primitive(make_plane()));
    const int count = 20000;
    std::string roots;
    for (int n = 0; n + 1 < count; ++n) glb.add("nodes", text(R"({"children":[%d]})", n + 1));
    glb.add("nodes", R"({"mesh":0})");
    for (int n = count; n-- > 0;) roots += text("%d%s", n, n > 0 ? "," : "");
    glb.add("scenes", R"({"nodes":[)" + roots + "]}");
    CHECK(read(glb.glb()).mesh.triangles.size() == 2);
}

TEST_CASE("A model without triangles says so") {
    check_refused(GlbBuilder::pack(R"({"asset":{"version":"2.0"}})", {}), TXC_STATUS_NO_TRIANGLES);
    GlbBuilder empty = make_model(make_plane());
    empty.add("scenes", R"({"nodes":[]})");
    empty.set("scene", "1");
    check_refused(empty.glb(), TXC_STATUS_NO_TRIANGLES);
}

TEST_CASE("A failed load leaves the model before it as it was") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    CHECK(session.try_load(bytes_of("nonsense")) == TXC_STATUS_BAD_MODEL);
    CHECK(session.model_info().triangle_count == 2);
    CHECK(session.map_info(target).covered_texels == 256);
}
