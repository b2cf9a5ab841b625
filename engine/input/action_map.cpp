#include "input/action_map.hpp"

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "core/assert.hpp"
#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

std::vector<Binding> bindingsOf(std::initializer_list<std::string_view> texts) {
    std::vector<Binding> bindings;
    for (const std::string_view text : texts) {
        const std::optional<Binding> binding = bindingFromText(text);
        PLUMB_ASSERT(binding.has_value(), "a default binding has an unknown name; see platform/key.cpp");
        bindings.push_back(*binding);
    }
    return bindings;
}

template <class Named>
int indexOf(const std::vector<Named>& items, TextId id) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (textId(items[i].name) == id) return static_cast<int>(i);
    }
    return -1;
}

/// Returns the item of that name, which is added if it is new; null if the limit is reached.
template <class Named>
Named* itemFor(std::vector<Named>& items, std::string_view name, std::size_t limit) {
    if (const int index = indexOf(items, textId(name)); index >= 0)
        return &items[static_cast<std::size_t>(index)];
    if (items.size() == limit) return nullptr;
    items.push_back({});
    items.back().name = name;
    return &items.back();
}

void readBinding(const Json& json, const std::string& where, std::vector<Binding>& bindings,
                 std::vector<Error>& problems) {
    const std::string text = json.is_string() ? stringOrEmpty(json) : briefText(json);
    const std::optional<Binding> binding = json.is_string() ? bindingFromText(text) : std::nullopt;
    if (binding) {
        bindings.push_back(*binding);
        return;
    }
    const std::string meant = text.size() <= 40 ? closestBinding(text) : std::string{};
    problems.push_back({where, format("no key, button or stick is named \"{}\"", text.substr(0, 40)),
                        meant.empty() ? "write e.g. \"Space\", \"Mouse Left\" or \"Pad A\""
                                      : format("did you mean \"{}\"?", meant)});
}

/// @param former  returned if the list has entries and none of them is valid
std::vector<Binding> readBindings(const Json& list, const std::string& where,
                                  const std::vector<Binding>& former, std::vector<Error>& problems) {
    std::vector<Binding> bindings;
    if (!list.is_array()) {
        problems.push_back(
            {where, "expected a list, found " + briefText(list), "write [\"Space\", \"Pad A\"]"});
        return former;
    }
    for (const Json& item : list) {
        if (bindings.size() == ActionMap::kMaxBindings) {
            problems.push_back(
                {where, format("more than {} bindings", ActionMap::kMaxBindings), "remove some"});
            break;
        }
        readBinding(item, where, bindings, problems);
    }
    return bindings.empty() && !list.empty() ? former : bindings;
}

void readActions(JsonFields& fields, ActionMap& map, std::vector<Error>& problems) {
    const Json* actions = fields.find("actions");
    if (actions == nullptr) return;
    if (!actions->is_object()) {
        fields.warn("actions", "expected an object, found " + briefText(*actions),
                    "write { \"Jump\": [\"Space\"] }");
        return;
    }
    for (const auto& [name, list] : actions->items()) {
        const std::string where = format("{}.actions.{}", fields.where(), name.substr(0, 80));
        if (ActionBindings* action = itemFor(map.actions, name, ActionMap::kMaxActions)) {
            action->bindings = readBindings(list, where, action->bindings, problems);
        } else {
            problems.push_back(
                {where, format("more than {} actions", ActionMap::kMaxActions), "remove some"});
        }
    }
}

void readAxis(const Json& json, const std::string& where, AxisBindings& axis, std::vector<Error>& problems) {
    JsonFields fields{json, where, problems};
    const auto read = [&](std::string_view key, std::vector<Binding>& bindings) {
        if (const Json* list = fields.find(key))
            bindings = readBindings(*list, format("{}.{}", where, key), bindings, problems);
    };
    read("negative", axis.negative);
    read("positive", axis.positive);
    read("analog", axis.analog);
    fields.warnUnknown();
}

void readAxes(JsonFields& fields, ActionMap& map, std::vector<Error>& problems) {
    const Json* axes = fields.find("axes");
    if (axes == nullptr) return;
    if (!axes->is_object()) {
        fields.warn("axes", "expected an object, found " + briefText(*axes),
                    "write { \"Horizontal\": { ... } }");
        return;
    }
    for (const auto& [name, value] : axes->items()) {
        const std::string where = format("{}.axes.{}", fields.where(), name.substr(0, 80));
        if (AxisBindings* axis = itemFor(map.axes, name, ActionMap::kMaxAxes)) {
            readAxis(value, where, *axis, problems);
        } else {
            problems.push_back({where, format("more than {} axes", ActionMap::kMaxAxes), "remove some"});
        }
    }
}

