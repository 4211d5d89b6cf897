// Zones' edges against every edge looked at one by one, and what of them is refused (docs/print-truth.md).
#include "print_zone.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "support/random.h"
#include "support/strokes.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr Color kRed{200, 0, 0, 255};
constexpr float kWhole[] = {0, 0, 1, 0, 1, 1, 0, 1};

/// Metres along the surface to the nearest edge, above 0 inside: each edge in turn.
double inset_by_all_edges(const txc::PrintZone& zone, const txc::ZoneTexel& texel) {
    double nearest = std::numeric_limits<double>::infinity();
    bool inside = false;
    for (std::size_t c = 0; c < zone.corners.size(); ++c) {
        const glm::dvec2 from = zone.corners[c] * texel.size;
        const glm::dvec2 to = zone.corners[(c + 1) % zone.corners.size()] * texel.size;
        const glm::dvec2 edge = to - from;
        const glm::dvec2 way = texel.place - from;
        const double square = texel.metric.dot(edge, edge);
        const double share = square > 0.0 ? std::clamp(texel.metric.dot(way, edge) / square, 0.0, 1.0) : 0.0;
        const glm::dvec2 left = way - edge * share;
        nearest = std::min(nearest, texel.metric.dot(left, left));
        if ((from.y > texel.place.y) != (to.y > texel.place.y) && way.x < edge.x * way.y / edge.y) inside = !inside;
    }
    return (inside ? 1.0 : -1.0) * std::sqrt(std::max(nearest, 0.0));
}

/// Texels that are up to ten times as long as wide, and askew.
txc::TexelMetric random_metric(Random& random) {
    const double across = random.between(0.1, 1.0);
    const double down = random.between(0.1, 1.0);
    return {across * across, across * down * random.between(-0.9, 0.9), down * down};
}

TxcZone whole_texture() {
    TxcZone zone;
    txc_zone_default(&zone);
    zone.corner_count = 4;
    return zone;
}

TxcZone box_zone(double x, double y, double z, double degrees_about_y) {
    TxcZone box;
    txc_zone_default(&box);
    box.kind = TXC_ZONE_BOX;
    box.position_model[0] = static_cast<float>(x);
    box.position_model[1] = static_cast<float>(y);
    box.position_model[2] = static_cast<float>(z);
    const double half = degrees_about_y * 3.14159265358979 / 360.0;
    box.rotation[1] = static_cast<float>(std::sin(half));
    box.rotation[3] = static_cast<float>(std::cos(half));
    return box;
}

TxcStatus set_zones(const TestSession& session, const std::vector<TxcZone>& zones) {
    return txc_session_set_zones(session.id(), zones.data(), static_cast<std::uint32_t>(zones.size()), kWhole, 4);
}

std::vector<std::uint8_t> mask_of(const TestSession& session, TxcTarget target, std::uint32_t width,
                                  std::uint32_t height) {
    std::vector<std::uint8_t> mask(width * height);
    must(txc_zone_mask(session.id(), target, TXC_NONE, 0, height, mask.data()));
    return mask;
}

}  // namespace

TEST_CASE("A zone's edge is as far as the nearest of all its edges, on texels of any form") {
    Random random(301);
    for (int round = 0; round < 60; ++round) {
        CAPTURE(round);
        txc::PrintZone zone;
        const std::uint32_t corners = 3 + random.below(60);
        for (std::uint32_t c = 0; c < corners; ++c) zone.corners.emplace_back(random.unit(), random.unit());
        txc::ZoneLook look(zone);
        txc::ZoneTexel texel;
        texel.size = {64.0 + random.below(200), 64.0 + random.below(200)};
        std::uint32_t others = 0;
        for (int i = 0; i < 300; ++i) {
            texel.place = glm::floor(glm::dvec2(random.unit(), random.unit()) * texel.size) + 0.5;
            texel.metric = random_metric(random);
            const double expected = inset_by_all_edges(zone, texel);
            others += std::fabs(look.inset(texel) - expected) > 1e-9 * (1.0 + std::fabs(expected)) ? 1 : 0;
        }
        CHECK(others == 0);
    }
}

TEST_CASE("A look that comes to a texture of another size looks anew") {
    txc::PrintZone zone;
    zone.corners = {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}};
    txc::ZoneLook look(zone);
    txc::ZoneTexel texel;
    texel.metric = {1.0, 0.0, 1.0};
    texel.place = {8.5, 8.5};
    texel.size = {64.0, 64.0};
    CHECK(look.inset(texel) < 0.0);
    texel.size = {16.0, 16.0};
    CHECK(look.inset(texel) == doctest::Approx(3.5));
}

