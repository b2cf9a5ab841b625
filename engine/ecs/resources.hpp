#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/hash.hpp"
#include "core/result.hpp"
#include "core/state_archive.hpp"
#include "ecs/component_type.hpp"
#include "ecs/saved_type.hpp"
#include "reflect/type_key.hpp"

namespace plumb {

template <class T>
concept AddsToHash = requires(const T& value, Hasher& hasher) {
    value.addTo(hasher);
};

template <class T>
concept Archived = requires(T& value, StateArchive& archive) {
    value.archive(archive);
};
/// A resource that saved games do not contain: it belongs to the running program, not to the game.
template <class T>
concept NotSaved = T::kNotSaved;

/// One value per type, for data that exists once per world. Part of snapshots; hashed if T has `addTo`. A
/// saved game contains those with `archive`, by field those with `describe`, and plain data.
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
        static_cast<void>(&kListed<T>);
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

    /// Appends all values to the bytes of a saved game.
    /// @param problems  receives the types that cannot be saved
    void write(StateArchive& archive, std::vector<Error>& problems) const;
    /// Returns the values of a saved game. Types with kNotSaved have those of `*this`.
    /// @param problems  receives what the program cannot use: unknown types, and those of another size
    Resources read(StateArchive& archive, std::vector<Error>& problems) const;

    /// Copies all values of `other`; values missing there are reset to their defaults.
    void assign(const Resources& other);
    void addTo(Hasher& hasher) const;
    /// Removes the values of types for which isReloadable() holds.
    void dropReloadable();

private:
    /// How a saved game contains a type.
    enum class Saving : std::uint8_t { Whole, Not, Impossible };

    struct Box {
        TypeKey key = 0;
        std::uint64_t nameHash = 0;
        std::string_view name;  ///< of the type, as the compiler writes it
        bool present = false;

        virtual ~Box() = default;
        [[nodiscard]] virtual std::unique_ptr<Box> copy() const = 0;
        virtual void assign(const Box& other) = 0;
        virtual void reset() = 0;
        virtual void addTo(Hasher& hasher) const = 0;
        /// Writes or reads the value.
        virtual void archive(StateArchive& archive) = 0;
        [[nodiscard]] virtual Saving saving() const = 0;
    };

    template <class T>
    struct BoxOf final : Box {
        T value{};

        BoxOf() {
            key = typeKey<T>();
            name = compilerTypeName<T>();
            nameHash = hashText(name);
        }
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
        void archive(StateArchive& archive) override {
            if constexpr (Archived<T>) {
                value.archive(archive);
            } else if constexpr (Described<T>) {
                TypeInfo type;
                TypeBuilder<T> builder{type};
                T::describe(builder);
                archiveFields(archive, type, &value);
            } else if constexpr (std::is_trivially_copyable_v<T>) {
                archive.value(value);
            }
        }
        [[nodiscard]] Saving saving() const override {
            if constexpr (NotSaved<T>) return Saving::Not;
            constexpr bool kPossible = Archived<T> || std::is_trivially_copyable_v<T>;
            return kPossible ? Saving::Whole : Saving::Impossible;
        }
    };

    /// A type of which the code uses a resource, so that a saved game can create it.
    struct Known {
        std::string_view name;
        std::unique_ptr<Box> (*make)();
        std::uint32_t version;  // reloadableVersion() of the code
    };
    static bool list(const Known& known);
    static std::vector<Known>& known();
    /// Listed when the code that uses the resource is loaded, not only when it is created.
    template <class T>
    static inline const bool kListed =
        list({compilerTypeName<T>(), []() -> std::unique_ptr<Box> { return std::make_unique<BoxOf<T>>(); },
              reloadableVersion()});

    [[nodiscard]] std::unique_ptr<Box> boxFor(std::string_view name) const;
    [[nodiscard]] Box* find(TypeKey key) const;
    Box& insert(std::unique_ptr<Box> box);

    std::vector<std::unique_ptr<Box>> boxes_;  // sorted by hash of name
};

}  // namespace plumb
