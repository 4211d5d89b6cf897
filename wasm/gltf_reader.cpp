// Longer than other files here, for one reason: tinygltf stays behind this one file.
#include "gltf_reader.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <glm/gtc/quaternion.hpp>
#include <sstream>

#include "tinygltf_json.h"
#include "tinygltf_words.h"

#define TINYGLTF_USE_RAPIDJSON
#define TINYGLTF_NO_INCLUDE_RAPIDJSON
#define TINYGLTF_NOEXCEPTION
#define TINYGLTF_NO_FS
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#endif
#include <tiny_gltf.h>  // as cmake/mend_tinygltf.cmake makes it, without checks that are made below
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

#include "detail_words.h"
#include "exact_math.h"
#include "gltf_container.h"

namespace txc {
namespace {

using Model = tinygltf::Model;

std::uint32_t read_u32(const std::uint8_t* bytes) {
    return static_cast<std::uint32_t>(bytes[0]) | static_cast<std::uint32_t>(bytes[1]) << 8 |
           static_cast<std::uint32_t>(bytes[2]) << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

bool keep_no_picture(tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                     void*) {
    return true;  // the host decodes pictures; the core needs none to read a mesh
}

TxcStatus parse(const std::uint8_t* bytes, std::uint32_t byte_count, Model& model) {
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keep_no_picture, nullptr);
    std::string error;
    std::string warning;
    const bool loaded = is_glb(bytes, byte_count)
                            ? loader.LoadBinaryFromMemory(&model, &error, &warning, bytes, byte_count)
                            : loader.LoadASCIIFromString(&model, &error, &warning, reinterpret_cast<const char*>(bytes),
                                                         byte_count, "");
    if (!loaded) {
        while (!error.empty() && (error.back() == '\n' || error.back() == ' ')) error.pop_back();
        return fail(TXC_STATUS_BAD_MODEL, "%s", error.empty() ? "the glTF document cannot be read" : error.c_str());
    }
    const tinygltf::Asset& asset = model.asset;
    const bool is_later = !asset.minVersion.empty() && asset.minVersion != "2.0";
    if (is_later || asset.version.rfind("2.", 0) != 0) {
        return fail(TXC_STATUS_BAD_MODEL, "asset.%s is \"%.20s\"; only glTF 2.0 is read",
                    is_later ? "minVersion" : "version", (is_later ? asset.minVersion : asset.version).c_str());
    }
    for (const std::string& extension : model.extensionsRequired) {
        // Extensions of looks and pictures change no triangle. Geometry is another matter: not to know it is to paint it wrongly.
        static const char* const kHarmlessPrefixes[] = {"KHR_materials_",       "KHR_texture_",          "EXT_texture_",
                                                        "KHR_lights_",          "KHR_mesh_quantization", "KHR_xmp",
                                                        "KHR_animation_pointer"};
        bool known = false;
        for (const char* prefix : kHarmlessPrefixes) known = known || extension.rfind(prefix, 0) == 0;
        if (!known) {
            return fail(TXC_STATUS_UNSUPPORTED_MODEL,
                        "the model requires the extension %s; export it without that extension", extension.c_str());
        }
    }
    return TXC_STATUS_OK;
}

// ---- Accessors ------------------------------------------------------------------------------------------------------

std::uint32_t component_size(int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return 1;
        case TINYGLTF_COMPONENT_TYPE_SHORT:
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return 2;
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        case TINYGLTF_COMPONENT_TYPE_FLOAT:
            return 4;
        default:
            return 0;
    }
}

std::uint32_t component_count(int type) {
    switch (type) {
        case TINYGLTF_TYPE_SCALAR:
            return 1;
        case TINYGLTF_TYPE_VEC2:
            return 2;
        case TINYGLTF_TYPE_VEC3:
            return 3;
        case TINYGLTF_TYPE_VEC4:
            return 4;
        case TINYGLTF_TYPE_MAT4:
            return 16;
        default:
            return 0;
    }
}

float read_component(const std::uint8_t* at, int type, bool normalized) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_BYTE: {
            const auto value = static_cast<float>(static_cast<std::int8_t>(at[0]));
            return normalized ? std::fmax(value / 127.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
            const auto value = static_cast<float>(at[0]);
            return normalized ? value / 255.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_SHORT: {
            const auto value = static_cast<float>(static_cast<std::int16_t>(at[0] | at[1] << 8));
            return normalized ? std::fmax(value / 32767.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
            const auto value = static_cast<float>(at[0] | at[1] << 8);
            return normalized ? value / 65535.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
            return static_cast<float>(read_u32(at));
        default: {
            float value;
            std::memcpy(&value, at, 4);
            return value;
        }
    }
}

std::uint32_t read_index(const std::uint8_t* at, int type) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
            return at[0];
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
            return static_cast<std::uint32_t>(at[0] | at[1] << 8);
        default:
            return read_u32(at);
    }
}

/// A checked piece of a buffer: `count` elements of `element_size` bytes, `stride` apart, all inside the buffer.
struct Elements {
    const std::uint8_t* first = nullptr;
    std::uint64_t stride = 0;
};

TxcStatus find_elements(const Model& model, int view_index, std::uint64_t offset, std::uint64_t count,
                        std::uint64_t element_size, bool may_interleave, int accessor_index, Elements& out) {
    if (view_index < 0 || static_cast<std::size_t>(view_index) >= model.bufferViews.size()) {
        return fail(TXC_STATUS_BAD_MODEL, "accessors[%d]: there is no bufferViews[%d]", accessor_index, view_index);
    }
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(view_index)];
    if (view.buffer < 0 || static_cast<std::size_t>(view.buffer) >= model.buffers.size()) {
        return fail(TXC_STATUS_BAD_MODEL, "bufferViews[%d]: there is no buffers[%d]", view_index, view.buffer);
    }
    const std::vector<unsigned char>& data = model.buffers[static_cast<std::size_t>(view.buffer)].data;
    if (view.byteOffset > data.size() || view.byteLength > data.size() - view.byteOffset) {
        return fail(TXC_STATUS_BAD_MODEL, "bufferViews[%d] lies outside its buffer of %zu bytes", view_index,
                    data.size());
    }
    const std::uint64_t stride = may_interleave && view.byteStride != 0 ? view.byteStride : element_size;
    if (stride < element_size || stride > 252 + element_size) {
        return fail(TXC_STATUS_BAD_MODEL, "bufferViews[%d]: byteStride %llu does not fit elements of %llu bytes",
                    view_index, static_cast<unsigned long long>(stride), static_cast<unsigned long long>(element_size));
    }
    const std::uint64_t needed = count == 0 ? 0 : stride * (count - 1) + element_size;
    if (offset > view.byteLength || needed > view.byteLength - offset) {
        return fail(TXC_STATUS_BAD_MODEL,
                    "accessors[%d]: its %llu elements need %llu bytes at offset %llu, bufferViews[%d] has %zu",
                    accessor_index, static_cast<unsigned long long>(count), static_cast<unsigned long long>(needed),
                    static_cast<unsigned long long>(offset), view_index, view.byteLength);
    }
    out.first = data.data() + view.byteOffset + offset;
    out.stride = stride;
    return TXC_STATUS_OK;
}

