// What print truth counts, and by what weight (docs/print-truth.md): covered texels alone, each with its area.
#include <doctest/doctest.h>

#include <cmath>
#include <vector>

#include "support/picture.h"
#include "support/projector_defs.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr Color kRed{200, 0, 0, 255};

TxcLayerMetrics measure(TestSession& session, TxcTarget target, const TxcLayerDef& def) {
    const TxcLayer layer = session.layer(target, def);
    session.update(target);
    TxcLayerMetrics metrics{};
    must(txc_layer_metrics(session.id(), &layer, 1, &metrics, nullptr));
    must(txc_layer_destroy(session.id(), layer));
    return metrics;
}

TxcZoneSurface surface_of(TestSession& session, TxcTarget target) {
    TxcZoneSurface surface{};
    must(txc_zone_surface(session.id(), target, TXC_NONE, &surface));
    return surface;
}

/// A parallelogram: its upper left corner, and how far it goes along u and along v.
Shape make_parallelogram(const double (&corner)[3], const double (&along_u)[3], const double (&along_v)[3],
                         const UvRect& chart = {}) {
    return make_grid(1, 1, chart, [&](double s, double t, double(&p)[3], double(&n)[3]) {
        for (int c = 0; c < 3; ++c) {
            p[c] = corner[c] + along_u[c] * s + along_v[c] * t;
            const int d = (c + 1) % 3;
            const int e = (c + 2) % 3;
            n[c] = along_v[d] * along_u[e] - along_v[e] * along_u[d];
        }
    });
}

}  // namespace

TEST_CASE("Gutters are painted, and neither measured nor part of the surface") {
    TestSession session(make_plane(1.0, 0.0, {0.25, 0.25, 0.75, 0.75}));
    const TxcTarget target = session.target(64, 64, 4);
    const TxcLayerMetrics metrics = measure(session, target, fill_def(1, 0, 0));
    CHECK(metrics.painted_texels == 32 * 32);
    CHECK(metrics.area == doctest::Approx(1.0));
    const TxcZoneSurface surface = surface_of(session, target);
    CHECK(surface.texels == 32 * 32);
    CHECK(surface.first_x == 16);
    CHECK(surface.end_y == 48);
}

TEST_CASE("Of a tile that two charts share in part, only the texels of both overlap") {
    Shape shape = make_plane();
    shape.append(moved(make_plane(1.0, 0.0, {20.0 / 64, 18.0 / 64, 28.0 / 64, 42.0 / 64}), 2.0, 0.0, 0.0));
    TestSession session(shape);
    const TxcTarget target = session.target(64, 64);
    const TxcLayerMetrics metrics = measure(session, target, fill_def(1, 0, 0));
    CHECK(metrics.painted_texels == 64 * 64);
    CHECK(metrics.overlapping_texels == 8 * 24);
}

TEST_CASE("A stamp is measured in a window of a texture as in the whole") {
    TestSession session(make_plane());
    TxcLayerDef stamp = uv_def(session.image(make_checker(32, 32, 4)), 0.6, 0.8, 0.2, 0.2, 30.0);
    const TxcTarget whole = session.target(128, 128, 0);
    const TxcLayerMetrics expected = measure(session, whole, stamp);
    CHECK(expected.clipped == 0.0f);
    TxcTargetDef def;
    txc_target_def_default(&def);
    def.texture_width = def.texture_height = 128;
    def.window_x = 48;
    def.window_y = 64;
    def.width = 80;
    def.height = 64;
    def.gutter = 0;
    TxcTarget window = 0;
    must(txc_target_create(session.id(), &def, &window));
    session.bake(window);
    const TxcLayerMetrics metrics = measure(session, window, stamp);
    CHECK(metrics.clipped == 0.0f);
    CHECK(metrics.hidden == 0.0f);
    CHECK(metrics.painted_texels == expected.painted_texels);
    CHECK(metrics.area == doctest::Approx(static_cast<double>(expected.area)));
    CHECK(metrics.mean_pixels_per_metre == doctest::Approx(static_cast<double>(expected.mean_pixels_per_metre)));
}

TEST_CASE("A side that faces away hides all of a picture whose pixels are finer than texels, holes or none") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(64, 64);
    // Sixteen pixels a texel, and a hole under each texel's centre.
    Picture picture(128, 128, kRed);
    for (std::uint32_t y = 0; y < 128; ++y) {
        for (std::uint32_t x = 0; x < 128; ++x) {
            if (x % 4 != 0 && y % 4 != 0) picture.set(x, y, {});
        }
    }
    TxcLayerDef def = decal_def(session.image(picture));
    resize(def, 0.5, 0.5, 1.0);
    CHECK(measure(session, target, def).hidden == 0.0f);
    turn(def, 0.0, 1.0, 0.0, 180.0);
    const TxcLayerMetrics behind = measure(session, target, def);
    CHECK(behind.hidden == 1.0f);
    CHECK(behind.clipped == 1.0f);
}

