// What a session may hold at once. Sizes are counted before anything is allocated, so that passing the budget is a
// typed error and never an abort of the module.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "status.h"

namespace txc {

class MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t limit_bytes) : limit_(limit_bytes) {}

    std::uint64_t used() const { return used_; }
    std::uint64_t peak() const { return peak_; }
    std::uint64_t limit() const { return limit_; }
    bool fits(std::uint64_t bytes) const { return bytes <= limit_ && used_ <= limit_ - bytes; }

    /// `give_back` is called when room is short, before a request is refused: it gives up what can be made again.
    void on_shortage(std::function<void()> give_back) { give_back_ = std::move(give_back); }

private:
    friend class BudgetShare;
    bool makes_room(std::uint64_t bytes) {
        if (!fits(bytes) && give_back_) give_back_();
        return fits(bytes);
    }

    std::function<void()> give_back_;
    std::uint64_t limit_;
    std::uint64_t used_ = 0;
    std::uint64_t peak_ = 0;
};

/// One owner's part of a budget; given back when the owner goes.
class BudgetShare {
public:
    BudgetShare() = default;
    explicit BudgetShare(MemoryBudget& budget) : budget_(&budget) {}
    BudgetShare(const BudgetShare&) = delete;
    BudgetShare& operator=(const BudgetShare&) = delete;
    BudgetShare(BudgetShare&& other) noexcept : budget_(other.budget_), bytes_(other.bytes_) { other.bytes_ = 0; }
    BudgetShare& operator=(BudgetShare&& other) noexcept {
        if (this != &other) {
            release();
            budget_ = other.budget_;
            bytes_ = other.bytes_;
            other.bytes_ = 0;
        }
        return *this;
    }
    ~BudgetShare() { release(); }

    std::uint64_t bytes() const { return bytes_; }

    /// Makes the share `bytes` large. On OUT_OF_BUDGET the share is as it was; `what` names the work for the message.
    TxcStatus resize(std::uint64_t bytes, const char* what) {
        if (bytes > bytes_ && !budget_->makes_room(bytes - bytes_)) {
            return fail(TXC_STATUS_OUT_OF_BUDGET,
                        "%s needs %llu MiB, but only %llu of the budget's %llu MiB are left: choose a smaller size or "
                        "raise the memory budget",
                        what, mib(bytes), mib(budget_->limit_ - (budget_->used_ - bytes_)), mib(budget_->limit_));
        }
        budget_->used_ = budget_->used_ - bytes_ + bytes;
        bytes_ = bytes;
        if (budget_->used_ > budget_->peak_) budget_->peak_ = budget_->used_;
        return TXC_STATUS_OK;
    }

    /// Makes the share larger where at least half of the budget then stays free: for what can be made anew. False where
    /// it would not; the share is then as it was.
    bool resize_within_half(std::uint64_t bytes) {
        const std::uint64_t used = budget_->used_ - bytes_ + bytes;
        if (used > budget_->limit_ / 2) return false;
        budget_->used_ = used;
        bytes_ = bytes;
        if (used > budget_->peak_) budget_->peak_ = used;
        return true;
    }

    void release() {
        if (budget_ != nullptr) budget_->used_ -= bytes_;
        bytes_ = 0;
    }

private:
    static unsigned long long mib(std::uint64_t bytes) { return (bytes + (1u << 20) - 1) >> 20; }

    MemoryBudget* budget_ = nullptr;
    std::uint64_t bytes_ = 0;
};

/// Makes room for `capacity` elements, which is more than there is, counting it with `share` first. OUT_OF_BUDGET.
template <typename T>
TxcStatus reserve_counted(std::vector<T>& elements, std::size_t capacity, BudgetShare& share, const char* what) {
    const std::uint64_t added = std::uint64_t{capacity - elements.capacity()} * sizeof(T);
    if (const TxcStatus status = share.resize(share.bytes() + added, what); status != TXC_STATUS_OK) return status;
    elements.reserve(capacity);
    return TXC_STATUS_OK;
}

/// Makes room for `needed` elements, where there is none, and for half as many more as there were. Other than above, the old
/// array is counted too while it is copied into the new one. OUT_OF_BUDGET.
template <typename Elements>
TxcStatus grow_counted(Elements& elements, std::size_t needed, BudgetShare& share, const char* what) {
    if (needed <= elements.capacity()) return TXC_STATUS_OK;
    const std::size_t capacity = std::max(needed, elements.capacity() + elements.capacity() / 2);
    constexpr std::size_t kSize = sizeof(typename Elements::value_type);
    const std::uint64_t old_bytes = std::uint64_t{elements.capacity()} * kSize;
    const std::uint64_t both = share.bytes() + std::uint64_t{capacity} * kSize;
    if (const TxcStatus status = share.resize(both, what); status != TXC_STATUS_OK) return status;
    elements.reserve(capacity);
    return share.resize(both - old_bytes, what);
}

}  // namespace txc
