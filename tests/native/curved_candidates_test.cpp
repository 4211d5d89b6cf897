// The broad phase of the projectors that are not planar: no texel that takes paint may be missed.
#include <doctest/doctest.h>

#include <algorithm>

#include "curved_projection.h"
#include "picture_sampler.h"
#include "support/core_mesh.h"
#include "support/projector_defs.h"
#include "support/reference_projector.h"

using namespace support;

namespace {

/// A map of a shape, baked by the core's own parts, and a picture.
class Easel {
public:
    Easel(const Shape& shape, std::uint32_t width, std::uint32_t height)
        : mesh_(make_core_mesh(shape)), image_(budget_) {
        std::unique_ptr<txc::MapBaker> baker;
        must(txc::MapBaker::begin(mesh_, {0, width, height, 2}, budget_, baker));
        while (baker->step(1u << 20) == TXC_STATUS_PENDING) continue;
        map_ = baker->take();
        const Picture picture(3, 2, {255, 255, 255, 255});  // few pixels: they reach far beyond the rectangle
        must(image_.build(picture.width, picture.height, picture.rgba.data()));
    }

    struct Count {
        std::uint32_t found = 0;
        std::uint32_t painted = 0;
    };

    /// Paints over every tile and over the tiles found: the same bytes must come out.
    Count check(const TxcLayerDef& def) {
        txc::CurvedProjector projector;
        must(txc::read_curved_projector(def, glm::vec3(0.0f), projector));
        txc::DecalSettings settings;
        settings.nearest = def.filter == TXC_FILTER_NEAREST;
        settings.repeat = def.wrap == TXC_WRAP_REPEAT;
        settings.backfaces = true;
        std::vector<std::uint32_t> all(map_->tiles.size());
        for (std::uint32_t place = 0; place < all.size(); ++place) all[place] = place;
        txc::LayerTiles by_all(budget_);
        txc::LayerTiles by_search(budget_);
        std::uint32_t texels_of_all = 0;
        std::uint32_t texels_of_search = 0;
        const std::vector<std::uint32_t> found = find_curved_candidates(*map_, settings, projector, image_);
        const auto project = [&](const std::vector<std::uint32_t>& places, txc::LayerTiles& out,
                                 std::uint32_t& texels) {
            must(
                project_curved_decal(*map_, mesh_, settings, projector, image_, places, nullptr, nullptr, out, texels));
        };
        project(all, by_all, texels_of_all);
        project(found, by_search, texels_of_search);
        CHECK(texels_of_all == texels_of_search);
        CHECK_UNARY(by_all.indices == by_search.indices);
        CHECK_UNARY(by_all.texels == by_search.texels);
        CHECK_UNARY(std::is_sorted(found.begin(), found.end()));
        CHECK_UNARY(std::adjacent_find(found.begin(), found.end()) == found.end());
        return {static_cast<std::uint32_t>(found.size()), static_cast<std::uint32_t>(by_all.indices.size())};
    }

private:
    txc::MemoryBudget budget_{1u << 30};
    txc::Mesh mesh_;
    std::shared_ptr<txc::LocalSpaceMap> map_;
    txc::ImagePyramid image_;
};

Shape make_scene() {
    Shape shape = make_sphere(1.0, 24, 12, {0.0, 0.0, 0.5, 1.0});
    shape.append(make_cylinder(0.7, 2.0, 24, {0.5, 0.1, 0.95, 0.9}));
    return shape;
}

void vary(TxcLayerDef& def, Random& random) {
    def.filter = random.below(2);
    def.wrap = random.below(2);
    random.rotation(def.rotation);
}

TxcLayerDef any_slide(Random& random, double scale = 1.0) {
    const double near_distance = std::pow(10.0, random.between(-2, 0)) * scale;
    TxcLayerDef def = perspective_def(0, random.between(3, random.coin() ? 40 : 175), random.between(0.3, 3),
                                      near_distance, near_distance + random.between(0.1, 4) * scale);
    vary(def, random);
    return def;
}

TxcLayerDef any_label(Random& random, double scale = 1.0) {
    TxcLayerDef def =
        cylindrical_def(0, random.between(0.05, 1.2) * scale, random.between(0.05, 1.5) * scale,
                        random.below(4) == 0 ? 360 : random.between(3, 359), random.between(0.02, 0.5) * scale);
    vary(def, random);
    return def;
}

}  // namespace

