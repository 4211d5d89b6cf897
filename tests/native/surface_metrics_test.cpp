// Print truth on surfaces whose numbers are known in closed form.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "support/picture.h"
#include "support/strokes.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr Color kRed{200, 0, 0, 255};

TxcLayerMetrics measure(TestSession& session, TxcLayer layer, std::vector<float>* zone_shares = nullptr) {
    TxcLayerMetrics metrics{};
    must(txc_layer_metrics(session.id(), &layer, 1, &metrics, zone_shares != nullptr ? zone_shares->data() : nullptr));
    return metrics;
}

/// The picture as a decal on a target, painted and measured.
TxcLayerMetrics measure_decal(TestSession& session, TxcTarget target, TxcLayerDef def, const Picture& picture) {
    def.image = session.image(picture);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    return measure(session, layer);
}

/// A plane of 1 m whose texture lies mirrored.
Shape make_mirrored_plane() {
    Shape plane = make_plane();
    for (std::size_t i = 0; i < plane.uvs.size(); i += 2) plane.uvs[i] = 1.0f - plane.uvs[i];
    return plane;
}

TxcZone uv_zone(std::uint32_t first, std::uint32_t count, double safe = 0.0, double bleed = 0.0) {
    TxcZone zone;
    txc_zone_default(&zone);
    zone.first_corner = first;
    zone.corner_count = count;
    zone.safe = static_cast<float>(safe);
    zone.bleed = static_cast<float>(bleed);
    return zone;
}

const std::vector<float> kLeftHalf = {0, 0, 0.5f, 0, 0.5f, 1, 0, 1};

void set_zones(TestSession& session, const std::vector<TxcZone>& zones, const std::vector<float>& corners = kLeftHalf) {
    must(txc_session_set_zones(session.id(), zones.data(), static_cast<std::uint32_t>(zones.size()), corners.data(),
                               static_cast<std::uint32_t>(corners.size() / 2)));
}

}  // namespace

TEST_CASE("On a plane a decal has the density, area and form that its size says") {
    TestSession session(make_plane(2.0));
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.5, 0.25, 1.0);
    const TxcLayerMetrics flat = measure_decal(session, target, def, Picture(100, 50, kRed));
    CHECK(flat.least_pixels_per_metre == doctest::Approx(200.0).epsilon(1e-5));
    CHECK(flat.mean_pixels_per_metre == doctest::Approx(200.0).epsilon(1e-5));
    CHECK(flat.least_texels_per_metre == doctest::Approx(128.0).epsilon(1e-5));
    CHECK(flat.greatest_stretch == doctest::Approx(0.0).scale(1.0).epsilon(1e-5));
    CHECK(flat.area == doctest::Approx(0.125).epsilon(1e-3));
    CHECK(flat.clipped == 0.0f);
    CHECK(flat.hidden == 0.0f);
    CHECK(flat.overlapping_texels == 0);
    CHECK(flat.mirrored_texels == 0);
}

TEST_CASE("A picture drawn out to twice its width is stretched by a whole, and its worse axis counts") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(128, 128);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.5, 0.25, 1.0);
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(64, 64, kRed));
    CHECK(metrics.least_pixels_per_metre == doctest::Approx(128.0).epsilon(1e-5));
    CHECK(metrics.greatest_stretch == doctest::Approx(1.0).epsilon(1e-5));
    CHECK(metrics.mean_stretch == doctest::Approx(1.0).epsilon(1e-5));
}

TEST_CASE("A plane that the projector sees at an angle stretches the picture by its cosine") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(128, 128);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.25, 0.25, 2.0);
    turn(def, 0.0, 1.0, 0.0, 60.0);
    def.angle_fade_start = def.angle_fade_end = 90.0f;
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(64, 64, kRed));
    CHECK(metrics.least_pixels_per_metre == doctest::Approx(128.0).epsilon(1e-4));
    CHECK(metrics.greatest_stretch == doctest::Approx(1.0).epsilon(1e-4));
    CHECK(metrics.area == doctest::Approx(0.25 * 0.5).epsilon(2e-3));
    CHECK(metrics.clipped == 0.0f);
}

TEST_CASE("Half of a decal beyond the plane's edge is clipped, and none of it hidden") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.5, 0.5, 1.0);
    place(def, 0.5, 0.0, 0.0);
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(128, 128, kRed));
    CHECK(metrics.clipped == doctest::Approx(0.5));
    CHECK(metrics.hidden == 0.0f);
    CHECK(metrics.area == doctest::Approx(0.125).epsilon(3e-3));
}

