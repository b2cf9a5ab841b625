#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "core/hash.hpp"
#include "ecs/component_type.hpp"
#include "reflect/type_key.hpp"

namespace plumb {

template <class T>
concept AddsToHash = requires(const T& value, Hasher& hasher) {
    value.addTo(hasher);
};

/// One value per type, for data that exists once per world. Part of snapshots; hashed if T has `addTo`.
class Resources {
public:
    Resources() = default;
    Resources(const Resources&) = delete;
    Resources& operator=(const Resources&) = delete;
    Resources(Resources&&) = default;
    Resources& operator=(Resources&&) = default;

    /// The value; created with defaults on first use. The reference stays valid as long as the world.
    template <class T>
    T& get() {
        Box* box = find(typeKey<T>());
        if (box == nullptr) box = &insert(std::make_unique<BoxOf<T>>());
        box->present = true;
        return static_cast<BoxOf<T>*>(box)->value;
    }
    template <class T>
    [[nodiscard]] T* find() const {
        Box* box = find(typeKey<T>());
        return box != nullptr && box->present ? &static_cast<BoxOf<T>*>(box)->value : nullptr;
    }

    /// Copies all values of `other`; values missing there are reset to their defaults.
    void assign(const Resources& other);
    void addTo(Hasher& hasher) const;
    /// Removes the values of types for which isReloadable() holds.
    void dropReloadable();

private:
    struct Box {
        TypeKey key = 0;
        std::uint64_t nameHash = 0;
        bool present = false;

        virtual ~Box() = default;
        [[nodiscard]] virtual std::unique_ptr<Box> copy() const = 0;
        virtual void assign(const Box& other) = 0;
        virtual void reset() = 0;
        virtual void addTo(Hasher& hasher) const = 0;
    };

    template <class T>
    struct BoxOf final : Box {
        T value{};

        BoxOf() { key = typeKey<T>(), nameHash = hashText(compilerTypeName<T>()); }
        [[nodiscard]] std::unique_ptr<Box> copy() const override { return std::make_unique<BoxOf>(*this); }
        void assign(const Box& other) override { value = static_cast<const BoxOf&>(other).value; }
        void reset() override { value = T{}; }
        void addTo(Hasher& hasher) const override {
            if constexpr (AddsToHash<T>) {
                hasher.add(nameHash);
                value.addTo(hasher);
            } else {
                static_cast<void>(hasher);
            }
        }
    };

    [[nodiscard]] Box* find(TypeKey key) const;
    Box& insert(std::unique_ptr<Box> box);

    std::vector<std::unique_ptr<Box>> boxes_;  // sorted by hash of name
};

}  // namespace plumb
