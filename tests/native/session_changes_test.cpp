// What a session is told one thing at a time gives what it gives when told at once: nothing of an earlier state stays.
#include <doctest/doctest.h>

#include <numeric>

#include "support/layer_tree.h"
#include "support/strokes.h"

using namespace support;

namespace {

constexpr std::uint32_t kSize = 32;
constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

TxcLayerDef within(TxcLayerDef def, TxcLayer parent, std::uint32_t role = TXC_ROLE_CONTENT) {
    def.parent = parent;
    def.role = role;
    return def;
}

TxcLayerDef group_def(bool isolated) {
    TxcLayerDef def;
    txc_layer_def_default(&def);
    def.kind = TXC_LAYER_GROUP;
    def.isolated = isolated ? 1 : 0;
    return def;
}

/// A group with layers in it and a mask, upon layers.
class MaskedStack {
public:
    explicit MaskedStack(bool isolated) {
        session_.set_base(target_, base_);
        for (int i = 0; i < 4; ++i) session_.layer(target_, patch());
        const TxcLayer group = session_.layer(target_, group_def(isolated));
        for (int i = 0; i < 4; ++i) session_.layer(target_, within(patch(), group));
        top_def_ = within(patch(), group);
        top_ = session_.layer(target_, top_def_);
        mask_def_ = within(patch(), group, TXC_ROLE_MASK);
        mask_ = session_.layer(target_, mask_def_);
        session_.update(target_);
    }

    void drag(double x) {
        top_def_.position_model[0] = static_cast<float>(x);
        session_.change(top_, top_def_);
    }
    void toggle_mask(bool by_opacity) {
        if (by_opacity) {
            mask_def_.opacity = 0.5f - mask_def_.opacity;
        } else {
            mask_def_.visible ^= 1;
        }
        session_.change(mask_, mask_def_);
    }
    Picture paint() { return session_.paint(target_); }
    /// With nothing held from before.
    Picture paint_anew() {
        session_.set_base(target_, base_);
        return paint();
    }

private:
    TxcLayerDef patch() {
        TxcLayerDef def = decal_def(session_.image(patchy_noise(kSize, random_)));
        def.opacity = 0.5f;
        return def;
    }

    Random random_{37};
    TestSession session_{make_plane()};
    TxcTarget target_ = session_.target(kSize, kSize);
    Picture base_ = make_noise(kSize, kSize, 5, true);
    TxcLayerDef top_def_{};
    TxcLayerDef mask_def_{};
    TxcLayer top_ = 0;
    TxcLayer mask_ = 0;
};

}  // namespace

TEST_CASE("A mesh without indices is one whose corners stand in order") {
    const Shape plane = make_plane();
    Shape corners;
    for (const std::uint32_t index : plane.indices) {
        const auto at = [index](const std::vector<float>& list, std::size_t count) {
            return list.begin() + static_cast<std::ptrdiff_t>(index * count);
        };
        corners.positions.insert(corners.positions.end(), at(plane.positions, 3), at(plane.positions, 3) + 3);
        corners.normals.insert(corners.normals.end(), at(plane.normals, 3), at(plane.normals, 3) + 3);
        corners.uvs.insert(corners.uvs.end(), at(plane.uvs, 2), at(plane.uvs, 2) + 2);
    }
    TestSession in_order(corners);
    CHECK(in_order.model_info().triangle_count == 2);
    corners.indices.resize(corners.vertex_count());
    std::iota(corners.indices.begin(), corners.indices.end(), 0u);
    TestSession by_indices(corners);
    CHECK(in_order.map(in_order.target(kSize, kSize)) == by_indices.map(by_indices.target(kSize, kSize)));
}

