// The broad phase: no texel that the decal paints may be missed.
#include "tile_tree.h"

#include <doctest/doctest.h>

#include <algorithm>

#include "support/core_mesh.h"

using namespace support;

namespace {

/// A map of a shape, baked by the core's own parts.
class BakedMap {
public:
    BakedMap(const Shape& shape, std::uint32_t width, std::uint32_t height) : mesh_(make_core_mesh(shape)) {
        std::unique_ptr<txc::MapBaker> baker;
        must(txc::MapBaker::begin(mesh_, {0, width, height, 2}, budget_, baker));
        while (baker->step(1u << 20) == TXC_STATUS_PENDING) continue;
        map_ = baker->take();
    }
    const txc::LocalSpaceMap& map() const { return *map_; }

private:
    txc::MemoryBudget budget_{1u << 30};
    txc::Mesh mesh_;
    std::shared_ptr<txc::LocalSpaceMap> map_;
};

/// Tiles (by their index) with a texel whose centre lies in the decal's box.
std::vector<std::uint32_t> tiles_by_scan(const txc::LocalSpaceMap& map, const txc::PlanarProjector& projector) {
    std::vector<std::uint32_t> tiles;
    map.for_each_run(0, map.key.height, [&](const txc::TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
        for (std::uint32_t i = 0; i < run.length; ++i) {
            const std::uint32_t x = tile_x + run.x + i;
            const glm::vec3 p =
                map.frames[run.frame].position_at(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y));
            const glm::dvec3 q = projector.to_decal.apply(glm::dvec3(p));
            if (std::fabs(q.x) > 0.5 || std::fabs(q.y) > 0.5 || std::fabs(q.z) > 0.5) continue;
            tiles.push_back(y / txc::kTileSize * map.tile_columns() + x / txc::kTileSize);
        }
    });
    std::sort(tiles.begin(), tiles.end());
    tiles.erase(std::unique(tiles.begin(), tiles.end()), tiles.end());
    return tiles;
}

}  // namespace

TEST_CASE("Every tile with a texel in the decal's box is found, and few others") {
    Shape shape = make_sphere(1.0, 24, 12, {0.0, 0.0, 0.5, 1.0});
    shape.append(make_cylinder(0.7, 2.0, 24, {0.5, 0.1, 0.95, 0.9}));
    const BakedMap baked(shape, 300, 200);
    Random random(60);
    std::uint32_t found_total = 0;
    std::uint32_t needed_total = 0;
    for (int round = 0; round < 300; ++round) {
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        place(def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        resize(def, random.between(0.02, 1), random.between(0.02, 1), random.between(0.02, 1));
        const txc::PlanarProjector projector = make_projector(def);
        const std::vector<std::uint32_t> needed = tiles_by_scan(baked.map(), projector);
        std::vector<std::uint32_t> places;
        baked.map().tree.find(baked.map(), projector.to_decal, places);
        CHECK_UNARY(std::is_sorted(places.begin(), places.end()));
        std::vector<std::uint32_t> found;
        for (const std::uint32_t place : places) found.push_back(baked.map().tiles[place].index);
        CAPTURE(round);
        CHECK_UNARY(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
        found_total += static_cast<std::uint32_t>(found.size());
        needed_total += static_cast<std::uint32_t>(needed.size());
    }
    CHECK(needed_total > 1000);
    // Boxes are not their contents, but a broad phase that hands on everything would be none.
    CHECK(found_total < needed_total * 4);
}

TEST_CASE("A decal away from the model touches no tile") {
    const BakedMap baked(make_sphere(1.0), 128, 64);
    TxcLayerDef def = decal_def(0);
    place(def, 3, 0, 0);
    const txc::PlanarProjector projector = make_projector(def);
    std::vector<std::uint32_t> places{1, 2, 3};
    baked.map().tree.find(baked.map(), projector.to_decal, places);
    CHECK(places.empty());
}

TEST_CASE("A small decal paints exactly the texels that a scan of the whole map finds inside its box") {
    Shape shape = make_sphere(1.0, 24, 12);
    TestSession session(shape);
    const TxcTarget target = session.target(200, 120);
    const MapArrays map = session.map(target);
    Random random(61);
    for (int round = 0; round < 40; ++round) {
        TxcLayerDef def = decal_def(session.image(Picture(1, 1, {0, 0, 0, 255})));
        def.filter = TXC_FILTER_NEAREST;
        def.backfaces = 1;
        def.angle_fade_start = def.angle_fade_end = 90.0f;
        random.rotation(def.rotation);
        place(def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
        resize(def, random.between(0.02, 0.5), random.between(0.02, 0.5), random.between(0.02, 0.5));
        const TxcLayer layer = session.layer(target, def);
        const Picture painted = session.paint(target);
        const txc::PlanarProjector projector = make_projector(def);
        std::uint32_t wrong = 0;
        for (std::uint32_t y = 0; y < map.height; ++y) {
            for (std::uint32_t x = 0; x < map.width; ++x) {
                if (map.coverage_at(x, y) == 0) continue;
                const float* p = map.position(x, y);
                const glm::dvec3 q = projector.to_decal.apply({p[0], p[1], p[2]});
                const double outermost = std::max({std::fabs(q.x), std::fabs(q.y), std::fabs(q.z)});
                if (std::fabs(outermost - 0.5) < 1e-4) continue;  // rounding decides
                wrong += (painted.at(x, y).red == 0) != (outermost < 0.5) ? 1 : 0;
            }
        }
        CAPTURE(round);
        CHECK(wrong == 0);
        must(txc_layer_destroy(session.id(), layer));
    }
}

TEST_CASE("Small decals on a model far from the origin are found whole") {
    const BakedMap baked(moved(make_sphere(1.0, 24, 12), 800, -300, 500), 256, 128);
    Random random(62);
    std::uint32_t needed_total = 0;
    for (int round = 0; round < 200; ++round) {
        TxcLayerDef def = decal_def(0);
        random.rotation(def.rotation);
        place(def, 800 + random.between(-1, 1), -300 + random.between(-1, 1), 500 + random.between(-1, 1));
        resize(def, random.between(0.02, 0.6), random.between(0.02, 0.6), random.between(0.02, 0.6));
        const txc::PlanarProjector projector = make_projector(def);
        const std::vector<std::uint32_t> needed = tiles_by_scan(baked.map(), projector);
        std::vector<std::uint32_t> places;
        baked.map().tree.find(baked.map(), projector.to_decal, places);
        std::vector<std::uint32_t> found;
        for (const std::uint32_t place : places) found.push_back(baked.map().tiles[place].index);
        CHECK_UNARY(std::includes(found.begin(), found.end(), needed.begin(), needed.end()));
        needed_total += static_cast<std::uint32_t>(needed.size());
    }
    CHECK(needed_total > 400);
}
