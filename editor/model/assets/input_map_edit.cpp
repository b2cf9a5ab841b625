#include "editor/model/assets/input_map_edit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/text.hpp"
#include "editor/model/assets/rename_action.hpp"
#include "editor/model/commands/write_asset.hpp"
#include "editor/model/input/key_words.hpp"
#include "editor/model/play/played_keys.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kFile = "project.json";
constexpr std::string_view kParts[] = {"negative", "positive", "analog"};
constexpr std::size_t kLongestName = 40;
constexpr float kPushed = 0.6f;  // deflection from which a stick counts as pushed, as a ratio of its range

using Kind = InputMapEdit::Kind;

std::string keyOf(Kind kind) { return kind == Kind::Action ? "actions" : "axes"; }
std::string_view nameOf(Kind kind) { return kind == Kind::Action ? "action" : "axis"; }

Json listOf(const std::vector<Binding>& bindings) {
    Json list = Json::array();
    for (const Binding binding : bindings) list.push_back(toText(binding));
    return list;
}

std::string counted(std::size_t count, std::string_view what) {
    return format("{} {}{}", count, what, count == 1 ? "" : "s");
}

bool isNamed(const Json& project, Kind kind, const std::string& name) {
    const Json* input = findMember(project, "input");
    const Json* list = input == nullptr ? nullptr : findMember(*input, keyOf(kind));
    return list != nullptr && findMember(*list, name) != nullptr;
}

bool isDefault(Kind kind, std::string_view name) {
    const ActionMap map = ActionMap::defaults();
    return kind == Kind::Action ? map.find(plumb::Action{name}) >= 0 : map.find(Axis{name}) >= 0;
}

}  // namespace

const std::string& InputMapEdit::refresh() {
    Result<std::string> text = readFile(workspace_.project.root / kFile);
    std::string now = text ? *std::move(text) : std::string{"{}"};
    if (text_ == now) return problem_;
    const bool known = text_.has_value();  // false: this is the first read, so nothing changed
    text_ = std::move(now);
    rows_.clear();
    problem_.clear();
    const Result<Json> json = parseJson(*text_, kFile);
    readable_ = json && json->is_object();
    if (!readable_) {
        problem_ = json ? "project.json is not a JSON object" : json.error().text();
        return problem_;
    }
    project_ = *json;
    const Json* input = findMember(project_, "input");
    std::vector<Error> problems;
    const ActionMap map =
        actionMapFromJson(input == nullptr ? Json::object() : *input, "project.json: input", problems);
    if (!problems.empty()) problem_ = problems.front().text();
    if (known) setPlayedKeys(workspace_, map);
    for (const ActionBindings& action : map.actions) {
        rows_.push_back({Kind::Action,
                         action.name,
                         isNamed(project_, Kind::Action, action.name),
                         {{"", action.bindings}}});
    }
    for (const AxisBindings& axis : map.axes) {
        rows_.push_back(
            {Kind::Axis,
             axis.name,
             isNamed(project_, Kind::Axis, axis.name),
             {{"negative", axis.negative}, {"positive", axis.positive}, {"analog", axis.analog}}});
    }
    return problem_;
}

const InputMapEdit::Row* InputMapEdit::find(Kind kind, std::string_view name) const {
    const auto found = std::find_if(rows_.begin(), rows_.end(),
                                    [&](const Row& row) { return row.kind == kind && row.name == name; });
    return found == rows_.end() ? nullptr : &*found;
}

const InputMapEdit::Part* InputMapEdit::find(const Place& place) const {
    const Row* row = find(place.kind, place.name);
    if (row == nullptr) return nullptr;
    for (const Part& part : row->parts) {
        if (part.key == place.part) return &part;
    }
    return nullptr;
}

std::vector<std::string> InputMapEdit::othersOf(Binding binding, const Place& but) const {
    std::vector<std::string> others;
    for (const Row& row : rows_) {
        for (const Part& part : row.parts) {
            if (row.kind == but.kind && row.name == but.name && part.key == but.part) continue;
            if (std::find(part.bindings.begin(), part.bindings.end(), binding) == part.bindings.end())
                continue;
            others.push_back(part.key.empty() ? row.name : format("{}, {}", row.name, part.key));
        }
    }
    return others;
}

std::size_t InputMapEdit::shared() const {
    std::vector<std::string> known;
    for (const Row& row : rows_) {
        for (const Part& part : row.parts) {
            for (const Binding binding : part.bindings) {
                if (!othersOf(binding, {row.kind, row.name, part.key}).empty())
                    known.push_back(toText(binding));
            }
        }
    }
    std::sort(known.begin(), known.end());
    return static_cast<std::size_t>(std::unique(known.begin(), known.end()) - known.begin());
}

Result<Done> InputMapEdit::checkName(Kind kind, std::string_view name) const {
    if (name.empty() || name.size() > kLongestName || trimmed(name) != name)
        return Error{std::string{name}, "this is not a valid name", "use a name like \"Dash\""};
    if (find(kind, name) != nullptr)
        return Error{std::string{name}, format("an {} with this name exists", nameOf(kind)),
                     "choose another name"};
    return Done{};
}

Result<Done> InputMapEdit::add(Kind kind, std::string_view name) {
    if (Result<Done> can = ready(); !can) return can;
    if (Result<Done> good = checkName(kind, name); !good) return good;
    Json project = project_;
    Json& item = makeObject(makeObject(project, "input"), keyOf(kind))[std::string{name}];
    item = Json::array();
    if (kind == Kind::Axis) {
        item = Json::object();
        for (const std::string_view part : kParts) item[std::string{part}] = Json::array();
    }
    return write(format("add {} {}", nameOf(kind), name), std::move(project));
}