TEST_CASE("What hides a decal's texels is asked of the model that is there now") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    TxcLayerDef def = decal_def(session.image(Picture(1, 1, kPaint)));
    def.filter = TXC_FILTER_NEAREST;
    def.occlusion = TXC_OCCLUSION_SELF;
    resize(def, 2, 2, 2);
    session.set_base(target, kBase);
    session.layer(target, def);
    CHECK(session.paint(target) == Picture(kSize, kSize, kPaint));
    session.add(make_plane(0.5, 0.3), 1);
    const TxcTarget behind = session.target(kSize, kSize);
    session.set_base(behind, kBase);
    session.layer(behind, def);
    const Picture painted = session.paint(behind);
    CHECK(painted.at(kSize / 2, kSize / 2) == kBase);
    CHECK(painted.at(1, 1) == kPaint);
}

TEST_CASE("Layers that are shown keep what they paint where a new one takes room that hidden ones held") {
    TestSession session(28);
    session.add(make_plane());
    const TxcTarget target = session.target(512, 512);
    const TxcImage red = session.image(Picture(4, 4, {200, 0, 0, 255}));
    const TxcImage half_blue = session.image(Picture(4, 4, {0, 0, 200, 128}));
    TxcLayerDef def = decal_def(red);
    resize(def, 0.7, 0.7, 2);
    session.layer(target, def);
    TxcLayerDef hidden = decal_def(red);
    resize(hidden, 2, 2, 2);
    const TxcLayer hiding = session.layer(target, hidden);
    session.update(target);
    hidden.visible = 0;
    session.change(hiding, hidden);
    session.update(target);
    // Until less is left than the next layer's tiles take.
    const Picture picture(128, 128);
    while (session.stats().memory_budget_kib - session.stats().memory_used_kib > 1024) session.image(picture);
    const std::uint32_t projections = session.stats().projection_count;
    def.image = half_blue;
    session.layer(target, def);
    const Picture painted = session.paint(target);
    CHECK(session.stats().projection_count == projections + 1);
    CHECK(painted.at(256, 256).red == doctest::Approx(100).epsilon(0.01));
    CHECK(painted.at(256, 256).blue == doctest::Approx(100).epsilon(0.01));
}

TEST_CASE("A brush's colour paints by its own alpha, whatever its tip is") {
    for (const std::uint32_t tip : {TXC_TIP_ROUND, TXC_TIP_MASK}) {
        CAPTURE(tip);
        TestSession session(make_plane());
        const TxcTarget target = session.target(kSize, kSize);
        session.set_base(target, Color{0, 0, 0, 0});
        TxcLayerDef def = stroke_def();
        def.tip = tip;
        def.image = session.image(Picture(2, 2, {0, 0, 0, 255}));
        const float rgba[4] = {1.0f, 0.2f, 0.6f, 0.4f};
        std::copy_n(rgba, 4, def.color);
        add_dabs(session, session.layer(target, def), {dab_at(0, 0, 3.0)});
        CHECK(session.paint(target).at(kSize / 2, kSize / 2) == Color{255, 51, 153, 102});
    }
}

TEST_CASE(
    "A fill that changes keeps its gradient and its triangles, and one that was another kind meanwhile has none") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize, 0);
    session.set_base(target, kBase);
    TxcLayerDef def = fill_def(1, 0, 0);
    const TxcLayer fill = session.layer(target, def);
    const std::uint32_t triangle = 0;
    must(txc_fill_set_triangles(session.id(), fill, &triangle, 1));
    TxcGradient gradient;
    txc_gradient_default(&gradient);
    gradient.from_model[0] = -0.5f;
    gradient.to_model[0] = 0.5f;
    gradient.to_model[1] = 0.0f;
    gradient.stop_count = 2;
    gradient.offsets[1] = 1.0f;
    gradient.colors[3] = 1.0f;
    gradient.colors[5] = gradient.colors[7] = 1.0f;
    must(txc_fill_set_gradient(session.id(), fill, &gradient));
    const Picture shown = session.paint(target);
    CHECK(count_color(shown, kBase) > 300);
    CHECK(shown.at(0, 0) != shown.at(kSize / 2, 0));
    def.opacity = 0.5f;
    session.change(fill, def);
    CHECK(session.paint(target) != shown);
    def.opacity = 1.0f;
    session.change(fill, def);
    CHECK(session.paint(target) == shown);
    TxcLayerDef decal = decal_def(0);
    session.change(fill, decal);
    session.update(target);
    session.change(fill, def);
    CHECK(session.paint(target) == Picture(kSize, kSize, {255, 0, 0, 255}));
}

