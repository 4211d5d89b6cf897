// A window of a texture has the very texels of the whole.
#include <doctest/doctest.h>

#include <string>

#include "support/picture.h"
#include "support/projector_defs.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kWhole = 192;
constexpr std::uint32_t kMargin = 32;  // more than gutter and bleed of textures as small as those below

struct Window {
    std::uint32_t x, y, width, height;
};

TxcTargetDef window_def(const Window& window, std::uint32_t whole = kWhole) {
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.width = window.width;
    def.height = window.height;
    def.texture_width = def.texture_height = whole;
    def.window_x = window.x;
    def.window_y = window.y;
    return def;
}

TxcTarget open_window(TestSession& session, const Window& window, std::uint32_t whole = kWhole) {
    const TxcTargetDef def = window_def(window, whole);
    TxcTarget target = 0;
    must(txc_target_create(session.id(), &def, &target));
    session.bake(target);
    return target;
}

/// Base picture, a decal with occlusion, a curved one, a stamp and a gradient fill: what reads texels' places.
void add_layers(TestSession& session, TxcTarget target, TxcImage image) {
    session.set_base(target, make_noise(40, 30, 7));
    TxcLayerDef decal = decal_def(image);
    decal.occlusion = TXC_OCCLUSION_SELF;
    resize(decal, 0.9, 0.7, 2.0);
    turn(decal, 0.6, 0.8, 0.0, 30.0);
    session.layer(target, decal);
    TxcLayerDef label = cylindrical_def(image, 0.5, 0.4, 300.0, 0.3);
    label.blend = TXC_BLEND_MULTIPLY;
    session.layer(target, label);
    TxcLayerDef stamp = decal_def(image);
    stamp.projector = TXC_PROJECTOR_UV;
    stamp.uv_size[0] = stamp.uv_size[1] = 0.4f;
    stamp.uv_angle_degrees = 20.0f;
    stamp.opacity = 0.5f;
    session.layer(target, stamp);
    const TxcLayer fill = session.layer(target, fill_def(0, 0, 0));
    TxcGradient gradient;
    txc_gradient_default(&gradient);
    gradient.colors[3] = 0.6f;
    gradient.colors[7] = 0.0f;
    gradient.stop_count = 2;
    gradient.offsets[1] = 1.0f;
    must(txc_fill_set_gradient(session.id(), fill, &gradient));
}

Picture read_bled(TestSession& session, TxcTarget target) {
    session.update(target);
    const TxcMapInfo info = session.map_info(target);
    Picture picture(info.width, info.height);
    must(txc_target_read_bled(session.id(), target, 0, info.height, picture.rgba.data()));
    return picture;
}

/// Of what lies further from the borders that the window cuts than the margin.
void check_same_as_whole(const Picture& whole, const Picture& part, const Window& window) {
    const std::uint32_t width = whole.width;
    const std::uint32_t height = whole.height;
    std::uint32_t different = 0;
    std::uint32_t compared = 0;
    for (std::uint32_t y = 0; y < window.height; ++y) {
        for (std::uint32_t x = 0; x < window.width; ++x) {
            const std::uint32_t right = window.x + window.width;
            const std::uint32_t bottom = window.y + window.height;
            if ((window.x > 0 && x < kMargin) || (right < width && x + kMargin >= window.width)) continue;
            if ((window.y > 0 && y < kMargin) || (bottom < height && y + kMargin >= window.height)) continue;
            ++compared;
            different += part.at(x, y) == whole.at(window.x + x, window.y + y) ? 0 : 1;
        }
    }
    CHECK(compared > 1000);
    CHECK(different == 0);
}