TEST_CASE("What is clipped counts by the picture's alpha") {
    Picture picture(128, 128);
    for (std::uint32_t y = 0; y < 128; ++y)
        for (std::uint32_t x = 0; x < 32; ++x) picture.set(x, y, kRed);
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.5, 0.5, 1.0);
    place(def, 0.5, 0.0, 0.0);
    CHECK(measure_decal(session, target, def, picture).clipped == 0.0f);
    def.flip_x = 1;
    CHECK(measure_decal(session, target, def, picture).clipped == 1.0f);
}

TEST_CASE("A side that faces away hides the picture, unless back faces are painted") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(128, 128);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.5, 0.5, 1.0);
    turn(def, 0.0, 1.0, 0.0, 180.0);
    const TxcLayerMetrics behind = measure_decal(session, target, def, Picture(64, 64, kRed));
    CHECK(behind.hidden == 1.0f);
    CHECK(behind.clipped == 1.0f);
    CHECK(behind.painted_texels == 0);
    def.backfaces = 1;
    const TxcLayerMetrics through = measure_decal(session, target, def, Picture(64, 64, kRed));
    CHECK(through.hidden == 0.0f);
    CHECK(through.clipped == 0.0f);
}

TEST_CASE("What lies behind another part of the model is hidden by just that") {
    TestSession session(make_plane());
    session.add(moved(make_plane(0.25), 0.125, 0.0, 0.25),
                1);  // before the right half of the decal, of another material
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(0);
    def.occlusion = TXC_OCCLUSION_SELF;
    resize(def, 0.5, 0.5, 1.0);
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(64, 64, kRed));
    CHECK(metrics.hidden == doctest::Approx(0.25).epsilon(0.03));
    CHECK(metrics.clipped == metrics.hidden);
}

TEST_CASE("On a cylinder a planar decal thins out as the cosine of the angle, and a label does not") {
    const double radius = 0.05;
    TestSession session(make_cylinder(radius, 0.1, 360));
    const TxcTarget target = session.target(1024, 256);
    TxcLayerDef flat = decal_def(0);
    resize(flat, radius, radius, 0.2);  // out to 30 degrees on either side
    place(flat, 0.0, 0.0, 0.1);
    const TxcLayerMetrics planar = measure_decal(session, target, flat, Picture(100, 100, kRed));
    CHECK(planar.mean_pixels_per_metre == doctest::Approx(100 / radius * std::sin(kPi / 6) / (kPi / 6)).epsilon(0.005));
    CHECK(planar.least_pixels_per_metre == doctest::Approx(100 / radius * std::cos(kPi / 6)).epsilon(0.01));
    CHECK(planar.greatest_stretch == doctest::Approx(1 / std::cos(kPi / 6) - 1).epsilon(0.03));
    CHECK(planar.area == doctest::Approx(radius * kPi / 3 * radius).epsilon(0.005));

    TxcLayerDef label = decal_def(0);
    label.projector = TXC_PROJECTOR_CYLINDRICAL;
    label.radius = static_cast<float>(radius);
    label.height = static_cast<float>(radius * kPi / 2);
    label.arc_degrees = 90.0f;
    label.depth = 0.02f;
    const TxcLayerMetrics curved = measure_decal(session, target, label, Picture(100, 100, kRed));
    const double density = 100 / (radius * kPi / 2);
    CHECK(curved.least_pixels_per_metre == doctest::Approx(density).epsilon(0.001));
    CHECK(curved.mean_pixels_per_metre == doctest::Approx(density).epsilon(0.001));
    CHECK(curved.greatest_stretch < 0.001f);
    CHECK(curved.clipped < 0.001f);
}

TEST_CASE("Of what the angle fade takes half or more, nothing is the least or the greatest") {
    // With this fade the weight is the angle's cosine, by which the pixels thin out, too: half of it is left at 60 degrees.
    TestSession session(make_cylinder(0.5, 1.0, 720));
    const TxcTarget target = session.target(720, 16);
    TxcLayerDef def = decal_def(0);
    resize(def, 1.0, 1.0, 2.0);
    def.angle_fade_start = 0.0f;
    def.angle_fade_end = 90.0f;
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(100, 100, kRed));
    CHECK(metrics.least_pixels_per_metre == doctest::Approx(50.0).epsilon(0.02));
    CHECK(metrics.greatest_stretch == doctest::Approx(1.0).epsilon(0.02));
}

