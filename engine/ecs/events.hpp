#pragma once

#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "reflect/type_key.hpp"

namespace plumb {

/// The events of this tick, one list per event type. Not part of
/// snapshots: systems read events in the tick in which they are emitted.
class Events {
public:
    template <class E>
    void emit(E event) {
        listOf<E>().events.push_back(std::move(event));
    }
    /// The events of a type in the order of emission. Valid until the next event of this type is emitted.
    template <class E>
    [[nodiscard]] std::span<const E> of() const {
        const TypeKey key = typeKey<E>();
        if (key >= lists_.size() || lists_[key] == nullptr) return {};
        return static_cast<const ListOf<E>&>(*lists_[key]).events;
    }
    /// Removes the lists of types for which isReloadable() holds.
    void dropReloadable() {
        for (TypeKey key = 0; key < lists_.size(); ++key) {
            if (isReloadable(key)) lists_[key].reset();
        }
    }
    void clear() {
        for (const std::unique_ptr<List>& list : lists_) {
            if (list != nullptr) list->clear();
        }
    }

private:
    struct List {
        virtual ~List() = default;
        virtual void clear() = 0;
    };
    template <class E>
    struct ListOf final : List {
        std::vector<E> events;
        void clear() override { events.clear(); }
    };

    template <class E>
    ListOf<E>& listOf() {
        const TypeKey key = typeKey<E>();
        if (key >= lists_.size()) lists_.resize(key + 1);
        if (lists_[key] == nullptr) lists_[key] = std::make_unique<ListOf<E>>();
        return static_cast<ListOf<E>&>(*lists_[key]);
    }

    std::vector<std::unique_ptr<List>> lists_;  // indexed by TypeKey
};

}  // namespace plumb