TxcStatus find_accessor(const Model& model, int index, const tinygltf::Accessor*& out) {
    if (index < 0 || static_cast<std::size_t>(index) >= model.accessors.size()) {
        return fail(TXC_STATUS_BAD_MODEL, "there is no accessors[%d]", index);
    }
    out = &model.accessors[static_cast<std::size_t>(index)];
    return TXC_STATUS_OK;
}

bool is_unsigned(int component_type) {
    return component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

/// Reads an accessor's elements of `element_size` bytes into `out`, `values` each: `read(bytes, first value)` one by one, then the
/// sparse ones that replace some. What no bufferView stores is 0, as glTF has it.
template <typename Value, typename Read>
TxcStatus read_elements(const Model& model, int index, std::uint64_t element_size, std::uint32_t values,
                        bool may_interleave, BudgetShare& scratch, std::vector<Value>& out, const Read& read) {
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    const std::uint64_t count = accessor.count;
    Elements elements;
    if (accessor.bufferView >= 0) {
        const TxcStatus status = find_elements(model, accessor.bufferView, accessor.byteOffset, count, element_size,
                                               may_interleave, index, elements);
        if (status != TXC_STATUS_OK) return status;
    }
    char what[32];
    write_words(what, sizeof what, "accessors[%d]", index);
    if (const TxcStatus fits = scratch.resize(scratch.bytes() + count * values * sizeof(Value), what);
        fits != TXC_STATUS_OK)
        return fits;
    out.assign(static_cast<std::size_t>(count * values), Value{});
    const auto read_into = [&](const std::uint8_t* from, std::uint64_t element) {
        read(from, out.data() + static_cast<std::size_t>(element * values));
    };
    if (elements.first != nullptr) {
        for (std::uint64_t i = 0; i < count; ++i) read_into(elements.first + i * elements.stride, i);
    }
    const auto& sparse = accessor.sparse;
    if (!sparse.isSparse) return TXC_STATUS_OK;
    if (sparse.count < 0 || static_cast<std::uint64_t>(sparse.count) > count) {
        return fail(TXC_STATUS_BAD_MODEL, "accessors[%d].sparse.count is %d of %llu elements", index, sparse.count,
                    static_cast<unsigned long long>(count));
    }
    const auto sparse_count = static_cast<std::uint64_t>(sparse.count);
    const std::uint32_t index_size = component_size(sparse.indices.componentType);
    if (!is_unsigned(sparse.indices.componentType))
        return fail(TXC_STATUS_BAD_MODEL, "accessors[%d].sparse.indices.componentType is %d", index,
                    sparse.indices.componentType);
    Elements at;
    Elements replacing;
    TxcStatus status =
        find_elements(model, sparse.indices.bufferView, static_cast<std::uint64_t>(sparse.indices.byteOffset),
                      sparse_count, index_size, false, index, at);
    if (status == TXC_STATUS_OK) {
        status = find_elements(model, sparse.values.bufferView, static_cast<std::uint64_t>(sparse.values.byteOffset),
                               sparse_count, element_size, false, index, replacing);
    }
    if (status != TXC_STATUS_OK) return status;
    for (std::uint64_t i = 0; i < sparse_count; ++i) {
        const std::uint32_t element = read_index(at.first + i * index_size, sparse.indices.componentType);
        if (element >= count)
            return fail(TXC_STATUS_BAD_MODEL, "accessors[%d].sparse: index %u is beyond its %llu elements", index,
                        element, static_cast<unsigned long long>(count));
        read_into(replacing.first + i * element_size, element);
    }
    return TXC_STATUS_OK;
}

/// Reads an accessor as floats, the first `components` of each element, as a renderer's shader does; sparse values, strides
/// and normalised integers included.
TxcStatus read_floats(const Model& model, int index, std::uint32_t components, BudgetShare& scratch,
                      std::vector<float>& out) {
    const tinygltf::Accessor* accessor = nullptr;
    if (const TxcStatus status = find_accessor(model, index, accessor); status != TXC_STATUS_OK) return status;
    const std::uint32_t size = component_size(accessor->componentType);
    const std::uint32_t there = component_count(accessor->type);
    if (size == 0 || there < components) {
        return fail(TXC_STATUS_BAD_MODEL,
                    "accessors[%d]: type %d of component type %d is not what its use asks for (%u components)", index,
                    accessor->type, accessor->componentType, components);
    }
    return read_elements(model, index, std::uint64_t{size} * there, components, true, scratch, out,
                         [&](const std::uint8_t* from, float* into) {
                             for (std::uint32_t c = 0; c < components; ++c)
                                 into[c] =
                                     read_component(from + c * size, accessor->componentType, accessor->normalized);
                         });
}

TxcStatus read_indices(const Model& model, int index, BudgetShare& scratch, std::vector<std::uint32_t>& out) {
    const tinygltf::Accessor* accessor = nullptr;
    if (const TxcStatus status = find_accessor(model, index, accessor); status != TXC_STATUS_OK) return status;
    const int type = accessor->componentType;
    if (!is_unsigned(type) || accessor->type != TINYGLTF_TYPE_SCALAR)
        return fail(TXC_STATUS_BAD_MODEL, "accessors[%d]: indices must be unsigned integers", index);
    // All of them would be the first vertex: a file that forgot something, as that it is compressed.
    if (accessor->bufferView < 0 && !accessor->sparse.isSparse)
        return fail(TXC_STATUS_BAD_MODEL, "accessors[%d]: indices without a bufferView", index);
    return read_elements(model, index, component_size(type), 1, false, scratch, out,
                         [type](const std::uint8_t* from, std::uint32_t* into) { *into = read_index(from, type); });
}

// ---- Materials ------------------------------------------------------------------------------------------------------

/// KHR_texture_transform as a matrix on (u, v, 1): translation * rotation * scale, counter-clockwise with v down.
struct UvTransform {
    double xx = 1, xy = 0, x = 0;
    double yx = 0, yy = 1, y = 0;
    glm::vec2 apply(float u, float v) const {
        return {static_cast<float>(xx * static_cast<double>(u) + xy * static_cast<double>(v) + x),
                static_cast<float>(yx * static_cast<double>(u) + yy * static_cast<double>(v) + y)};
    }
};

/// The numbers of an extension's member, which keep their values where it is left out: one, or a list of so many. False where it is
/// none.
bool read_numbers(const tinygltf::Value& extension, const char* key, double* out, std::size_t count) {
    if (!extension.Has(key)) return true;
    const tinygltf::Value& list = extension.Get(key);
    if (list.IsArray() ? count < 2 || list.ArrayLen() != count : count > 1) return false;
    for (std::size_t i = 0; i < count; ++i) {
        const tinygltf::Value& number = count > 1 ? list.Get(i) : list;
        if (!number.IsNumber()) return false;
        out[i] = number.GetNumberAsDouble();
    }
    return true;
}

/// False where what says how the picture lies on the texture coordinates is broken: painted as if it were not there, all would lie elsewhere.
bool read_material(const Model& model, const tinygltf::Material& source, Material& material, UvTransform& transform) {
    const auto& pbr = source.pbrMetallicRoughness;
    for (int c = 0; c < 4 && static_cast<std::size_t>(c) < pbr.baseColorFactor.size(); ++c) {
        material.base_color_factor[c] = static_cast<float>(pbr.baseColorFactor[static_cast<std::size_t>(c)]);
    }
    const auto& info = pbr.baseColorTexture;
    if (info.index < 0 || static_cast<std::size_t>(info.index) >= model.textures.size()) return true;
    material.tex_coord = info.texCoord > 0 ? static_cast<std::uint32_t>(info.texCoord) : 0;
    const tinygltf::Texture& texture = model.textures[static_cast<std::size_t>(info.index)];
    int image = texture.source;
    for (const char* name : {"EXT_texture_webp", "KHR_texture_basisu"}) {
        const auto found = texture.extensions.find(name);
        if (image < 0 && found != texture.extensions.end() && found->second.IsObject() &&
            found->second.Get("source").IsInt()) {
            image = found->second.Get("source").GetNumberAsInt();
        }
    }
    if (image >= 0 && static_cast<std::size_t>(image) < model.images.size())
        material.image = static_cast<std::uint32_t>(image);
    if (texture.sampler >= 0 && static_cast<std::size_t>(texture.sampler) < model.samplers.size()) {
        material.nearest_filter =
            model.samplers[static_cast<std::size_t>(texture.sampler)].magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
    }
    const auto found = info.extensions.find("KHR_texture_transform");
    if (found == info.extensions.end() || !found->second.IsObject()) return true;
    const tinygltf::Value& extension = found->second;
    double set = material.tex_coord;
    double angle = 0.0;
    double scale[2] = {1.0, 1.0};
    double offset[2] = {0.0, 0.0};
    if (!read_numbers(extension, "texCoord", &set, 1) || !read_numbers(extension, "rotation", &angle, 1) ||
        !read_numbers(extension, "scale", scale, 2) || !read_numbers(extension, "offset", offset, 2))
        return false;
    material.tex_coord = static_cast<std::uint32_t>(std::min(std::max(0.0, set), 1e9));
    double sine = 0.0;
    double cosine = 1.0;
    if (std::fabs(angle) <= 1e6) exact_sin_cos(angle, sine, cosine);
    transform = {cosine * scale[0], sine * scale[1], offset[0], -sine * scale[0], cosine * scale[1], offset[1]};
    return true;
}

// ---- Nodes ----------------------------------------------------------------------------------------------------------

glm::dmat4 local_matrix(const tinygltf::Node& node) {
    glm::dmat4 matrix(1.0);
    if (node.matrix.size() == 16) {
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = node.matrix[static_cast<std::size_t>(i)];
        return matrix;
    }
    if (node.rotation.size() == 4) {
        matrix = glm::mat4_cast(glm::dquat(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]));
    }
    if (node.scale.size() == 3) {
        for (int c = 0; c < 3; ++c) matrix[c] *= node.scale[static_cast<std::size_t>(c)];
    }
    if (node.translation.size() == 3) {
        for (int c = 0; c < 3; ++c) matrix[3][c] = node.translation[static_cast<std::size_t>(c)];
    }
    return matrix;
}

