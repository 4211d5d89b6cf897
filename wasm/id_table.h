// Objects by id: 20 bits of slot, 12 bits of generation, so that an id outlives its object harmlessly. 0 is null.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace txc {

template <typename Object>
class IdTable {
public:
    static constexpr std::uint32_t kSlotBits = 20;
    static constexpr std::uint32_t kSlotMask = (1u << kSlotBits) - 1;

    /// Takes ownership; 0 when all slots are in use.
    std::uint32_t add(std::unique_ptr<Object> object) {
        std::uint32_t slot;
        if (!free_.empty()) {
            slot = free_.back();
            free_.pop_back();
        } else {
            if (entries_.size() > kSlotMask) return 0;
            slot = static_cast<std::uint32_t>(entries_.size());
            entries_.emplace_back();
        }
        entries_[slot].object = std::move(object);
        return (entries_[slot].generation << kSlotBits) | slot;
    }

    /// Null for ids that are null, stale or made up.
    Object* find(std::uint32_t id) const {
        const std::uint32_t slot = id & kSlotMask;
        if (slot >= entries_.size()) return nullptr;
        const Entry& entry = entries_[slot];
        return entry.generation == (id >> kSlotBits) ? entry.object.get() : nullptr;
    }

    void remove(std::uint32_t id) {
        if (find(id) == nullptr) return;
        Entry& entry = entries_[id & kSlotMask];
        entry.object.reset();
        entry.generation = entry.generation == 0xfffu ? 1u : entry.generation + 1u;
        free_.push_back(id & kSlotMask);
    }

    void clear() {
        for_each([this](std::uint32_t id, Object&) { remove(id); });
    }

    template <typename Visit>
    void for_each(Visit&& visit) const {
        for (std::uint32_t slot = 0; slot < entries_.size(); ++slot) {
            const Entry& entry = entries_[slot];
            if (entry.object != nullptr) visit((entry.generation << kSlotBits) | slot, *entry.object);
        }
    }

private:
    struct Entry {
        std::unique_ptr<Object> object;
        std::uint32_t generation = 1;  // never 0, so no valid id is 0
    };
    std::vector<Entry> entries_;
    std::vector<std::uint32_t> free_;
};

}  // namespace txc
