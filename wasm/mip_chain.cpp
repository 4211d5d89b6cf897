#include "mip_chain.h"

#include <algorithm>
#include <array>
#include <utility>

#include "exact_math.h"

namespace txc {
namespace {

constexpr std::uint32_t kLinearSteps = 8192;  // finer than an 8-bit sRGB step even where the curve is steepest

struct TransferTables {
    std::array<std::uint32_t, 256> to_linear{};  // 0 to kLinearSteps - 1
    std::array<std::uint8_t, kLinearSteps> to_srgb{};

    TransferTables() {
        for (std::uint32_t i = 0; i < 256; ++i) {
            to_linear[i] = static_cast<std::uint32_t>(srgb_to_linear(i / 255.0) * (kLinearSteps - 1) + 0.5);
        }
        for (std::uint32_t i = 0; i < kLinearSteps; ++i)
            to_srgb[i] = to_byte(linear_to_srgb(static_cast<double>(i) / (kLinearSteps - 1)));
        // Rounding must not tint a flat area: each byte's own linear step leads back to it.
        for (std::uint32_t i = 0; i < 256; ++i) to_srgb[to_linear[i]] = static_cast<std::uint8_t>(i);
    }
};

const TransferTables& transfer_tables() {
    static const TransferTables tables;
    return tables;
}

constexpr std::uint32_t kAllFour = 15;

/// Which of the four texels under a coarser one hold some of a chart, as bits in the order of their reading; all four
/// where no charts are known. A level one texel wide stands in for the second of each pair.
class ChartedFours {
public:
    ChartedFours(const CoverageBits* covered, const MipLevel& fine, std::uint32_t above, std::uint32_t below)
        : above_(covered ? covered->row(above) : nullptr),
          below_(covered ? covered->row(below) : nullptr),
          is_narrow_(fine.width == 1) {}

    std::uint32_t at(std::uint32_t x) const {
        return above_ == nullptr ? kAllFour : pair(above_, x) | pair(below_, x) << 2;
    }

private:
    std::uint32_t pair(const std::uint64_t* row, std::uint32_t x) const {
        const auto bits = static_cast<std::uint32_t>(row[x / 32] >> (2 * x % 64) & 3);
        return is_narrow_ ? bits * 3 : bits;
    }

    const std::uint64_t* above_;
    const std::uint64_t* below_;
    bool is_narrow_;
};

/// The mean in linear light, weighted by alpha.
inline void mean_of(const TransferTables& tables, const std::uint8_t* const* texels, std::uint32_t count,
                    std::uint8_t* out) {
    std::uint32_t alpha = 0;
    for (std::uint32_t t = 0; t < count; ++t) alpha += texels[t][3];
    for (int c = 0; c < 3; ++c) {
        std::uint32_t sum = 0;
        if (alpha == 0 || alpha == count * 255) {
            for (std::uint32_t t = 0; t < count; ++t) sum += tables.to_linear[texels[t][c]];
            sum = (sum + count / 2) / count;
        } else {
            for (std::uint32_t t = 0; t < count; ++t) sum += tables.to_linear[texels[t][c]] * texels[t][3];
            sum = (sum + alpha / 2) / alpha;
        }
        out[c] = tables.to_srgb[sum];
    }
    out[3] = static_cast<std::uint8_t>((alpha + count / 2) / count);
}

}  // namespace

std::uint32_t MipChain::full_count(std::uint32_t width, std::uint32_t height) {
    std::uint32_t count = 1;
    for (std::uint32_t size = std::max(width, height); size > 1; size /= 2) ++count;
    return count;
}

std::uint64_t MipChain::byte_count(std::uint32_t width, std::uint32_t height, std::uint32_t level_count) {
    std::uint64_t bytes = 0;
    for (std::uint32_t level = 0; level < level_count; ++level) {
        bytes += static_cast<std::uint64_t>(std::max(1u, width >> level)) * std::max(1u, height >> level) * 4;
    }
    return bytes;
}

void MipChain::allocate(std::uint32_t width, std::uint32_t height, std::uint32_t level_count) {
    levels.clear();
    for (std::uint32_t level = 0; level < level_count; ++level) {
        MipLevel mip{std::max(1u, width >> level), std::max(1u, height >> level), {}};
        mip.rgba.resize(static_cast<std::size_t>(mip.width) * mip.height * 4);
        levels.push_back(std::move(mip));
    }
}

std::uint64_t MipChain::coverage_byte_count(std::uint32_t width, std::uint32_t height, std::uint32_t level_count) {
    std::uint64_t bytes = 0;
    for (std::uint32_t level = 0; level + 1 < level_count; ++level)
        bytes += CoverageBits::byte_count(std::max(1u, width >> level), std::max(1u, height >> level));
    return bytes;
}

void MipChain::note_charts(CoverageBits charts) {
    covered.clear();
    covered.push_back(std::move(charts));
    for (std::uint32_t level = 1; level + 1 < levels.size(); ++level) {
        const MipLevel& fine = levels[level - 1];
        const MipLevel& mip = levels[level];
        CoverageBits bits(mip.width, mip.height);
        for (std::uint32_t y = 0; y < mip.height; ++y) {
            const ChartedFours fours(&covered.back(), fine, 2 * y, std::min(2 * y + 1, fine.height - 1));
            for (std::uint32_t x = 0; x < mip.width; ++x) {
                if (fours.at(x) != 0) bits.claim(x, y);
            }
        }
        covered.push_back(std::move(bits));
    }
}

void MipChain::reduce(std::uint32_t level, std::uint32_t x0, std::uint32_t y0, std::uint32_t x1, std::uint32_t y1) {
    const TransferTables& tables = transfer_tables();
    const MipLevel& fine = levels[level - 1];
    MipLevel& coarse = levels[level];
    const CoverageBits* charted = covered.empty() ? nullptr : &covered[level - 1];
    for (std::uint32_t y = y0; y < y1; ++y) {
        const std::uint32_t below = std::min(2 * y + 1, fine.height - 1);
        const std::uint8_t* rows[2] = {fine.rgba.data() + static_cast<std::size_t>(2 * y) * fine.width * 4,
                                       fine.rgba.data() + static_cast<std::size_t>(below) * fine.width * 4};
        const ChartedFours fours(charted, fine, 2 * y, below);
        std::uint8_t* out = coarse.rgba.data() + (static_cast<std::size_t>(y) * coarse.width + x0) * 4;
        for (std::uint32_t x = x0; x < x1; ++x, out += 4) {
            const std::size_t left = static_cast<std::size_t>(2 * x) * 4;
            const std::size_t right = static_cast<std::size_t>(std::min(2 * x + 1, fine.width - 1)) * 4;
            const std::uint8_t* texels[4] = {rows[0] + left, rows[0] + right, rows[1] + left, rows[1] + right};
            const std::uint32_t four = fours.at(x);
            if (four == kAllFour || four == 0) {
                mean_of(tables, texels, 4, out);
                continue;
            }
            std::uint32_t count = 0;
            for (std::uint32_t t = 0; t < 4; ++t) {
                if ((four >> t & 1) != 0) texels[count++] = texels[t];
            }
            mean_of(tables, texels, count, out);
        }
    }
}

}  // namespace txc
