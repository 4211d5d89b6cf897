#include "backdrop_cache.h"

namespace txc {
namespace {

// Of the budget, in parts: a drag that sweeps over more than that begins anew.
constexpr std::uint64_t kLargestShare = 4;

}  // namespace

bool BackdropCache::has_room(std::size_t states) const {
    const std::uint64_t bytes = states * kTileTexels * sizeof(Float4);
    return share_.bytes() + bytes <= budget_->limit() / kLargestShare && budget_->fits(bytes);
}

Float4* BackdropCache::make(std::uint32_t tile, std::uint32_t tile_count, std::size_t states) {
    const std::uint64_t bytes = states * kTileTexels * sizeof(Float4);
    const std::uint64_t list_bytes = std::uint64_t{tile_count} * sizeof(tiles_[0]);
    if (share_.bytes() + bytes > budget_->limit() / kLargestShare) empty();
    const std::uint64_t added = bytes + (tiles_.empty() ? list_bytes : 0);
    // Asked for only where it fits: a shortage must not make the session give up the very room that is being filled.
    if (!budget_->fits(added) || share_.resize(share_.bytes() + added, "backdrops") != TXC_STATUS_OK) return nullptr;
    tiles_.resize(tile_count);
    tiles_[tile] = std::make_unique<Float4[]>(states * kTileTexels);
    return tiles_[tile].get();
}

void BackdropCache::empty() {
    tiles_ = decltype(tiles_)();
    share_.release();
}

void BackdropCache::forget() {
    empty();
    split_ = candidate_ = 0;
    steady_updates_ = 0;
}

}  // namespace txc