TEST_CASE("Back faces that are painted have their density as front faces have") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    TxcLayerDef def = decal_def(0);
    turn(def, 0.0, 1.0, 0.0, 180.0);
    def.backfaces = 1;
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(32, 32, kRed));
    CHECK(metrics.least_pixels_per_metre == doctest::Approx(32.0).epsilon(0.001));
    CHECK(metrics.mean_pixels_per_metre == doctest::Approx(32.0).epsilon(0.001));
}

TEST_CASE("What lies before or behind a decal's box is clipped, and not hidden") {
    // The plane runs through the box at a slant, and leaves it by its front and its back at 0.1 / tan(30 degrees).
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.8, 0.8, 0.2);
    turn(def, 0.0, 1.0, 0.0, 30.0);
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(64, 64, kRed));
    CHECK(metrics.clipped == doctest::Approx(1.0 - 0.2 * std::sqrt(3.0) / 0.8).epsilon(0.02));
    CHECK(metrics.hidden == 0.0f);
}

TEST_CASE("A label all round a cylinder is clipped nowhere, not even at its back") {
    TestSession session(make_cylinder(0.05, 0.1, 64));
    const TxcTarget target = session.target(512, 256);
    TxcLayerDef label = decal_def(0);
    label.projector = TXC_PROJECTOR_CYLINDRICAL;
    label.radius = 0.05f;
    label.height = 0.05f;
    label.arc_degrees = 360.0f;
    label.depth = 0.02f;
    CHECK(measure_decal(session, target, label, Picture(512, 64, kRed)).clipped == 0.0f);
}

TEST_CASE("A texture that lies mirrored is told, and one that does not is not") {
    for (const bool mirrored : {false, true}) {
        TestSession session(mirrored ? make_mirrored_plane() : make_plane());
        const TxcTarget target = session.target(64, 64);
        TxcLayerDef def = decal_def(0);
        resize(def, 0.5, 0.5, 1.0);
        const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(32, 32, kRed));
        CHECK(metrics.painted_texels >= 32 * 32);
        CHECK(metrics.mirrored_texels == (mirrored ? metrics.painted_texels : 0u));
    }
}

TEST_CASE("Texels that two triangles share count as overlapping where the layer paints them") {
    Shape shape = make_plane();
    shape.append(moved(make_plane(), 2.0, 0.0, 0.0));
    TestSession session(shape);
    const TxcTarget target = session.target(64, 64);
    TxcLayerDef def = decal_def(0);
    resize(def, 0.5, 0.5, 1.0);
    const TxcLayerMetrics metrics = measure_decal(session, target, def, Picture(32, 32, kRed));
    CHECK(metrics.painted_texels > 0);
    CHECK(metrics.overlapping_texels == metrics.painted_texels);
}

TEST_CASE("One decal on two materials is measured as one") {
    TestSession session(make_plane());
    session.add(moved(make_plane(), 1.0, 0.0, 0.0), 1);
    const TxcTarget left = session.target(64, 64);
    const TxcTarget right = session.target(64, 64, TXC_NONE, 1, 1);
    TxcLayerDef def = decal_def(session.image(Picture(32, 32, kRed)));
    resize(def, 0.5, 0.5, 1.0);
    place(def, 0.5, 0.0, 0.0);
    const TxcLayer layers[] = {session.layer(left, def), session.layer(right, def)};
    session.update(left);
    session.update(right);
    TxcLayerMetrics both{};
    must(txc_layer_metrics(session.id(), layers, 2, &both, nullptr));
    CHECK(both.clipped == 0.0f);
    CHECK(both.area == doctest::Approx(0.25).epsilon(0.01));
    CHECK(measure(session, layers[0]).clipped == doctest::Approx(0.5));
}

TEST_CASE("A zone cuts a decal where its edge runs, its safe margin and its bleed in metres of the surface") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(session.image(Picture(64, 64, kRed)));
    resize(def, 0.5, 0.5, 1.0);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    std::vector<float> shares(1);
    set_zones(session, {uv_zone(0, 4)});
    TxcLayerMetrics metrics = measure(session, layer, &shares);
    CHECK(metrics.outside_zones == doctest::Approx(0.5).epsilon(0.001));
    CHECK(shares[0] == doctest::Approx(0.5).epsilon(0.001));
    CHECK(metrics.in_safe_margin == 0.0f);
    set_zones(session, {uv_zone(0, 4, 0.125)});
    CHECK(measure(session, layer).in_safe_margin == doctest::Approx(0.25).epsilon(0.01));
    set_zones(session, {uv_zone(0, 4, 0.0, 0.125)});
    metrics = measure(session, layer);
    CHECK(metrics.outside_zones == doctest::Approx(0.25).epsilon(0.01));
    CHECK(metrics.in_safe_margin == doctest::Approx(0.25).epsilon(0.02));
}

