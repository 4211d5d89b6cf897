// Test 4 of spec section 4 for rays that are not parallel: to an eye, and straight out from an axis.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>

#include "support/brute_force_rays.h"
#include "support/projector_defs.h"
#include "support/reference_projector.h"

using namespace support;

namespace {

constexpr Color kBase{10, 20, 30, 255};
constexpr Color kPaint{200, 100, 50, 255};

Picture paint(TestSession& session, TxcTarget target, const TxcLayerDef& def) {
    session.set_base(target, kBase);
    const TxcLayer layer = session.layer(target, def);
    Picture picture = session.paint(target);
    must(txc_layer_destroy(session.id(), layer));
    return picture;
}

/// One that shows nothing but test 4.
void show_occlusion_alone(TxcLayerDef& def) {
    def.filter = TXC_FILTER_NEAREST;
    def.occlusion = TXC_OCCLUSION_SELF;
    def.backfaces = 1;
    def.angle_fade_start = def.angle_fade_end = 90.0f;
}

/// Compares every texel of a sphere in clutter with a search of all triangles. Returns how many are hidden.
std::uint32_t check_clutter(Random& random, const std::function<TxcLayerDef()>& make_def) {
    const Shape target_shape = make_sphere(0.6, 16, 8);
    const Shape clutter = make_random_triangles(random, 60, 1.0, 0.3);
    TestSession session;
    session.add(target_shape, 0);
    session.add(clutter, 1);
    const TxcTarget target = session.target(64, 32, 0);
    Shape bare = target_shape;
    bare.normals.clear();
    bare.uvs.clear();
    bare.append(clutter);
    const txc::Mesh mesh = make_core_mesh(bare);
    const ReferenceMap map(target_shape, 64, 32);
    const double least = 0.0005 * static_cast<double>(mesh.bounds.diagonal());
    std::uint32_t hidden = 0;
    for (int round = 0; round < 8; ++round) {
        TxcLayerDef def = make_def();
        show_occlusion_alone(def);
        def.image = session.image(Picture(1, 1, kPaint));
        def.occlusion = TXC_OCCLUSION_NONE;
        const Picture through = paint(session, target, def);
        def.occlusion = TXC_OCCLUSION_SELF;
        const Picture painted = paint(session, target, def);
        std::uint32_t wrong = 0;
        for (std::uint32_t y = 0; y < 32; ++y) {
            for (std::uint32_t x = 0; x < 64; ++x) {
                const ReferenceTexel& texel = map.at(x, y);
                if (texel.triangle < 0 || !texel.sure) continue;
                if (through.at(x, y) == kBase) {
                    wrong += painted.at(x, y) != kBase ? 1 : 0;
                    continue;
                }
                const Vec3 p = map.position(texel.triangle, texel.u, texel.v);
                const ReferenceSight sight = look(def, p, 0, 0);
                const auto own = static_cast<std::uint32_t>(texel.triangle);
                bool unsure = false;
                bool ignored = false;
                const bool expected = BruteForce{mesh, least}.is_blocked(p, sight.towards, sight.reach, own, unsure);
                // Neighbours on the sphere that the ray only grazes, at about the least distance.
                const bool nearer =
                    BruteForce{mesh, least * 0.25}.is_blocked(p, sight.towards, sight.reach, own, ignored);
                if (unsure || ignored || nearer != expected) continue;
                wrong += (painted.at(x, y) == kBase) != expected ? 1 : 0;
                hidden += expected ? 1 : 0;
            }
        }
        CAPTURE(round);
        CHECK(wrong == 0);
    }
    return hidden;
}

}  // namespace

TEST_CASE("Every texel before an eye is hidden or painted as a search of all triangles says") {
    Random random(120);
    const std::uint32_t hidden = check_clutter(random, [&random] {
        TxcLayerDef def = perspective_def(0, random.between(40, 140), 1.2, random.between(0.05, 0.8), 5);
        random.rotation(def.rotation);
        const Vec3 eye =
            out_of_box(def, {random.between(-0.3, 0.3), random.between(-0.3, 0.3), random.between(0, 1.8)});
        place(def, eye.x, eye.y, eye.z);
        return def;
    });
    CHECK(hidden > 1000);
}

TEST_CASE("Every texel about an axis is hidden or painted as a search of all triangles says") {
    Random random(121);
    const std::uint32_t hidden = check_clutter(random, [&random] {
        TxcLayerDef def = cylindrical_def(0, random.between(0.2, 0.7), 3, 360, random.between(0.4, 1.0));
        random.rotation(def.rotation);
        place(def, random.between(-0.2, 0.2), random.between(-0.2, 0.2), random.between(-0.2, 0.2));
        return def;
    });
    CHECK(hidden > 1000);
}