TEST_CASE("Every tile that a slide paints is found, and few others") {
    Easel easel(make_scene(), 300, 200);
    Random random(110);
    std::uint32_t found = 0;
    std::uint32_t painted = 0;
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        TxcLayerDef def = any_slide(random);
        place(def, random.between(-2, 2), random.between(-2, 2), random.between(-2, 2));
        const Easel::Count count = easel.check(def);
        found += count.found;
        painted += count.painted;
    }
    CHECK(painted > 1000);
    // Boxes are not their contents: near and far cut most slides out of a hollow scene.
    CHECK(found < painted * 4);
}

TEST_CASE("Every tile that a label paints is found, and few others") {
    Easel easel(make_scene(), 300, 200);
    Random random(111);
    std::uint32_t found = 0;
    std::uint32_t painted = 0;
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        TxcLayerDef def = any_label(random);
        place(def, random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(-0.5, 0.5));
        const Easel::Count count = easel.check(def);
        found += count.found;
        painted += count.painted;
    }
    CHECK(painted > 1000);
    CHECK(found < painted * 2);
}

TEST_CASE("Every tile that a stamp paints is found, and few others") {
    Easel easel(make_scene(), 300, 200);
    Random random(112);
    std::uint32_t found = 0;
    std::uint32_t painted = 0;
    for (int round = 0; round < 300; ++round) {
        CAPTURE(round);
        TxcLayerDef def = uv_def(0, random.between(-0.2, 1.2), random.between(-0.2, 1.2), random.between(0.001, 0.6),
                                 random.between(0.001, 0.6), random.between(-360, 360));
        def.filter = random.below(2);
        def.wrap = random.below(2);
        const Easel::Count count = easel.check(def);
        found += count.found;
        painted += count.painted;
    }
    CHECK(painted > 1000);
    CHECK(found < painted * 2);
}

TEST_CASE("Texels as large as the projector itself are not missed") {
    // A few texels over the whole scene: their footprints are far from what they look like at their centres.
    Easel easel(make_scene(), 12, 9);
    Random random(113);
    std::uint32_t painted = 0;
    for (int round = 0; round < 600; ++round) {
        CAPTURE(round);
        TxcLayerDef def = round % 2 == 0 ? any_slide(random, 0.3) : any_label(random, 0.5);
        place(def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        painted += easel.check(def).painted;
    }
    CHECK(painted > 300);
}

TEST_CASE("On a model far from the origin no tile is missed either") {
    Easel easel(moved(make_sphere(1.0, 24, 12), 800, -300, 500), 256, 128);
    Random random(114);
    std::uint32_t painted = 0;
    for (int round = 0; round < 200; ++round) {
        CAPTURE(round);
        TxcLayerDef def = round % 2 == 0 ? any_slide(random) : any_label(random);
        place(def, 800 + random.between(-1, 1), -300 + random.between(-1, 1), 500 + random.between(-1, 1));
        painted += easel.check(def).painted;
    }
    CHECK(painted > 400);
}

TEST_CASE("A projector away from the model touches no tile") {
    Easel easel(make_scene(), 128, 64);
    TxcLayerDef slide = perspective_def(0, 30, 1, 0.1, 2);
    place(slide, 0, 0, 5);
    CHECK(easel.check(slide).found == 0);
    place(slide, 0, 0, -2);  // it looks the other way
    CHECK(easel.check(slide).found == 0);
    TxcLayerDef label = cylindrical_def(0, 0.5, 1, 360, 0.1);
    place(label, 5, 0, 0);
    CHECK(easel.check(label).found == 0);
    label = cylindrical_def(0, 3, 1, 360, 0.5);
    CHECK(easel.check(label).found == 0);
    CHECK(easel.check(uv_def(0, 1.5, 0.5, 0.3, 0.3, 0)).found == 0);
}