Result<Done> InputMapEdit::rename(Kind kind, const std::string& from, std::string_view to) {
    if (Result<Done> can = ready(); !can) return can;
    if (from == to) return Done{};
    if (!workspace_.canEdit())
        return Error{from, "the game is running",
                     format("stop it first ({})", keysFor(workspace_, "run.play"))};
    if (!isNamed(project_, kind, from) || isDefault(kind, from))
        return Error{from, "an engine default cannot be renamed", "add a new one with the same keys"};
    if (Result<Done> good = checkName(kind, to); !good) return good;
    Workspace& w = workspace_;
    w.undo.endGesture();
    auto command =
        std::make_unique<RenameAction>(w.prefabs(), w.assets, keyOf(kind), std::string{nameOf(kind)}, from,
                                       std::string{to}, [&w] { w.safety.opened(); });
    const RenameAction& made = *command;
    w.undo.push(std::move(command));
    w.undo.endGesture();
    refresh();
    if (!made.done()) {
        const Error problem = made.problem();
        w.undo.undo();
        return problem;
    }
    w.notice = made.places() == 0 ? format("Renamed {} to {}; no scene or prefab references it", from, to)
                                  : format("Renamed {} to {}, also in {} of {}; press {} to undo", from, to,
                                           counted(static_cast<std::size_t>(made.places()), "place"),
                                           counted(made.files(), "file"), keysFor(w, "edit.undo"));
    return Done{};
}

Result<Done> InputMapEdit::remove(Kind kind, const std::string& name) {
    if (Result<Done> can = ready(); !can) return can;
    if (!isNamed(project_, kind, name))
        return Error{name, "an engine default cannot be removed", "remove its keys instead"};
    Json project = project_;
    makeObject(makeObject(project, "input"), keyOf(kind)).erase(name);
    return write(
        isDefault(kind, name) ? format("reset keys of {}", name) : format("remove {} {}", nameOf(kind), name),
        std::move(project));
}

Json InputMapEdit::withList(const Place& place, const std::vector<Binding>& bindings) const {
    Json project = project_;
    Json& all = makeObject(makeObject(project, "input"), keyOf(place.kind));
    if (place.kind == Kind::Action) {
        all[place.name] = listOf(bindings);
    } else {
        makeObject(all, place.name)[place.part] = listOf(bindings);
    }
    return project;
}

Result<Done> InputMapEdit::bind(const Place& place, Binding binding) {
    if (Result<Done> can = ready(); !can) return can;
    const Part* part = find(place);
    if (part == nullptr)
        return Error{place.name, "this list of keys does not exist", "add the action or axis first"};
    const bool half = binding.kind == BindingKind::PadAxisPlus || binding.kind == BindingKind::PadAxisMinus;
    if (place.part == "analog" && half) binding.kind = BindingKind::PadAxis;  // both directions of the stick
    if (std::find(part->bindings.begin(), part->bindings.end(), binding) != part->bindings.end())
        return Error{toText(binding), format("{} already has this binding", place.name), "press another one"};
    if (part->bindings.size() == ActionMap::kMaxBindings)
        return Error{place.name, format("it already has {} bindings", ActionMap::kMaxBindings),
                     "remove one first"};
    std::vector<Binding> bindings = part->bindings;
    bindings.push_back(binding);
    return write(format("bind {} to {}", toText(binding), place.name), withList(place, bindings));
}

Result<Done> InputMapEdit::unbind(const Place& place, std::size_t index) {
    if (Result<Done> can = ready(); !can) return can;
    const Part* part = find(place);
    if (part == nullptr || index >= part->bindings.size())
        return Error{place.name, "this binding no longer exists", "check the list again"};
    std::vector<Binding> bindings = part->bindings;
    const std::string text = toText(bindings[index]);
    bindings.erase(bindings.begin() + static_cast<std::ptrdiff_t>(index));
    return write(format("unbind {} from {}", text, place.name), withList(place, bindings));
}

Result<Done> InputMapEdit::ready() {
    refresh();
    if (!readable_) return Error{std::string{kFile}, "the file cannot be read", "correct it first"};
    return Done{};
}

Result<Done> InputMapEdit::write(std::string label, Json project) {
    workspace_.notice = format("{}: written to project.json", label);
    workspace_.undo.push(std::make_unique<WriteAsset>(std::move(label), workspace_.project.root,
                                                      workspace_.assets, std::string{kFile},
                                                      writeJson(project)));
    workspace_.undo.endGesture();
    refresh();
    return Done{};
}

std::optional<Binding> bindingOf(const Event& event) {
    const auto binding = [](BindingKind kind, auto code) {
        return Binding{kind, static_cast<std::uint8_t>(code)};
    };
    switch (event.kind) {
        case EventKind::KeyDown:
            if (event.repeated || event.key == Key::None) return std::nullopt;
            return binding(BindingKind::Key, event.key);
        case EventKind::MouseDown: return binding(BindingKind::MouseButton, event.mouseButton);
        case EventKind::PadDown: return binding(BindingKind::PadButton, event.padButton);
        case EventKind::PadAxisMoved:
            if (std::abs(event.value) < kPushed) return std::nullopt;
            return binding(event.value > 0.0f ? BindingKind::PadAxisPlus : BindingKind::PadAxisMinus,
                           event.padAxis);
        default: return std::nullopt;
    }
}

}  // namespace plumb::editor
