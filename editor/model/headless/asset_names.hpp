#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "reflect/json_fwd.hpp"
#include "reflect/type_registry.hpp"

namespace plumb::editor {

/// Which entities of which scenes and prefabs name a file, in which fields.
class AssetNames {
public:
    explicit AssetNames(const TypeRegistry& types) : types_{types} {}

    /// Reads a scene or a prefab. What is no JSON names nothing; opening it reports that.
    void read(const std::string& file, std::string_view text);

    struct Named {
        AssetKind kind = AssetKind::None;
        std::vector<std::string> by;  ///< "scenes/cave.scene.json: crate (0000000000000004), Sprite.texture"
    };
    /// By path, as it is written there.
    [[nodiscard]] const std::map<std::string, Named, std::less<>>& all() const { return named_; }
    /// The first place that names it, and how many more do; empty: none.
    [[nodiscard]] std::string usersOf(std::string_view path) const;

private:
    void readEntity(const std::string& file, const Json& entity, const std::string& user);
    void add(const FieldInfo& field, const Json& value, const std::string& user);

    const TypeRegistry& types_;
    std::map<std::string, Named, std::less<>> named_;
};

}  // namespace plumb::editor
