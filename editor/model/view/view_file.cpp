#include "editor/model/view/view_file.hpp"

#include "core/text.hpp"
#include "editor/model/safety/backups.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

Json toJson(const std::set<ObjectId>& ids) {
    Json list = Json::array();
    for (const ObjectId id : ids) list.push_back(hexText(id.value));
    return list;
}

template <class F>
void eachId(const Json& file, const char* key, F&& use) {
    const Json* list = findArray(file, key);
    if (list == nullptr) return;
    for (const Json& id : *list) {
        if (const std::uint64_t value = hexIdOf(id)) use(ObjectId{value});
    }
}

}  // namespace

Path ViewFile::fileOf(std::string_view scene) const {
    return project_ / ".plumb" / "view" / Path{std::string{scene} + ".view"};
}

void ViewFile::read(std::string_view scene, EntityView& view) {
    view.clear();
    kept_ = view.revision();
    std::error_code failed;
    if (scene.empty() || !std::filesystem::exists(fileOf(scene), failed)) return;
    const Result<std::string> text = readFile(fileOf(scene));
    const Result<Json> file = text ? parseJson(*text, "view") : Result<Json>{text.error()};
    if (!file || !file->is_object()) return;
    eachId(*file, "hidden", [&](ObjectId id) { view.setHidden(id, true); });
    eachId(*file, "locked", [&](ObjectId id) { view.setLocked(id, true); });
    kept_ = view.revision();
}

void ViewFile::keep(std::string_view scene, const EntityView& view) {
    if (scene.empty() || std::exchange(kept_, view.revision()) == view.revision()) return;
    const Path file = fileOf(scene);
    std::error_code failed;
    if (view.showsAll()) {
        std::filesystem::remove(file, failed);
        return;
    }
    makeEditorFolder(project_);
    std::filesystem::create_directories(file.parent_path(), failed);
    Json json = Json::object();
    json["hidden"] = toJson(view.hidden());
    json["locked"] = toJson(view.locked());
    static_cast<void>(writeFile(file, writeJson(json)).ok());
}

}  // namespace plumb::editor