TEST_CASE("A box of model space is a zone all the same, and its front and back are no edge of it") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 256);
    TxcLayerDef def = decal_def(session.image(Picture(64, 64, kRed)));
    resize(def, 0.5, 0.5, 1.0);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    TxcZone box;
    txc_zone_default(&box);
    box.kind = TXC_ZONE_BOX;
    box.position_model[0] = -0.25f;
    box.size[0] = 0.5f;
    box.size[2] = 0.02f;
    box.safe = 0.125f;
    set_zones(session, {box}, {});
    const TxcLayerMetrics metrics = measure(session, layer);
    CHECK(metrics.outside_zones == doctest::Approx(0.5).epsilon(0.001));
    CHECK(metrics.in_safe_margin == doctest::Approx(0.25).epsilon(0.01));
    box.rotation[1] = 1.0f;
    box.rotation[3] = 0.0f;
    set_zones(session, {box}, {});
    CHECK(measure(session, layer).outside_zones == 1.0f);  // a box that looks the other way takes none of this side
    box.rotation[1] = 0.0f;
    box.rotation[3] = 1.0f;
    box.material = 1;
    set_zones(session, {box}, {});
    CHECK(measure(session, layer).outside_zones == 1.0f);
}

TEST_CASE("A zone's mask is full inside, clear outside, and goes with its bleed") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    const auto row_of = [&](std::uint32_t zone) {
        std::vector<std::uint8_t> row(64);
        must(txc_zone_mask(session.id(), target, zone, 30, 1, row.data()));
        return row;
    };
    set_zones(session, {uv_zone(0, 4)});
    CHECK(row_of(0)[31] == 255);
    CHECK(row_of(0)[32] == 0);
    CHECK(row_of(TXC_NONE) == row_of(0));
    set_zones(session, {uv_zone(0, 4, 0.0, 4.0 / 64)});
    CHECK(row_of(0)[35] == 255);
    CHECK(row_of(0)[36] == 0);
    set_zones(session, {});
    CHECK(row_of(TXC_NONE)[0] == 0);
}

TEST_CASE("However many corners a zone's edge has, its mask is that of the edge") {
    // Texels four times as long as wide, so that the nearest edge on the surface is not the nearest in the texture.
    TestSession session(make_plane());
    const TxcTarget target = session.target(256, 64);
    const double inward = 0.05;
    const std::vector<float> plain = {0.125f, 0.25f, 0.875f, 0.25f, 0.875f, 0.75f, 0.125f, 0.75f};
    std::vector<float> dense;
    constexpr int kSteps = 96;
    for (std::size_t corner = 0; corner < 4; ++corner) {
        const float* from = &plain[corner * 2];
        const float* to = &plain[(corner + 1) % 4 * 2];
        for (int step = 0; step < kSteps; ++step) {
            const float share = static_cast<float>(step) / kSteps;
            dense.push_back(from[0] + (to[0] - from[0]) * share);
            dense.push_back(from[1] + (to[1] - from[1]) * share);
        }
    }
    const auto mask_of = [&](const std::vector<float>& corners) {
        set_zones(session, {uv_zone(0, static_cast<std::uint32_t>(corners.size() / 2), 0.0, inward)}, corners);
        std::vector<std::uint8_t> mask(256 * 64);
        must(txc_zone_mask(session.id(), target, 0, 0, 64, mask.data()));
        return mask;
    };
    const std::vector<std::uint8_t> few = mask_of(plain);
    const std::vector<std::uint8_t> many = mask_of(dense);
    int worst = 0;
    for (std::size_t i = 0; i < few.size(); ++i) worst = std::max(worst, std::abs(few[i] - many[i]));
    CHECK(worst <= 1);
    CHECK(few[32 * 256 + 128] == 255);
    CHECK(few[0] == 0);
}

TEST_CASE("A zone tells its area, its rectangle, its scale, and which way is up") {
    TestSession session(make_plane(0.5));
    const TxcTarget target = session.target(100, 100);
    set_zones(session, {uv_zone(0, 4)});
    TxcZoneSurface surface{};
    must(txc_zone_surface(session.id(), target, 0, &surface));
    CHECK(surface.texels == 50 * 100);
    CHECK(surface.end_x == 50);
    CHECK(surface.end_y == 100);
    CHECK(surface.area == doctest::Approx(0.125));
    CHECK(std::sqrt(surface.metric[0]) == doctest::Approx(0.005));
    CHECK(surface.metric[1] == doctest::Approx(0.0));
    CHECK(surface.up[0] == doctest::Approx(0.0));
    CHECK(surface.up[1] < 0.0f);
    CHECK(surface.mirrored == 0.0f);
    must(txc_zone_surface(session.id(), target, TXC_NONE, &surface));
    CHECK(surface.area == doctest::Approx(0.25));
}

