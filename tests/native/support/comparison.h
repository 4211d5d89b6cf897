// The core and the slow painter side by side, over one shape and one texture.
#pragma once

#include <doctest/doctest.h>

#include <utility>
#include <vector>

#include "reference_painter.h"
#include "test_session.h"

namespace support {

inline constexpr Color kWhite{255, 255, 255, 255};
/// Decibels that spec section 5 asks for.
inline constexpr double kAsked = 40.0;

/// A shape, its slow bake, and a session with the same texture: paints decals with both.
class Comparison {
public:
    Comparison(const Shape& shape, std::uint32_t width, std::uint32_t height)
        : shape_(shape), reference_(shape_, width, height), session_(shape), target_(session_.target(width, height)) {}

    Closeness paint(const TxcLayerDef& def, const Picture& picture, Color base = kWhite) {
        return paint({{def, picture}}, base);
    }
    Closeness paint(std::vector<std::pair<TxcLayerDef, Picture>> layers, Color base) {
        session_.set_base(target_, base);
        ReferencePainter expected(reference_, base);
        std::vector<TxcLayer> made;
        for (auto& [def, picture] : layers) {
            def.image = session_.image(picture);
            made.push_back(session_.layer(target_, def));
            expected.paint(def, picture);
        }
        const Closeness closeness = compare(expected, session_.paint(target_), base);
        for (const TxcLayer layer : made) must(txc_layer_destroy(session_.id(), layer));
        return closeness;
    }

private:
    Shape shape_;
    ReferenceMap reference_;
    TestSession session_;
    TxcTarget target_;
};

inline void check(const Closeness& closeness, std::uint32_t at_least = 200) {
    CHECK(closeness.decibel >= kAsked);
    CHECK(closeness.compared >= at_least);
}

}  // namespace support
