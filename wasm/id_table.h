// Objects by id. An id is given out once in the module's life, whatever the table: one that outlived its object, or that
// belongs to another session, finds nothing. 0 is null.
//
// (Slots with a generation, the usual way, would let an id of one session name an object of another.)
#pragma once

#include <cstdint>
#include <map>
#include <memory>

namespace txc {

/// The next unused id; 0 after four thousand million of them.
std::uint32_t next_object_id();

template <typename Object>
class IdTable {
public:
    /// Takes ownership; 0 when no id is left.
    std::uint32_t add(std::unique_ptr<Object> object) {
        const std::uint32_t id = next_object_id();
        if (id != 0) objects_[id] = std::move(object);
        return id;
    }

    /// Null for ids that are null, stale, another table's or made up.
    Object* find(std::uint32_t id) const {
        const auto found = objects_.find(id);
        return found != objects_.end() ? found->second.get() : nullptr;
    }

    void remove(std::uint32_t id) { objects_.erase(id); }
    void clear() { objects_.clear(); }

    template <typename Visit>
    void for_each(Visit&& visit) const {
        for (const auto& [id, object] : objects_) visit(id, *object);
    }

private:
    std::map<std::uint32_t, std::unique_ptr<Object>> objects_;  // ordered, so that visits repeat
};

}  // namespace txc