TEST_CASE("A fill in a mask shows at once, whatever it masks, when it comes, changes and goes") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    const Picture base(kSize, kSize, kBase);
    session.set_base(target, base);
    TxcLayerDef stamp = decal_def(session.image(Picture(1, 1, kPaint)));
    stamp.projector = TXC_PROJECTOR_UV;
    stamp.uv_size[0] = stamp.uv_size[1] = 0.25f;
    stamp.filter = TXC_FILTER_NEAREST;
    const TxcLayer group = session.layer(target, group_def(true));
    const TxcLayer stamped = session.layer(target, within(stamp, group));
    for (const TxcLayer masked : {stamped, group}) {
        CAPTURE(masked);
        const Picture whole = session.paint(target);
        CHECK(whole.at(kSize / 2, kSize / 2) == kPaint);
        TxcLayerDef def = within(fill_def(0, 0, 0, 0.5f), masked, TXC_ROLE_MASK);
        def.blend = TXC_BLEND_ERASE;
        const TxcLayer mask = session.layer(target, def);
        const Picture half = session.paint(target);
        CHECK(half.at(kSize / 2, kSize / 2) == Color{105, 60, 40, 255});
        CHECK(half.at(1, 1) == kBase);
        def.color[3] = 1.0f;
        session.change(mask, def);
        CHECK(session.paint(target) == base);
        def.blend = TXC_BLEND_NORMAL;
        session.change(mask, def);
        CHECK(session.paint(target) == whole);
        must(txc_layer_destroy(session.id(), mask));
        CHECK(session.paint(target) == whole);
    }
}

TEST_CASE("A layer may be moved as deep as one may be made, and no deeper") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(kSize, kSize);
    TxcLayer parent = 0;
    for (std::uint32_t depth = 1; depth < TXC_MAX_DEPTH; ++depth)
        parent = session.layer(target, within(group_def(true), parent));
    TxcLayerDef leaf = fill_def(1, 0, 0);
    session.layer(target, within(leaf, parent));
    const TxcLayer moved_there = session.layer(target, leaf);
    leaf = within(leaf, parent);
    CHECK(txc_layer_update(session.id(), moved_there, &leaf) == TXC_STATUS_OK);
    // With one in it, it lies one deeper.
    TxcLayerDef group = group_def(true);
    const TxcLayer holder = session.layer(target, group);
    session.layer(target, within(fill_def(0, 1, 0), holder));
    group = within(group, parent);
    CHECK(txc_layer_update(session.id(), holder, &group) == TXC_STATUS_BAD_ARGUMENT);
    group.parent = session.layer_def(parent).parent;
    CHECK(txc_layer_update(session.id(), holder, &group) == TXC_STATUS_OK);
}

TEST_CASE("While a layer is dragged in a group, the group's mask may begin and cease to show") {
    for (const bool by_opacity : {false, true}) {
        for (const bool isolated : {false, true}) {
            CAPTURE(by_opacity);
            CAPTURE(isolated);
            MaskedStack dragged(isolated);
            MaskedStack anew(isolated);
            for (int step = 0; step < 24; ++step) {
                CAPTURE(step);
                for (MaskedStack* stack : {&dragged, &anew}) {
                    if (step % 6 == 5) {
                        stack->toggle_mask(by_opacity);
                    } else {
                        stack->drag(0.05 * (step % 5));
                    }
                }
                CHECK(dragged.paint() == anew.paint_anew());
            }
        }
    }
}