TEST_CASE("Of a zone whose edge is its chart's, the gutter is whole") {
    // The chart's last columns of texels are 16 and 47, and the zone's edges run where it ends.
    TestSession session(make_plane(1.0, 0.0, {0.25, 0.25, 0.75, 0.75}));
    const TxcTarget target = session.target(64, 64, 3);
    TxcZone zone = whole_texture();
    const float corners[] = {0.25f, 0.25f, 0.75f, 0.25f, 0.75f, 0.75f, 0.25f, 0.75f};
    must(txc_session_set_zones(session.id(), &zone, 1, corners, 4));
    const std::vector<std::uint8_t> mask = mask_of(session, target, 64, 64);
    for (const std::uint32_t x : {13u, 16u, 47u, 50u}) {
        CAPTURE(x);
        CHECK(mask[32 * 64 + x] == 255);
    }
    CHECK(mask[32 * 64 + 12] == 0);
    CHECK(mask[32 * 64 + 51] == 0);
}

TEST_CASE("A box takes what faces it, be it at a slant, and nothing that faces away") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    TxcZone box = box_zone(0, 0, 0, 60);
    std::fill(std::begin(box.size), std::end(box.size), 4.0f);
    must(set_zones(session, {box}));
    CHECK(mask_of(session, target, 16, 16) == std::vector<std::uint8_t>(256, 255));
    for (const double degrees : {120.0, 240.0}) {
        const TxcZone turned = box_zone(0, 0, 0, degrees);
        std::copy(std::begin(turned.rotation), std::end(turned.rotation), std::begin(box.rotation));
        must(set_zones(session, {box}));
        CHECK(mask_of(session, target, 16, 16) == std::vector<std::uint8_t>(256, 0));
    }
}

TEST_CASE("What runs along a box's front lies in it or beyond it, whatever its bleed") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    TxcZone box = box_zone(0, 0, -0.6, 0);
    std::fill(std::begin(box.size), std::end(box.size), 1.0f);
    box.size[0] = box.size[1] = 4.0f;
    box.bleed = 0.5f;
    must(set_zones(session, {box}));
    CHECK(mask_of(session, target, 16, 16) == std::vector<std::uint8_t>(256, 0));
    box.position_model[2] = -0.4f;
    must(set_zones(session, {box}));
    CHECK(mask_of(session, target, 16, 16) == std::vector<std::uint8_t>(256, 255));
}

TEST_CASE("The way to a box's face is that along the surface, steep or shallow") {
    // The box's x is the plane's, shortened by the turn's cosine: its faces stand at 0.2 of the plane, its bleed ends at 0.3.
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    for (const double degrees : {10.0, 60.0, 75.0}) {
        CAPTURE(degrees);
        const double cosine = std::cos(degrees * 3.14159265358979 / 180.0);
        TxcZone box = box_zone(0, 0, 0, degrees);
        std::fill(std::begin(box.size), std::end(box.size), 4.0f);
        box.size[0] = static_cast<float>(0.4 * cosine);
        box.bleed = 0.1f;
        must(set_zones(session, {box}));
        TxcZoneSurface surface{};
        must(txc_zone_surface(session.id(), target, 0, &surface));
        CHECK(surface.end_x - surface.first_x == doctest::Approx(0.6 * 256).epsilon(0.02));
    }
    // The same by the face that the plane nearly runs along: its way is by the turn's sine.
    TxcZone box = box_zone(0, 0, 0, 10);
    std::fill(std::begin(box.size), std::end(box.size), 4.0f);
    box.size[2] = static_cast<float>(0.4 * std::sin(10.0 * 3.14159265358979 / 180.0));
    box.bleed = 0.1f;
    must(set_zones(session, {box}));
    TxcZoneSurface surface{};
    must(txc_zone_surface(session.id(), target, 0, &surface));
    CHECK(surface.end_x - surface.first_x == doctest::Approx(0.6 * 256).epsilon(0.02));
}

TEST_CASE("Where zones overlap a texel lies in the one that takes most of it, and other materials' zones take none") {
    TestSession session(make_plane());
    session.add(make_plane(), 1);
    const TxcTarget target = session.target(16, 16);
    // The left half, up to the middle of a texel, and all of the upper half; on the other material everything.
    const float corners[] = {0, 0,    7.5f / 16, 0,    7.5f / 16, 1, 0, 1, 0, 0, 1, 0,
                             1, 0.5f, 0,         0.5f, 0,         0, 1, 0, 1, 1, 0, 1};
    std::vector<TxcZone> zones(3, whole_texture());
    for (std::uint32_t z = 0; z < 3; ++z) zones[z].first_corner = z * 4;
    zones[2].material = 1;
    for (const bool swapped : {false, true}) {
        if (swapped) std::swap(zones[0], zones[1]);
        must(txc_session_set_zones(session.id(), zones.data(), 3, corners, 12));
        const std::vector<std::uint8_t> mask = mask_of(session, target, 16, 16);
        CHECK(mask[4 * 16 + 2] == 255);
        CHECK(mask[4 * 16 + 12] == 255);
        CHECK(mask[12 * 16 + 2] == 255);
        CHECK(mask[12 * 16 + 7] == 128);
        CHECK(mask[12 * 16 + 12] == 0);
    }
}

