#pragma once

#include <string>
#include <vector>

#include "app/module.hpp"
#include "app/system_order.hpp"
#include "reflect/type_registry.hpp"
#include "scene/effect_table.hpp"

namespace plumb {

/// What another version of a project's code changes in running worlds.
struct ContentChange {
    struct Type {
        TypeInfo before;
        const TypeInfo* now = nullptr;  ///< null: removed
    };
    std::vector<Type> types;       ///< components with another layout, or removed
    bool newTypes = false;         ///< component types were added: files may contain them
    std::vector<TypeKey> systems;  ///< systems of the version before
    Module before;                 ///< the version before
};

/// Component types, systems and effects of the engine and of a project's code: what scenes can contain and
/// what a tick runs. Must outlive the games that use it.
class GameContent {
public:
    /// @param problems  receives what cannot be done: a name that is used already, an unknown system
    GameContent(Module code, std::vector<Error>& problems);
    GameContent(const GameContent&) = delete;
    GameContent& operator=(const GameContent&) = delete;

    /// Replaces the project's code by another version. References to types() and effects() and to a TypeInfo
    /// stay valid. Worlds that use this content must be converted before they are used again: convertWorld().
    ContentChange update(Module code, std::vector<Error>& problems);

    [[nodiscard]] const TypeRegistry& types() const { return types_; }
    [[nodiscard]] const EffectTable& effects() const { return effects_; }
    [[nodiscard]] const std::vector<SystemRow>& systems() const { return systems_; }
    [[nodiscard]] const Module& code() const { return code_; }

    /// Makes the world run its systems in this order, others after them.
    void useSystemOrder(World& world) const;
    /// Adds all systems.
    void addSystems(World& world) const;

private:
    void updateTypes(ContentChange& change, std::vector<Error>& problems);
    void updateSystems(std::vector<Error>& problems);

    Module code_;
    TypeRegistry types_;
    std::vector<std::string> codeTypes_;  // names of the components of the code
    std::vector<SystemRow> systems_;
    EffectTable effects_;
};

/// Carries a world that runs with `content` over to the version after an update(): components and declared
/// resources keep the fields that both versions have, systems are replaced, all other resources of the code
/// are removed.
void convertWorld(World& world, const GameContent& content, const ContentChange& change);

/// The content without a project's code.
const GameContent& engineContent();

}  // namespace plumb
