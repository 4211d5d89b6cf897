#include "gltf_container.h"

#include <cmath>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "detail_words.h"
#include "json_reader.h"

namespace txc {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67u;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534Au;  // "JSON"
constexpr double kMostBytes = 4294967295.0;        // of a GLB; a count or size above it can only be a lie
constexpr std::size_t kMaxJsonDepth = 256;         // parsers of nested values recurse; no real model is so deep
constexpr std::uint64_t kMostIndex = 0x7fffffffu;  // as an int has it
constexpr std::uint64_t kBudgetStep = 64u << 10;   // the share grows by so much at a time

// What one JSON value becomes in tinygltf's model, bytes, with room for its arrays' growth. Measured on 64-bit: a material
// takes 2144, a camera 920, a node 456 and other objects up to 424; a value inside extras or extensions takes 152.
constexpr std::uint64_t kMaterialBytes = 6500;
constexpr std::uint64_t kObjectBytes = 1400;
constexpr std::uint64_t kFreeValueBytes = 256;
constexpr std::uint64_t kValueBytes = 48;

std::uint32_t read_u32(const std::uint8_t* bytes) {
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
           static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

/// The file's parts, inside it. `binary` is null where there is no such chunk.
struct Chunks {
    const std::uint8_t* json = nullptr;
    std::uint32_t json_length = 0;
    std::uint32_t binary_length = 0;
};

TxcStatus find_chunks(const std::uint8_t* bytes, std::uint32_t byte_count, Chunks& out) {
    if (byte_count < 20)
        return fail(TXC_STATUS_BAD_MODEL, "the file ends inside the GLB header (%u bytes)", byte_count);
    const std::uint32_t version = read_u32(bytes + 4);
    if (version != 2) return fail(TXC_STATUS_BAD_MODEL, "the GLB's version is %u; only glTF 2.0 is read", version);
    const std::uint32_t length = read_u32(bytes + 8);
    if (length > byte_count) {
        return fail(TXC_STATUS_BAD_MODEL, "the file is cut short: its header says %u bytes, there are %u", length,
                    byte_count);
    }
    const std::uint32_t json_length = read_u32(bytes + 12);
    if (read_u32(bytes + 16) != kJsonChunk || json_length > length || length < 20 || json_length > length - 20) {
        return fail(TXC_STATUS_BAD_MODEL, "the GLB's first chunk is not a JSON chunk inside the file (length %u)",
                    json_length);
    }
    out.json = bytes + 20;
    out.json_length = json_length;
    const std::uint32_t rest = length - 20 - json_length;
    if (rest == 0) return TXC_STATUS_OK;
    const std::uint32_t binary_length = rest >= 8 ? read_u32(out.json + json_length) : 0;
    if (rest < 8 || binary_length > rest - 8) {
        return fail(TXC_STATUS_BAD_MODEL, "the GLB's second chunk is not inside the file (length %u of %u bytes)",
                    binary_length, rest);
    }
    out.binary_length = binary_length;
    return TXC_STATUS_OK;
}

// Kinds of values; for numbers, those that the higher ones include.
constexpr char kIndex = '1';   // a whole number from 0 that an int holds
constexpr char kSize = '2';    // any whole number from 0
constexpr char kNumber = '3';  // any
constexpr char kBool = 'b';
constexpr char kText = 's';
constexpr char kList = 'l';
constexpr char kObject = 'o';
constexpr char kNull = 'z';

/// How far the square of a quaternion's length may be from 1: a length off by 0.0077, which is what components in bytes come to,
/// and what glTF's validator lets pass.
constexpr double kUnitSlack = 0.0154;

/// The members that say which triangles there are, where they lie and what they wear, and what glTF 2.0 asks of them:
/// tinygltf passes over one of another kind as if it were not there. Each as its kind, or its elements'; how many elements
/// its list has (blank: it is no list; '.': any number; else counted from '0'); the depth at which it stands, from 1 for the
/// file's own members ('0': wherever it does below them); and its name. An object that is in no list has an index, which glTF
/// requires.
constexpr char kMemberRules[] =
    "1 0bufferView\0"
    "1 0buffer\0"
    "2 0byteOffset\0"
    "2 0byteLength\0"
    "2 0byteStride\0"
    "1 0componentType\0"
    "2 0count\0"
    "b 0normalized\0"
    "1 0mesh\0"
    "1 0skin\0"
    "1 0material\0"
    "1 5indices\0"
    "1 0mode\0"
    "1 0index\0"
    "1 0texCoord\0"
    "1 0source\0"
    "1 1scene\0"
    "1 0inverseBindMatrices\0"
    "o.1accessors\0"
    "o.1bufferViews\0"
    "o.1buffers\0"
    "o.1images\0"
    "o.1materials\0"
    "o.1meshes\0"
    "o.1nodes\0"
    "o.1scenes\0"
    "o.1skins\0"
    "o.1textures\0"
    "1.3nodes\0"
    "1.3children\0"
    "1.3joints\0"
    "3.3weights\0"
    "333translation\0"
    "343rotation\0"
    "333scale\0"
    "3@3matrix\0"
    "o.3primitives\0"
    "o.5targets\0"
    "o 4baseColorTexture\0"
    "344baseColorFactor\0"
    "s.1extensionsRequired\0";

const char* words_for(char kind) {
    switch (kind) {
        case kIndex:
        case kSize:
            return "a whole number from 0";
        case kNumber:
            return "a number";
        case kBool:
            return "true or false";
        case kText:
            return "a text";
        case kList:
            return "a list";
        case kObject:
            return "an object";
        default:
            return "null";
    }
}

/// Follows the JSON text from value to value without keeping it.
class DocumentCheck final : public JsonEvents {
public:
    DocumentCheck(bool glb, BudgetShare& share) : glb_(glb), share_(share), charged_(share.bytes()) {}

    TxcStatus status() const { return status_; }

    bool Null() override { return take_value(kNull); }
    bool Bool(bool) override { return take_value(kBool); }
    bool Int(int value) override { return Int64(value); }
    bool Uint(unsigned value) override { return Uint64(value); }
    bool Int64(std::int64_t value) override {
        if (value < 0) return Double(static_cast<double>(value));
        return Uint64(static_cast<std::uint64_t>(value));
    }
    bool Uint64(std::uint64_t value) override {
        return take_value(value <= kMostIndex ? kIndex : kSize, nullptr, static_cast<double>(value));
    }
    bool Double(double value) override { return take_value(kNumber, nullptr, value); }
    bool String(const char* letters, unsigned, bool) override { return take_value(kText, letters); }
    bool StartObject() override { return open(false); }
    bool EndObject(unsigned) override { return close(); }
    bool StartArray() override { return open(true); }
    bool EndArray(unsigned) override { return close(); }
    bool Key(const char* letters, unsigned length, bool) override {
        Level& object = levels_.back();
        object.key.assign(letters, length);
        // glTF forbids it, and of two values one parser takes the first, another the last.
        if (object.keys[object.key]++ > 0) {
            return stop(fail(TXC_STATUS_BAD_MODEL, "the JSON has the member %.40s twice in one object", letters));
        }
        return true;
    }

    /// The checks that need the whole document.
    TxcStatus check_lists() const {
        for (std::size_t b = 0; b < buffers_.size() && glb_; ++b) {
            if (buffers_[b].has_uri) continue;
            if (b > 0)
                return fail(TXC_STATUS_BAD_MODEL, "buffers[%zu] has no uri; only the first is the GLB's own chunk", b);
            if (buffers_[b].byte_length == 0) return fail(TXC_STATUS_BAD_MODEL, "buffers[0].byteLength is 0");
        }
        for (std::size_t i = 0; i < images_.size(); ++i) {
            if (images_[i] < 0 || static_cast<std::size_t>(images_[i]) >= views_.size()) continue;
            const View& view = views_[static_cast<std::size_t>(images_[i])];
            if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= buffers_.size()) continue;
            if (view.byte_offset >= buffers_[static_cast<std::size_t>(view.buffer)].byte_length) {
                return fail(TXC_STATUS_BAD_MODEL, "images[%zu]: bufferViews[%d] begins behind the end of its buffer", i,
                            images_[i]);
            }
        }
        return TXC_STATUS_OK;
    }

private:
    struct Level {
        bool is_array;
        std::string key;                  // of the member under way, in an object
        std::map<std::string, int> keys;  // of all its members so far
        std::uint32_t index = 0;          // of the element under way, in an array
        const char* rule = nullptr;       // from kMemberRules
        double square = 0.0;              // the sum of its numbers' squares
    };
    struct Buffer {
        std::uint64_t byte_length = 0;
        bool has_uri = false;
    };
    struct View {
        int buffer = -1;
        std::uint64_t byte_offset = 0;
    };

    bool stop(TxcStatus status) {
        status_ = status;
        return false;
    }

    bool charge(std::uint64_t bytes) {
        charged_ += bytes;
        if (charged_ <= share_.bytes()) return true;
        const TxcStatus status = share_.resize(charged_ + kBudgetStep, "reading the model");
        return status == TXC_STATUS_OK || stop(status);
    }

    /// In an element of one of the file's lists: nodes[3] or buffers[0], say.
    bool in_element() const { return levels_.size() == 3 && levels_[1].is_array && !levels_[2].is_array; }

    /// Stops: the value under way, "meshes[0].primitives[2].indices", say, is not what glTF asks for.
    bool refuse(const char* seen, const char* asked) {
        char path[120];
        std::size_t length = 0;
        for (const Level& level : levels_) {
            char* const end = path + length;
            if (level.is_array)
                write_words(end, sizeof path - length, "[%u]", level.index);
            else
                write_words(end, sizeof path - length, length == 0 ? "%s" : ".%s", level.key.c_str());
            length += std::strlen(end);
        }
        return stop(fail(TXC_STATUS_BAD_MODEL, "%s %s; glTF asks for %s", path, seen, asked));
    }

    const char* find_rule() const {
        const Level& object = levels_.back();
        const std::size_t depth = levels_.size();
        if (depth > 1 && !in_known_member_) return nullptr;
        if (depth >= 3) {
            const Level& holder = levels_[depth - 2];
            const std::string& name = holder.is_array ? levels_[depth - 3].key : holder.key;
            // All of their members are accessors.
            if (name == "attributes" || name == "targets") return kMemberRules;
        }
        for (const char* rule = kMemberRules; *rule != 0; rule += std::strlen(rule) + 1) {
            if (object.key == rule + 3 &&
                (depth == 1 ? rule[2] == '1' : rule[2] == '0' || rule[2] - '0' == static_cast<int>(depth)))
                return rule;
        }
        return nullptr;
    }

    /// Whether the value under way is what glTF asks for; finds `rule_`.
    bool check_kind(char kind, const char* letters, double number) {
        rule_ = nullptr;
        if (levels_.empty() || free_depth_ > 0) return true;
        const Level& level = levels_.back();
        rule_ = level.is_array ? level.rule : find_rule();
        if (levels_.size() == 1) in_known_member_ = rule_ != nullptr;
        if (rule_ == nullptr) return true;
        const char asked = level.is_array || rule_[1] == ' ' ? rule_[0] : kList;
        const char* words = words_for(asked);
        if (kind == asked || (kind < asked && asked <= kNumber)) {
            if (asked != kSize || number <= kMostBytes) return true;
            words = "less than 4 GiB";
        }
        char seen[48];
        if (kind <= kNumber)
            write_words(seen, sizeof seen, "is %g", number);
        else
            write_words(seen, sizeof seen, letters != nullptr ? "is \"%.40s\"" : "is %s",
                        letters != nullptr ? letters : words_for(kind));
        return refuse(seen, words);
    }

    bool open(bool is_array) {
        if (levels_.size() >= kMaxJsonDepth) {
            return stop(fail(TXC_STATUS_BAD_MODEL, "the JSON is nested deeper than %zu levels", kMaxJsonDepth));
        }
        if (!check_kind(is_array ? kList : kObject, nullptr, 0.0)) return false;
        const bool is_element = levels_.size() == 2 && levels_[1].is_array && !is_array;
        const std::string& list = levels_.empty() ? std::string() : levels_[0].key;
        const bool is_free =
            free_depth_ > 0 || (!levels_.empty() && !levels_.back().is_array &&
                                (levels_.back().key == "extras" || levels_.back().key == "extensions"));
        if (is_free) ++free_depth_;
        if (is_element) begin_element(list);
        levels_.push_back({is_array, {}, {}, 0, rule_});
        return charge(is_element && list == "materials" ? kMaterialBytes
                      : is_array && is_free             ? kFreeValueBytes
                      : is_array                        ? kValueBytes
                                                        : kObjectBytes);
    }

    bool close() {
        const char* rule = levels_.back().rule;
        const std::uint32_t count = levels_.back().index;
        const bool lacks_index = rule != nullptr && rule[1] == ' ' && levels_.back().keys["index"] == 0;
        const double square = levels_.back().square;
        levels_.pop_back();
        if (lacks_index) return refuse("has no index", "one");
        // The only list of four at this depth is a node's rotation.
        if (rule != nullptr && rule[1] == '4' && rule[2] == '3' && count == 4 && std::fabs(square - 1.0) > kUnitSlack)
            return refuse("is no unit quaternion", "one");
        if (rule != nullptr && rule[1] > '0' && count != static_cast<std::uint32_t>(rule[1] - '0')) {
            char seen[32];
            char asked[8];
            write_words(seen, sizeof seen, "has %u elements", count);
            write_words(asked, sizeof asked, "%d", rule[1] - '0');
            return refuse(seen, asked);
        }
        if (free_depth_ > 0) --free_depth_;
        step();
        return true;
    }

    bool take_value(char kind, const char* letters = nullptr, double number = 0.0) {
        if (!check_kind(kind, letters, number)) return false;
        if (in_element()) note_member(letters, number);
        if (!levels_.empty()) levels_.back().square += number * number;
        step();
        return charge(free_depth_ > 0 ? kFreeValueBytes : kValueBytes);
    }

    void step() {
        if (!levels_.empty() && levels_.back().is_array) ++levels_.back().index;
    }

    void begin_element(const std::string& list) {
        if (list == "buffers") buffers_.emplace_back();
        if (list == "bufferViews") views_.emplace_back();
        if (list == "images") images_.push_back(-1);
    }

    /// Numbers of these names are whole and below 4 GiB: their rules have been asked.
    void note_member(const char* letters, double number) {
        const std::string& list = levels_[0].key;
        const std::string& member = levels_[2].key;
        if (list == "buffers") {
            if (member == "byteLength") buffers_.back().byte_length = static_cast<std::uint64_t>(number);
            if (member == "uri") buffers_.back().has_uri = letters != nullptr && letters[0] != 0;
        } else if (list == "bufferViews") {
            if (member == "buffer") views_.back().buffer = static_cast<int>(number);
            if (member == "byteOffset") views_.back().byte_offset = static_cast<std::uint64_t>(number);
        } else if (list == "images" && member == "bufferView") {
            images_.back() = static_cast<int>(number);
        }
    }

    bool glb_;
    BudgetShare& share_;
    std::uint64_t charged_;
    TxcStatus status_ = TXC_STATUS_OK;
    std::vector<Level> levels_;
    const char* rule_ = nullptr;    // of the value under way
    bool in_known_member_ = false;  // of the file; what glTF 2.0 does not have, as 1.0's techniques, may hold anything
    std::uint32_t free_depth_ = 0;  // levels since extras or extensions began
    std::vector<Buffer> buffers_;
    std::vector<View> views_;
    std::vector<int> images_;
};

}  // namespace