TEST_CASE("What is safe in one zone is safe, though it lies in the margin of another") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    TxcLayerDef def = decal_def(session.image(Picture(4, 4, kRed)));
    resize(def, 0.25, 0.25, 1.0);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    std::vector<TxcZone> zones(2, whole_texture());
    zones[1].safe = 0.49f;
    for (const bool swapped : {false, true}) {
        if (swapped) std::swap(zones[0], zones[1]);
        must(set_zones(session, zones));
        TxcLayerMetrics metrics{};
        must(txc_layer_metrics(session.id(), &layer, 1, &metrics, nullptr));
        CHECK(metrics.in_safe_margin == 0.0f);
        CHECK(metrics.outside_zones == 0.0f);
    }
}

TEST_CASE("As many zones are taken as there may be, and a list of one more is refused whole") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    std::vector<TxcZone> zones(TXC_MAX_ZONES, whole_texture());
    must(set_zones(session, zones));
    std::uint8_t row[16];
    must(txc_zone_mask(session.id(), target, TXC_MAX_ZONES - 1, 0, 1, row));
    zones.push_back(whole_texture());
    CHECK(set_zones(session, zones) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(std::string(txc_error_detail()).find("zone_count is 101") != std::string::npos);
    must(txc_zone_mask(session.id(), target, TXC_MAX_ZONES - 1, 0, 1, row));
}

TEST_CASE("A zone that is refused is named by its place, and the zones before it stay") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    must(set_zones(session, {whole_texture()}));
    TxcZone unknown_kind = whole_texture();
    unknown_kind.kind = TXC_ZONE_KIND_COUNT;
    TxcZone beyond = whole_texture();
    beyond.first_corner = 5;
    TxcZone around = whole_texture();
    around.first_corner = 0xffffffffu;
    TxcZone cut = whole_texture();
    cut.first_corner = 1;
    for (const TxcZone& bad : {unknown_kind, beyond, around, cut}) {
        CHECK(set_zones(session, {whole_texture(), bad}) == TXC_STATUS_BAD_ARGUMENT);
        CHECK(std::string(txc_error_detail()).find("zone 1: ") != std::string::npos);
        CHECK(mask_of(session, target, 16, 16) == std::vector<std::uint8_t>(256, 255));
    }
    const TxcZone zone = whole_texture();
    CHECK(txc_session_set_zones(session.id(), &zone, 1, nullptr, 1) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(std::string(txc_error_detail()).find("corners_uv is null") != std::string::npos);
}

TEST_CASE("Rows of a mask are those of the texture, to its end and no further") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    must(set_zones(session, {whole_texture()}));
    std::vector<std::uint8_t> rows(16 * 32);
    must(txc_zone_mask(session.id(), target, 0, 16, 0, rows.data()));
    must(txc_zone_mask(session.id(), target, 0, 15, 1, rows.data()));
    CHECK(txc_zone_mask(session.id(), target, 0, 1, 16, rows.data()) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_zone_mask(session.id(), target, 0, 17, 0, rows.data()) == TXC_STATUS_BAD_ARGUMENT);
    CHECK(txc_zone_mask(session.id(), target, 0, 2, 0xffffffffu, rows.data()) == TXC_STATUS_BAD_ARGUMENT);
}

TEST_CASE("The picture of a stroke's brush has no density on the surface, as its dabs are of any size") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    TxcLayerDef def = stroke_def();
    def.tip = TXC_TIP_PICTURE;
    def.image = session.image(Picture(8, 8, kRed));
    const TxcLayer layer = session.layer(target, def);
    add_dabs(session, layer, {dab_at(0, 0, 0.5)});
    session.update(target);
    TxcLayerMetrics metrics{};
    must(txc_layer_metrics(session.id(), &layer, 1, &metrics, nullptr));
    CHECK(metrics.area == doctest::Approx(0.25).epsilon(0.05));
    CHECK(metrics.mean_pixels_per_metre == 0.0f);
    CHECK(metrics.clipped == 0.0f);
}
