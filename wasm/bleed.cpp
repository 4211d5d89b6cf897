#include "bleed.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "coverage_bits.h"
#include "sorted_keys.h"
#include "target.h"

namespace txc {
namespace {

class Bleeder {
public:
    explicit Bleeder(Target& target)
        : target_(target),
          width_(target.def.width),
          height_(target.def.height),
          texture_(target.output.levels[0].rgba.data()),
          filled_(width_, height_),
          touched_(width_, height_),
          ring_(width_, height_) {}

    static std::uint64_t byte_count(const Target& target) {
        return 3 * CoverageBits::byte_count(target.def.width, target.def.height);
    }

    /// Colours the texture itself, and lists what was there before.
    TxcStatus bleed(std::uint32_t reach) {
        mark_charts();
        for (std::uint32_t step = 0; step < reach; ++step) {
            bool any = false;
            for (std::uint32_t y = 0; y < height_; ++y) any = find_ring(y) || any;
            if (!any) break;
            for (std::uint32_t y = 0; y < height_; ++y) {
                if (const TxcStatus status = fill_ring(y); status != TXC_STATUS_OK) return status;
            }
        }
        return TXC_STATUS_OK;
    }

    /// Puts the texture back; the list then holds the new colours.
    void swap_colors() {
        for (std::uint64_t& packed : target_.bleed.texels) {
            BledTexel bled = BledTexel::of(packed);
            std::uint8_t* texel = texture_ + std::size_t{bled.index} * 4;
            std::uint32_t shown;
            std::memcpy(&shown, texel, 4);
            std::memcpy(texel, &bled.rgba, 4);
            bled.rgba = shown;
            packed = bled.packed();
        }
    }

private:
    void mark_charts() {
        const LocalSpaceMap& map = *target_.map;
        map.for_each_run(0, height_, [&](const TexelRun& run, std::uint32_t tile_x, std::uint32_t y) {
            for (std::uint32_t x = tile_x + run.x; x < tile_x + run.x + run.length; ++x) {
                filled_.claim(x, y);
                if (std::memcmp(texel(x, y), base(x, y), 4) != 0) touched_.claim(x, y);
            }
        });
    }

    /// Marks the row's empty texels that have a filled neighbour, diagonal ones too.
    bool find_ring(std::uint32_t y) {
        const std::uint32_t words = filled_.words();
        std::uint64_t* ring = ring_.row(y);
        std::uint64_t any = 0;
        for (std::uint32_t w = 0; w < words; ++w) {
            std::uint64_t near = 0;
            for (std::uint32_t row = y > 0 ? y - 1 : 0; row <= std::min(y + 1, height_ - 1); ++row) {
                const std::uint64_t* bits = filled_.row(row);
                near |= bits[w] | bits[w] << 1 | bits[w] >> 1;
                if (w > 0) near |= bits[w - 1] >> 63;
                if (w + 1 < words) near |= bits[w + 1] << 63;
            }
            ring[w] = near & ~filled_.row(y)[w];
            if (w + 1 == words && width_ % 64 != 0) ring[w] &= ~std::uint64_t{0} >> (64 - width_ % 64);
            any |= ring[w];
        }
        return any != 0;
    }

    TxcStatus fill_ring(std::uint32_t y) {
        for (std::uint32_t w = 0; w < ring_.words(); ++w) {
            for (std::uint64_t bits = ring_.row(y)[w]; bits != 0; bits &= bits - 1) {
                const std::uint32_t x = w * 64 + static_cast<std::uint32_t>(std::countr_zero(bits));
                if (const TxcStatus status = fill(x, y); status != TXC_STATUS_OK) return status;
                filled_.claim(x, y);
            }
        }
        return TXC_STATUS_OK;
    }