TEST_CASE("A plate throws its shadow from the eye, larger the further the wall") {
    TestSession session;
    session.add(make_plane(2.0, 0.0), 0);
    session.add(make_plane(0.5, 1.0), 1);
    const TxcTarget target = session.target(64, 64);
    TxcLayerDef def = perspective_def(session.image(Picture(1, 1, kPaint)), 90, 1, 0.1, 5);
    place(def, 0, 0, 2);
    show_occlusion_alone(def);
    const Picture picture = paint(session, target, def);
    // Half a metre at 1 m from the eye hides one metre at 2 m: texels 16 to 47.
    CHECK(picture.at(15, 32) == kPaint);
    CHECK(picture.at(16, 32) == kBase);
    CHECK(picture.at(47, 32) == kBase);
    CHECK(picture.at(48, 32) == kPaint);
    def.occlusion = TXC_OCCLUSION_NONE;
    CHECK(paint(session, target, def) == Picture(64, 64, kPaint));
}

TEST_CASE("A plate nearer to the eye than the volume begins hides nothing, and one behind the wall neither") {
    TestSession session;
    session.add(make_plane(1.0, 0.0), 0);
    session.add(make_plane(0.5, 1.0), 1);
    session.add(make_plane(0.5, -0.5), 1);
    const TxcTarget target = session.target(32, 32);
    TxcLayerDef def = perspective_def(session.image(Picture(1, 1, kPaint)), 90, 1, 1.1, 5);
    place(def, 0, 0, 2);
    show_occlusion_alone(def);
    CHECK(paint(session, target, def) == Picture(32, 32, kPaint));
    def.near_distance = 0.9f;
    CHECK(paint(session, target, def).at(16, 16) == kBase);
}

TEST_CASE("A handle hides the mug behind it, as far as the label's depth reaches") {
    // A wall of a quarter turn about +Z stands 0.3 m before a cylinder.
    Shape handle;
    {
        const Shape whole = make_cylinder(1.3, 2.0, 48);
        handle = whole;
        handle.indices.clear();
        // Columns run from -180 to 180 degrees: those from -45 to 45.
        for (std::uint32_t column = 18; column < 30; ++column) {
            handle.add_triangle(column, column + 49, column + 1);
            handle.add_triangle(column + 1, column + 49, column + 50);
        }
    }
    TestSession session;
    session.add(make_cylinder(1.0, 1.0, 48), 0);
    session.add(handle, 1);
    const TxcTarget target = session.target(96, 8, 0);
    TxcLayerDef def = cylindrical_def(session.image(Picture(1, 1, kPaint)), 1.0, 2, 360, 0.5);
    show_occlusion_alone(def);
    const Picture hidden = paint(session, target, def);
    for (std::uint32_t x = 0; x < 96; ++x) CHECK_UNARY((hidden.at(x, 4) == kBase) == (x >= 36 && x < 60));
    def.depth = 0.2f;
    CHECK(paint(session, target, def) == Picture(96, 8, kPaint));
}

TEST_CASE("A convex shape never hides itself from an eye or an axis") {
    // Flat normals: rounded ones face the eye on facets that do not, and those the solid does hide.
    Shape sphere = make_sphere(1.0, 32, 16);
    sphere.normals.clear();
    TestSession session(sphere);
    const TxcTarget target = session.target(96, 64);
    const TxcImage image = session.image(Picture(1, 1, kPaint));
    TxcLayerDef slide = perspective_def(image, 90, 1, 0.1, 5);
    place(slide, 0, 0, 2.5);
    TxcLayerDef label = cylindrical_def(image, 0.8, 3, 360, 0.7);
    for (TxcLayerDef* def : {&slide, &label}) {
        def->filter = TXC_FILTER_NEAREST;
        def->occlusion = TXC_OCCLUSION_NONE;
        const Picture through = paint(session, target, *def);
        def->occlusion = TXC_OCCLUSION_SELF;
        CHECK(count_differences(paint(session, target, *def), through) == 0);
        CHECK(count_color(through, kPaint) > 600);
    }
}

TEST_CASE(
    "The gutter at an inner corner is painted by a slide, though the neighbour stands before its continued plane") {
    TestSession session(make_inner_corner());
    const TxcTarget target = session.target(64, 64, 3);
    TxcLayerDef def = perspective_def(session.image(Picture(1, 1, kPaint)), 100, 1, 0.1, 9);
    def.filter = TXC_FILTER_NEAREST;
    def.occlusion = TXC_OCCLUSION_SELF;
    def.angle_fade_start = def.angle_fade_end = 90.0f;
    place(def, 0, 2, 2);
    look_at(def, 0, 0.3, 0.3);
    const Picture painted = paint(session, target, def);
    const MapArrays map = session.map(target);
    std::uint32_t gutter = 0;
    for (std::uint32_t y = 0; y < 64; ++y) {
        for (std::uint32_t x = 0; x < 64; ++x) {
            if (map.coverage_at(x, y) == 0) continue;
            CHECK_UNARY(painted.at(x, y) == kPaint);
            gutter += map.coverage_at(x, y) == 2 ? 1 : 0;
        }
    }
    CHECK(gutter > 300);
}
