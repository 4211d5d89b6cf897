// Small glTF files made in code: JSON members as text, and a binary chunk.
#pragma once

#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "shapes.h"

namespace support {

/// printf into a string: JSON with indices in it.
__attribute__((format(printf, 1, 2))) inline std::string text(const char* format, ...) {
    char buffer[4096];
    std::va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(buffer, sizeof buffer, format, arguments);
    va_end(arguments);
    return buffer;
}

enum ComponentType { kByte = 5120, kUnsignedByte, kShort, kUnsignedShort, kUnsignedInt = 5125, kFloat };

class GlbBuilder {
public:
    /// Appends an object to one of the file's lists; returns its index there.
    int add(const char* list, const std::string& object) {
        for (auto& [name, objects] : lists_) {
            if (name != list) continue;
            objects.push_back(object);
            return static_cast<int>(objects.size()) - 1;
        }
        lists_.emplace_back(list, std::vector<std::string>{object});
        return 0;
    }
    /// Sets a top-level member that is no such list, as JSON.
    void set(const char* member, const std::string& json) { members_.emplace_back(member, json); }

    /// Appends bytes, aligned to 4, as a buffer view; a stride of 0 is left out.
    int view(const void* bytes, std::size_t count, int stride = 0) {
        binary_.resize((binary_.size() + 3) / 4 * 4);
        const std::size_t offset = binary_.size();
        const auto* from = static_cast<const std::uint8_t*>(bytes);
        binary_.insert(binary_.end(), from, from + count);
        std::string json = text(R"({"buffer":0,"byteOffset":%zu,"byteLength":%zu)", offset, count);
        if (stride > 0) json += text(R"(,"byteStride":%d)", stride);
        return add("bufferViews", json + "}");
    }
    /// `more` goes into the accessor's object: ,"normalized":true for instance.
    int accessor(int view, int component_type, std::size_t count, const char* type, const std::string& more = "") {
        return add("accessors", text(R"({"bufferView":%d,"componentType":%d,"count":%zu,"type":"%s"%s})", view,
                                     component_type, count, type, more.c_str()));
    }
    int floats(const std::vector<float>& values, int components) {
        static const char* const kTypes[] = {"", "SCALAR", "VEC2", "VEC3", "VEC4"};
        const char* type = components == 16 ? "MAT4" : kTypes[components];
        return accessor(view(values.data(), values.size() * 4), kFloat,
                        values.size() / static_cast<std::size_t>(components), type);
    }
    template <typename Integer>
    int integers(const std::vector<Integer>& values, int component_type, const char* type, int components,
                 const std::string& more = "") {
        return accessor(view(values.data(), values.size() * sizeof(Integer)), component_type,
                        values.size() / static_cast<std::size_t>(components), type, more);
    }

    /// A shape as a primitive's JSON, with 32-bit indices. `more`: ,"material":0 for instance.
    std::string primitive(const Shape& shape, const std::string& more = "") {
        std::string attributes = text(R"("POSITION":%d)", floats(shape.positions, 3));
        if (!shape.normals.empty()) attributes += text(R"(,"NORMAL":%d)", floats(shape.normals, 3));
        if (!shape.uvs.empty()) attributes += text(R"(,"TEXCOORD_0":%d)", floats(shape.uvs, 2));
        const int indices = integers(shape.indices, kUnsignedInt, "SCALAR", 1);
        return text(R"({"attributes":{%s},"indices":%d%s})", attributes.c_str(), indices, more.c_str());
    }
    /// A mesh of one primitive.
    int mesh(const std::string& primitive, const std::string& more = "") {
        return add("meshes", R"({"primitives":[)" + primitive + "]" + more + "}");
    }

    std::vector<std::uint8_t>& binary() { return binary_; }

    std::string json(bool binary_chunk = true) const {
        std::string out = R"({"asset":{"version":"2.0"})";
        for (const auto& [name, objects] : lists_) {
            out += ",\"" + name + "\":[";
            for (std::size_t i = 0; i < objects.size(); ++i) out += (i > 0 ? "," : "") + objects[i];
            out += "]";
        }
        for (const auto& [name, value] : members_) out += ",\"" + name + "\":" + value;
        if (!binary_.empty() && !has("buffers")) {
            const std::string uri = binary_chunk ? "" : ",\"uri\":\"" + data_uri() + "\"";
            out += text(R"(,"buffers":[{"byteLength":%zu)", binary_.size()) + uri + "}]";
        }
        return out + "}";
    }
    std::vector<std::uint8_t> glb() const { return pack(json(), binary_); }
    /// One file of JSON, the buffer inside it as base64.
    std::vector<std::uint8_t> gltf() const {
        const std::string all = json(false);
        return {all.begin(), all.end()};
    }

    /// A GLB of any JSON and binary chunk, valid or not; without a binary chunk where that is empty.
    static std::vector<std::uint8_t> pack(std::string json, std::vector<std::uint8_t> binary) {
        while (json.size() % 4 != 0) json += ' ';
        binary.resize((binary.size() + 3) / 4 * 4);
        std::vector<std::uint8_t> out;
        const std::size_t total = 20 + json.size() + (binary.empty() ? 0 : 8 + binary.size());
        for (const std::size_t word :
             {std::size_t{0x46546C67u}, std::size_t{2}, total, json.size(), std::size_t{0x4E4F534Au}})
            put(out, static_cast<std::uint32_t>(word));
        out.insert(out.end(), json.begin(), json.end());
        if (binary.empty()) return out;
        put(out, static_cast<std::uint32_t>(binary.size()));
        put(out, 0x004E4942u);
        out.insert(out.end(), binary.begin(), binary.end());
        return out;
    }

private:
    static void put(std::vector<std::uint8_t>& out, std::uint32_t word) {
        for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::uint8_t>(word >> shift));
    }
    bool has(const char* member) const {
        for (const auto& entry : members_) {
            if (entry.first == member) return true;
        }
        return false;
    }
    std::string data_uri() const {
        static const char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
        std::string out = "data:application/octet-stream;base64,";
        for (std::size_t i = 0; i < binary_.size(); i += 3) {
            std::uint32_t bits = 0;
            for (std::size_t b = 0; b < 3; ++b) bits = bits << 8 | (i + b < binary_.size() ? binary_[i + b] : 0u);
            for (std::size_t digit = 0; digit < 4; ++digit)
                out += i + digit <= binary_.size() ? kDigits[bits >> (18 - 6 * digit) & 63] : '=';
        }
        return out;
    }

    std::vector<std::pair<std::string, std::vector<std::string>>> lists_;
    std::vector<std::pair<std::string, std::string>> members_;
    std::vector<std::uint8_t> binary_;
};

/// The shape in one node of one scene, with a material of no particular looks. `node`: its JSON.
inline GlbBuilder make_model(const Shape& shape, const std::string& node = R"({"mesh":0})") {
    GlbBuilder glb;
    glb.mesh(glb.primitive(shape, R"(,"material":0)"));
    glb.add("nodes", node);
    glb.add("scenes", R"({"nodes":[0]})");
    glb.add("materials", "{}");
    return glb;
}

}  // namespace support
