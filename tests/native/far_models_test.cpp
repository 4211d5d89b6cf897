// Models that stand far from model space's origin: what floats lose there is no loss of theirs (spec section 2).
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/glb_builder.h"
#include "support/projector_defs.h"
#include "support/reference_map.h"
#include "support/strokes.h"
#include "support/test_session.h"

using namespace support;

namespace {

struct Place {
    double x, y, z;
};
// Whole numbers, so that a design is moved there without rounding.
constexpr Place kHere{0.0, 0.0, 0.0};
constexpr Place kFar{4096.0, -2048.0, 8192.0};
constexpr Place kFarAlongOne{0.0, 4096.0, 0.5};

/// The shape in a node that puts it there.
std::vector<std::uint8_t> glb_at(const Shape& shape, const Place& at) {
    return make_model(shape, text(R"({"mesh":0,"translation":[%g,%g,%g]})", at.x, at.y, at.z)).glb();
}

/// How far a point within a metre of the place may be from where floats put it, at the most.
double float_step(const Place& at) {
    double square = 0.0;
    for (const double c : {at.x, at.y, at.z}) {
        const auto most = static_cast<float>(std::fabs(c) + 1.0);
        const double half = 0.5 * static_cast<double>(std::nextafter(most, HUGE_VALF) - most);
        square += half * half;
    }
    return std::sqrt(square);
}

/// The furthest that a texel's position is from the triangle's own, moved there; metres.
double worst_error(const TestSession& session, TxcTarget target, const Shape& shape, const Place& at) {
    const MapArrays map = session.map(target);
    const ReferenceMap reference(shape, map.width, map.height);
    double worst = 0.0;
    std::uint32_t compared = 0;
    for (std::uint32_t y = 0; y < map.height; ++y) {
        for (std::uint32_t x = 0; x < map.width; ++x) {
            const ReferenceTexel& texel = reference.at(x, y);
            if (!texel.sure || texel.triangle < 0 || map.coverage_at(x, y) != 1) continue;
            const Vec3 p = reference.position(texel.triangle, texel.u, texel.v) + Vec3{at.x, at.y, at.z};
            worst = std::fmax(worst, length(vec3(map.position(x, y)) - p));
            ++compared;
        }
    }
    CHECK(compared > 7000);
    return worst;
}

void move(TxcLayerDef& def, const Place& at, double x, double y, double z) { place(def, at.x + x, at.y + y, at.z + z); }

/// Two spheres side by side, of which one hides a part of the other, and whose bounds lie around the middle.
Shape make_pair() {
    Shape pair = moved(make_sphere(0.5, 24, 12, {0.0, 0.0, 0.5, 1.0}), -0.5, 0.0, 0.0);
    pair.append(moved(make_sphere(0.5, 24, 12, {0.5, 0.0, 1.0, 1.0}), 0.5, 0.0, 0.0));
    return pair;
}

/// A layer of each kind that asks where the surface is.
Picture paint_all(TestSession& session, TxcTarget target, const Place& at) {
    const TxcImage image = session.image(make_noise(3, 32, 32));
    TxcLayerDef planar = decal_def(image);
    planar.occlusion = TXC_OCCLUSION_SELF;
    turn(planar, 0, 1, 0, 80);
    move(planar, at, 0.25, 0.0, 0.0);
    resize(planar, 0.5, 0.5, 3.0);
    session.layer(target, planar);

    TxcLayerDef eye = perspective_def(image, 30, 1, 0.5, 5);
    eye.occlusion = TXC_OCCLUSION_SELF;
    move(eye, at, -2.0, 1.0, 1.0);
    look_at(eye, at.x, at.y, at.z);
    session.layer(target, eye);

    TxcLayerDef label = cylindrical_def(image, 0.5, 0.25, 120, 0.25);
    label.occlusion = TXC_OCCLUSION_SELF;
    move(label, at, -0.5, -0.25, 0.0);
    session.layer(target, label);

    TxcLayerDef sheen = fill_def(1, 1, 1, 0.5f);
    const TxcLayer fill = session.layer(target, sheen);
    TxcGradient gradient;
    txc_gradient_default(&gradient);
    const double from[3] = {at.x - 1.0, at.y, at.z};
    const double to[3] = {at.x + 1.0, at.y + 0.25, at.z};
    for (int c = 0; c < 3; ++c) {
        gradient.from_model[c] = static_cast<float>(from[c]);
        gradient.to_model[c] = static_cast<float>(to[c]);
    }
    must(txc_fill_set_gradient(session.id(), fill, &gradient));

    std::vector<TxcDab> dabs;
    for (const double x : {0.25, 0.5, 0.75}) {
        TxcDab dab = dab_at(at.x + x, at.y + 0.25, 0.25);
        dab.position_model[2] = static_cast<float>(at.z + 0.5);
        dabs.push_back(dab);
    }
    add_dabs(session, session.layer(target, stroke_def(0.5)), dabs);
    return session.paint(target);
}

/// How much of each texel lies in a box in front of the left sphere.
std::vector<std::uint8_t> zone_mask(const TestSession& session, TxcTarget target, const Place& at) {
    TxcZone box;
    txc_zone_default(&box);
    box.kind = TXC_ZONE_BOX;
    const double centre[3] = {at.x - 0.5, at.y, at.z + 0.5};
    for (int c = 0; c < 3; ++c) {
        box.position_model[c] = static_cast<float>(centre[c]);
        box.size[c] = 0.5f;
    }
    must(txc_session_set_zones(session.id(), &box, 1, nullptr, 0));
    const TxcMapInfo info = session.map_info(target);
    std::vector<std::uint8_t> mask(std::size_t{info.width} * info.height);
    must(txc_zone_mask(session.id(), target, TXC_NONE, 0, info.height, mask.data()));
    return mask;
}

}  // namespace