bool is_glb(const std::uint8_t* bytes, std::uint32_t byte_count) {
    return byte_count >= 4 && read_u32(bytes) == kGlbMagic;
}

TxcStatus check_gltf_container(const std::uint8_t* bytes, std::uint32_t byte_count, BudgetShare& share) {
    const bool glb = is_glb(bytes, byte_count);
    Chunks chunks;
    if (glb) {
        if (const TxcStatus status = find_chunks(bytes, byte_count, chunks); status != TXC_STATUS_OK) return status;
    } else {
        std::uint32_t first = 0;
        while (first < byte_count &&
               (bytes[first] == ' ' || bytes[first] == '\n' || bytes[first] == '\r' || bytes[first] == '\t'))
            ++first;
        if (first == byte_count || bytes[first] != '{') {
            return fail(TXC_STATUS_BAD_MODEL, "the file begins neither with glTF (a GLB) nor with a JSON object");
        }
        chunks.json = bytes;
        chunks.json_length = byte_count;
    }
    // The binary chunk is copied; a text is held as it came, as an address, and as the bytes that this encodes.
    const std::uint64_t text_bytes = static_cast<std::uint64_t>(chunks.json_length) * 3;
    if (const TxcStatus status = share.resize(text_bytes + chunks.binary_length, "reading the model");
        status != TXC_STATUS_OK)
        return status;
    DocumentCheck check(glb, share);
    const JsonResult parsed = read_json(reinterpret_cast<const char*>(chunks.json), chunks.json_length, check);
    if (check.status() != TXC_STATUS_OK) return check.status();
    if (!parsed.is_whole) return fail(TXC_STATUS_BAD_MODEL, "the JSON is broken at its byte %zu", parsed.place);
    return check.check_lists();
}

}  // namespace txc