void check_windows(const Shape& shape) {
    TestSession session(shape);
    const TxcImage image = session.image(make_noise(64, 48, 3));
    const TxcTarget target = session.target(kWhole, kWhole);
    add_layers(session, target, image);
    const Picture whole = read_bled(session, target);
    for (const Window& window : {Window{0, 0, 128, 128}, Window{64, 0, 128, 144}, Window{16, 80, 112, 112},
                                 Window{0, 96, 192, 96}, Window{48, 48, 112, 112}}) {
        CAPTURE(window.x);
        CAPTURE(window.y);
        const TxcTarget part = open_window(session, window);
        add_layers(session, part, image);
        check_same_as_whole(whole, read_bled(session, part), window);
        must(txc_target_destroy(session.id(), part));
    }
}

}  // namespace

TEST_CASE("A window of a texture has the very texels of the whole, bleed and gutter included") {
    check_windows(make_sphere(0.5));
    check_windows(make_cube());
}

TEST_CASE("So has a window of a texture that repeats, or that several triangles share") {
    check_windows(make_sphere(0.5, 32, 16, {-0.4, 0.3, 0.9, 1.2}));
    Shape twice = make_plane();
    twice.append(make_sphere(0.4, 16, 8, {0.2, 0.1, 0.8, 0.7}));
    check_windows(twice);
}

TEST_CASE("A window of few tiles has the very texels of a whole of many") {
    constexpr std::uint32_t kLarge = 1024;
    TestSession session(make_sphere(0.5));
    const TxcImage image = session.image(make_noise(640, 640, 3));
    const auto add = [&](TxcTarget target) {
        TxcLayerDef decal = decal_def(image);
        resize(decal, 0.9, 0.9, 2.0);
        session.layer(target, decal);
        TxcLayerDef label = cylindrical_def(image, 0.5, 0.6, 180.0, 0.3);
        label.opacity = 0.5f;
        session.layer(target, label);
    };
    const TxcTarget target = session.target(kLarge, kLarge);
    add(target);
    const Picture whole = read_bled(session, target);
    const Window window{256, 384, 256, 256};
    const TxcTarget part = open_window(session, window, kLarge);
    add(part);
    check_same_as_whole(whole, read_bled(session, part), window);
}

TEST_CASE("A window tells the overlaps that lie in it") {
    Shape twice = make_plane();
    twice.append(make_plane(1.0, 0.1));
    TestSession session(twice);
    const TxcTarget part = open_window(session, {64, 32, 64, 96});
    const TxcMapInfo info = session.map_info(part);
    CHECK(info.covered_texels == 64 * 96);
    CHECK(info.overlapping_texels == 64 * 96);
}

TEST_CASE("A window's counts go to their end, whatever lies beside it") {
    Shape many;
    for (int i = 0; i < 300; ++i) many.append(make_plane(1.0, i * 0.01, {0.0, 0.0, 1.0, i % 2 == 0 ? 1.0 : 0.5}));
    TestSession session(many);
    // Half of the planes end in its middle row.
    const MapArrays map = session.map(open_window(session, {64, 32, 64, 128}));
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) CHECK_UNARY(map.overlap_at(x, y) == (y < 64 ? 255 : 150));
    }
}

TEST_CASE("A window that the texture does not have is refused by name") {
    TestSession session(make_plane());
    const auto refuses = [&](const TxcTargetDef& def, TxcStatus status, const char* words) {
        TxcTarget target = 0;
        CHECK(txc_target_create(session.id(), &def, &target) == status);
        INFO(txc_error_detail());
        CHECK(std::string(txc_error_detail()).find(words) != std::string::npos);
    };
    TxcTargetDef def = window_def({8, 0, 64, 64});
    refuses(def, TXC_STATUS_BAD_ARGUMENT, "multiples of 16");
    def = window_def({144, 0, 64, 64});
    refuses(def, TXC_STATUS_BAD_ARGUMENT, "beyond the texture's 192 x 192");
    def = window_def({0, 0, 64, 64});
    def.mip_levels = 0;
    refuses(def, TXC_STATUS_BAD_ARGUMENT, "a window of a texture has 1");
    def.mip_levels = 1;
    def.texture_width = TXC_MAX_TEXTURE_SIZE + 1;
    refuses(def, TXC_STATUS_BAD_SIZE, "at most 16384");
}