TEST_CASE("Arrays whose coordinates lie far from the origin are baked as exactly as floats are there") {
    const Shape sphere = make_sphere(0.1, 24, 12);
    for (const Place& at : {Place{100, 100, 100}, Place{-150, 0, 0}, Place{0, 20, -140}}) {
        const Shape far = moved(sphere, at.x, at.y, at.z);
        TestSession session(far);
        CHECK(worst_error(session, session.target(128, 64), far, kHere) < float_step(at) * 1.01);
    }
}

TEST_CASE("A model that its node puts far from the origin is baked as exactly as floats are there") {
    const Shape sphere = make_sphere(0.1, 24, 12);
    for (const Place& at : {Place{100, 100, 100}, Place{-150, 0, 0}, Place{0, 20, -140}}) {
        TestSession session;
        session.load(glb_at(sphere, at));
        CHECK(worst_error(session, session.target(128, 64), sphere, at) < float_step(at) * 1.01);
    }
}

TEST_CASE("A design of all kinds of layers paints the same bytes far from the origin as there") {
    const Shape pair = make_pair();
    TestSession here;
    here.load(glb_at(pair, kHere));
    const TxcTarget target = here.target(256, 128);
    const Picture picture = paint_all(here, target, kHere);
    const std::vector<std::uint8_t> mask = zone_mask(here, target, kHere);
    CHECK(count_opaque(picture) > 0);
    CHECK(std::count(mask.begin(), mask.end(), 0) < static_cast<std::ptrdiff_t>(mask.size()));
    for (const Place& at : {kFar, kFarAlongOne}) {
        CAPTURE(at.x);
        TestSession there;
        there.load(glb_at(pair, at));
        const TxcTarget far = there.target(256, 128);
        CHECK(paint_all(there, far, at) == picture);
        CHECK(zone_mask(there, far, at) == mask);
    }
}

TEST_CASE("What is told of a model far from the origin is where it stands, and its map's picture is as at home") {
    const Shape pair = make_pair();
    TestSession here;
    here.load(glb_at(pair, kHere));
    TestSession there;
    there.load(glb_at(pair, kFar));
    const TxcTarget target = here.target(64, 32);
    const TxcTarget far = there.target(64, 32);
    const double by[3] = {kFar.x, kFar.y, kFar.z};
    const double half[3] = {1.0, 0.5, 0.5};
    const TxcModelInfo model = there.model_info();
    const TxcMaterialInfo material = there.material_info();
    const TxcMapInfo map = there.map_info(far);
    for (int c = 0; c < 3; ++c) {
        CAPTURE(c);
        const auto least = static_cast<float>(by[c] - half[c]);
        const auto most = static_cast<float>(by[c] + half[c]);
        CHECK(model.bounds_min_model[c] == least);
        CHECK(model.bounds_max_model[c] == most);
        CHECK(material.bounds_min_model[c] == least);
        CHECK(material.bounds_max_model[c] == most);
        CHECK(map.bounds_min_model[c] == least);
        CHECK(map.bounds_max_model[c] == most);
    }
    std::vector<std::uint8_t> views[2];
    for (int i = 0; i < 2; ++i) {
        views[i].resize(64 * 32 * 4);
        must(txc_map_view(i == 0 ? here.id() : there.id(), i == 0 ? target : far, TXC_VIEW_POSITIONS, 0, 32,
                          views[i].data()));
    }
    CHECK(views[0] == views[1]);
}

TEST_CASE("Arrays that are added to a model far from the origin stand where they say, and so does what was there") {
    const Shape cube = make_cube(2.0);
    TestSession session(moved(cube, kFar.x, kFar.y, kFar.z));
    // One beside the first, and one so far from both that the model is no longer far from the origin by its own size.
    const double places[] = {kFar.x, kFar.x + 4.0, kFar.x - 8192.0};
    for (std::uint32_t added = 1; added < 3; ++added) {
        session.add(moved(cube, places[added], kFar.y, kFar.z), added);
        for (std::uint32_t material = 0; material <= added; ++material) {
            CAPTURE(material);
            const MapArrays map = session.map(session.target(96, 96, TXC_NONE, 1, material));
            double least = HUGE_VAL;
            double most = -HUGE_VAL;
            for (std::size_t texel = 0; texel < map.coverage.size(); ++texel) {
                if (map.coverage[texel] != 1) continue;
                const auto x = static_cast<double>(map.positions[texel * 3]);
                least = std::fmin(least, x);
                most = std::fmax(most, x);
            }
            CHECK(std::fabs(least - (places[material] - 1.0)) < 1e-3);
            CHECK(std::fabs(most - (places[material] + 1.0)) < 1e-3);
        }
    }
}
