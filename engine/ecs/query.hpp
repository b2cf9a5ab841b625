#pragma once

#include <cstddef>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <utility>

#include "ecs/entity.hpp"
#include "ecs/paused.hpp"
#include "ecs/storage.hpp"

namespace plumb {

/// Query filter: only entities that also have all of these types, `query<A>(with<B, Tag>)`.
template <class... T>
struct With {};
template <class... T>
inline constexpr With<T...> with{};

/// Query filter: only entities that have none of these types, `query<A>(without<B, C>)`.
template <class... T>
struct Without {};
template <class... T>
inline constexpr Without<T...> without{};

/// True if no two of the types are the same.
template <class... T>
inline constexpr bool kAreDistinct = true;
template <class T, class... Others>
inline constexpr bool kAreDistinct<T, Others...> =
    (!std::is_same_v<T, Others> && ...) && kAreDistinct<Others...>;

/// True if a filter excludes all entities that have a T.
template <class Filter, class T>
inline constexpr bool kExcludes = false;
template <class... U, class T>
inline constexpr bool kExcludes<Without<U...>, T> = (std::is_same_v<U, T> || ...);

std::uint32_t nextQueryKey();
template <class... T>
inline const std::uint32_t kQueryKey = nextQueryKey();

/// The single object that all holders of a tag share, so that tags can be used in queries like components.
template <class T>
inline std::remove_const_t<T> kTagInstance{};

/// Returns item `i` of a column; for a tag, the shared instance.
template <class T>
T& itemOf(T* column, std::size_t i) {
    if constexpr (kIsTag<T>) {
        static_cast<void>(i);
        return *column;
    } else {
        return column[i];
    }
}

template <class T>
T* columnOf(const Pool& pool) {
    if constexpr (kIsTag<T>) {
        return &kTagInstance<T>;
    } else {
        return reinterpret_cast<T*>(pool.column);
    }
}

template <class T>
T* advanced(T* column, std::uint32_t by) {
    return kIsTag<T> ? column : column + by;
}

/// The element type of a range-for over a query: an entity and its components.
/// The destructor keeps compilers from warning about unused variables in loops that only count.
template <class... T>
struct Row : std::tuple<Entity, T&...> {
    using std::tuple<Entity, T&...>::tuple;
    Row(const Row&) = default;
    Row& operator=(const Row&) = delete;
    ~Row() {}
};

/// A loop over the entities of a query: the state of a range-for. Entities that stop matching
/// during the loop are skipped; entities that start to match are not visited by this loop.
template <class... T>
class Cursor {
    static constexpr std::uint32_t kColumns = sizeof...(T);

public:
    struct End {};

    Cursor(World& world, Storage& storage, QueryCache& wanted)
        : world_{&world}, storage_{&storage}, cache_{&storage.beginIteration(wanted)} {
        structure_ = storage.structure();
        stampAll(*cache_, storage.clock(), std::index_sequence_for<T...>{});
        enterRun(cache_->runs.data());
    }
    ~Cursor() { storage_->endIteration(*cache_); }
    Cursor(const Cursor&) = delete;
    Cursor& operator=(const Cursor&) = delete;

    [[nodiscard]] bool done() const { return at_ == span_.length; }
    bool operator!=(End) const { return !done(); }

    Cursor& operator++() {
        ++at_;
        if (storage_->structure() != structure_) [[unlikely]] {
            if (done()) enterRun(run_ + cache_->step());
            skipGone();
        } else if (done()) [[unlikely]] {
            enterRun(run_ + cache_->step());
        }
        return *this;
    }
    [[nodiscard]] Row<T...> operator*() const { return row(std::index_sequence_for<T...>{}); }

private:
    template <std::size_t... I>
    Row<T...> row(std::index_sequence<I...>) const {
        return Row<T...>{Entity{*world_, storage_->idAt(span_.entities[at_])},
                         itemOf(std::get<I>(span_.items), at_)...};
    }
    void skipGone() {
        while (!done() && !cache_->stillThere(storage_->records(), run_, static_cast<std::uint32_t>(at_))) {
            if (++at_ == span_.length) enterRun(run_ + cache_->step());
        }
    }
    void enterRun(const std::uint32_t* run) {
        run_ = run;
        at_ = 0;
        span_ = spanOf(*cache_, run, std::index_sequence_for<T...>{});
    }

    /// The current run of the loop; of length 0 after the last one.
    struct Span {
        std::size_t length = 0;
        const std::uint32_t* entities = nullptr;
        std::tuple<T*...> items;
    };
    template <std::size_t... I>
    static Span spanOf(const QueryCache& cache, const std::uint32_t* run, std::index_sequence<I...>) {
        if (run == cache.runs.data() + cache.runs.size()) return {};
        const std::uint32_t length = cache.indexed ? 1 : run[kColumns];
        return {length,
                cache.included[0]->dense + run[0],
                {advanced(columnOf<T>(*cache.included[I]), run[I])...}};
    }