/// Global matrices of all nodes (joints may stand outside the scene), and the scene's nodes depth first.
TxcStatus place_nodes(const Model& model, std::vector<glm::dmat4>& global, std::vector<std::size_t>& scene_nodes) {
    const std::size_t count = model.nodes.size();
    std::vector<int> parent(count, -1);
    for (std::size_t n = 0; n < count; ++n) {
        for (const int child : model.nodes[n].children) {
            if (child < 0 || static_cast<std::size_t>(child) >= count)
                return fail(TXC_STATUS_BAD_MODEL, "nodes[%zu]: there is no child nodes[%d]", n, child);
            if (parent[static_cast<std::size_t>(child)] >= 0)
                return fail(TXC_STATUS_BAD_MODEL, "nodes[%d] has two parents", child);
            parent[static_cast<std::size_t>(child)] = static_cast<int>(n);
        }
    }
    global.assign(count, glm::dmat4(1.0));
    std::vector<std::uint8_t> placed(count, 0);
    std::vector<std::size_t> stack;
    // `visit` says whether to go on to the node's children.
    const auto descend = [&](std::size_t root, auto&& visit) {
        stack.push_back(root);
        while (!stack.empty()) {
            const std::size_t n = stack.back();
            stack.pop_back();
            if (!visit(n)) continue;
            const std::vector<int>& children = model.nodes[n].children;
            for (std::size_t c = children.size(); c > 0; --c)
                stack.push_back(static_cast<std::size_t>(children[c - 1]));
        }
    };
    for (std::size_t n = 0; n < count; ++n) {
        if (parent[n] >= 0) continue;
        descend(n, [&](std::size_t node) {
            const glm::dmat4 local = local_matrix(model.nodes[node]);
            global[node] = parent[node] >= 0 ? global[static_cast<std::size_t>(parent[node])] * local : local;
            placed[node] = 1;
            return true;
        });
    }
    std::vector<int> roots;
    if (model.scenes.empty()) {
        for (std::size_t n = 0; n < count; ++n) {
            if (parent[n] < 0) roots.push_back(static_cast<int>(n));
        }
    } else {
        const int scene = model.defaultScene >= 0 ? model.defaultScene : 0;
        if (static_cast<std::size_t>(scene) >= model.scenes.size())
            return fail(TXC_STATUS_BAD_MODEL, "there is no scenes[%d]", scene);
        roots = model.scenes[static_cast<std::size_t>(scene)].nodes;
    }
    std::vector<std::uint8_t> seen(count, 0);
    for (const int root : roots) {
        if (root < 0 || static_cast<std::size_t>(root) >= count)
            return fail(TXC_STATUS_BAD_MODEL, "the scene names nodes[%d], which does not exist", root);
        // Nodes of a ring have no root above them, so they were never placed.
        if (placed[static_cast<std::size_t>(root)] == 0)
            return fail(TXC_STATUS_BAD_MODEL, "nodes[%d] is its own ancestor", root);
        descend(static_cast<std::size_t>(root), [&](std::size_t node) {
            if (seen[node] != 0) return false;
            scene_nodes.push_back(node);
            seen[node] = 1;
            return true;
        });
    }
    return TXC_STATUS_OK;
}

