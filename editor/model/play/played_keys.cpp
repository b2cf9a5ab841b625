#include "editor/model/play/played_keys.hpp"

#include <optional>
#include <string>

#include "editor/model/workspace.hpp"
#include "input/input.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

/// The key bindings to use in the running game. A resource of the document's world, which outlives the
/// game's.
struct WantedKeys {
    std::optional<ActionMap> map;
};

/// A fake component type that marks changes of key bindings in `PlayEdits`. No entity has such a component,
/// and no scene stores it.
const TypeInfo& keysType() {
    static const TypeInfo kType = [] {
        TypeInfo type;
        type.name = "Input";
        FieldInfo& field = type.fields.emplace_back();
        field.name = "keys";
        field.kind = FieldKind::Text;
        field.transient = true;
        return type;
    }();
    return kType;
}

FieldValue valueOf(const ActionMap& keys) {
    const std::string text = compactText(toJson(keys));
    const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
    return {std::vector<std::byte>(bytes, bytes + text.size())};
}

}  // namespace

void setPlayedKeys(Workspace& workspace, const ActionMap& keys) {
    if (!workspace.play.running()) return;
    workspace.document.world.resource<WantedKeys>().map = keys;
    updatePlayedKeys(workspace);
}

void updatePlayedKeys(Workspace& workspace) {
    PlayMode& play = workspace.play;
    const WantedKeys* wanted = workspace.document.world.findResource<WantedKeys>();
    if (wanted == nullptr || !wanted->map || !play.running() || play.inPast()) return;
    const Input* input = play.world().findResource<Input>();
    if (input != nullptr && input->map() != *wanted->map)
        play.edit({}, keysType(), keysType().fields.front(), valueOf(*wanted->map));
}

void clearPlayedKeys(Workspace& workspace) { workspace.document.world.resource<WantedKeys>().map.reset(); }

bool isOfKeys(const PlayEdit& edit) { return edit.type == &keysType(); }

void writeKeys(World& world, const PlayEdit& edit) {
    Input* input = world.findResource<Input>();
    if (input == nullptr) return;
    const std::string_view text{reinterpret_cast<const char*>(edit.value.bytes.data()),
                                edit.value.bytes.size()};
    std::vector<Error> problems;
    if (const Result<Json> json = parseJson(text, "keys"))
        input->setMap(actionMapFromJson(*json, "keys", problems));
}

}  // namespace plumb::editor
