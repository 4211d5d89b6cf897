// Objects by ids that are given out once.
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

TEST_CASE("An id does not find an object that came after its own") {
    Table table;
    const std::uint32_t old = table.add(std::make_unique<int>(1));
    table.remove(old);
    const std::uint32_t next = table.add(std::make_unique<int>(2));
    CHECK(next != old);
    CHECK(table.find(old) == nullptr);
    table.remove(old);  // must not remove the newcomer
    CHECK(*table.find(next) == 2);
}

TEST_CASE("No two objects ever have the same id, whatever their table") {
    Table tables[2];
    std::set<std::uint32_t> seen;
    for (int i = 0; i < 5000; ++i) {
        const std::uint32_t id = tables[i % 2].add(std::make_unique<int>(i));
        CHECK_UNARY(seen.insert(id).second);
        CHECK_UNARY(tables[1 - i % 2].find(id) == nullptr);
        tables[i % 2].remove(id);
    }
    CHECK(seen.count(0) == 0);
}

TEST_CASE("Null and made-up ids find nothing") {
    Table table;
    CHECK(table.find(0) == nullptr);
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