Json listJson(const std::vector<Binding>& bindings) {
    Json list = Json::array();
    for (const Binding binding : bindings) list.push_back(toText(binding));
    return list;
}

}  // namespace

ActionMap ActionMap::defaults() {
    ActionMap map;
    map.actions = {
        {"Jump", bindingsOf({"Space", "W", "Up", "Pad A"})},
        {"Attack", bindingsOf({"X", "J", "Mouse Left", "Pad X"})},
        {"Interact", bindingsOf({"E", "Down", "Pad Y"})},
        {"Confirm", bindingsOf({"Enter", "PadEnter", "Space", "Pad A", "Pad Start"})},
        {"Cancel", bindingsOf({"Escape", "Backspace", "Pad B"})},
        {"Pause", bindingsOf({"Escape", "P", "Pad Start"})},
    };
    map.axes = {
        {"Horizontal", bindingsOf({"Left", "A", "Pad Left"}), bindingsOf({"Right", "D", "Pad Right"}),
         bindingsOf({"Pad LeftX"})},
        {"Vertical", bindingsOf({"Up", "W", "Pad Up"}), bindingsOf({"Down", "S", "Pad Down"}),
         bindingsOf({"Pad LeftY"})},
    };
    return map;
}

int ActionMap::find(Action action) const { return indexOf(actions, action.id); }
int ActionMap::find(Axis axis) const { return indexOf(axes, axis.id); }

void ActionMap::bind(std::string_view action, std::vector<Binding> bindings) {
    ActionBindings* item = itemFor(actions, action, kMaxActions);
    PLUMB_ASSERT(item != nullptr, "a map holds at most kMaxActions actions");
    if (item != nullptr) item->bindings = std::move(bindings);
}

ActionMap actionMapFromJson(const Json& json, std::string_view where, std::vector<Error>& problems) {
    ActionMap map = ActionMap::defaults();
    JsonFields fields{json, std::string{where}, problems};
    readActions(fields, map, problems);
    readAxes(fields, map, problems);
    map.deadZone = fields.number("deadZone", map.deadZone, 0.0f, 0.95f);
    fields.warnUnknown();
    return map;
}

namespace {

/// Removes the items that a file has added to a map.
template <class Item>
void dropUnknown(std::vector<Item>& items, std::size_t known, const char* kind, std::string_view where,
                 std::vector<Error>& problems) {
    for (std::size_t i = known; i < items.size(); ++i)
        problems.push_back({std::string{where}, format("the game has no {} \"{}\"", kind, items[i].name),
                            "its keys were left out"});
    if (items.size() > known) items.resize(known);
}

Json axisJson(const AxisBindings& axis) {
    Json item = Json::object();
    item["negative"] = listJson(axis.negative);
    item["positive"] = listJson(axis.positive);
    item["analog"] = listJson(axis.analog);
    return item;
}

}  // namespace

ActionMap reboundFromJson(const ActionMap& base, const Json& json, std::string_view where,
                          std::vector<Error>& problems) {
    ActionMap map = base;
    JsonFields fields{json, std::string{where}, problems};
    readActions(fields, map, problems);
    readAxes(fields, map, problems);
    fields.warnUnknown();
    dropUnknown(map.actions, base.actions.size(), "action", where, problems);
    dropUnknown(map.axes, base.axes.size(), "axis", where, problems);
    return map;
}

Json bindingChanges(const ActionMap& base, const ActionMap& map) {
    Json actions = Json::object(), axes = Json::object();
    for (std::size_t i = 0; i < map.actions.size(); ++i) {
        if (i >= base.actions.size() || map.actions[i] != base.actions[i])
            actions[map.actions[i].name] = listJson(map.actions[i].bindings);
    }
    for (std::size_t i = 0; i < map.axes.size(); ++i) {
        if (i >= base.axes.size() || map.axes[i] != base.axes[i])
            axes[map.axes[i].name] = axisJson(map.axes[i]);
    }
    Json json = Json::object();
    json["actions"] = std::move(actions);
    json["axes"] = std::move(axes);
    return json;
}

Json toJson(const ActionMap& map) {
    Json json = Json::object();
    Json& actions = json["actions"] = Json::object();
    for (const ActionBindings& action : map.actions) actions[action.name] = listJson(action.bindings);
    Json axes = Json::object();
    for (const AxisBindings& axis : map.axes) {
        axes[axis.name] = axisJson(axis);
    }
    json["axes"] = std::move(axes);
    json["deadZone"] = map.deadZone;
    return json;
}

}  // namespace plumb
