#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
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
        listOf<E>().add(std::move(event));
    }
    /// The events of a type in the order of emission: those emitted so far, also if more are emitted while a
    /// loop reads them. Valid until clear(), also after retire().
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
    /// Removes all events, but keeps their memory until clear(), because a loop may be reading them.
    void retire() {
        for (const std::unique_ptr<List>& list : lists_) {
            if (list != nullptr) list->retire();
        }
    }

private:
    struct List {
        virtual ~List() = default;
        virtual void clear() = 0;
        virtual void retire() = 0;
    };
    template <class E>
    struct ListOf final : List {
        static_assert(std::is_copy_constructible_v<E>, "an event is copied when its list grows");

        std::vector<E> events;
        std::vector<std::vector<E>> outgrown;  ///< smaller arrays of this tick, which loops may be reading

        /// Copies a full array instead of letting it grow, so that spans and references stay valid. After
        /// clear() the largest array is used again, so ticks with as many events allocate nothing.
        void add(E event) {
            if (events.size() == events.capacity()) {
                std::vector<E> larger;
                larger.reserve(std::max<std::size_t>(2 * events.size(), 8));
                for (const E& old : events) larger.push_back(old);
                if (!events.empty()) outgrown.push_back(std::move(events));
                events = std::move(larger);
            }
            events.push_back(std::move(event));
        }
        void clear() override {
            events.clear();
            outgrown.clear();
        }
        void retire() override {
            if (!events.empty()) outgrown.push_back(std::exchange(events, {}));
        }
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