/// Joint matrices of a skin: the joint's place times its inverse bind matrix. The mesh node's own place does not count.
TxcStatus joint_matrices(const Model& model, int skin_index, const std::vector<glm::dmat4>& global,
                         BudgetShare& scratch, std::vector<glm::dmat4>& out) {
    if (static_cast<std::size_t>(skin_index) >= model.skins.size())
        return fail(TXC_STATUS_BAD_MODEL, "there is no skins[%d]", skin_index);
    const tinygltf::Skin& skin = model.skins[static_cast<std::size_t>(skin_index)];
    std::vector<float> inverse_bind;
    if (skin.inverseBindMatrices >= 0) {
        if (const TxcStatus status = read_floats(model, skin.inverseBindMatrices, 16, scratch, inverse_bind);
            status != TXC_STATUS_OK)
            return status;
        if (inverse_bind.size() < skin.joints.size() * 16) {
            return fail(TXC_STATUS_BAD_MODEL, "skins[%d] has %zu joints but %zu inverse bind matrices", skin_index,
                        skin.joints.size(), inverse_bind.size() / 16);
        }
    }
    out.clear();
    // Of a skin without any the first is looked for, too.
    for (std::size_t j = 0; j < std::max<std::size_t>(skin.joints.size(), 1); ++j) {
        const int joint = skin.joints.empty() ? -1 : skin.joints[j];
        if (joint < 0 || static_cast<std::size_t>(joint) >= model.nodes.size())
            return fail(TXC_STATUS_BAD_MODEL, "skins[%d]: there is no joint nodes[%d]", skin_index, joint);
        glm::dmat4 bind(1.0);
        if (!inverse_bind.empty()) {
            for (int i = 0; i < 16; ++i)
                bind[i / 4][i % 4] = static_cast<double>(inverse_bind[j * 16 + static_cast<std::size_t>(i)]);
        }
        out.push_back(global[static_cast<std::size_t>(joint)] * bind);
    }
    return TXC_STATUS_OK;
}

