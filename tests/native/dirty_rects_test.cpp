// What an update reports: rectangles that hold every change, and no more than it must.
#include "dirty_rects.h"

#include <doctest/doctest.h>

#include "support/random.h"
#include "support/test_session.h"

using namespace support;

namespace {

/// All levels of a target as a host keeps them: written by nothing but the updates' rectangles.
class Mirror {
public:
    Mirror(std::uint32_t width, std::uint32_t height, std::uint32_t levels) {
        for (std::uint32_t level = 0; level < levels; ++level)
            levels_.emplace_back(std::max(1u, width >> level), std::max(1u, height >> level), Color{1, 2, 3, 4});
    }

    /// Copies the packed bytes; true if all rectangles lie inside their levels, apart from each other, and end to end in
    /// the packed bytes.
    bool apply(const UpdateReport& report) {
        std::vector<std::vector<bool>> written;
        for (const Picture& level : levels_) written.emplace_back(level.width * level.height, false);
        std::size_t expected_offset = 0;
        for (const TxcRect& rect : report.rects) {
            if (rect.level >= levels_.size() || rect.byte_offset != expected_offset) return false;
            Picture& level = levels_[rect.level];
            if (rect.width == 0 || rect.height == 0 || rect.x + rect.width > level.width ||
                rect.y + rect.height > level.height)
                return false;
            expected_offset += static_cast<std::size_t>(rect.width) * rect.height * 4;
            if (expected_offset > report.bytes.size()) return false;
            const std::uint8_t* from = report.bytes.data() + rect.byte_offset;
            for (std::uint32_t y = rect.y; y < rect.y + rect.height; ++y) {
                for (std::uint32_t x = rect.x; x < rect.x + rect.width; ++x, from += 4) {
                    if (written[rect.level][y * level.width + x]) return false;
                    written[rect.level][y * level.width + x] = true;
                    level.set(x, y, {from[0], from[1], from[2], from[3]});
                }
            }
        }
        return expected_offset == report.bytes.size();
    }
    const Picture& level(std::uint32_t level) const { return levels_[level]; }

private:
    std::vector<Picture> levels_;
};

std::uint64_t texels_of(const UpdateReport& report, std::uint32_t level) {
    std::uint64_t texels = 0;
    for (const TxcRect& rect : report.rects) texels += rect.level == level ? rect.width * rect.height : 0;
    return texels;
}

}  // namespace

TEST_CASE("The first update covers every level whole") {
    for (const auto& size : {std::pair{64u, 64u}, {100u, 37u}, {1u, 1u}, {3u, 200u}, {513u, 2u}}) {
        const std::uint32_t width = size.first;
        const std::uint32_t height = size.second;
        CAPTURE(width);
        CAPTURE(height);
        TestSession session(make_plane());
        const TxcTarget target = session.target(width, height, 0, 0);
        const std::uint32_t levels = session.map_info(target).mip_levels;
        const UpdateReport report = session.report(target);
        CHECK(report.update.rect_count == report.rects.size());
        CHECK(report.update.byte_count == report.bytes.size());
        Mirror mirror(width, height, levels);
        CHECK(mirror.apply(report));
        for (std::uint32_t level = 0; level < levels; ++level) {
            CHECK(texels_of(report, level) ==
                  static_cast<std::uint64_t>(mirror.level(level).width) * mirror.level(level).height);
            CHECK(mirror.level(level) == session.read(target, level));
        }
    }
}

TEST_CASE("An update without a change reports no rectangle") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64, 0, 0);
    TxcLayerDef def = decal_def(session.image(make_checker(8, 8, 2)));
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    const UpdateReport again = session.report(target);
    CHECK(again.update.rect_count == 0);
    CHECK(again.update.byte_count == 0);
    CHECK(again.update.composited_texels == 0);
    CHECK(txc_target_update_rects(session.id(), target) == nullptr);
    session.change(layer, def);  // the same
    CHECK(session.report(target).update.composited_texels == 0);
    // Painted again, but the same bytes come out.
    def.rotation[3] = 2.0f;
    session.change(layer, def);
    const UpdateReport same = session.report(target);
    CHECK(same.update.projected_layers == 1);
    CHECK(same.update.rect_count == 0);
}

TEST_CASE("Rectangles alone keep a host's copy of every level up to date through random edits") {
    for (const auto& size : {std::pair{160u, 96u}, {100u, 75u}, {333u, 65u}}) {
        TestSession session(make_sphere(1.0, 24, 12));
        const TxcTarget target = session.target(size.first, size.second, 2, 0);
        const std::uint32_t levels = session.map_info(target).mip_levels;
        Mirror mirror(size.first, size.second, levels);
        Random random(100);
        std::vector<TxcLayer> layers;
        const TxcImage image = session.image(make_gradient(16, 16, true));
        for (int step = 0; step < 40; ++step) {
            TxcLayerDef def = decal_def(image);
            random.rotation(def.rotation);
            place(def, random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
            resize(def, random.between(0.05, 0.7), random.between(0.05, 0.7), 1);
            if (layers.size() < 5 || random.below(4) == 0)
                layers.push_back(session.layer(target, def));
            else
                session.change(layers[random.below(static_cast<std::uint32_t>(layers.size()))], def);
            if (step == 25) session.set_base(target, make_noise(size.first, size.second, 101));
            CAPTURE(step);
            REQUIRE(mirror.apply(session.report(target)));
            for (std::uint32_t level = 0; level < levels; ++level)
                REQUIRE(mirror.level(level) == session.read(target, level));
        }
    }
}

TEST_CASE("A small change in a large texture reports small rectangles") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(1024, 1024, 0, 0);
    TxcLayerDef def = decal_def(session.image(Picture(1, 1, {0, 0, 0, 255})));
    def.filter = TXC_FILTER_NEAREST;
    resize(def, 0.05, 0.05, 1);
    place(def, -0.4, 0.4, 0);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    place(def, 0.4, -0.4, 0);
    session.change(layer, def);
    const UpdateReport report = session.report(target);
    // 51 texels wide, at opposite corners: two rectangles of at most 5 tiles a side, not one of the whole texture.
    CHECK(texels_of(report, 0) <= 2 * 80 * 80);
    CHECK(texels_of(report, 0) >= 2 * 51 * 51);
    CHECK(texels_of(report, 1) <= texels_of(report, 0));
}

