#include "gltf_container.h"

#include <string>
#include <vector>

#define JSON_NOEXCEPTION
#include <nlohmann/json.hpp>

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
class DocumentCheck {
public:
    DocumentCheck(bool glb, BudgetShare& share) : glb_(glb), share_(share), charged_(share.bytes()) {}

    TxcStatus status() const { return status_; }

    bool null() { return take_value(); }
    bool boolean(bool) { return take_value(); }
    bool number_integer(std::int64_t) { return take_value(); }
    bool number_unsigned(std::uint64_t value) { return take_value(&value); }
    bool number_float(double, const std::string&) { return take_value(); }
    bool string(std::string& value) { return take_value(nullptr, &value); }
    bool binary(std::vector<std::uint8_t>&) { return take_value(); }
    bool start_object(std::size_t) { return open(false); }
    bool end_object() { return close(); }
    bool start_array(std::size_t) { return open(true); }
    bool end_array() { return close(); }
    bool key(std::string& name) {
        levels_.back().key = name;
        return true;
    }
    template <typename Exception>
    bool parse_error(std::size_t position, const std::string&, const Exception&) {
        status_ = fail(TXC_STATUS_BAD_MODEL, "the JSON is broken at its byte %zu", position);
        return false;
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
        std::string key;          // of the member under way, in an object
        std::uint32_t index = 0;  // of the element under way, in an array
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
        if (levels_.size() == 1 && is_array) forget_list(list);
        if (is_element) begin_element(list);
        levels_.push_back({is_array, {}, 0});
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

    bool take_value(const std::uint64_t* number = nullptr, const std::string* letters = nullptr) {
        if (in_element() && !note_member(number, letters)) return false;
        step();
        return charge(free_depth_ > 0 ? kFreeValueBytes : kValueBytes);
    }

    void step() {
        if (!levels_.empty() && levels_.back().is_array) ++levels_.back().index;
    }

    // A list that stands twice in the document counts as it stands last, as it does for the parser.
    void forget_list(const std::string& list) {
        if (list == "buffers") buffers_.clear();
        if (list == "bufferViews") views_.clear();
        if (list == "images") images_.clear();
    }

    void begin_element(const std::string& list) {
        if (list == "buffers") buffers_.emplace_back();
        if (list == "bufferViews") views_.emplace_back();
        if (list == "images") images_.push_back(-1);
    }

    bool note_member(const std::uint64_t* number, const std::string* letters) {
        const std::string& list = levels_[0].key;
        const std::string& member = levels_[2].key;
        const bool is_size = member == "byteLength" || member == "byteOffset" || member == "count";
        if (is_size && number != nullptr && *number > kMaxBytes) {
            return stop(fail(TXC_STATUS_BAD_MODEL, "%s[%u].%s is %llu, more than any file holds", list.c_str(),
                             levels_[1].index, member.c_str(), static_cast<unsigned long long>(*number)));
        }
        // tinygltf cuts other numbers down to an int.
        const int index = number != nullptr ? static_cast<int>(*number) : -1;
        if (list == "buffers") {
            if (member == "byteLength") buffers_.back().byte_length = number != nullptr ? *number : 0;
            if (member == "uri") buffers_.back().has_uri = letters != nullptr && !letters->empty();
        } else if (list == "bufferViews") {
            if (member == "buffer") views_.back().buffer = index;
            if (member == "byteOffset") views_.back().byte_offset = number != nullptr ? *number : 0;
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
    const bool parsed = nlohmann::json::sax_parse(chunks.json, chunks.json + chunks.json_length, &check);
    if (check.status() != TXC_STATUS_OK) return check.status();
    if (!parsed) return fail(TXC_STATUS_BAD_MODEL, "the JSON cannot be read");
    return check.check_lists();
}

}  // namespace txc
