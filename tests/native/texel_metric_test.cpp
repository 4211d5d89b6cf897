// A texel's form on the surface against the ways that it stands for.
#include "texel_metric.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "support/random.h"

using namespace support;

namespace {

/// What a texel to the right and a texel down are on a surface.
struct Sides {
    glm::dvec3 right, below;

    txc::TexelMetric metric() const { return {glm::dot(right, right), glm::dot(right, below), glm::dot(below, below)}; }
    glm::dvec3 at(const glm::dvec2& way) const { return right * way.x + below * way.y; }
};

glm::dvec3 random_way(Random& random) {
    return {random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)};
}

glm::dvec2 random_texels(Random& random) { return {random.between(-2.0, 2.0), random.between(-2.0, 2.0)}; }

}  // namespace

TEST_CASE("The product of two ways in texels is that of the ways on the surface") {
    Random random(311);
    for (int round = 0; round < 50; ++round) {
        const Sides sides{random_way(random), random_way(random)};
        const glm::dvec2 a = random_texels(random);
        const glm::dvec2 b = random_texels(random);
        CHECK(sides.metric().dot(a, b) == doctest::Approx(glm::dot(sides.at(a), sides.at(b))));
    }
}

TEST_CASE(
    "The longest and shortest way of a texel's length are the ends of all directions, and the area the sides' own") {
    Random random(312);
    for (int round = 0; round < 50; ++round) {
        const Sides sides{random_way(random), random_way(random)};
        double longest = 0.0;
        double shortest = 1e9;
        for (int step = 0; step < 3600; ++step) {
            const double angle = step * 3.14159265358979 / 3600.0;
            const double length = glm::length(sides.at({std::cos(angle), std::sin(angle)}));
            longest = std::max(longest, length);
            shortest = std::min(shortest, length);
        }
        const txc::TexelMetric metric = sides.metric();
        CHECK(metric.longest() == doctest::Approx(longest).epsilon(1e-4));
        CHECK(metric.shortest() == doctest::Approx(shortest).epsilon(1e-3));
        CHECK(metric.area() == doctest::Approx(glm::length(glm::cross(sides.right, sides.below))));
    }
}

TEST_CASE("In other units a way is as long as before, and units on one line are none") {
    Random random(313);
    for (int round = 0; round < 50; ++round) {
        const Sides sides{random_way(random), random_way(random)};
        // A texel to the right and a texel down, in pixels of a picture.
        const glm::dvec2 right = random_texels(random);
        const glm::dvec2 below = random_texels(random);
        txc::TexelMetric pixel;
        REQUIRE(sides.metric().in_units_of(right, below, pixel));
        const glm::dvec2 a = random_texels(random);
        const glm::dvec2 b = random_texels(random);
        const double product = pixel.dot(right * a.x + below * a.y, right * b.x + below * b.y);
        CHECK(product == doctest::Approx(glm::dot(sides.at(a), sides.at(b))).epsilon(1e-6));
        CHECK_FALSE(sides.metric().in_units_of(right, right * 2.0, pixel));
    }
}
