#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "import/entity_json.hpp"
#include "import/import_report.hpp"
#include "import/import_stage.hpp"
#include "math/rect.hpp"
#include "reflect/json.hpp"

namespace plumb {

/// The file of a project that an import writes.
struct ImportTarget {
    Path root;         ///< the project's folder
    std::string path;  ///< path of the file, relative to the project's folder
    std::string name;  ///< file name without extension
    Vec2 picture;      ///< the game's resolution, px

    /// Finds the project of a file to be written.
    /// @param ending  required extension of the file: ".scene.json"
    /// @error  the file has another extension, or its name is only the extension
    static Result<ImportTarget> of(const Path& file, std::string_view ending);
};

/// A scene under construction by an import: entities, names of drawing orders, and files used by the scene.
class SceneDraft {
public:
    explicit SceneDraft(ImportTarget place);

    /// Adds an entity with an id computed from `key`, so that it is the same at every import. @return its id
    /// @param key  distinct for each entity of this import
    std::string add(std::string_view key, const std::string& name, Json components);
    /// Returns the entity added last.
    [[nodiscard]] Json& last() { return entities_.back(); }
    /// Returns all entities added so far.
    [[nodiscard]] Json& entities() { return entities_; }
    /// Adds an entity that is the parent of all entities added until the matching `close`. @return its id
    std::string open(std::string_view key, const std::string& name, Vec2 position);
    void close() { parents_.pop_back(); }

    /// Adds a camera at the center of `bounds`, limited to them.
    void addCamera(const Rect& bounds);
    /// Adds a rectangle of one color behind everything.
    void addBackground(std::string_view key, const Rect& area, Color color);
    /// Names a drawing order for the editor's lists; ignored if the order has a name already.
    void nameLayer(int order, std::string_view name);

    /// Appends all files of this import to `files`, the scene last, without writing them.
    Result<ImportReport> finish(std::vector<ImportedFile>& files);
    /// Writes all files of this import, the scene last. @error the files could not be written
    Result<ImportReport> write();

    ImportTarget place;
    ImportStage stage;
    ImportReport report;
    Json extra = Json::object();      ///< further members of the scene's JSON
    std::size_t colliderCorners = 0;  ///< of all colliders of tiles so far

private:
    /// Returns the text that loading and saving the scene produces, so that saving it again changes nothing.
    Result<std::string> savedForm(const Json& json);

    EntityIds ids_;
    Json entities_ = Json::array();
    std::vector<std::string> parents_;
    std::map<int, std::string> layers_;
};

}  // namespace plumb
