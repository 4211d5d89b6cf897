// JSON that says something else than glTF asks for. The parser behind the reader aborts where a program that may throw
// would throw: no text may get it there.
#include <doctest/doctest.h>

#include "support/glb_builder.h"
#include "support/json_spans.h"
#include "support/read_model.h"

using namespace support;

namespace {

using Bytes = std::vector<std::uint8_t>;

/// A small model that uses every member that the reader or its parser knows.
GlbBuilder make_everything() {
    GlbBuilder glb;
    const int positions = glb.floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
    const int normals = glb.floats({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    const int uvs = glb.floats({0, 0, 1, 0, 0, 1}, 2);
    const int indices = glb.integers(std::vector<std::uint16_t>{0, 1, 2}, kUnsignedShort, "SCALAR", 1);
    const int joints = glb.integers(Bytes(12, 0), kUnsignedByte, "VEC4", 4);
    const int weights = glb.floats({1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}, 4);
    const int bind = glb.floats({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}, 16);
    const Bytes places{0, 0, 1, 0};
    const int place_view = glb.view(places.data(), 4);
    const std::vector<float> moves{0, 0, 1, 0, 0, 1};
    const int move_view = glb.view(moves.data(), 24);
    const int delta = glb.add(
        "accessors",
        text(
            R"({"componentType":5126,"normalized":false,"count":3,"type":"VEC3","min":[0,0,0],"max":[0,0,1],"name":"d","sparse":{"count":2,"indices":{"bufferView":%d,"byteOffset":0,"componentType":5123},"values":{"bufferView":%d,"byteOffset":0}}})",
            place_view, move_view));
    glb.mesh(
        text(
            R"({"attributes":{"POSITION":%d,"NORMAL":%d,"TEXCOORD_0":%d,"JOINTS_0":%d,"WEIGHTS_0":%d},"indices":%d,"material":0,"mode":4,"targets":[{"POSITION":%d}],"extras":{"a":[1,"b",null]},"extensions":{"X":{"y":1.5}}})",
            positions, normals, uvs, joints, weights, indices, delta),
        R"(,"weights":[0.5],"name":"m")");
    glb.add("nodes", R"({"mesh":0,"skin":0,"weights":[0.25],"name":"n","camera":0,"children":[1]})");
    glb.add("nodes", R"({"translation":[1,2,3],"rotation":[0,0,0,1],"scale":[1,1,1]})");
    glb.add("nodes",
            R"({"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],"extensions":{"KHR_lights_punctual":{"light":0}}})");
    glb.add("scenes", R"({"nodes":[0,2],"name":"s"})");
    glb.set("scene", "0");
    glb.add("skins", text(R"({"joints":[1],"skeleton":1,"inverseBindMatrices":%d})", bind));
    glb.add(
        "materials",
        R"({"name":"x","doubleSided":true,"alphaMode":"MASK","alphaCutoff":0.5,"emissiveFactor":[0,0,0],"pbrMetallicRoughness":{"baseColorFactor":[1,1,1,1],"metallicFactor":0,"roughnessFactor":1,"baseColorTexture":{"index":0,"texCoord":0,"extensions":{"KHR_texture_transform":{"offset":[0,0],"rotation":0.5,"scale":[1,1],"texCoord":0}}},"metallicRoughnessTexture":{"index":0}},"normalTexture":{"index":0,"scale":1},"occlusionTexture":{"index":0,"strength":1},"emissiveTexture":{"index":0},"extensions":{"KHR_materials_unlit":{}}})");
    glb.add("textures", R"({"source":0,"sampler":0,"extensions":{"EXT_texture_webp":{"source":1}}})");
    glb.add("samplers", R"({"magFilter":9728,"minFilter":9729,"wrapS":10497,"wrapT":33071})");
    glb.add("images", text(R"({"bufferView":%d,"mimeType":"image/png","name":"i"})", place_view));
    glb.add("images", R"({"uri":"data:image/png;base64,AAAA"})");
    glb.add("images", R"({"uri":"a%20b.png"})");
    glb.add("cameras", R"({"type":"perspective","perspective":{"yfov":1,"znear":0.1,"zfar":10,"aspectRatio":1}})");
    glb.add("cameras", R"({"type":"orthographic","orthographic":{"xmag":1,"ymag":1,"znear":0.1,"zfar":10}})");
    glb.add(
        "animations",
        text(
            R"({"name":"w","channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],"samplers":[{"input":%d,"output":%d,"interpolation":"LINEAR"}]})",
            uvs, positions));
    glb.set("extensionsUsed", R"(["KHR_texture_transform"])");
    glb.set("extensionsRequired", R"(["KHR_texture_transform"])");
    glb.set(
        "extensions",
        R"({"KHR_lights_punctual":{"lights":[{"type":"spot","color":[1,1,1],"intensity":1,"range":5,"spot":{"innerConeAngle":0,"outerConeAngle":1}}]}})");
    glb.set("extras", R"({"deep":{"er":[[1],{"x":true}]}})");
    glb.set("buffers", text(R"([{"byteLength":%zu,"name":"b"}])", glb.binary().size()));
    return glb;
}

