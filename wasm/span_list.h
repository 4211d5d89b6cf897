// The spans that the raster claims, in the order of the triangles: kept in blocks, so that a long list never moves and
// each block is counted against the budget before it is there.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "memory_budget.h"

namespace txc {

/// Neighbouring texels of one row of the target that one frame owns.
struct Span {
    std::uint32_t frame;
    std::uint16_t x;
    std::uint16_t y;
    std::uint16_t length;
};

class SpanList {
public:
    explicit SpanList(BudgetShare& share) : share_(share) {}

    std::uint64_t size() const { return blocks_.size() * kBlock - static_cast<std::uint64_t>(end_ - next_); }

    TxcStatus add(std::uint32_t frame, std::uint32_t x, std::uint32_t y, std::uint32_t length) {
        if (next_ == end_) {
            if (const TxcStatus status = add_block(); status != TXC_STATUS_OK) return status;
        }
        // Field by field: a whole span put together on the stack first, then copied, costs three times as much.
        next_->frame = frame;
        next_->x = static_cast<std::uint16_t>(x);
        next_->y = static_cast<std::uint16_t>(y);
        next_->length = static_cast<std::uint16_t>(length);
        ++next_;
        return TXC_STATUS_OK;
    }

    /// Calls visit(span) for up to `count` spans from `first` on; returns the place after the last.
    template <typename Visit>
    std::uint64_t visit(std::uint64_t first, std::uint64_t count, Visit&& visit) const {
        const std::uint64_t last = count < size() - first ? first + count : size();
        while (first < last) {
            const Span* spans = blocks_[static_cast<std::size_t>(first / kBlock)].get();
            const std::uint64_t left = kBlock - first % kBlock;
            const std::uint64_t here = left < last - first ? left : last - first;
            for (std::uint64_t i = 0; i < here; ++i) visit(spans[first % kBlock + i]);
            first += here;
        }
        return last;
    }

    void clear() {
        share_.resize(share_.bytes() - blocks_.size() * kBlock * sizeof(Span), "baking the map");
        blocks_ = decltype(blocks_)();
        next_ = end_ = nullptr;
    }

private:
    static constexpr std::uint64_t kBlock = 16384;

    __attribute__((noinline)) TxcStatus add_block() {
        if (const TxcStatus status = share_.resize(share_.bytes() + kBlock * sizeof(Span), "baking the map");
            status != TXC_STATUS_OK)
            return status;
        blocks_.emplace_back(new Span[kBlock]);
        next_ = blocks_.back().get();
        end_ = next_ + kBlock;
        return TXC_STATUS_OK;
    }

    BudgetShare& share_;
    std::vector<std::unique_ptr<Span[]>> blocks_;
    Span* next_ = nullptr;
    Span* end_ = nullptr;
};

}  // namespace txc