    /// Marks all non-const columns as written, before the loop:
    /// a call inside it would make compilers reload registers.
    template <std::size_t... I>
    [[gnu::noinline]] static void stampAll(const QueryCache& cache, std::uint64_t clock,
                                           std::index_sequence<I...>) {
        if constexpr ((!std::is_const_v<T> || ...)) {
            const std::uint32_t* const end = cache.runs.data() + cache.runs.size();
            for (const std::uint32_t* run = cache.runs.data(); run != end; run += cache.step()) {
                const std::uint32_t length = cache.indexed ? 1 : run[kColumns];
                ((std::is_const_v<T> ? void() : cache.included[I]->stamp(run[I], length, clock)), ...);
            }
        }
    }

    World* world_;
    Storage* storage_;
    QueryCache* cache_;
    const std::uint32_t* run_ = nullptr;
    std::size_t at_ = 0;
    std::uint64_t structure_ = 0;
    Span span_;
};

/// The entities that have all of T, except paused ones. Cheap
/// to construct; the result is looked up when a loop begins.
///
///     for (auto [entity, body, transform] : world.query<const RigidBody, Transform>(without<Asleep>)) …
///
/// Entities may be created and destroyed and components added and removed inside the loop. A component that
/// was removed, or whose entity was destroyed, must not be used any more: its memory holds old values until
/// the loop ends. Not inside a loop: save(), restore() and cluster() of the world, which report an error.
template <class... T>
class Query {
    static_assert(sizeof...(T) > 0, "a query names at least one component");
    static_assert(
        ((std::is_object_v<T> && !std::is_pointer_v<T>)&&...),
        "a query names component types without & and *: query<Transform>, or query<const Transform>");
    static_assert(kAreDistinct<std::remove_const_t<T>...>, "a query names each component type once");

public:
    Query(World& world, Storage& storage, QueryCache& cache)
        : world_{world}, storage_{storage}, cache_{cache} {}

    [[nodiscard]] Cursor<T...> begin() const { return {world_, storage_, cache_}; }
    [[nodiscard]] typename Cursor<T...>::End end() const { return {}; }

    [[nodiscard]] std::size_t count() const {
        QueryCache& cache = storage_.beginIteration(cache_);
        const std::size_t total = cache.total;
        storage_.endIteration(cache);
        return total;
    }
    [[nodiscard]] bool empty() const { return count() == 0; }
    /// The first entity, or the empty handle.
    [[nodiscard]] Entity first() const {
        QueryCache& cache = storage_.beginIteration(cache_);
        const Entity found = cache.total == 0
                                 ? Entity{}
                                 : Entity{world_, storage_.idAt(cache.included[0]->dense[cache.runs[0]])};
        storage_.endIteration(cache);
        return found;
    }

    /// Calls `f(T&...)`, or `f(Entity, T&...)`, for each entity. The fastest loop:
    /// without the entity it is a plain loop over arrays that the compiler can vectorize.
    template <class F>
    void each(F&& f) const {
        static_assert(std::is_invocable_v<F&, T&...> || std::is_invocable_v<F&, Entity, T&...>,
                      "each() calls f(T&...) or f(Entity, T&...), in the order of the query's types");
        Loop loop{*this};
        for (const std::uint32_t* run = loop.begin; run != loop.end; run += loop.step) {
            const std::uint32_t length = loop.length(run);
            stampRun(loop, run, length, Columns{});
            std::uint32_t i = loop.changed() ? 0 : eachPlain(f, loop, run, length, Columns{});
            for (; i < length; ++i) {
                if (loop.cache.stillThere(storage_.records(), run, i)) callOne(f, loop, run, i, Columns{});
            }
        }
    }

    /// Calls `f(count, T*...)` for arrays of consecutive entities. Not for tags.
    template <class F>
    void chunks(F&& f) const {
        Loop loop{*this};
        const auto call = [&]<std::size_t... I>(const std::uint32_t* run, std::uint32_t at,
                                                std::uint32_t length, std::index_sequence<I...>) {
            f(std::size_t{length}, (columnOf<T>(*loop.cache.included[I]) + run[I] + at)...);
        };
        for (const std::uint32_t* run = loop.begin; run != loop.end; run += loop.step) {
            const std::uint32_t length = loop.length(run);
            stampRun(loop, run, length, Columns{});
            if (!loop.changed()) {
                call(run, 0, length, Columns{});
                continue;
            }
            for (std::uint32_t i = 0; i < length; ++i) {
                if (loop.cache.stillThere(storage_.records(), run, i)) call(run, i, 1, Columns{});
            }
        }
    }

private:
    using Columns = std::index_sequence_for<T...>;

    /// Scope guard: the iteration ends with its lifetime.
    struct Loop {
        explicit Loop(const Query& query)
            : storage{query.storage_},
              cache{query.storage_.beginIteration(query.cache_)},
              structure{storage.structure()} {
            begin = cache.runs.data();
            end = begin + cache.runs.size();
            step = cache.step();
        }
        ~Loop() { storage.endIteration(cache); }
        Loop(const Loop&) = delete;
        Loop& operator=(const Loop&) = delete;

