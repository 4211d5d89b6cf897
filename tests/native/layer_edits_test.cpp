// Any sequence of edits ends with the same bytes as building its last state afresh.
#include <doctest/doctest.h>

#include <algorithm>

#include "support/strokes.h"

using namespace support;

namespace {

constexpr std::uint32_t kWidth = 72;
constexpr std::uint32_t kHeight = 56;
constexpr std::uint32_t kMipLevels = 7;

Shape make_scene() {
    Shape shape = make_sphere(1.0, 12, 6, {0.02, 0.05, 0.6, 0.95});
    shape.append(make_plane(1.6, 1.2, {0.65, 0.1, 0.98, 0.9}));
    return shape;
}

Picture picture_of(std::uint32_t which) {
    switch (which % 4) {
        case 0:
            return make_checker(12, 12, 3);
        case 1:
            return make_gradient(20, 10, true);
        case 2:
            return make_noise(7, 5, 90);
        default:
            return make_noise(33, 40, 91, true);
    }
}

/// A layer as the test remembers it: the picture by number, so that a fresh session can make its own.
struct Plan {
    TxcLayerDef def;
    std::uint32_t picture;
    std::vector<TxcDab> dabs = {};  // of a stroke
};

struct Design {
    std::vector<Plan> layers;  // bottom to top
    std::uint32_t base = 0;    // which base picture or colour
};

class Stage {
public:
    Stage() : session_(make_scene()), target_(session_.target(kWidth, kHeight, 2, kMipLevels)) {
        for (std::uint32_t which = 0; which < 4; ++which) images_.push_back(session_.image(picture_of(which)));
    }

    TxcLayer add(const Plan& plan) {
        const TxcLayer layer = session_.layer(target_, with_image(plan));
        grow(layer, plan.dabs);
        return layer;
    }
    void grow(TxcLayer layer, const std::vector<TxcDab>& dabs) { add_dabs(session_, layer, dabs); }
    /// All but a stroke's dabs.
    void adjust(TxcLayer layer, const Plan& plan) { session_.change(layer, with_image(plan)); }
    void change(TxcLayer layer, const Plan& plan) {
        adjust(layer, plan);
        if (plan.def.kind == TXC_LAYER_STROKE) must(txc_stroke_clear(session_.id(), layer));
        grow(layer, plan.dabs);
    }
    void set_base(std::uint32_t which) {
        if (which % 3 == 0) session_.set_base(target_, {static_cast<std::uint8_t>(which * 40), 90, 200, 255});
        if (which % 3 == 1) session_.set_base(target_, make_noise(kWidth, kHeight, which));
        if (which % 3 == 2) session_.set_base(target_, make_noise(50, 90, which));
    }
    /// All levels, one after another.
    std::vector<std::uint8_t> paint() {
        session_.update(target_);
        std::vector<std::uint8_t> bytes;
        for (std::uint32_t level = 0; level < kMipLevels; ++level) {
            const Picture picture = session_.read(target_, level);
            bytes.insert(bytes.end(), picture.rgba.begin(), picture.rgba.end());
        }
        return bytes;
    }
    TestSession& session() { return session_; }
    TxcTarget target() const { return target_; }

private:
    TxcLayerDef with_image(const Plan& plan) const {
        TxcLayerDef def = plan.def;
        if (def.kind != TXC_LAYER_FILL) def.image = images_[plan.picture];
        return def;
    }

    TestSession session_;
    TxcTarget target_;
    std::vector<TxcImage> images_;
};

TxcDab random_dab(Random& random) {
    TxcDab dab = dab_at(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1), random.unit());
    random.rotation(dab.rotation);
    dab.projector = random.below(TXC_PROJECTOR_COUNT);
    dab.uv_size[0] = dab.uv_size[1] = 0.25f;
    return dab;
}