// ---- Primitives -----------------------------------------------------------------------------------------------------

struct Reader {
    const Model& model;
    BudgetShare& scratch;  // the primitive under way's
    const std::vector<UvTransform>& uv_transforms;
    Mesh& mesh;
    MeshSize filled;  // so much of it has been read
};

/// Strips and fans as a triangle list (glTF 2.0, 3.7.2.1).
void to_triangle_list(int mode, std::vector<std::uint32_t>& indices) {
    if (mode == TINYGLTF_MODE_TRIANGLES) return;
    const bool is_strip = mode == TINYGLTF_MODE_TRIANGLE_STRIP;
    std::vector<std::uint32_t> list;
    for (std::size_t i = 0; i + 2 < indices.size(); ++i) {
        // (To insert all three as a list is 0.3 kB more of the module.)
        list.push_back(indices[is_strip ? i : i + 1]);
        list.push_back(indices[is_strip ? i + 1 + i % 2 : i + 2]);
        list.push_back(indices[is_strip ? i + 2 - i % 2 : 0]);
    }
    indices = std::move(list);
}

int attribute(const std::map<std::string, int>& attributes, const std::string& name) {
    const auto found = attributes.find(name);
    return found == attributes.end() ? -1 : found->second;
}

/// The accessor of the primitive's positions; below 0 where it has no triangles: points and lines have no texels, and without
/// positions it is not drawn (glTF 2.0, 3.7.2.1).
int drawn_positions(const tinygltf::Primitive& primitive) {
    const bool has_triangles = primitive.mode == TINYGLTF_MODE_TRIANGLES ||
                               primitive.mode == TINYGLTF_MODE_TRIANGLE_STRIP ||
                               primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN;
    return has_triangles ? attribute(primitive.attributes, "POSITION") : -1;
}

// Places of primitives, and elements of an accessor, beyond which there is no need to count: so many places are more than anything
// draws, and so many elements fit no budget. What both come to at the most still fits 64 bits.
constexpr std::uint64_t kMostPlaces = 1u << 20;
constexpr std::uint64_t kMostElements = std::uint64_t{1} << 35;

/// Elements of an accessor, which is first looked at when it is read: of those that a file of so many bytes stores, no more than it
/// can hold.
std::uint64_t element_count(const Model& model, int index, std::uint32_t byte_count) {
    if (static_cast<std::size_t>(index) >= model.accessors.size()) return 0;
    const tinygltf::Accessor& accessor = model.accessors[static_cast<std::size_t>(index)];
    return std::min<std::uint64_t>(accessor.count, accessor.bufferView < 0 ? kMostElements : byte_count);
}

/// Adds the primitive's arrays, in one of its places.
void add_size(const Model& model, const tinygltf::Primitive& primitive, std::uint32_t byte_count, MeshSize& size) {
    const std::uint64_t vertices = element_count(model, drawn_positions(primitive), byte_count);
    if (vertices == 0) return;
    const std::uint64_t corners =
        primitive.indices < 0 ? vertices : element_count(model, primitive.indices, byte_count);
    size.vertices += vertices;
    size.triangles += primitive.mode == TINYGLTF_MODE_TRIANGLES ? corners / 3 : corners < 2 ? 0 : corners - 2;
}

