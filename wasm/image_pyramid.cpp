#include "image_pyramid.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace txc {
namespace {

std::int16_t to_biased(std::int32_t channel) { return static_cast<std::int16_t>(channel - kChannelBias); }

std::int32_t wrap(std::int32_t index, std::int32_t size) {
    const std::int32_t rest = index % size;
    return rest < 0 ? rest + size : rest;
}

// Area average of the finer level over each pixel of the coarser one. For odd sizes a pixel covers a little more than
// two, with fractions at its ends, so that no level is shifted against another.
void reduce(const PyramidLevel& fine, PyramidLevel& coarse) {
    const double step_x = static_cast<double>(fine.width) / coarse.width;
    const double step_y = static_cast<double>(fine.height) / coarse.height;
    for (std::uint32_t y = 0; y < coarse.height; ++y) {
        const double top = y * step_y;
        const double bottom = std::min((y + 1) * step_y, static_cast<double>(fine.height));
        for (std::uint32_t x = 0; x < coarse.width; ++x) {
            const double left = x * step_x;
            const double right = std::min((x + 1) * step_x, static_cast<double>(fine.width));
            double sum[4] = {0, 0, 0, 0};
            double area = 0;
            for (auto fy = static_cast<std::uint32_t>(top); fy < bottom; ++fy) {
                const double high = std::min(bottom, fy + 1.0) - std::max(top, static_cast<double>(fy));
                for (auto fx = static_cast<std::uint32_t>(left); fx < right; ++fx) {
                    const double weight = high * (std::min(right, fx + 1.0) - std::max(left, static_cast<double>(fx)));
                    const Int4 color = fine.color_at(fx, fy);
                    for (int c = 0; c < 4; ++c) sum[c] += weight * color[c];
                    area += weight;
                }
            }
            std::int16_t* out = coarse.pixel(x, y);
            for (int c = 0; c < 4; ++c) out[c] = to_biased(static_cast<std::int32_t>(sum[c] / area + 0.5));
        }
    }
}

/// The largest second differences around the pixel at `at` and those `stride` away, by channels: along x, along y, and how much the
/// four pixels of a square at its corners depart from a plane. `row`: values from row to row.
Int4 second_differences(const std::int16_t* at, std::size_t row, std::size_t stride) {
    const std::size_t right = stride * 4;
    const std::size_t down = stride * row;
    const Int4 middle = load_short4(at);
    const Int4 left_of = load_short4(at - right);
    const Int4 right_of = load_short4(at + right);
    const Int4 above = load_short4(at - down);
    const Int4 below = load_short4(at + down);
    const Int4 twice = middle + middle;
    const auto magnitude = [](Int4 v) { return greater(v, -v); };
    Int4 largest = greater(magnitude(left_of - twice + right_of), magnitude(above - twice + below));
    const auto twist = [&](Int4 along, Int4 across, const std::int16_t* corner) {
        largest = greater(largest, magnitude(middle - along - across + load_short4(corner)));
    };
    twist(left_of, above, at - right - down);
    twist(right_of, above, at + right - down);
    twist(left_of, below, at - right + down);
    twist(right_of, below, at + right + down);
    return largest;
}

/// On the scale of kFullScale to 8-bit steps, rounded up, at most 255.
std::uint8_t to_steps(Int4 differences) {
    const std::int32_t largest =
        std::max(std::max(differences[0], differences[1]), std::max(differences[2], differences[3]));
    return static_cast<std::uint8_t>(std::min((largest + kByteStep - 1) / kByteStep, 255));
}

using List = std::vector<std::uint8_t>;

/// Each value becomes the larger of those `before` and `after` its place.
void widen_line(const List& from, std::size_t before, std::size_t after, List& out) {
    const std::size_t count = from.size();
    std::size_t i = 0;
    for (; i < before; ++i) out[i] = i + after < count ? from[i + after] : std::uint8_t{0};
    for (; i + after < count; ++i) out[i] = std::max(from[i - before], from[i + after]);
    for (; i < count; ++i) out[i] = from[i - before];
}

/// Windows made of four. (Where a row ends in the padding the next one begins: there windows know too much, which is safe.)
void widen(const List& from, std::size_t row, std::size_t before, std::size_t after, List& lines, List& out) {
    widen_line(from, before, after, lines);
    widen_line(lines, before * row, after * row, out);
}

void measure_roughness(PyramidLevel& level) {
    const auto width = static_cast<std::size_t>(level.stride());
    const std::size_t height = level.height + 2 * kPad;
    const std::size_t row = width * 4;
    const std::size_t count = level.padded_count();
    List steps(count);
    List lines(count);
    for (List& list : level.peaks) list.resize(count);
    for (List& list : level.bends) list.resize(count);
    List& wide = level.bends[2];  // what is measured at the wider stride, until that list is made
    // What lies in the padding's outer half is transparent all around.
    for (std::size_t y = 2; y + 2 < height; ++y) {
        for (std::size_t x = 2; x + 2 < width; ++x) {
            const std::size_t place = y * width + x;
            const std::int16_t* at = level.rgba.data() + place * 4;
            steps[place] = to_steps(second_differences(at, row, 1));
            wide[place] = to_steps(second_differences(at, row, 2));
        }
    }
    widen(steps, width, 0, 1, lines, level.peaks[0]);
    widen(level.peaks[0], width, 1, 1, lines, level.peaks[1]);
    List& around = level.bends[0];
    widen(level.peaks[0], width, 1, 0, lines, around);
    for (std::size_t i = 0; i < count; ++i) {
        const auto half = static_cast<std::uint8_t>((steps[i] + 1) / 2);
        steps[i] = around[i] > 2 * kMostBend ? half : std::max(half, wide[i]);
    }
    widen(steps, width, 0, 1, lines, level.bends[1]);
    widen(level.bends[1], width, 1, 1, lines, level.bends[0]);
    widen(level.bends[0], width, 2, 2, lines, level.bends[1]);
    widen(level.bends[1], width, 4, 4, lines, level.bends[2]);
}

}  // namespace

