// Objects by id with a generation.
#include "id_table.h"

#include <doctest/doctest.h>

#include <set>

namespace {
using Table = txc::IdTable<int>;
}

TEST_CASE("An id finds its own object until that is removed") {
    Table table;
    const std::uint32_t first = table.add(std::make_unique<int>(1));
    const std::uint32_t second = table.add(std::make_unique<int>(2));
    CHECK(first != 0);
    CHECK(second != first);
    CHECK(*table.find(first) == 1);
    CHECK(*table.find(second) == 2);
    table.remove(first);
    CHECK(table.find(first) == nullptr);
    CHECK(*table.find(second) == 2);
}

TEST_CASE("An id does not find the object that took its place") {
    Table table;
    const std::uint32_t old = table.add(std::make_unique<int>(1));
    table.remove(old);
    const std::uint32_t next = table.add(std::make_unique<int>(2));
    CHECK(next != old);
    CHECK(table.find(old) == nullptr);
    table.remove(old);  // must not remove the newcomer
    CHECK(*table.find(next) == 2);
}

TEST_CASE("A place gives 4095 different ids before one comes again, and never null") {
    Table table;
    std::set<std::uint32_t> seen;
    for (int i = 0; i < 4095; ++i) {
        const std::uint32_t id = table.add(std::make_unique<int>(i));
        CHECK_UNARY(id != 0);
        seen.insert(id);
        table.remove(id);
    }
    CHECK(seen.size() == 4095);
    CHECK(table.find(0) == nullptr);
}

TEST_CASE("Null and made-up ids find nothing") {
    Table table;
    CHECK(table.find(0) == nullptr);
    CHECK(table.find(1) == nullptr);
    CHECK(table.find(0xffffffffu) == nullptr);
    table.add(std::make_unique<int>(1));
    CHECK(table.find(0) == nullptr);
    CHECK(table.find(0xffffffffu) == nullptr);
}

TEST_CASE("Clearing makes all ids stale") {
    Table table;
    const std::uint32_t first = table.add(std::make_unique<int>(1));
    const std::uint32_t second = table.add(std::make_unique<int>(2));
    table.clear();
    CHECK(table.find(first) == nullptr);
    CHECK(table.find(second) == nullptr);
    int visited = 0;
    table.for_each([&](std::uint32_t, int&) { ++visited; });
    CHECK(visited == 0);
}