Plan random_plan(Random& random) {
    Plan plan{decal_def(0), random.below(4)};
    TxcLayerDef& def = plan.def;
    if (random.below(8) == 0) {
        def = fill_def(static_cast<float>(random.unit()), static_cast<float>(random.unit()),
                       static_cast<float>(random.unit()), static_cast<float>(random.unit()));
    }
    random.rotation(def.rotation);
    place(def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    resize(def, random.between(0.1, 2), random.between(0.1, 2), random.between(0.1, 3));
    def.opacity = static_cast<float>(random.unit());
    def.lock_alpha = random.below(4) == 0 ? 1 : 0;
    if (random.coin()) def.blend = random.below(TXC_BLEND_COUNT);
    def.blend_space = random.below(4) == 0 ? TXC_BLEND_SPACE_LINEAR : TXC_BLEND_SPACE_SRGB;
    def.filter = random.below(3) == 0 ? TXC_FILTER_NEAREST : TXC_FILTER_LINEAR;
    def.wrap = random.below(4) == 0 ? TXC_WRAP_REPEAT : TXC_WRAP_NONE;
    def.backfaces = random.below(4) == 0 ? 1 : 0;
    def.occlusion = random.coin() ? TXC_OCCLUSION_SELF : TXC_OCCLUSION_NONE;
    def.visible = random.below(6) == 0 ? 0 : 1;
    if (def.kind == TXC_LAYER_DECAL && random.below(3) == 0) {
        def.kind = TXC_LAYER_STROKE;
        def.tip = random.below(TXC_TIP_COUNT);
        def.hardness = static_cast<float>(random.below(3)) / 2;
        def.flow = static_cast<float>(random.unit());
        for (float& channel : def.color) channel = static_cast<float>(random.unit());
        for (std::uint32_t count = random.below(6); count > 0; --count) plan.dabs.push_back(random_dab(random));
    }
    return plan;
}

std::vector<std::uint8_t> paint_afresh(const Design& design) {
    Stage stage;
    stage.set_base(design.base);
    for (const Plan& plan : design.layers) stage.add(plan);
    return stage.paint();
}

/// One random edit, in the design and on the stage alike.
void edit(Random& random, Design& design, Stage& stage, std::vector<TxcLayer>& layers) {
    const std::uint32_t count = static_cast<std::uint32_t>(layers.size());
    const std::uint32_t kind = random.below(20);
    const std::uint32_t which = count > 0 ? random.below(count) : 0;
    if (count == 0 || (kind < 4 && count < 12)) {
        design.layers.push_back(random_plan(random));
        layers.push_back(stage.add(design.layers.back()));
    } else if (kind < 6) {
        must(txc_layer_destroy(stage.session().id(), layers[which]));
        layers.erase(layers.begin() + which);
        design.layers.erase(design.layers.begin() + which);
    } else if (kind < 9) {
        const std::uint32_t to = random.below(count);
        must(txc_layer_move(stage.session().id(), layers[which], to));
        const TxcLayer layer = layers[which];
        const Plan plan = design.layers[which];
        layers.erase(layers.begin() + which);
        layers.insert(layers.begin() + to, layer);
        design.layers.erase(design.layers.begin() + which);
        design.layers.insert(design.layers.begin() + to, plan);
    } else if (kind == 9) {
        design.base = random.below(12);
        stage.set_base(design.base);
    } else {
        Plan& plan = design.layers[which];
        if (plan.def.kind == TXC_LAYER_STROKE && kind < 16) {
            plan.dabs.push_back(random_dab(random));
            stage.grow(layers[which], {plan.dabs.back()});
            return;
        }
        if (kind >= 18) {
            plan = random_plan(random);
            stage.change(layers[which], plan);
            return;
        }
        if (kind < 12)
            plan.def.visible = 1 - plan.def.visible;
        else if (kind < 14)
            plan.def.opacity = static_cast<float>(random.unit());
        else
            place(plan.def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        stage.adjust(layers[which], plan);
    }
}

void run(std::uint64_t seed, int steps) {
    Random random(seed);
    Stage stage;
    Design design;
    stage.set_base(design.base);
    std::vector<TxcLayer> layers;
    for (int step = 1; step <= steps; ++step) {
        edit(random, design, stage, layers);
        // Sometimes several edits go into one update.
        if (step % 10 != 0 && random.coin()) stage.session().update(stage.target());
        // Sometimes an update has time for a layer or a dab or two, or for none.
        TxcUpdate part{};
        if (step % 10 != 0 && random.coin())
            must(txc_target_update(stage.session().id(), stage.target(), random.below(3) * 2048, &part));
        if (step % 10 != 0) continue;
        CAPTURE(seed);
        CAPTURE(step);
        REQUIRE(stage.paint() == paint_afresh(design));
    }
}

}  // namespace

TEST_CASE("Two hundred edits at random end, at every tenth, where a fresh start ends") {
    run(1, 200);
    run(2, 200);
}

TEST_CASE("Undoing edits in reverse gives the bytes of each state again") {
    Random random(93);
    Stage stage;
    stage.set_base(1);
    Plan plan = random_plan(random);
    plan.def.visible = 1;
    stage.add(random_plan(random));
    const TxcLayer layer = stage.add(plan);
    stage.add(random_plan(random));
    std::vector<Plan> states{plan};
    std::vector<std::vector<std::uint8_t>> pictures{stage.paint()};
    for (int i = 0; i < 15; ++i) {
        states.push_back(random_plan(random));
        stage.change(layer, states.back());
        pictures.push_back(stage.paint());
    }
    for (std::size_t i = states.size(); i-- > 0;) {
        stage.change(layer, states[i]);
        CHECK_UNARY(stage.paint() == pictures[i]);
    }
}
