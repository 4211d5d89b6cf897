// What a session may hold: shares of one budget.
#include "memory_budget.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <string>
#include <vector>

using txc::BudgetShare;
using txc::MemoryBudget;

TEST_CASE("Shares add up and are given back") {
    MemoryBudget budget(1000);
    {
        BudgetShare a(budget);
        BudgetShare b(budget);
        CHECK(a.resize(600, "a") == TXC_STATUS_OK);
        CHECK(b.resize(400, "b") == TXC_STATUS_OK);
        CHECK(budget.used() == 1000);
        CHECK(a.resize(100, "a") == TXC_STATUS_OK);
        CHECK(budget.used() == 500);
    }
    CHECK(budget.used() == 0);
    CHECK(budget.peak() == 1000);
}

TEST_CASE("A share that does not fit stays as it was and says what it was for") {
    MemoryBudget budget(64u << 20);
    BudgetShare share(budget);
    CHECK(share.resize(40u << 20, "one thing") == TXC_STATUS_OK);
    CHECK(share.resize(65u << 20, "the other thing") == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(share.bytes() == 40u << 20);
    CHECK(budget.used() == 40u << 20);
    const std::string detail = txc::error_detail();
    CHECK(detail.find("the other thing needs 65 MiB") != std::string::npos);
    // What it has already is no other's.
    CHECK(detail.find("only 64 of the budget's 64 MiB are left") != std::string::npos);
    BudgetShare other(budget);
    CHECK(other.resize(25u << 20, "another") == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(std::string(txc::error_detail()).find("only 24 of the budget's 64 MiB are left") != std::string::npos);
}

TEST_CASE("One share may have all of the budget") {
    MemoryBudget budget(1000);
    BudgetShare share(budget);
    CHECK(share.resize(1000, "all") == TXC_STATUS_OK);
    CHECK(share.resize(1001, "more") == TXC_STATUS_OUT_OF_BUDGET);
}

TEST_CASE("Sizes near 2^64 do not wrap round into fitting") {
    MemoryBudget budget(1000);
    BudgetShare share(budget);
    CHECK(share.resize(10, "a little") == TXC_STATUS_OK);
    CHECK_FALSE(budget.fits(~std::uint64_t{0}));
    CHECK_FALSE(budget.fits(~std::uint64_t{0} - 9));
    CHECK(share.resize(~std::uint64_t{0}, "everything") == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(share.bytes() == 10);
}

TEST_CASE("A moved share counts once") {
    MemoryBudget budget(1000);
    {
        BudgetShare a(budget);
        CHECK(a.resize(300, "a") == TXC_STATUS_OK);
        BudgetShare b(std::move(a));
        CHECK(budget.used() == 300);
        BudgetShare c(budget);
        CHECK(c.resize(200, "c") == TXC_STATUS_OK);
        c = std::move(b);
        CHECK(budget.used() == 300);
        c.release();
        CHECK(budget.used() == 0);
    }
    CHECK(budget.used() == 0);
}

TEST_CASE("What can be made anew has room as long as half of the budget stays free, whoever holds the rest") {
    MemoryBudget budget(1000);
    BudgetShare model(budget);
    BudgetShare derived(budget);
    CHECK(model.resize(300, "model") == TXC_STATUS_OK);
    CHECK(derived.resize_within_half(150));
    CHECK(derived.resize_within_half(200));
    CHECK(budget.used() == 500);
    CHECK(budget.peak() == 500);
    CHECK_FALSE(derived.resize_within_half(201));
    CHECK(derived.bytes() == 200);
    CHECK(budget.used() == 500);
    derived.release();
    CHECK(budget.used() == 300);
}

TEST_CASE("A list that grows is counted with the old one beside the new while it is copied, then alone") {
    MemoryBudget budget(160);
    BudgetShare share(budget);
    std::vector<std::uint32_t> list;
    CHECK(txc::grow_counted(list, 10, share, "a list") == TXC_STATUS_OK);
    CHECK(list.capacity() == 10);
    CHECK(share.bytes() == 40);
    CHECK(txc::grow_counted(list, 10, share, "a list") == TXC_STATUS_OK);
    CHECK(list.capacity() == 10);
    // Half as many more as there were, where that is enough.
    CHECK(txc::grow_counted(list, 11, share, "a list") == TXC_STATUS_OK);
    CHECK(list.capacity() == 15);
    CHECK(share.bytes() == 60);
    CHECK(budget.peak() == 100);
    CHECK(txc::grow_counted(list, 26, share, "a list") == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(list.capacity() == 15);
    CHECK(share.bytes() == 60);
    CHECK(txc::reserve_counted(list, 40, share, "a list") == TXC_STATUS_OK);
    CHECK(list.capacity() == 40);
    CHECK(share.bytes() == 160);
    CHECK(txc::reserve_counted(list, 41, share, "a list") == TXC_STATUS_OUT_OF_BUDGET);
    CHECK(list.capacity() == 40);
}
