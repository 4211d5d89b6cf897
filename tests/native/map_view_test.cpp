// The map as pictures for people, as the paper's figure shows it (texelcast.h, TxcMapView).
#include <doctest/doctest.h>

#include "support/test_session.h"

using namespace support;

namespace {

Picture view(const TestSession& session, TxcTarget target, std::uint32_t which) {
    const TxcMapInfo info = session.map_info(target);
    Picture picture(info.width, info.height, {7, 7, 7, 7});
    must(txc_map_view(session.id(), target, which, 0, info.height, picture.rgba.data()));
    return picture;
}

}  // namespace

TEST_CASE("Positions show as red, green and blue over the bounding box") {
    TestSession session(make_cube());
    const TxcTarget target = session.target(96, 64, 0);
    const Picture picture = view(session, target, TXC_VIEW_POSITIONS);
    const MapArrays map = session.map(target);
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 96; ++x) {
            const Color color = picture.at(x, y);
            if (map.coverage_at(x, y) == 0) {
                CHECK_UNARY(color == Color{0, 0, 0, 0});
                continue;
            }
            CHECK_UNARY(std::fabs(color.red - (map.position(x, y)[0] + 0.5) * 255) <= 0.51);
            CHECK_UNARY(std::fabs(color.green - (map.position(x, y)[1] + 0.5) * 255) <= 0.51);
            CHECK_UNARY(std::fabs(color.blue - (map.position(x, y)[2] + 0.5) * 255) <= 0.51);
            CHECK_UNARY(color.alpha == 255);
        }
    }
}

TEST_CASE("Normals show as red, green and blue around grey") {
    TestSession session(make_plane());
    CHECK(view(session, session.target(8, 8), TXC_VIEW_NORMALS) == Picture(8, 8, {128, 128, 255, 255}));
}

TEST_CASE("A flat model's positions show its missing axis as the middle") {
    TestSession session(make_plane(1.0, 5.0));
    CHECK(view(session, session.target(8, 8), TXC_VIEW_POSITIONS).at(3, 3).blue == 128);
}

TEST_CASE("Coverage shows charts light, gutters darker, the rest not at all") {
    TestSession session(make_plane(1.0, 0.0, {0.25, 0.25, 0.75, 0.75}));
    const TxcTarget target = session.target(32, 32, 2);
    const Picture picture = view(session, target, TXC_VIEW_COVERAGE);
    const Color covered = picture.at(16, 16);
    const Color gutter = picture.at(6, 16);
    CHECK(covered.alpha == 255);
    CHECK(gutter.alpha == 255);
    CHECK(gutter.red < covered.red);
    CHECK(picture.at(1, 1) == Color{0, 0, 0, 0});
    const TxcMapInfo info = session.map_info(target);
    CHECK(count_color(picture, covered) == info.covered_texels);
    CHECK(count_color(picture, gutter) == info.gutter_texels);
}

TEST_CASE("Overlap shows one, two and more triangles in three colours") {
    Shape shape = make_plane(1.0, 0.0, {0.0, 0.0, 0.75, 1.0});
    shape.append(make_plane(1.0, 1.0, {0.25, 0.0, 0.75, 1.0}));
    shape.append(make_plane(1.0, 2.0, {0.5, 0.0, 0.75, 1.0}));
    TestSession session(shape);
    const Picture picture = view(session, session.target(32, 8, 0), TXC_VIEW_OVERLAP);
    const Color one = picture.at(4, 4);
    const Color two = picture.at(12, 4);
    const Color three = picture.at(20, 4);
    CHECK(picture.at(28, 4) == Color{0, 0, 0, 0});
    CHECK(one.green > one.red);
    CHECK(two.red > two.blue);
    CHECK(two.green > two.blue);
    CHECK(three.red > 2 * three.green);
    CHECK(count_color(picture, one) + count_color(picture, two) + count_color(picture, three) == 24 * 8);
}

TEST_CASE("Rows can be read a few at a time, and say the same") {
    TestSession session(make_sphere(1.0));
    const TxcTarget target = session.target(50, 41);
    const MapArrays map = session.map(target);
    for (std::uint32_t which = 0; which < TXC_VIEW_COUNT; ++which) {
        const Picture whole = view(session, target, which);
        Picture pieces(50, 41);
        for (std::uint32_t row = 0; row < 41; row += 7) {
            const std::uint32_t count = std::min(7u, 41 - row);
            must(txc_map_view(session.id(), target, which, row, count, pieces.rgba.data() + row * 50 * 4));
        }
        CHECK(pieces == whole);
    }
    std::vector<float> rows(50 * 3 * 3);
    for (std::uint32_t row = 0; row + 3 <= 41; row += 5) {
        must(txc_map_read_positions(session.id(), target, row, 3, rows.data()));
        CHECK(std::equal(rows.begin(), rows.end(), map.position(0, row)));
        must(txc_map_read_normals(session.id(), target, row, 3, rows.data()));
        CHECK(std::equal(rows.begin(), rows.end(), map.normal(0, row)));
    }
    must(txc_map_read_positions(session.id(), target, 41, 0, rows.data()));  // no rows at the end: nothing to do
}
