// RGBA pictures, straight alpha, row 0 at the top: what decals show, what targets hold, and how near two of them are.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "random.h"

namespace support {

struct Color {
    std::uint8_t red, green, blue, alpha;
    bool operator==(const Color& other) const = default;
};

struct Picture {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::vector<std::uint8_t> rgba;

    Picture() = default;
    Picture(std::uint32_t picture_width, std::uint32_t picture_height, Color color = {0, 0, 0, 0})
        : width(picture_width), height(picture_height) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(width) * height; ++i)
            rgba.insert(rgba.end(), {color.red, color.green, color.blue, color.alpha});
    }

    bool operator==(const Picture& other) const = default;

    Color at(std::uint32_t x, std::uint32_t y) const {
        const std::uint8_t* from = rgba.data() + (static_cast<std::size_t>(y) * width + x) * 4;
        return {from[0], from[1], from[2], from[3]};
    }
    void set(std::uint32_t x, std::uint32_t y, Color color) {
        std::uint8_t* to = rgba.data() + (static_cast<std::size_t>(y) * width + x) * 4;
        to[0] = color.red;
        to[1] = color.green;
        to[2] = color.blue;
        to[3] = color.alpha;
    }
};

/// How many texels differ between two pictures of one size.
inline std::uint32_t count_differences(const Picture& a, const Picture& b) {
    if (a.width != b.width || a.height != b.height) return a.width * a.height + b.width * b.height;
    std::uint32_t count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        count += std::equal(a.rgba.begin() + i, a.rgba.begin() + i + 4, b.rgba.begin() + i) ? 0 : 1;
    return count;
}

inline std::uint32_t count_opaque(const Picture& picture) {
    std::uint32_t count = 0;
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) count += picture.rgba[i] == 255 ? 1 : 0;
    return count;
}

inline std::uint32_t count_color(const Picture& picture, Color color) {
    std::uint32_t count = 0;
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) count += picture.at(x, y) == color ? 1 : 0;
    }
    return count;
}

/// Hard-edged squares of `cell` pixels in two colours.
inline Picture make_checker(std::uint32_t width, std::uint32_t height, std::uint32_t cell,
                            Color odd = {20, 30, 40, 255}, Color even = {250, 220, 60, 255}) {
    Picture picture(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) picture.set(x, y, (x / cell + y / cell) % 2 == 0 ? even : odd);
    }
    return picture;
}

/// Red rises to the right, green downwards, blue falls, and so does alpha where `fades`.
inline Picture make_gradient(std::uint32_t width, std::uint32_t height, bool fades = false) {
    Picture picture(width, height);
    for (std::uint32_t y = 0; y < height; ++y) {
        for (std::uint32_t x = 0; x < width; ++x) {
            const auto red = static_cast<std::uint8_t>(x * 255 / std::max(width - 1, 1u));
            const auto green = static_cast<std::uint8_t>(y * 255 / std::max(height - 1, 1u));
            picture.set(x, y, {red, green, static_cast<std::uint8_t>(255 - red), fades ? green : std::uint8_t{255}});
        }
    }
    return picture;
}

/// Every channel of every pixel drawn by lot. `opaque` leaves alpha at 255.
inline Picture make_noise(std::uint32_t width, std::uint32_t height, std::uint64_t seed, bool opaque = false) {
    Picture picture(width, height);
    Random random(seed);
    for (std::size_t i = 0; i < picture.rgba.size(); ++i) {
        const std::uint32_t value = random.next();
        picture.rgba[i] = opaque && i % 4 == 3 ? 255 : static_cast<std::uint8_t>(value >> 24);
    }
    return picture;
}

}  // namespace support