TEST_CASE("A fill and a stroke have area and texels, and no picture's numbers") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    const TxcLayer fill = session.layer(target, fill_def(1, 0, 0, 0.5f));
    session.update(target);
    const TxcLayerMetrics metrics = measure(session, fill);
    CHECK(metrics.painted_texels == 64 * 64);
    CHECK(metrics.area == doctest::Approx(0.5));
    CHECK(metrics.mean_texels_per_metre == doctest::Approx(64.0));
    CHECK(metrics.mean_pixels_per_metre == 0.0f);
    CHECK(metrics.clipped == 0.0f);

    // Dabs in opposite corners: what lies between them is no part of the stroke.
    must(txc_layer_destroy(session.id(), fill));
    const TxcLayer stroke = session.layer(target, stroke_def());
    add_dabs(session, stroke, {dab_at(-0.4, 0.4, 0.15), dab_at(0.4, -0.4, 0.15)});
    session.set_base(target, Color{255, 255, 255, 255});
    const Picture painted = session.paint(target);
    const TxcLayerMetrics of_stroke = measure(session, stroke);
    // A few at the rim are too faint to show in a byte.
    const std::uint32_t shown = 64 * 64 - count_color(painted, {255, 255, 255, 255});
    CHECK(of_stroke.painted_texels >= shown);
    CHECK(of_stroke.painted_texels <= shown + 16);
    CHECK(of_stroke.area == doctest::Approx(2 * kPi * 0.075 * 0.075).epsilon(0.02));
    CHECK(of_stroke.mean_pixels_per_metre == 0.0f);
}

TEST_CASE("The map of a decal's density has its number where it paints, and none elsewhere") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    TxcLayerDef def = decal_def(session.image(Picture(64, 32, kRed)));
    resize(def, 0.5, 0.5, 1.0);
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    std::vector<float> row(64);
    const auto read = [&](std::uint32_t kind) {
        must(txc_layer_print_map(session.id(), layer, kind, 32, 1, row.data()));
        CHECK(row[2] == 0.0f);
        return static_cast<double>(row[32]);
    };
    CHECK(read(TXC_PRINT_MAP_PIXELS) == doctest::Approx(64.0));
    CHECK(read(TXC_PRINT_MAP_TEXELS) == doctest::Approx(64.0));
    CHECK(read(TXC_PRINT_MAP_STRETCH) == doctest::Approx(2.0));
}

TEST_CASE("What cannot be measured is refused by name") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16);
    TxcLayerDef group_def = fill_def(0, 0, 0);
    group_def.kind = TXC_LAYER_GROUP;
    const TxcLayer group = session.layer(target, group_def);
    const TxcLayer waiting = session.layer(target, decal_def(session.image(Picture(2, 2, kRed))));
    TxcLayerMetrics metrics{};
    const auto refuses = [&](TxcStatus status, const char* words) {
        CHECK(status == TXC_STATUS_BAD_ARGUMENT);
        INFO(txc_error_detail());
        CHECK(std::string(txc_error_detail()).find(words) != std::string::npos);
    };
    refuses(txc_layer_metrics(session.id(), &group, 1, &metrics, nullptr), "is a group");
    refuses(txc_layer_metrics(session.id(), &waiting, 1, &metrics, nullptr), "waits for an update");
    session.update(target);
    float out[16];
    refuses(txc_layer_print_map(session.id(), waiting, TXC_PRINT_MAP_COUNT, 0, 1, out), "kind is 3");
    std::uint8_t mask[16];
    refuses(txc_zone_mask(session.id(), target, 0, 0, 1, mask), "the session has 0");
    TxcZone zone = uv_zone(0, 2);
    refuses(txc_session_set_zones(session.id(), &zone, 1, kLeftHalf.data(), 4), "a polygon has 3");
    zone = uv_zone(0, 4, -1.0);
    refuses(txc_session_set_zones(session.id(), &zone, 1, kLeftHalf.data(), 4), "a margin is -1");
    zone = uv_zone(0, 4);
    zone.kind = 7;
    refuses(txc_session_set_zones(session.id(), &zone, 1, kLeftHalf.data(), 4), "kind is 7");
}
