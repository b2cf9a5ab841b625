#pragma once

#include <string>
#include <vector>

#include "app/module.hpp"
#include "app/system_order.hpp"
#include "reflect/type_registry.hpp"
#include "scene/effect_table.hpp"
#include "script/script_set.hpp"

namespace plumb {

/// Differences between two versions of a project's code, or of its scripts, that matter for worlds that use
/// it.
struct ContentChange {
    struct Type {
        TypeInfo before;                ///< the type in the previous version
        const TypeInfo* now = nullptr;  ///< the type in the new version; null: removed
    };
    std::vector<Type> types;             ///< component types whose layout changed or that were removed
    std::vector<const TypeInfo*> added;  ///< component types that are new: files may contain them
    bool newCode = false;                ///< the code is another version, not only the scripts
    std::vector<TypeKey> systems;        ///< systems of the previous version of the code
    Module before;                       ///< the previous version of the code
};

/// Component types, systems and effects of the engine, of a project's code and of its scripts: what scenes
/// can contain and what a tick runs. Must outlive the games that use it.
class GameContent {
public:
    /// @param problems  receives the errors: a name that is already in use, a position at an unknown system.
    /// A game must not be started with them.
    GameContent(Module code, std::vector<Error>& problems);
    GameContent(const GameContent&) = delete;
    GameContent& operator=(const GameContent&) = delete;

    /// Replaces the project's code by another version. References to types() and effects() and to a TypeInfo
    /// stay valid. Call convertWorld() for every world that uses this content before the world is used again.
    ContentChange update(Module code, std::vector<Error>& problems);

    /// Reads the script files of a project again; then as update().
    /// @param folder  of the project
    ContentChange readScripts(const Path& folder, std::vector<Error>& problems);
    /// As readScripts(), with texts instead of files: pairs of a name and a text.
    ContentChange useScripts(const std::vector<std::pair<std::string, std::string>>& texts,
                             std::vector<Error>& problems);

    [[nodiscard]] const TypeRegistry& types() const { return types_; }
    [[nodiscard]] const ScriptSet& scripts() const { return scripts_; }
    [[nodiscard]] const EffectTable& effects() const { return effects_; }
    [[nodiscard]] const std::vector<SystemRow>& systems() const { return systems_; }
    [[nodiscard]] const Module& code() const { return code_; }

    /// Makes the world run its systems in the order of systems(), and systems that are not listed after them.
    void useSystemOrder(World& world) const;
    /// Adds all systems() to the world.
    void addSystems(World& world) const;

private:
    struct ProjectType {
        TypeInfo type;
        std::string where;  // what gives it its name: a function or a file
    };

    [[nodiscard]] std::vector<ProjectType> projectTypes() const;
    void updateTypes(ContentChange& change, std::vector<Error>& problems);
    void checkResources(std::vector<Error>& problems) const;
    void updateSystems(std::vector<Error>& problems);

    Module code_;
    TypeRegistry types_;
    std::vector<std::string> projectTypes_;  // names of the components of the code and of the scripts
    ScriptSet scripts_;
    std::vector<SystemRow> systems_;
    EffectTable effects_;
};

/// Converts a world that uses `content` to the new version of the code after GameContent::update().
/// Components, and resources declared with Module::resources(), keep the fields that both versions have;
/// systems are replaced; all other resources of the code are removed, and components that it does not list.
void convertWorld(World& world, const GameContent& content, const ContentChange& change);

/// Returns the content of the engine alone, without a project's code.
const GameContent& engineContent();

}  // namespace plumb