        [[nodiscard]] bool changed() const { return storage.structure() != structure; }
        [[nodiscard]] std::uint32_t length(const std::uint32_t* run) const {
            return cache.indexed ? 1 : run[sizeof...(T)];
        }

        Storage& storage;
        QueryCache& cache;
        std::uint64_t structure;
        const std::uint32_t* begin;
        const std::uint32_t* end;
        std::uint32_t step;
    };

    template <std::size_t... I>
    static void stampRun(const Loop& loop, const std::uint32_t* run, std::uint32_t length,
                         std::index_sequence<I...>) {
        ((std::is_const_v<T> ? void() : loop.cache.included[I]->stamp(run[I], length, loop.storage.clock())),
         ...);
    }

    template <class F, std::size_t... I>
    std::uint32_t eachPlain(F& f, const Loop& loop, const std::uint32_t* run, std::uint32_t length,
                            std::index_sequence<I...>) const {
        if constexpr (std::is_invocable_v<F&, T&...>) {
            return plainLoop(f, loop.storage.structure(), length,
                             advanced(columnOf<T>(*loop.cache.included[I]), run[I])...);
        } else {
            for (std::uint32_t i = 0; i < length; ++i) {
                callOne(f, loop, run, i, std::index_sequence<I...>{});
                if (loop.changed()) return i + 1;
            }
            return length;
        }
    }
    /// @return number of entities visited, up to the one whose visit changed the world
    template <class F>
    static std::uint32_t plainLoop(F& f, const std::uint64_t& structure, std::uint32_t length,
                                   T* __restrict... items) {
        const std::uint64_t before = structure;
        for (std::uint32_t i = 0; i < length; ++i) {
            f(itemOf(items, i)...);
            if (structure != before) [[unlikely]]
                return i + 1;
        }
        return length;
    }
    template <class F, std::size_t... I>
    void callOne(F& f, const Loop& loop, const std::uint32_t* run, std::uint32_t i,
                 std::index_sequence<I...>) const {
        const auto item = [&]<std::size_t K>(std::integral_constant<std::size_t, K>) -> auto& {
            using Component = std::tuple_element_t<K, std::tuple<T...>>;
            return itemOf(advanced(columnOf<Component>(*loop.cache.included[K]), run[K]), i);
        };
        if constexpr (std::is_invocable_v<F&, T&...>) {
            f(item(std::integral_constant<std::size_t, I>{})...);
        } else {
            const EntityId id = storage_.idAt(loop.cache.included[0]->dense[run[0] + i]);
            f(Entity{world_, id}, item(std::integral_constant<std::size_t, I>{})...);
        }
    }

    World& world_;
    Storage& storage_;
    QueryCache& cache_;
};

template <class... T>
void addTerms(With<T...>, Storage& storage, QueryCache& cache) {
    (cache.included.push_back(&storage.pool<T>()), ...);
}
template <class... T>
void addTerms(Without<T...>, Storage& storage, QueryCache& cache) {
    (cache.excluded.push_back(&storage.pool<T>()), ...);
}

inline void addTerms(WithPaused, Storage&, QueryCache&) {}

/// True if a term of a query determines whether paused entities are included.
template <class Term>
inline constexpr bool kNamesPaused = std::is_same_v<std::remove_const_t<Term>, Paused>;
template <>
inline constexpr bool kNamesPaused<WithPaused> = true;
template <class... T>
inline constexpr bool kNamesPaused<With<T...>> = (kNamesPaused<T> || ...);
template <class... T>
inline constexpr bool kNamesPaused<Without<T...>> = (kNamesPaused<T> || ...);

/// The cache of a query in a storage, created on first use.
template <class... T, class... Filters>
QueryCache& queryCache(Storage& storage, Filters... filters) {
    constexpr auto kIsExcluded = []<class C>(C*) { return (kExcludes<Filters, C> || ...); };
    static_assert(!(kIsExcluded(static_cast<std::remove_const_t<T>*>(nullptr)) || ...),
                  "a query that excludes one of its own types by `without` has no results");
    QueryCache& cache = storage.cache(kQueryKey<With<std::remove_const_t<T>...>, Filters...>);
    if (!cache.prepared) [[unlikely]] {
        addTerms(With<std::remove_const_t<T>...>{}, storage, cache);
        cache.columns = sizeof...(T);
        (addTerms(filters, storage, cache), ...);
        constexpr bool kHasPausedTerm = (kNamesPaused<T> || ...) || (kNamesPaused<Filters> || ...);
        if constexpr (!kHasPausedTerm) cache.excluded.push_back(&storage.pool<Paused>());
        cache.prepare();
    }
    return cache;
}

}  // namespace plumb

template <class... T>
struct std::tuple_size<plumb::Row<T...>> : std::tuple_size<std::tuple<plumb::Entity, T&...>> {};
template <std::size_t I, class... T>
struct std::tuple_element<I, plumb::Row<T...>> : std::tuple_element<I, std::tuple<plumb::Entity, T&...>> {};