/// The text with another in place of what it has once or first.
std::string with_other(const std::string& text, const std::string& part, const std::string& other) {
    const std::size_t at = text.find(part);
    REQUIRE(at != std::string::npos);
    return text.substr(0, at) + other + text.substr(at + part.size());
}

/// Any status will do as long as it is one; a model that was read must be whole.
void check_survived(const ReadModel& model) {
    if (model.status != TXC_STATUS_OK) {
        CHECK_UNARY(model.status < TXC_STATUS_COUNT);
        CHECK_UNARY(model.status != TXC_STATUS_INTERNAL);
        CHECK_UNARY(!model.detail.empty());
        return;
    }
    CHECK_UNARY(!model.mesh.triangles.empty());
    for (const txc::Triangle& triangle : model.mesh.triangles) {
        for (const std::uint32_t v : triangle.vertex) CHECK_UNARY(v < model.mesh.positions.size());
    }
    for (const txc::Material& material : model.mesh.materials)
        CHECK_UNARY((material.image == TXC_NONE || material.image < 4));
}

}  // namespace

TEST_CASE("The model of every member is read") {
    const ReadModel model = read(make_everything().glb());
    CHECK(model.mesh.triangles.size() == 1);
    CHECK(near(model.position(0), 1, 2, 3.25));
}

TEST_CASE("Any value may be of any other type") {
    const GlbBuilder glb = make_everything();
    const std::string json = glb.json();
    GlbBuilder copy = glb;
    const Bytes binary = copy.binary();
    const char* const others[] = {"null",
                                  "true",
                                  "-1",
                                  "0",
                                  "7",
                                  "0.5",
                                  "1e300",
                                  "4294967295",
                                  "-9223372036854775808",
                                  "18446744073709551615",
                                  "\"\"",
                                  "\"x\"",
                                  "[]",
                                  "{}",
                                  "[[]]",
                                  "[null]",
                                  "[{}]",
                                  "{\"a\":{}}",
                                  "[-1]",
                                  "[\"x\"]",
                                  "[0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0]"};
    const JsonSpans spans(json);
    CHECK(spans.all().size() > 300);
    for (const JsonSpan& span : spans.all()) {
        for (const char* other : others) {
            const std::string changed = json.substr(0, span.begin) + other + json.substr(span.end);
            CAPTURE(changed);
            check_survived(try_read(GlbBuilder::pack(changed, binary)));
        }
    }
}

TEST_CASE("Any member may be missing") {
    GlbBuilder glb = make_everything();
    const std::string json = glb.json();
    const JsonSpans spans(json);
    for (const JsonSpan& span : spans.all()) {
        if (span.member_begin == 0) continue;
        std::size_t begin = span.member_begin;
        std::size_t end = span.end;
        if (json[end] == ',')
            ++end;
        else if (json[begin - 1] == ',')
            --begin;
        const std::string changed = json.substr(0, begin) + json.substr(end);
        CAPTURE(changed);
        check_survived(try_read(GlbBuilder::pack(changed, glb.binary())));
        // The same as a file of JSON, whose buffer has no address then.
        check_survived(try_read(Bytes(changed.begin(), changed.end())));
    }
}

TEST_CASE("A member that is there twice is refused by name") {
    GlbBuilder glb = make_everything();
    const std::string json = glb.json();
    const JsonSpans spans(json);
    for (const JsonSpan& span : spans.all()) {
        if (span.member_begin == 0 || span.member_begin == span.begin) continue;  // an element of a list
        const std::string member = json.substr(span.member_begin, span.end - span.member_begin);
        const std::string changed = json.substr(0, span.end) + "," + member + json.substr(span.end);
        CAPTURE(changed);
        const ReadModel model = try_read(GlbBuilder::pack(changed, glb.binary()));
        CHECK(model.status == TXC_STATUS_BAD_MODEL);
        CHECK_UNARY(model.detail.find("twice in one object") != std::string::npos);
    }
}