TEST_CASE("A surface tells the lengths of its texels, their product, and where +Y points on it") {
    const double along_u[3] = {0.3, 0.4, 0.1};
    const double along_v[3] = {0.1, -0.5, 0.2};
    TestSession session(make_parallelogram({0.2, 0.3, 0.4}, along_u, along_v));
    const TxcTarget target = session.target(50, 20);
    const TxcZoneSurface surface = surface_of(session, target);
    double right[3];
    double down[3];
    for (int c = 0; c < 3; ++c) {
        right[c] = along_u[c] / 50;
        down[c] = along_v[c] / 20;
    }
    const auto dot = [](const double(&a)[3], const double(&b)[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; };
    CHECK(surface.metric[0] == doctest::Approx(dot(right, right)));
    CHECK(surface.metric[1] == doctest::Approx(dot(right, down)));
    CHECK(surface.metric[2] == doctest::Approx(dot(down, down)));
    // The part of +Y that lies in the surface: what is left of it stands upright upon both of a texel's sides.
    double rest[3];
    for (int c = 0; c < 3; ++c)
        rest[c] = (c == 1 ? 1.0 : 0.0) - right[c] * static_cast<double>(surface.up[0]) -
                  down[c] * static_cast<double>(surface.up[1]);
    CHECK(dot(rest, right) == doctest::Approx(0.0).scale(0.01).epsilon(1e-4));
    CHECK(dot(rest, down) == doctest::Approx(0.0).scale(0.01).epsilon(1e-4));
    CHECK(surface.first_x == 0);
    CHECK(surface.first_y == 0);
    CHECK(surface.end_x == 50);
    CHECK(surface.end_y == 20);
}

TEST_CASE("What is told of a surface of several parts is their mean by area, and so is how much lies mirrored") {
    // A square of 1 m upon a quarter of the texture, and beside it one of 3 m that is mirrored.
    Shape shape = make_plane(1.0, 0.0, {0.0, 0.5, 0.5, 1.0});
    shape.append(moved(make_plane(3.0, 0.0, {1.0, 0.0, 0.5, 0.5}), 5.0, 0.0, 0.0));
    TestSession session(shape);
    const TxcTarget target = session.target(64, 64, 0);
    const TxcZoneSurface surface = surface_of(session, target);
    CHECK(surface.texels == 2 * 32 * 32);
    CHECK(surface.area == doctest::Approx(10.0));
    CHECK(surface.mirrored == doctest::Approx(0.9));
    const double near_side = 1.0 / 32;
    const double far_side = 3.0 / 32;
    const double mean = 0.1 * near_side * near_side + 0.9 * far_side * far_side;
    CHECK(surface.metric[0] == doctest::Approx(mean));
    CHECK(surface.metric[1] == doctest::Approx(0.0).scale(1e-3));
    CHECK(surface.metric[2] == doctest::Approx(mean));
    CHECK(surface.up[0] == doctest::Approx(0.0).scale(1.0));
    CHECK(surface.up[1] == doctest::Approx(-0.1 / near_side - 0.9 / far_side));
    CHECK(surface.first_x == 0);
    CHECK(surface.first_y == 0);
    CHECK(surface.end_x == 64);
    CHECK(surface.end_y == 64);
    const TxcLayerMetrics metrics = measure(session, target, fill_def(1, 0, 0, 0.5f));
    CHECK(metrics.area == doctest::Approx(5.0));
    CHECK(metrics.mirrored_texels == 32 * 32);
    CHECK(metrics.least_texels_per_metre == doctest::Approx(1.0 / far_side));
    CHECK(metrics.mean_texels_per_metre == doctest::Approx(0.1 / near_side + 0.9 / far_side));
}

TEST_CASE("A surface of one texel tells that texel's rectangle") {
    TestSession session(make_plane(1.0, 0.0, {37.0 / 64, 21.0 / 64, 38.0 / 64, 22.0 / 64}));
    const TxcZoneSurface surface = surface_of(session, session.target(64, 64));
    CHECK(surface.texels == 1);
    CHECK(surface.first_x == 37);
    CHECK(surface.first_y == 21);
    CHECK(surface.end_x == 38);
    CHECK(surface.end_y == 22);
    CHECK(surface.area == doctest::Approx(1.0));
}

TEST_CASE(
    "However a picture of many pixels a texel is turned, what of it lies on the surface lands, and the rest is "
    "clipped") {
    TestSession session(make_plane());
    const TxcTarget target = session.target(16, 16, 0);
    TxcLayerDef def = decal_def(session.image(Picture(256, 192, kRed)));
    resize(def, 0.5, 0.375, 1.0);
    for (int flips = 0; flips < 4; ++flips) {
        def.flip_x = flips % 2 == 0 ? 0 : 1;
        def.flip_y = flips / 2 == 0 ? 0 : 1;
        for (const double degrees : {0.0, 30.0, -30.0, 75.0, 160.0}) {
            CAPTURE(flips);
            CAPTURE(degrees);
            turn(def, 0.0, 0.0, 1.0, degrees);
            place(def, 0.01, 0.02, 0.0);
            CHECK(measure(session, target, def).clipped == 0.0f);
            // The plane's edge runs through the middle, and through a quarter where the picture is upright.
            place(def, 0.5, 0.02, 0.0);
            CHECK(measure(session, target, def).clipped == doctest::Approx(0.5).epsilon(0.01));
            if (degrees != 0.0) continue;
            place(def, 0.375, 0.02, 0.0);
            CHECK(measure(session, target, def).clipped == doctest::Approx(0.25).epsilon(0.02));
        }
    }
}