bool PyramidLevel::is_clear(std::int32_t left, std::int32_t top, std::int32_t right, std::int32_t bottom) const {
    const std::int32_t last_x = static_cast<std::int32_t>(width) + kPad - 1;
    const std::int32_t last_y = static_cast<std::int32_t>(height) + kPad - 1;
    left = std::max(left, -kPad);
    top = std::max(top, -kPad);
    right = std::min(right, last_x);
    bottom = std::min(bottom, last_y);
    if (left > right || top > bottom) return true;
    const auto has_paint = [&](std::int32_t x, std::int32_t y) {
        return first_pixel()[(y * stride() + x) * 4 + 3] != to_biased(0);
    };
    if (has_paint(left, top) || has_paint(right, bottom) || has_paint(right, top) || has_paint(left, bottom))
        return false;
    constexpr std::int32_t kBefore = 7;  // see first_of
    constexpr std::int32_t kWindow = 16;
    const std::uint8_t* list = first_of(bends[2]);
    for (std::int32_t y = top; y <= bottom; y += kWindow) {
        const std::uint8_t* row = list + std::min(y + kBefore, last_y) * stride();
        for (std::int32_t x = left; x <= right; x += kWindow) {
            if (row[std::min(x + kBefore, last_x)] != 0) return false;
        }
    }
    return true;
}

TxcStatus ImagePyramid::build(std::uint32_t width, std::uint32_t height, const std::uint8_t* rgba) {
    // Pixels, and the lists of peaks and bends, of all levels; and two lists to make them.
    std::uint64_t bytes = 0;
    for (std::uint32_t w = width, h = height;; w = std::max(1u, w / 2), h = std::max(1u, h / 2)) {
        bytes += std::uint64_t{PyramidLevel::padded_count(w, h)} * (8 + 2 + 3);
        if (w == 1 && h == 1) break;
    }
    const std::uint64_t scratch = PyramidLevel::padded_count(width, height) * 2;
    if (const TxcStatus status = share.resize(bytes + scratch, "the decal's picture"); status != TXC_STATUS_OK)
        return status;
    // (To assign one level copies it: 0.5 kB of the module.)
    levels.clear();
    levels.emplace_back();
    levels[0].width = width;
    levels[0].height = height;
    levels[0].rgba.resize(levels[0].padded_count() * 4, to_biased(0));
    for (std::uint32_t y = 0; y < height; ++y) {
        const std::uint8_t* from = rgba + std::size_t{y} * width * 4;
        std::int16_t* to = levels[0].pixel(0, y);
        for (std::uint32_t x = 0; x < width; ++x, from += 4, to += 4) {
            const std::int32_t alpha = from[3];
            for (int c = 0; c < 3; ++c) to[c] = to_biased(from[c] * alpha);
            to[3] = to_biased(alpha * 255);
        }
    }
    while (levels.back().width > 1 || levels.back().height > 1) {
        PyramidLevel coarse;
        coarse.width = std::max(1u, levels.back().width / 2);
        coarse.height = std::max(1u, levels.back().height / 2);
        coarse.scale_x = static_cast<float>(coarse.width) / static_cast<float>(width);
        coarse.scale_y = static_cast<float>(coarse.height) / static_cast<float>(height);
        coarse.rgba.resize(coarse.padded_count() * 4, to_biased(0));
        reduce(levels.back(), coarse);
        levels.push_back(std::move(coarse));
    }
    for (PyramidLevel& level : levels) measure_roughness(level);
    return share.resize(bytes, "the decal's picture");
}

Float4 sample_bilinear(const PyramidLevel& level, float x, float y, bool repeat) {
    const float left = std::floor(x - 0.5f);
    const float top = std::floor(y - 0.5f);
    const auto w = static_cast<std::int32_t>(level.width);
    const auto h = static_cast<std::int32_t>(level.height);
    const auto column = static_cast<std::int32_t>(left);
    const auto row = static_cast<std::int32_t>(top);
    const auto pixel = [&](std::int32_t px, std::int32_t py) {
        if (!repeat && (px < 0 || py < 0 || px >= w || py >= h)) return splat(0.0f);
        return __builtin_convertvector(
            level.color_at(static_cast<std::uint32_t>(wrap(px, w)), static_cast<std::uint32_t>(wrap(py, h))), Float4);
    };
    const Float4 fx = splat(x - 0.5f - left);
    const Float4 fy = splat(y - 0.5f - top);
    const Float4 upper_left = pixel(column, row);
    const Float4 lower_left = pixel(column, row + 1);
    const Float4 above = upper_left + (pixel(column + 1, row) - upper_left) * fx;
    const Float4 below = lower_left + (pixel(column + 1, row + 1) - lower_left) * fx;
    return above + (below - above) * fy;
}

}  // namespace txc
