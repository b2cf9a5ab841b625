#include "import/import_file.hpp"

#include <algorithm>
#include <array>

#include "core/guarded.hpp"
#include "core/text.hpp"
#include "import/import_aseprite.hpp"
#include "import/import_ldtk.hpp"
#include "import/import_tiled.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

struct Ending {
    std::string_view text;
    ImportKind kind;
};
constexpr std::array kEndings{
    Ending{".tmx", ImportKind::TiledMap},    Ending{".tmj", ImportKind::TiledMap},
    Ending{".tmx.gz", ImportKind::TiledMap}, Ending{".world", ImportKind::TiledWorld},
    Ending{".ldtk", ImportKind::Ldtk},
};

ImportKind kindOfJson(const Path& file) {
    const Result<std::string> text = readFile(file);
    std::vector<Error> ignored;
    const Result<Json> json = text ? parseJson(*text, "", &ignored) : Result<Json>{text.error()};
    if (!json || !json->is_object()) return ImportKind::None;
    if (json->contains("frames") && json->contains("meta")) return ImportKind::Aseprite;
    if (json->contains("jsonVersion") && json->contains("defs")) return ImportKind::Ldtk;
    if (json->contains("layers") && json->contains("tilewidth")) return ImportKind::TiledMap;
    const std::string* type = findText(*json, "type");
    const bool isWorld = json->contains("maps") && type != nullptr && *type == "world";
    return isWorld ? ImportKind::TiledWorld : ImportKind::None;
}

std::string stemOf(const Path& file) {
    std::string name = file.filename().string();
    name = name.substr(0, name.find('.'));
    for (char& c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                           c == '-' || c == '_';
        if (!plain) c = '_';
    }
    return name.empty() ? "imported" : name;
}

Result<ImportReport> importOf(ImportKind kind, const Path& file, const Path& to) {
    switch (kind) {
        case ImportKind::TiledMap: return importTiled(file, to);
        case ImportKind::TiledWorld: return importTiledWorld(file, to);
        case ImportKind::Ldtk: return importLdtk(file, to);
        case ImportKind::Aseprite: return importAseprite(file, to);
        case ImportKind::None: break;
    }
    return Error{
        file.generic_string(), "this kind of file cannot be imported",
        "select a Tiled map or world (.tmx, .tmj, .world), an LDtk project (.ldtk) or an Aseprite sheet "
        "(.json)"};
}

}  // namespace

ImportKind importKindOf(const Path& file) {
    const std::string name = file.filename().string();
    for (const Ending& ending : kEndings) {
        if (endsWith(name, ending.text)) return ending.kind;
    }
    return endsWith(name, ".json") ? kindOfJson(file) : ImportKind::None;
}

bool mayBeImported(const Path& file) {
    const std::string name = file.filename().string();
    const auto ours = {".scene.json", ".prefab.json", ".tileset.json", ".anim.json", "project.json"};
    const bool isOurs =
        std::any_of(ours.begin(), ours.end(), [&](const char* end) { return endsWith(name, end); });
    const bool known = std::any_of(kEndings.begin(), kEndings.end(),
                                   [&](const Ending& e) { return endsWith(name, e.text); });
    return known || (endsWith(name, ".json") && !isOurs);
}

Path importTarget(const Path& file, ImportKind kind, const Path& project) {
    if (kind == ImportKind::Aseprite) return project / "assets" / (stemOf(file) + ".anim.json");
    return project / "scenes" / (stemOf(file) + ".scene.json");
}

Result<ImportReport> importFile(const Path& file, const Path& target, const Path& project) {
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return Error{file.generic_string(), "the file does not exist", "check the path"};
    const ImportKind kind = importKindOf(file);
    const Path to = target.empty() ? importTarget(file, kind, project) : target;
    return guarded(file.generic_string(), [&] { return importOf(kind, file, to); });
}

}  // namespace plumb