    /// Neighbours of the same ring do not count, so that the order of the texels makes no difference.
    TxcStatus fill(std::uint32_t x, std::uint32_t y) {
        std::uint32_t sum[4] = {0, 0, 0, 0};
        std::uint32_t weighted[3] = {0, 0, 0};
        std::uint32_t count = 0;
        bool touched = false;
        for (std::uint32_t ny = y > 0 ? y - 1 : 0; ny <= std::min(y + 1, height_ - 1); ++ny) {
            for (std::uint32_t nx = x > 0 ? x - 1 : 0; nx <= std::min(x + 1, width_ - 1); ++nx) {
                if (!filled_.is_claimed(nx, ny) || ring_.is_claimed(nx, ny)) continue;
                const std::uint8_t* neighbour = texel(nx, ny);
                for (int c = 0; c < 4; ++c) sum[c] += neighbour[c];
                for (int c = 0; c < 3; ++c) weighted[c] += std::uint32_t{neighbour[c]} * neighbour[3];
                touched = touched || touched_.is_claimed(nx, ny);
                ++count;
            }
        }
        if (!touched) return TXC_STATUS_OK;
        touched_.claim(x, y);
        std::uint8_t* to = texel(x, y);
        if (const TxcStatus status = list(y * width_ + x, to); status != TXC_STATUS_OK) return status;
        for (int c = 0; c < 3; ++c) {
            // Weighted by alpha, so that colour under transparent texels does not mix in where there is any other.
            const std::uint32_t weight = sum[3] > 0 ? sum[3] : count;
            const std::uint32_t total = sum[3] > 0 ? weighted[c] : sum[c];
            to[c] = static_cast<std::uint8_t>((total + weight / 2) / weight);
        }
        to[3] = static_cast<std::uint8_t>((sum[3] + count / 2) / count);
        return TXC_STATUS_OK;
    }

    TxcStatus list(std::uint32_t index, const std::uint8_t* before) {
        Bleed& bleed = target_.bleed;
        if (bleed.texels.size() == bleed.texels.capacity()) {
            const std::size_t larger = bleed.texels.size() + bleed.texels.size() / 2 + 1024;
            const TxcStatus status =
                reserve_counted(bleed.texels, larger, bleed.share, "bleeding the exported texture");
            if (status != TXC_STATUS_OK) return status;
        }
        BledTexel bled{index, 0};
        std::memcpy(&bled.rgba, before, 4);
        bleed.texels.push_back(bled.packed());
        return TXC_STATUS_OK;
    }

    std::uint8_t* texel(std::uint32_t x, std::uint32_t y) { return texture_ + (std::size_t{y} * width_ + x) * 4; }
    const std::uint8_t* base(std::uint32_t x, std::uint32_t y) const {
        const BasePicture& base = target_.base;
        return base.rgba.empty() ? base.color : base.rgba.data() + (std::size_t{y} * width_ + x) * 4;
    }

    Target& target_;
    std::uint32_t width_;
    std::uint32_t height_;
    std::uint8_t* texture_;
    CoverageBits filled_;   // charts, gutter included, and the rings so far
    CoverageBits touched_;  // of those: changed by a layer, or filled from one that was
    CoverageBits ring_;     // the texels to be filled next
};

}  // namespace

std::uint32_t bleed_reach(std::uint32_t width, std::uint32_t height) {
    return std::max(16u, std::max(width, height) / 64);
}

void Bleed::forget() {
    texels = std::vector<std::uint64_t>();
    is_known = false;
    share.release();
}

TxcStatus find_bleed(Target& target, MemoryBudget& budget) {
    if (target.bleed.is_known) return TXC_STATUS_OK;
    BudgetShare scratch(budget);
    if (const TxcStatus status = scratch.resize(Bleeder::byte_count(target), "bleeding the exported texture");
        status != TXC_STATUS_OK)
        return status;
    Bleeder bleeder(target);
    const TxcStatus status = bleeder.bleed(bleed_reach(target.def.texture_width, target.def.texture_height));
    bleeder.swap_colors();
    if (status != TXC_STATUS_OK) {
        target.bleed.forget();
        return status;
    }
    sort_keys(target.bleed.texels);
    target.bleed.is_known = true;
    return TXC_STATUS_OK;
}

void read_bled_rows(const Target& target, std::uint32_t row, std::uint32_t row_count, std::uint8_t* out) {
    const std::uint32_t first = row * target.def.width;
    const std::uint32_t last = first + row_count * target.def.width;
    std::memcpy(out, target.output.levels[0].rgba.data() + std::size_t{first} * 4, std::size_t{last - first} * 4);
    const std::vector<std::uint64_t>& texels = target.bleed.texels;
    auto packed = std::lower_bound(texels.begin(), texels.end(), BledTexel{first, 0}.packed());
    for (; packed != texels.end(); ++packed) {
        const BledTexel bled = BledTexel::of(*packed);
        if (bled.index >= last) break;
        std::memcpy(out + std::size_t{bled.index - first} * 4, &bled.rgba, 4);
    }
}

}  // namespace txc
