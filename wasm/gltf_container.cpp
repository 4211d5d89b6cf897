#include "gltf_container.h"

#include <set>
#include <string>
#include <vector>

#include "json_reader.h"

namespace txc {
namespace {

constexpr std::uint32_t kGlbMagic = 0x46546C67u;   // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534Au;  // "JSON"
constexpr std::uint64_t kMaxBytes = 0xffffffffu;   // of a GLB; a count or size above it can only be a lie
constexpr std::size_t kMaxJsonDepth = 256;         // parsers of nested values recurse; no real model is so deep
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

/// Follows the JSON text from value to value without keeping it.
class DocumentCheck final : public JsonEvents {
public:
    DocumentCheck(bool glb, BudgetShare& share) : glb_(glb), share_(share), charged_(share.bytes()) {}

    TxcStatus status() const { return status_; }

    bool Null() override { return take_value(); }
    bool Bool(bool) override { return take_value(); }
    bool Int(int value) override { return Int64(value); }
    bool Uint(unsigned value) override { return Uint64(value); }
    bool Int64(std::int64_t value) override {
        const WholeNumber number{static_cast<std::uint64_t>(value), value < 0};
        return take_value(&number);
    }
    bool Uint64(std::uint64_t value) override {
        const WholeNumber number{value, false};
        return take_value(&number);
    }
    bool Double(double) override { return take_value(); }
    bool String(const char* letters, unsigned, bool) override { return take_value(nullptr, letters); }
    bool StartObject() override { return open(false); }
    bool EndObject(unsigned) override { return close(); }
    bool StartArray() override { return open(true); }
    bool EndArray(unsigned) override { return close(); }
    bool Key(const char* letters, unsigned length, bool) override {
        Level& object = levels_.back();
        object.key.assign(letters, length);
        // glTF forbids it, and of two values one parser takes the first, another the last.
        if (!object.keys.insert(object.key).second) {
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
        std::string key;             // of the member under way, in an object
        std::set<std::string> keys;  // of all its members so far
        std::uint32_t index = 0;     // of the element under way, in an array
    };
    struct WholeNumber {
        std::uint64_t bits;
        bool is_negative;
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

    bool open(bool is_array) {
        if (levels_.size() >= kMaxJsonDepth) {
            return stop(fail(TXC_STATUS_BAD_MODEL, "the JSON is nested deeper than %zu levels", kMaxJsonDepth));
        }
        if (in_element() && !note_member(nullptr, nullptr)) return false;
        const bool is_element = levels_.size() == 2 && levels_[1].is_array && !is_array;
        const std::string& list = levels_.empty() ? std::string() : levels_[0].key;
        const bool is_free =
            free_depth_ > 0 || (!levels_.empty() && !levels_.back().is_array &&
                                (levels_.back().key == "extras" || levels_.back().key == "extensions"));
        if (is_free) ++free_depth_;
        if (is_element) begin_element(list);
        levels_.push_back({is_array, {}, {}, 0});
        return charge(is_element && list == "materials" ? kMaterialBytes
                      : is_array && is_free             ? kFreeValueBytes
                      : is_array                        ? kValueBytes
                                                        : kObjectBytes);
    }

    bool close() {
        levels_.pop_back();
        if (free_depth_ > 0) --free_depth_;
        step();
        return true;
    }

    bool take_value(const WholeNumber* number = nullptr, const char* letters = nullptr) {
        if (in_element() && !note_member(number, letters)) return false;
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

    bool note_member(const WholeNumber* number, const char* letters) {
        const std::string& list = levels_[0].key;
        const std::string& member = levels_[2].key;
        const bool is_size = member == "byteLength" || member == "byteOffset" || member == "count";
        const std::uint64_t size = number != nullptr && !number->is_negative ? number->bits : 0;
        if (is_size && size > kMaxBytes) {
            return stop(fail(TXC_STATUS_BAD_MODEL, "%s[%u].%s is %llu, more than any file holds", list.c_str(),
                             levels_[1].index, member.c_str(), static_cast<unsigned long long>(size)));
        }
        // tinygltf cuts other numbers down to an int.
        const int index = number != nullptr ? static_cast<int>(number->bits) : -1;
        if (list == "buffers") {
            if (member == "byteLength") buffers_.back().byte_length = size;
            if (member == "uri") buffers_.back().has_uri = letters != nullptr && letters[0] != 0;
        } else if (list == "bufferViews") {
            if (member == "buffer") views_.back().buffer = index;
            if (member == "byteOffset") views_.back().byte_offset = size;
        } else if (list == "images" && member == "bufferView") {
            images_.back() = index;
        }
        return true;
    }

    bool glb_;
    BudgetShare& share_;
    std::uint64_t charged_;
    TxcStatus status_ = TXC_STATUS_OK;
    std::vector<Level> levels_;
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
            return fail(TXC_STATUS_BAD_MODEL,
                        "the file begins neither with the letters glTF (a GLB) nor with a JSON object");
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