TxcStatus add_morph(Reader& reader, const std::map<std::string, int>& target, const char* name, double weight,
                    const char* whose, std::vector<float>& values) {
    const int accessor = attribute(target, name);
    if (accessor < 0 || weight == 0.0) return TXC_STATUS_OK;
    const std::uint64_t scratch_before = reader.scratch.bytes();
    std::vector<float> delta;
    if (const TxcStatus status = read_floats(reader.model, accessor, 3, reader.scratch, delta); status != TXC_STATUS_OK)
        return status;
    if (delta.size() != values.size())
        return fail(TXC_STATUS_BAD_MODEL, "%s: a morph target has %zu values for %zu", whose, delta.size(),
                    values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<float>(static_cast<double>(values[i]) + weight * static_cast<double>(delta[i]));
    return reader.scratch.resize(scratch_before, "a morph target");
}

/// The matrix that each vertex is placed by: its joints', weighted, or the node's own.
TxcStatus skin_vertices(Reader& reader, const tinygltf::Primitive& primitive, const std::vector<glm::dmat4>& joints,
                        std::size_t vertex_count, const char* whose, std::vector<glm::dmat4>& out) {
    const std::uint64_t bytes = static_cast<std::uint64_t>(vertex_count) * (sizeof(glm::dmat4) + sizeof(double));
    if (const TxcStatus status = reader.scratch.resize(reader.scratch.bytes() + bytes, whose); status != TXC_STATUS_OK)
        return status;
    out.assign(vertex_count, glm::dmat4(0.0));
    std::vector<double> total(vertex_count, 0.0);
    for (int set = 0;; ++set) {
        const int joint_accessor = attribute(primitive.attributes, "JOINTS_" + std::to_string(set));
        const int weight_accessor = attribute(primitive.attributes, "WEIGHTS_" + std::to_string(set));
        if (joint_accessor < 0 || weight_accessor < 0) break;
        const std::uint64_t scratch_before = reader.scratch.bytes();
        std::vector<float> joint_values;
        std::vector<float> weights;
        TxcStatus status = read_floats(reader.model, joint_accessor, 4, reader.scratch, joint_values);
        if (status == TXC_STATUS_OK) status = read_floats(reader.model, weight_accessor, 4, reader.scratch, weights);
        if (status != TXC_STATUS_OK) return status;
        // Signed or fractional joints would become other integers on other machines.
        const int joint_type = reader.model.accessors[static_cast<std::size_t>(joint_accessor)].componentType;
        if (joint_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE && joint_type != TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
            return fail(TXC_STATUS_BAD_MODEL, "%s: JOINTS_%d must be unsigned bytes or shorts", whose, set);
        if (joint_values.size() != vertex_count * 4 || weights.size() != vertex_count * 4) {
            return fail(TXC_STATUS_BAD_MODEL, "%s: JOINTS_%d or WEIGHTS_%d has another length than POSITION", whose,
                        set, set);
        }
        for (std::size_t i = 0; i < vertex_count * 4; ++i) {
            const auto weight = static_cast<double>(weights[i]);
            if (weight == 0.0) continue;
            const auto joint = static_cast<std::size_t>(joint_values[i]);
            if (joint >= joints.size())
                return fail(TXC_STATUS_BAD_MODEL, "%s: vertex %zu names joint %zu of %zu", whose, i / 4, joint,
                            joints.size());
            out[i / 4] += joints[joint] * weight;
            total[i / 4] += weight;
        }
        status = reader.scratch.resize(scratch_before, whose);
        if (status != TXC_STATUS_OK) return status;
    }
    for (std::size_t v = 0; v < vertex_count; ++v) {
        // Weights ought to add up to 1; like common viewers, make them.
        if (total[v] > 0.0)
            out[v] /= total[v];
        else
            out[v] = joints[0];
    }
    return TXC_STATUS_OK;
}

/// Below 0 where what the matrix places is mirrored.
double handedness(const glm::dmat4& matrix) {
    return glm::dot(glm::dvec3(matrix[0]), glm::cross(glm::dvec3(matrix[1]), glm::dvec3(matrix[2])));
}

glm::dvec3 place_normal(const glm::dmat4& matrix, const glm::dvec3& normal) {
    // The cofactor matrix is the inverse transpose times the determinant, and exists for flattened nodes too.
    const glm::dvec3 x(matrix[0]);
    const glm::dvec3 y(matrix[1]);
    const glm::dvec3 z(matrix[2]);
    const glm::dvec3 yz = glm::cross(y, z);
    const double sign = handedness(matrix) < 0.0 ? -1.0 : 1.0;
    return (yz * normal.x + glm::cross(z, x) * normal.y + glm::cross(x, y) * normal.z) * sign;
}

TxcStatus read_primitive(Reader& reader, const tinygltf::Primitive& primitive, const std::vector<double>& morph_weights,
                         const glm::dmat4& node_matrix, const std::vector<glm::dmat4>* joints, const char* whose) {
    const Model& model = reader.model;
    const int position_accessor = drawn_positions(primitive);
    if (position_accessor < 0) return TXC_STATUS_OK;
    reader.scratch.release();
    std::vector<float> positions;
    if (const TxcStatus status = read_floats(model, position_accessor, 3, reader.scratch, positions);
        status != TXC_STATUS_OK)
        return status;
    const std::size_t vertex_count = positions.size() / 3;

    std::vector<float> normals;
    if (const int accessor = attribute(primitive.attributes, "NORMAL"); accessor >= 0) {
        if (const TxcStatus status = read_floats(model, accessor, 3, reader.scratch, normals); status != TXC_STATUS_OK)
            return status;
        if (normals.size() != positions.size())
            return fail(TXC_STATUS_BAD_MODEL, "%s: NORMAL has another length than POSITION", whose);
    }
    for (std::size_t t = 0; t < primitive.targets.size() && t < morph_weights.size(); ++t) {
        TxcStatus status = add_morph(reader, primitive.targets[t], "POSITION", morph_weights[t], whose, positions);
        if (status == TXC_STATUS_OK && !normals.empty())
            status = add_morph(reader, primitive.targets[t], "NORMAL", morph_weights[t], whose, normals);
        if (status != TXC_STATUS_OK) return status;
    }

    if (primitive.material >= static_cast<int>(model.materials.size()))
        return fail(TXC_STATUS_BAD_MODEL, "%s: there is no materials[%d]", whose, primitive.material);
    const std::size_t material =
        primitive.material >= 0 ? static_cast<std::size_t>(primitive.material) : model.materials.size();
    if (primitive.material < 0)
        reader.mesh.has_default_material = true;
    else if (const int texture = model.materials[material].pbrMetallicRoughness.baseColorTexture.index;
             texture >= static_cast<int>(model.textures.size()))
        return fail(TXC_STATUS_BAD_MODEL, "%s: there is no textures[%d]", whose, texture);

    std::vector<float> uvs;
    if (const int accessor =
            attribute(primitive.attributes, "TEXCOORD_" + std::to_string(reader.mesh.materials[material].tex_coord));
        accessor >= 0) {
        if (const TxcStatus status = read_floats(model, accessor, 2, reader.scratch, uvs); status != TXC_STATUS_OK)
            return status;
        if (uvs.size() != vertex_count * 2)
            return fail(TXC_STATUS_BAD_MODEL, "%s: TEXCOORD has another length than POSITION", whose);
        const UvTransform& transform = reader.uv_transforms[material];
        for (std::size_t v = 0; v < vertex_count; ++v) {
            const glm::vec2 uv = transform.apply(uvs[v * 2], uvs[v * 2 + 1]);
            uvs[v * 2] = uv.x;
            uvs[v * 2 + 1] = uv.y;
        }
    }

    std::vector<std::uint32_t> indices;
    if (primitive.indices >= 0) {
        if (const TxcStatus status = read_indices(model, primitive.indices, reader.scratch, indices);
            status != TXC_STATUS_OK)
            return status;
    } else {
        if (const TxcStatus status = reader.scratch.resize(reader.scratch.bytes() + vertex_count * 4, whose);
            status != TXC_STATUS_OK)
            return status;
        indices.resize(vertex_count);
        for (std::size_t i = 0; i < vertex_count; ++i) indices[i] = static_cast<std::uint32_t>(i);
    }
    if (primitive.mode != TINYGLTF_MODE_TRIANGLES) {
        if (const TxcStatus status = reader.scratch.resize(reader.scratch.bytes() + indices.size() * 24, whose);
            status != TXC_STATUS_OK)
            return status;
    }
    to_triangle_list(primitive.mode, indices);

    std::vector<glm::dmat4> vertex_matrices;
    if (joints != nullptr) {
        if (const TxcStatus status = skin_vertices(reader, primitive, *joints, vertex_count, whose, vertex_matrices);
            status != TXC_STATUS_OK)
            return status;
    }
    for (std::size_t v = 0; v < vertex_count; ++v) {
        const glm::dmat4& matrix = vertex_matrices.empty() ? node_matrix : vertex_matrices[v];
        const glm::dvec4 p = matrix * glm::dvec4(positions[v * 3], positions[v * 3 + 1], positions[v * 3 + 2], 1.0);
        for (int c = 0; c < 3; ++c)
            positions[v * 3 + static_cast<std::size_t>(c)] =
                static_cast<float>(p[c] - static_cast<double>(reader.mesh.origin[c]));
        if (normals.empty()) continue;
        const glm::dvec3 n = place_normal(matrix, glm::dvec3(normals[v * 3], normals[v * 3 + 1], normals[v * 3 + 2]));
        const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
        for (int c = 0; c < 3; ++c)
            normals[v * 3 + static_cast<std::size_t>(c)] = length > 0.0 ? static_cast<float>(n[c] / length) : 0.0f;
    }

    // Fronts that are mirrored would be clockwise. One joint may do so and another not.
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        const std::size_t vertex = indices[i];
        const glm::dmat4& matrix = vertex < vertex_matrices.size() ? vertex_matrices[vertex] : node_matrix;
        if (handedness(matrix) < 0.0) std::swap(indices[i + 1], indices[i + 2]);
    }
    PrimitiveArrays arrays;
    arrays.positions = reinterpret_cast<const glm::vec3*>(positions.data());
    arrays.normals = normals.empty() ? nullptr : reinterpret_cast<const glm::vec3*>(normals.data());
    arrays.uvs = uvs.empty() ? nullptr : reinterpret_cast<const glm::vec2*>(uvs.data());
    arrays.vertex_count = static_cast<std::uint32_t>(vertex_count);
    arrays.indices = indices.data();
    arrays.index_count = static_cast<std::uint32_t>(indices.size());
    arrays.material = static_cast<std::uint32_t>(material);
    return place_primitive(reader.mesh, reader.filled, arrays, whose);
}

/// Reads all meshes of the scene's nodes, whose matrices are `global`.
TxcStatus read_scene(Reader& reader, const std::vector<std::size_t>& scene_nodes, const std::vector<glm::dmat4>& global,
                     BudgetShare& skin_scratch) {
    const Model& model = reader.model;
    for (const std::size_t n : scene_nodes) {
        const tinygltf::Node& node = model.nodes[n];
        if (node.mesh < 0) continue;
        const tinygltf::Mesh& mesh = model.meshes[static_cast<std::size_t>(node.mesh)];
        std::vector<glm::dmat4> joints;
        if (node.skin >= 0) {
            skin_scratch.release();
            if (const TxcStatus status = joint_matrices(model, node.skin, global, skin_scratch, joints);
                status != TXC_STATUS_OK)
                return status;
        }
        const std::vector<double>& weights = node.weights.empty() ? mesh.weights : node.weights;
        for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
            char whose[80];
            write_words(whose, sizeof whose, "meshes[%d].primitives[%zu]", node.mesh, p);
            const TxcStatus status = read_primitive(reader, mesh.primitives[p], weights, global[n],
                                                    node.skin >= 0 ? &joints : nullptr, whose);
            if (status != TXC_STATUS_OK) return status;
        }
    }
    return TXC_STATUS_OK;
}

}  // namespace

