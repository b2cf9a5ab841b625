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

/// Where an import goes: a file of a project and a folder for all that it needs.
struct ImportPlace {
    Path root;         ///< the project's folder
    std::string path;  ///< of the file, in the project
    std::string name;  ///< of the file, without ending
    Vec2 picture;      ///< px of the game's picture

    /// @param ending  that the file must have: ".scene.json"
    /// @error  another ending, or nothing before it
    static Result<ImportPlace> of(const Path& file, std::string_view ending);
};

/// The scene that an import makes, while it is made: entities, the names of the layers, the files beside it.
class SceneDraft {
public:
    explicit SceneDraft(ImportPlace place);

    /// Adds an entity under an id that is the same at every import. @return its id
    /// @param key  tells it from all others of this import
    std::string add(std::string_view key, const std::string& name, Json components);
    /// The entity added last.
    [[nodiscard]] Json& last() { return entities_.back(); }
    /// All entities so far.
    [[nodiscard]] Json& entities() { return entities_; }
    /// An entity at a place, to be the parent of what comes until the matching `close`.
    std::string open(std::string_view key, const std::string& name, Vec2 position);
    void close() { parents_.pop_back(); }

    /// A camera that shows the middle of what is there and does not leave it.
    void addCamera(const Rect& bounds);
    /// A rectangle of one color behind everything.
    void addBackground(std::string_view key, const Rect& area, Color color);
    /// The name of an order of drawing, for the editor's lists; the first one stays.
    void nameLayer(int order, std::string_view name);

    /// Adds all files of this import to those to be written, the scene last.
    Result<ImportReport> finish(std::vector<ImportedFile>& files);
    /// Does that and writes them. @error nothing could be written
    Result<ImportReport> write();

    ImportPlace place;
    ImportStage stage;
    ImportReport report;
    Json extra = Json::object();  ///< members of the scene beside its entities

private:
    /// The scene in the one form that saving gives it, so that opening and saving it changes nothing.
    Result<std::string> savedForm(const Json& json);

    EntityIds ids_;
    Json entities_ = Json::array();
    std::vector<std::string> parents_;
    std::map<int, std::string> layers_;
};

}  // namespace plumb
