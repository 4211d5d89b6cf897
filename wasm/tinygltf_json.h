/// The JSON that tinygltf reads, in place of what it would include: RapidJSON's values, from the parser and the memory that
/// the core has for all JSON (json_reader.h, json_memory.h), and of its writer no more than the name. nlohmann/json, which
/// tinygltf takes otherwise, makes the module a sixth larger. Include before tiny_gltf.h.
#pragma once

#include <cstdint>

#include "json_memory.h"
#include "json_reader.h"

// tinygltf says `rapidjson::`, and finds the names below before the library's own.
#define RAPIDJSON_NAMESPACE rapidjson_library
#define RAPIDJSON_NOMEMBERITERATORCLASS
#include <rapidjson/document.h>

namespace rapidjson {

using namespace rapidjson_library;

using Pool = MemoryPoolAllocator<txc::JsonMemory>;
using Value = GenericValue<UTF8<>, Pool>;

/// A document that a text's events build.
class Document : public GenericDocument<UTF8<>, Pool, txc::JsonMemory> {
public:
    Document() = default;
    Document(Document&&) = default;

    /// Null where the text is not whole.
    void Parse(const char* text, std::size_t length) {
        bool is_whole = false;
        const auto build = [&](GenericDocument& document) {
            Builder builder(document);
            is_whole = txc::read_json(text, length, builder).is_whole;
            return is_whole;
        };
        Populate(build);
    }

private:
    class Builder final : public txc::JsonEvents {
    public:
        explicit Builder(GenericDocument& document) : document_(document) {}

        bool Null() override { return document_.Null(); }
        bool Bool(bool value) override { return document_.Bool(value); }
        bool Int(int value) override { return document_.Int(value); }
        bool Uint(unsigned value) override { return document_.Uint(value); }
        bool Int64(std::int64_t value) override { return document_.Int64(value); }
        bool Uint64(std::uint64_t value) override { return document_.Uint64(value); }
        bool Double(double value) override { return document_.Double(value); }
        bool String(const char* letters, unsigned length, bool copy) override {
            return document_.String(letters, length, copy);
        }
        bool StartObject() override { return document_.StartObject(); }
        bool Key(const char* letters, unsigned length, bool copy) override {
            return document_.Key(letters, length, copy);
        }
        bool EndObject(unsigned member_count) override { return document_.EndObject(member_count); }
        bool StartArray() override { return document_.StartArray(); }
        bool EndArray(unsigned element_count) override { return document_.EndArray(element_count); }

    private:
        GenericDocument& document_;
    };
};

/// tinygltf writes JSON where it is asked to keep the words of extras, or to write a file: nobody here does.
struct StringBuffer {
    const char* GetString() const { return ""; }
};
template <typename Buffer>
struct Writer {
    explicit Writer(Buffer&) {}
    bool Null() { return false; }
    bool Bool(bool) { return false; }
    bool Int(int) { return false; }
    bool Uint(unsigned) { return false; }
    bool Int64(std::int64_t) { return false; }
    bool Uint64(std::uint64_t) { return false; }
    bool Double(double) { return false; }
    bool String(const char*, unsigned, bool) { return false; }
    bool StartObject() { return false; }
    bool Key(const char*, unsigned, bool) { return false; }
    bool EndObject(unsigned) { return false; }
    bool StartArray() { return false; }
    bool EndArray(unsigned) { return false; }
};
template <typename Buffer>
struct PrettyWriter : Writer<Buffer> {
    using Writer<Buffer>::Writer;
    void SetIndent(char, unsigned) {}
};

}  // namespace rapidjson