TEST_CASE("A negative number that tinygltf cuts down to another is refused or unused, never read") {
    GlbBuilder glb = make_model(make_plane());
    const int view = glb.add("bufferViews", R"({"buffer":-0,"byteOffset":4000000000,"byteLength":4})");
    glb.add("images", text(R"({"bufferView":%lld,"mimeType":"image/png"})", view - 4294967296ll));
    CHECK(try_read(glb.glb()).status == TXC_STATUS_BAD_MODEL);
}

TEST_CASE("An address that begins with a zero letter is none") {
    GlbBuilder glb = make_model(make_plane());
    glb.set("buffers", R"([{"byteLength":144},{"byteLength":144,"uri":"\u0000x"}])");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_BAD_MODEL);
}

TEST_CASE("A text cut short anywhere is survived") {
    GlbBuilder glb = make_everything();
    const std::string json = glb.json();
    for (std::size_t length = 0; length < json.size(); length += 3) {
        const std::string part = json.substr(0, length);
        CAPTURE(length);
        CHECK_UNARY(try_read(GlbBuilder::pack(part, glb.binary())).status == TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("Nesting a hundred thousand deep is refused before the parser follows it down") {
    const std::size_t deep = 100000;
    for (const auto& [open, close] :
         {std::pair<std::string, std::string>{"[", "]"}, {"{\"a\":", "}"}, {"[{\"a\":", "}]"}}) {
        std::string nested;
        for (std::size_t i = 0; i < deep; ++i) nested += open;
        const std::string opened = nested;
        nested += "1";
        for (std::size_t i = 0; i < deep; ++i) nested += close;
        for (const std::string& json : {R"({"asset":{"version":"2.0"},"extras":)" + nested + "}",
                                        R"({"asset":{"version":"2.0"},"extras":)" + opened, nested}) {
            const ReadModel model = try_read(GlbBuilder::pack(json, {}));
            CHECK(model.status == TXC_STATUS_BAD_MODEL);
            const ReadModel bare = try_read(Bytes(json.begin(), json.end()));
            CHECK(bare.status == TXC_STATUS_BAD_MODEL);
        }
    }
}

TEST_CASE("Braces inside strings are not nesting") {
    GlbBuilder glb = make_model(make_plane());
    glb.set("extras", "\"" + std::string(5000, '{') + "\\\"" + std::string(5000, '[') + "\"");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_OK);
}

TEST_CASE("Texts that are not quite JSON are refused") {
    for (const std::string json :
         {"", " ", "[", "nul", "{\"asset\":{\"version\":\"2.0\"},}", "{\"a\":01}", "{\"a\":1e999}",
          "{\"a\":\"\\ud800\"}", "{\"a\":\"\xff\xfe\"}", "{\"a\":NaN}", "{'a':1}", "{\"a\":1}}", "{\"a\":\"\n\"}",
          "{\"a\":1} trailing", "[]", "\"text\"", "17"}) {
        CAPTURE(json);
        CHECK(try_read(GlbBuilder::pack(json, {})).status == TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("A buffer of no bytes, or one more without an address, is refused") {
    for (const std::string buffers :
         {R"([{"byteLength":0}])", R"([{"byteLength":144},{"byteLength":144}])", R"([{}])", R"([null])",
          R"([{"byteLength":-1}])", R"([{"byteLength":144,"uri":"other.bin"}])",
          R"([{"byteLength":144,"uri":"data:application/octet-stream;base64,"}])",
          R"([{"byteLength":18446744073709551615,"uri":"data:application/octet-stream;base64,AAAA"}])"}) {
        CAPTURE(buffers);
        GlbBuilder glb = make_model(make_plane());
        REQUIRE(glb.binary().size() >= 144);
        glb.set("buffers", buffers);
        CHECK(try_read(glb.glb()).status == TXC_STATUS_BAD_MODEL);
    }
}

TEST_CASE("Many copies of the binary chunk do not fill the memory") {
    GlbBuilder glb = make_model(make_plane());
    glb.binary().resize(1u << 20);
    std::string buffers = "[";
    for (int i = 0; i < 4000; ++i) buffers += text(R"(%s{"byteLength":%d})", i > 0 ? "," : "", 1 << 20);
    glb.set("buffers", buffers + "]");
    CHECK(try_read(glb.glb()).status != TXC_STATUS_OK);
}

TEST_CASE("Many empty objects do not fill the memory") {
    // Three bytes of text each; the parser makes a kilobyte of it.
    for (const std::string list : {"nodes", "materials", "meshes", "animations", "textures", "cameras"}) {
        CAPTURE(list);
        std::string objects;
        for (int i = 0; i < 100000; ++i) objects += i > 0 ? ",{}" : "{}";
        const std::string json = R"({"asset":{"version":"2.0"},")" + list + "\":[" + objects + "]}";
        CHECK(try_read(GlbBuilder::pack(json, {}), 16u << 20).status == TXC_STATUS_OUT_OF_BUDGET);
    }
    std::string numbers;
    for (int i = 0; i < 200000; ++i) numbers += i > 0 ? ",0" : "0";
    const std::string json = R"({"asset":{"version":"2.0"},"extras":[)" + numbers + "]}";
    CHECK(try_read(GlbBuilder::pack(json, {}), 16u << 20).status == TXC_STATUS_OUT_OF_BUDGET);
}

TEST_CASE("An image that points outside every buffer is refused or unused, never read") {
    for (const std::string view : {R"({"buffer":0,"byteOffset":4000000000,"byteLength":4})",
                                   R"({"buffer":0,"byteOffset":18446744073709551615,"byteLength":4})",
                                   R"({"buffer":7,"byteLength":4})", R"({"buffer":-1,"byteLength":4})"}) {
        CAPTURE(view);
        GlbBuilder glb = make_model(make_plane());
        const int index = glb.add("bufferViews", view);
        glb.add("images", text(R"({"bufferView":%d,"mimeType":"image/png"})", index));
        check_survived(try_read(glb.glb()));
    }
    GlbBuilder glb = make_model(make_plane());
    glb.add("images", R"({"bufferView":-5,"mimeType":"image/png"})");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_BAD_MODEL);
}

TEST_CASE("A member that says where triangles lie is refused by its path where glTF asks for another kind of value") {
    GlbBuilder glb = make_everything();
    const std::string json = glb.json();
    struct Fault {
        const char* member;
        const char* instead;
        const char* said;
    };
    const Fault faults[] = {
        {R"("byteOffset":0)", R"("byteOffset":-4)", ".byteOffset is -4; glTF asks for a whole number from 0"},
        {R"("byteOffset":0)", R"("byteOffset":"4")", R"(.byteOffset is "4"; glTF asks for a whole number from 0)"},
        {R"("byteOffset":0)", R"("byteOffset":0.5)", ".byteOffset is 0.5; glTF asks for a whole number from 0"},
        {R"("normalized":false)", R"("normalized":"yes")", R"(.normalized is "yes"; glTF asks for true or false)"},
        {R"("normalized":false)", R"("normalized":0)", ".normalized is 0; glTF asks for true or false"},
        {R"("count":2)", R"("count":null)", ".sparse.count is null; glTF asks for a whole number from 0"},
        {R"("count":2)", R"("count":4294967296)", ".sparse.count is 4.29497e+09; glTF asks for less than 4 GiB"},
        {R"("mesh":0)", R"("mesh":"0")", R"(nodes[0].mesh is "0"; glTF asks for a whole number from 0)"},
        {R"("mesh":0)", R"("mesh":4294967296)", "nodes[0].mesh is 4.29497e+09; glTF asks for a whole number from 0"},
        {R"("skin":0)", R"("skin":-1)", "nodes[0].skin is -1; glTF asks for a whole number from 0"},
        {R"("children":[1])", R"("children":"1")", R"(nodes[0].children is "1"; glTF asks for a list)"},
        {R"("children":[1])", R"("children":[true])",
         "nodes[0].children[0] is true or false; glTF asks for a whole number from 0"},
        {R"("weights":[0.25])", R"("weights":[0.25,{}])", "nodes[0].weights[1] is an object; glTF asks for a number"},
        {R"("translation":[1,2,3])", R"("translation":[1,2])", "nodes[1].translation has 2 elements; glTF asks for 3"},
        {R"("translation":[1,2,3])", R"("translation":[1,2,"3"])",
         R"(nodes[1].translation[2] is "3"; glTF asks for a number)"},
        {R"("rotation":[0,0,0,1])", R"("rotation":[0,0,0,1,0])", "nodes[1].rotation has 5 elements; glTF asks for 4"},
        {R"("scale":[1,1,1])", R"("scale":2)", "nodes[1].scale is 2; glTF asks for a list"},
        {R"("matrix":[1,)", R"("matrix":[1,0,)", "nodes[2].matrix has 17 elements; glTF asks for 16"},
        {R"("joints":[1])", R"("joints":[-1])", "skins[0].joints[0] is -1; glTF asks for a whole number from 0"},
        {R"("mode":4)", R"("mode":"TRIANGLES")",
         R"(meshes[0].primitives[0].mode is "TRIANGLES"; glTF asks for a whole number from 0)"},
        {R"("POSITION":0)", R"("POSITION":[0])",
         "meshes[0].primitives[0].attributes.POSITION is a list; glTF asks for a whole number from 0"},
        {R"("source":0)", R"("source":-1)", "textures[0].source is -1; glTF asks for a whole number from 0"},
        {R"("targets":[{"POSITION":)", R"("targets":[{"NORMAL":"x","POSITION":)",
         R"(meshes[0].primitives[0].targets[0].NORMAL is "x"; glTF asks for a whole number from 0)"},
        {R"("targets":[{)", R"("targets":[1,{)", "meshes[0].primitives[0].targets[0] is 1; glTF asks for an object"},
        {R"("indices":3,"material")", R"("indices":{},"material")",
         "meshes[0].primitives[0].indices is an object; glTF asks for a whole number from 0"},
        {R"("baseColorFactor":[1,1,1,1])", R"("baseColorFactor":[1,1])",
         "materials[0].pbrMetallicRoughness.baseColorFactor has 2 elements; glTF asks for 4"},
        {R"("scene":0)", R"("scene":"first")", R"(scene is "first"; glTF asks for a whole number from 0)"},
    };
    for (const Fault& fault : faults) {
        CAPTURE(fault.instead);
        const std::string changed = with_other(json, fault.member, fault.instead);
        const ReadModel model = try_read(GlbBuilder::pack(changed, glb.binary()));
        CHECK(model.status == TXC_STATUS_BAD_MODEL);
        CAPTURE(model.detail);
        CHECK_UNARY(model.detail.find(fault.said) != std::string::npos);
    }
}

TEST_CASE("A number that is no count and no size may be 4 billion and more") {
    GlbBuilder glb = make_model(make_plane());
    glb.add("nodes", R"({"translation":[5000000000,0,0]})");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_OK);
}

TEST_CASE("What extras and extensions hold may be of any kind, whatever it is called") {
    GlbBuilder glb = make_model(make_plane());
    const std::string odd = R"({"mesh":"none","byteOffset":-4,"children":7,"scale":[1],"attributes":{"POSITION":"x"}})";
    glb.set("extras", odd);
    glb.set("extensions", "{\"ANY_one\":" + odd + "}");
    glb.add("textures", "{\"extras\":" + odd + "}");
    CHECK(try_read(glb.glb()).status == TXC_STATUS_OK);
}

TEST_CASE("Members of the file that glTF 2.0 does not have may hold anything, as what glTF 1.0 left behind does") {
    GlbBuilder glb = make_model(make_plane());
    glb.set("techniques", R"([{"attributes":{"a_normal":"normal"},"parameters":{"light":{"count":-1}},"source":"x"}])");
    glb.set("source", R"("a scan")");
    glb.set("index", "null");
    const std::string json = with_other(glb.json(), R"("version":"2.0")", R"("version":"2.0","source":"a scan")");
    CHECK(try_read(GlbBuilder::pack(json, glb.binary())).status == TXC_STATUS_OK);
}

TEST_CASE("A model that needs a later version of glTF is refused by that version") {
    GlbBuilder glb = make_model(make_plane());
    const auto with = [&](const char* version) {
        return GlbBuilder::pack(with_other(glb.json(), R"("version":"2.0")", version), glb.binary());
    };
    CHECK(try_read(with(R"("version":"2.1","minVersion":"2.0")")).status == TXC_STATUS_OK);
    const ReadModel model = try_read(with(R"("version":"2.1","minVersion":"2.1")"));
    CHECK(model.status == TXC_STATUS_BAD_MODEL);
    CHECK_UNARY(model.detail.find("asset.minVersion is \"2.1\"; only glTF 2.0 is read") != std::string::npos);
}
