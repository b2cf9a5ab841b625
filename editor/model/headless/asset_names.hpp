#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reflect/json_fwd.hpp"
#include "reflect/type_registry.hpp"

namespace plumb::editor {

/// All asset references in the entities of scenes and prefabs, with the places that contain them.
class AssetNames {
public:
    explicit AssetNames(const TypeRegistry& types) : types_{types} {}

    /// Collects the references of a scene or prefab file. Invalid JSON is ignored, because opening reports
    /// it.
    void read(const std::string& file, std::string_view text);

    struct Named {  ///< an asset, and the fields that reference it
        AssetKind kind = AssetKind::None;
        std::vector<std::string> by;  ///< "scenes/cave.scene.json: crate (0000000000000004), Sprite.texture"
    };
    /// References by asset path, as written in the files.
    [[nodiscard]] const std::map<std::string, Named, std::less<>>& all() const { return named_; }
    /// Returns the first reference to an asset and the number of others; empty if there is none.
    [[nodiscard]] std::string usersOf(std::string_view path) const;

private:
    void readEntity(const std::string& file, const Json& entity, const std::string& user);
    void add(const FieldInfo& field, const Json& value, const std::string& user);

    const TypeRegistry& types_;
    std::map<std::string, Named, std::less<>> named_;
};

}  // namespace plumb::editor