TxcStatus read_gltf(const std::uint8_t* bytes, std::uint32_t byte_count, MemoryBudget& budget, Mesh& out_mesh) {
    BudgetShare file_share(budget);
    if (const TxcStatus status = check_gltf_container(bytes, byte_count, file_share); status != TXC_STATUS_OK)
        return status;
    Model model;
    if (const TxcStatus status = parse(bytes, byte_count, model); status != TXC_STATUS_OK) return status;

    out_mesh = Mesh{};
    out_mesh.materials.resize(model.materials.size() + 1);  // the last one is glTF's implied default
    std::vector<UvTransform> uv_transforms(out_mesh.materials.size());
    for (std::size_t m = 0; m < model.materials.size(); ++m) {
        if (!read_material(model, model.materials[m], out_mesh.materials[m], uv_transforms[m]))
            return fail(TXC_STATUS_BAD_MODEL, "materials[%zu]: KHR_texture_transform", m);
    }

    std::vector<glm::dmat4> global;
    std::vector<std::size_t> scene_nodes;
    if (const TxcStatus status = place_nodes(model, global, scene_nodes); status != TXC_STATUS_OK) return status;

    // All places of all meshes are counted before the first is read: a small file may have its meshes in very many.
    MeshSize size;
    std::uint64_t places = 0;
    for (const std::size_t n : scene_nodes) {
        const int index = model.nodes[n].mesh;
        if (index < 0) continue;
        if (static_cast<std::size_t>(index) >= model.meshes.size())
            return fail(TXC_STATUS_BAD_MODEL, "nodes[%zu]: there is no meshes[%d]", n, index);
        const std::vector<tinygltf::Primitive>& primitives = model.meshes[static_cast<std::size_t>(index)].primitives;
        places += primitives.size();
        if (places > kMostPlaces)
            return fail(TXC_STATUS_OUT_OF_BUDGET, "nodes[%zu]: up to it, the meshes' parts are in %llu places", n,
                        static_cast<unsigned long long>(places));
        for (const tinygltf::Primitive& primitive : primitives) add_size(model, primitive, byte_count, size);
    }
    BudgetShare mesh_share(budget);
    if (const TxcStatus status = mesh_share.resize(size.byte_count(), "reading the model"); status != TXC_STATUS_OK)
        return status;
    out_mesh.resize(size);

    BudgetShare scratch(budget);
    BudgetShare skin_scratch(budget);
    Reader reader{model, scratch, uv_transforms, out_mesh, {}};
    do {
        reader.filled = {};
        if (const TxcStatus status = read_scene(reader, scene_nodes, global, skin_scratch); status != TXC_STATUS_OK)
            return status;
        if (out_mesh.triangles.empty())
            return fail(TXC_STATUS_NO_TRIANGLES, "the model's scene has only points and lines, or nothing");
        out_mesh.materials.resize(model.materials.size() + (out_mesh.has_default_material ? 1 : 0));
        out_mesh.summarise();
        // Read anew, and not moved: what a node adds to far positions is gone from their floats.
    } while (out_mesh.come_near());
    return TXC_STATUS_OK;
}

}  // namespace txc
