#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/hash.hpp"
#include "core/result.hpp"
#include "core/state_archive.hpp"
#include "reflect/type_key.hpp"

namespace plumb {

/// The events of this tick, one list per event type, and those that handlers have yet to receive.
///
/// Systems read the lists in the tick in which the events are emitted, so they are not part of snapshots. A
/// handler has an inbox instead: it receives each event once, in its next turn, which is in the next tick if
/// its turn is over. Inboxes are part of snapshots. Source: EventReader of Bevy, whose readers
/// likewise get what was emitted since they read last.
class Events {
public:
    class Inbox;
    /// Copies of inboxes, as a snapshot keeps them.
    using Inboxes = std::vector<std::unique_ptr<Inbox>>;

    Events();
    ~Events();
    Events(const Events&) = delete;
    Events& operator=(const Events&) = delete;

    template <class E>
    void emit(E event) {
        if (const TypeKey key = typeKey<E>(); key < inboxes_.size()) {
            for (const std::unique_ptr<Inbox>& inbox : inboxes_[key])
                static_cast<InboxOf<E>&>(*inbox).waiting.push_back(event);
        }
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

    /// Gives a handler an inbox for events of a type; does nothing if it has one.
    /// @param handler  key of the system that calls deliver()
    template <class E>
    void openInbox(TypeKey handler) {
        const TypeKey key = typeKey<E>();
        if (key >= inboxes_.size()) inboxes_.resize(key + 1);
        if (find(key, handler) == nullptr) inboxes_[key].push_back(std::make_unique<InboxOf<E>>(handler));
    }
    void closeInboxes(TypeKey handler);
    /// Calls `f(const E&)` for the events in the inbox of a handler, in the order of emission, and removes
    /// them. Those emitted meanwhile are in the next call's. @pre not called by `f` for the same handler
    template <class E, class F>
    void deliver(TypeKey handler, F&& f) {
        auto* inbox = static_cast<InboxOf<E>*>(find(typeKey<E>(), handler));
        if (inbox == nullptr) return;
        if (!inbox->delivered.empty()) return failNested();
        std::swap(inbox->delivered, inbox->waiting);
        while (inbox->next < inbox->delivered.size()) f(std::as_const(inbox->delivered[inbox->next++]));
        inbox->delivered.clear();
        inbox->next = 0;
    }
    /// Removes the events that handlers have yet to receive.
    void dropWaiting();
    /// Copies the inboxes. Those of `saved` that are of the same handlers are filled again.
    void save(Inboxes& saved) const;
    /// Replaces the events of all inboxes. Events for handlers that this world does not have are dropped.
    void restore(const Inboxes& saved);
    /// Appends the events that handlers have yet to receive to the bytes of a saved game.
    /// @param problems  receives the types that cannot be saved
    void write(StateArchive& archive, std::vector<Error>& problems) const;
    /// Returns the inboxes of a saved game. Events for handlers that there are not any more are left out.
    Inboxes read(StateArchive& archive, std::vector<Error>& problems) const;
    /// Adds how many events each handler has yet to receive; nothing if all have received all. Not the
    /// events, as those may have bytes between their members that differ from run to run.
    void addTo(Hasher& hasher) const;

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
    struct InboxOf;

    [[nodiscard]] Inbox* find(TypeKey event, TypeKey handler) const;
    static void failNested();

    template <class E>
    ListOf<E>& listOf() {
        const TypeKey key = typeKey<E>();
        if (key >= lists_.size()) lists_.resize(key + 1);
        if (lists_[key] == nullptr) lists_[key] = std::make_unique<ListOf<E>>();
        return static_cast<ListOf<E>&>(*lists_[key]);
    }

    std::vector<std::unique_ptr<List>> lists_;  // indexed by TypeKey
    std::vector<Inboxes> inboxes_;              // indexed by the TypeKey of the event, then as opened
};

/// The events of one type that a handler has yet to receive.
class Events::Inbox {
public:
    Inbox(TypeKey event, TypeKey receiver) : type{event}, handler{receiver} {}
    virtual ~Inbox() = default;
    Inbox(const Inbox&) = delete;
    Inbox& operator=(const Inbox&) = delete;

    [[nodiscard]] virtual std::size_t size() const = 0;
    /// Removes the events; one that the handler receives at present stays valid.
    virtual void clear() = 0;
    /// Replaces the events by those of an inbox for the same type.
    virtual void assign(const Inbox& other) = 0;
    [[nodiscard]] virtual std::unique_ptr<Inbox> copy() const = 0;
    /// Writes or reads the events. @return false if they are not plain data, which cannot be saved
    virtual bool archive(StateArchive& archive) = 0;

    const TypeKey type;                                 ///< of the events
    const TypeKey handler;                              ///< of the system that receives them
    const std::uint32_t version = reloadableVersion();  ///< of the code that made it
};

template <class E>
struct Events::InboxOf final : Events::Inbox {
    std::vector<E> waiting;
    std::vector<E> delivered;  ///< those of the handler's present turn; its memory is used again
    std::size_t next = 0;      ///< index in `delivered` of the next one; those before it were received

    explicit InboxOf(TypeKey receiver) : Inbox{typeKey<E>(), receiver} {}
    [[nodiscard]] std::size_t size() const override { return delivered.size() - next + waiting.size(); }
    void clear() override {
        waiting.clear();
        next = delivered.size();
    }
    void assign(const Inbox& other) override {
        const auto& from = static_cast<const InboxOf&>(other);
        clear();
        // One by one, as events need not be assignable.
        for (std::size_t i = from.next; i < from.delivered.size(); ++i) waiting.push_back(from.delivered[i]);
        for (const E& event : from.waiting) waiting.push_back(event);
    }
    [[nodiscard]] std::unique_ptr<Inbox> copy() const override {
        auto made = std::make_unique<InboxOf>(handler);
        made->assign(*this);
        return made;
    }
    bool archive(StateArchive& archive) override {
        if constexpr (std::is_trivially_copyable_v<E>) {
            if (archive.reading()) clear();
            archive.list(waiting);
            return true;
        } else {
            return false;
        }
    }
};

}  // namespace plumb