TEST_CASE("Levels that were not asked for are not reported") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64, 0, 3);
    CHECK(session.map_info(target).mip_levels == 3);
    const UpdateReport report = session.report(target);
    for (const TxcRect& rect : report.rects) CHECK(rect.level < 3);
    CHECK(texels_of(report, 2) == 16 * 16);
    std::uint8_t texel[4];
    CHECK(txc_target_read(session.id(), target, 3, 0, 0, 1, 1, texel) == TXC_STATUS_BAD_ARGUMENT);
}

TEST_CASE("Rectangles cover every marked tile once, and are few") {
    Random random(102);
    for (int round = 0; round < 300; ++round) {
        const std::uint32_t columns = 1 + random.below(24);
        const std::uint32_t rows = 1 + random.below(24);
        std::vector<std::uint8_t> marked(columns * rows, 0);
        std::uint32_t marked_count = 0;
        // A few blocks, as decals mark them.
        for (std::uint32_t blocks = random.below(4); blocks > 0; --blocks) {
            const std::uint32_t x0 = random.below(columns);
            const std::uint32_t y0 = random.below(rows);
            for (std::uint32_t y = y0; y < std::min(rows, y0 + 1 + random.below(6)); ++y) {
                for (std::uint32_t x = x0; x < std::min(columns, x0 + 5); ++x) marked[y * columns + x] = 1;
            }
        }
        for (const std::uint8_t mark : marked) marked_count += mark;
        const std::uint64_t cost = random.below(200);
        std::vector<txc::TileRect> rects;
        txc::cover_tiles(marked, columns, cost, rects);
        std::vector<std::uint32_t> covered(columns * rows, 0);
        for (const txc::TileRect& r : rects) {
            REQUIRE(r.x0 < r.x1);
            REQUIRE(r.y0 < r.y1);
            REQUIRE(r.x1 <= columns);
            REQUIRE(r.y1 <= rows);
            for (std::uint32_t y = r.y0; y < r.y1; ++y) {
                for (std::uint32_t x = r.x0; x < r.x1; ++x) ++covered[y * columns + x];
            }
        }
        std::uint64_t covered_count = 0;
        for (std::size_t t = 0; t < covered.size(); ++t) {
            REQUIRE(covered[t] <= 1);
            REQUIRE(covered[t] >= marked[t]);
            covered_count += covered[t];
        }
        // Never dearer than one rectangle around everything.
        CHECK_UNARY(covered_count + rects.size() * cost <= columns * rows + cost);
        CHECK_UNARY((rects.empty() == (marked_count == 0)));
    }
}

TEST_CASE("From mark to mark all marks are met, each once and in order, in lists of any length") {
    Random random(3);
    for (std::size_t size = 0; size < 40; ++size) {
        std::vector<std::uint8_t> marks(size, 0);
        std::vector<std::size_t> places;
        for (std::size_t at = 0; at < size; ++at) {
            if (random.below(9) != 0) continue;
            marks[at] = 1;
            places.push_back(at);
        }
        std::vector<std::size_t> met;
        for (std::size_t at = txc::next_mark(marks, 0); at < size; at = txc::next_mark(marks, at + 1))
            met.push_back(at);
        CHECK(met == places);
        CHECK(txc::next_mark(marks, size) == size);
    }
}

TEST_CASE("A cut is made only where it saves more than a rectangle costs") {
    // Two single tiles, ten apart: eleven tiles in one, two in two.
    std::vector<std::uint8_t> marked(11, 0);
    marked[0] = marked[10] = 1;
    std::vector<txc::TileRect> rects;
    txc::cover_tiles(marked, 11, 8, rects);
    CHECK(rects.size() == 2);
    txc::cover_tiles(marked, 11, 9, rects);
    CHECK(rects.size() == 1);
}

TEST_CASE("Of the cuts that pay, the one that saves most is made, be it along rows or columns") {
    // Two bars side by side, the one moved along by two tiles: cut between them they are two whole rectangles.
    for (const bool is_upright : {false, true}) {
        CAPTURE(is_upright);
        const std::uint32_t columns = is_upright ? 6 : 8;
        std::vector<std::uint8_t> marked(6 * 8, 0);
        for (std::uint32_t along = 0; along < 6; ++along) {
            for (std::uint32_t across = 0; across < 2; ++across) {
                const std::uint32_t first[2] = {along, across};
                const std::uint32_t second[2] = {along + 2, across + 4};
                for (const auto& at : {first, second})
                    marked[at[is_upright ? 0 : 1] * columns + at[is_upright ? 1 : 0]] = 1;
            }
        }
        std::vector<txc::TileRect> rects;
        txc::cover_tiles(marked, columns, 2, rects);
        CHECK(rects.size() == 2);
    }
}
