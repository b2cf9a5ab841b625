#include "editor/model/assets/rename_action.hpp"

#include <algorithm>
#include <utility>

#include "core/log.hpp"
#include "core/text.hpp"
#include "editor/model/assets/renamed_fields.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

constexpr const char* kProject = "project.json";

/// Returns the project's text with one member of an input list renamed, at the same position.
Result<std::string> projectWith(const std::string& text, const std::string& list, const std::string& from,
                                const std::string& to) {
    Result<Json> json = parseJson(text, kProject);
    if (!json) return json.error();
    const Error missing{kProject, format("the input map no longer contains \"{}\"", from),
                        "refresh the list and try again"};
    Json* input = findObject(*json, "input");
    Json* items = input == nullptr ? nullptr : findObject(*input, list);
    if (items == nullptr || !items->contains(from)) return missing;
    Json renamed = Json::object();
    for (const auto& [name, value] : items->items()) renamed[name == from ? to : name] = value;
    *items = std::move(renamed);
    return writeJson(*json);
}

}  // namespace

RenameAction::RenameAction(const PrefabEdit& edit, AssetStore& assets, std::string list, std::string field,
                           std::string from, std::string to, std::function<void()> written)
    : edit_{edit},
      assets_{assets},
      list_{std::move(list)},
      field_{std::move(field)},
      from_{std::move(from)},
      to_{std::move(to)},
      written_{std::move(written)} {}

std::string RenameAction::label() const { return format("rename {} {} to {}", field_, from_, to_); }

Result<std::vector<RenameAction::Rewritten>> RenameAction::rewritten(const Document& document,
                                                                     const std::string& from,
                                                                     const std::string& to) {
    // A file that this command wrote gets back exactly its bytes from before.
    const auto known = [&](const std::string& path, const std::string& now) -> const std::string* {
        for (const Rewritten& last : last_) {
            if (last.path == path && last.after == now) return &last.before;
        }
        return nullptr;
    };
    std::vector<Rewritten> files;
    Result<std::string> project = readFile(edit_.root / kProject);
    if (!project) return project.error();
    const std::string* bytes = known(kProject, *project);
    Result<std::string> renamed =
        bytes != nullptr ? Result<std::string>{*bytes} : projectWith(*project, list_, from, to);
    if (!renamed) return renamed.error();
    files.push_back({kProject, *std::move(project), *std::move(renamed)});
    const std::vector<NamingField> fields = namingFields(document.types(), field_);
    places_ = 0;
    for (const char* ending : {".scene.json", ".prefab.json"}) {
        for (const std::string& path : filesBelow(edit_.root, ending)) {
            Result<std::string> before = readFile(edit_.root / path);
            if (!before) return before.error();
            int times = 0;
            std::string after = withRenamedFields(*before, fields, from, to, times);
            if (times == 0) continue;
            places_ += times;
            if (const std::string* old = known(path, *before)) after = *old;
            files.push_back({path, *std::move(before), std::move(after)});
        }
    }
    return files;
}

Result<Done> RenameAction::writeAll(const std::vector<Rewritten>& files) const {
    for (std::size_t i = 0; i < files.size(); ++i) {
        const Result<Done> written = writeFile(edit_.root / files[i].path, files[i].after);
        if (written) continue;
        for (std::size_t done = 0; done < i; ++done)
            static_cast<void>(writeFile(edit_.root / files[done].path, files[done].before).ok());
        return written;
    }
    return Done{};
}

void RenameAction::renameInDocument(Document& document, const std::string& from, const std::string& to) {
    const TextId next = document.world.texts().add(to);
    for (const NamingField& naming : namingFields(document.types(), field_)) {
        std::vector<SetField::Change> changes;
        for (const ObjectId id : document.objects()) {
            const EntityId entity = document.find(id);
            if (!document.world.has(*naming.type, entity)) continue;
            const void* component = std::as_const(document.world).find(*naming.type, entity);
            if (*static_cast<const TextId*>(naming.field->in(component)) == textId(from))
                changes.push_back({id, FieldValue::of(next)});
        }
        if (!changes.empty()) SetField{*naming.type, *naming.field, std::move(changes)}.apply(document);
    }
}

bool RenameAction::rename(Document& document, const std::string& from, const std::string& to) {
    Result<std::vector<Rewritten>> files = rewritten(document, from, to);
    const Result<Done> written = files ? writeAll(*files) : Result<Done>{files.error()};
    if (!written) {
        problem_ = written.error();
        logError("Editor", problem_);
        return false;
    }
    last_ = *std::move(files);
    renameInDocument(document, from, to);
    if (edit_.prefabs != nullptr) edit_.prefabs->forget();
    static_cast<void>(assets_.pollChanges(assets_.size()));
    if (written_) written_();
    return true;
}

}  // namespace plumb::editor
