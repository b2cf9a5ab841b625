#include "editor/model/input/key_bindings.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"
#include "editor/model/actions.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"

namespace plumb::editor {
namespace {

struct ModifierName {
    std::string_view name;
    bool Shortcut::*held;
};
constexpr std::array kModifiers{ModifierName{"Ctrl", &Shortcut::control},
                                ModifierName{"Shift", &Shortcut::shift}, ModifierName{"Alt", &Shortcut::alt}};

/// True if both actions are available in the same editor state, so that equal keys would be ambiguous.
bool meet(const Action& a, const Action& b) { return a.during == b.during; }

}  // namespace

std::optional<Shortcut> shortcutFromText(std::string_view text) {
    Shortcut keys;
    const std::vector<std::string_view> words = split(text, '+');
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i + 1 == words.size()) {
            const std::optional<Key> key = keyFromName(words[i]);
            if (!key || *key == Key::None) return std::nullopt;
            keys.key = *key;
            return keys;
        }
        const auto modifier = std::find_if(kModifiers.begin(), kModifiers.end(),
                                           [&](const ModifierName& one) { return one.name == words[i]; });
        if (modifier == kModifiers.end()) return std::nullopt;
        keys.*modifier->held = true;
    }
    return std::nullopt;
}

std::vector<Shortcut> KeyBindings::of(const Action& action) const {
    if (const auto chosen = chosen_.find(action.id); chosen != chosen_.end()) return chosen->second;
    std::vector<Shortcut> keys;
    for (const Shortcut& one : {action.shortcut, action.alternative}) {
        if (one.key != Key::None) keys.push_back(one);
    }
    return keys;
}

Shortcut KeyBindings::shownOf(const Action& action) const {
    const auto chosen = chosen_.find(action.id);
    if (chosen == chosen_.end()) return action.shortcut;
    return chosen->second.empty() ? Shortcut{} : chosen->second.front();
}

bool KeyBindings::matches(const Action& action, const Event& event) const {
    const auto chosen = chosen_.find(action.id);
    if (chosen == chosen_.end()) return action.shortcut.matches(event) || action.alternative.matches(event);
    return std::any_of(chosen->second.begin(), chosen->second.end(),
                       [&](const Shortcut& keys) { return keys.matches(event); });
}

std::string KeyBindings::labelOf(const Action& action, std::string_view label) const {
    const std::string_view shown = label.empty() ? action.label : label;
    const std::string keys = shownOf(action).text();
    return keys.empty() ? std::string{shown} : format("{}  ({})", shown, keys);
}

void KeyBindings::bind(const Action& action, Shortcut keys) {
    while (const Action* other = conflict(action, keys)) {
        std::vector<Shortcut> rest = of(*other);
        std::erase(rest, keys);
        chosen_.insert_or_assign(std::string{other->id}, std::move(rest));
    }
    std::vector<Shortcut> mine = of(action);
    std::erase(mine, keys);
    if (mine.empty()) {
        mine.push_back(keys);
    } else {
        mine.front() = keys;
    }
    chosen_.insert_or_assign(std::string{action.id}, std::move(mine));
    if (!isChanged(action)) reset(action);
}

void KeyBindings::unbind(const Action& action) {
    chosen_.insert_or_assign(std::string{action.id}, std::vector<Shortcut>{});
    if (!isChanged(action)) reset(action);
}

void KeyBindings::reset(const Action& action) {
    if (const auto chosen = chosen_.find(action.id); chosen != chosen_.end()) chosen_.erase(chosen);
}

bool KeyBindings::isChanged(const Action& action) const {
    return chosen_.find(action.id) != chosen_.end() && of(action) != KeyBindings{}.of(action);
}

const Action* KeyBindings::conflict(const Action& action, Shortcut keys) const {
    if (keys.key == Key::None) return nullptr;
    for (const Action& other : actionTable()) {
        if (other.id.empty() || other.id == action.id || !meet(action, other)) continue;
        const std::vector<Shortcut> theirs = of(other);
        if (std::find(theirs.begin(), theirs.end(), keys) != theirs.end()) return &other;
    }
    return nullptr;
}

Json KeyBindings::toJson() const {
    Json json = Json::object();
    for (const auto& [id, keys] : chosen_) {
        Json texts = Json::array();
        for (const Shortcut& one : keys) texts.push_back(one.text());
        json[id] = std::move(texts);
    }
    return json;
}

KeyBindings KeyBindings::fromJson(const Json& json, const std::string& where, std::vector<Error>& problems) {
    KeyBindings bindings;
    if (!json.is_object()) {
        problems.push_back(
            {where,
             format("expected an object that maps action ids to lists of keys, found {}", json.type_name()),
             "the default keys are used"});
        return bindings;
    }
    for (const auto& [id, texts] : json.items()) {
        const Action* action = findAction(id);
        if (action == nullptr || !texts.is_array()) {
            problems.push_back(
                {where + "." + id,
                 action == nullptr ? "unknown action" : "expected a list of keys, e.g. [\"Ctrl+Shift+Z\"]",
                 "this entry is ignored"});
            continue;
        }
        std::vector<Shortcut> keys;
        for (const Json& text : texts) {
            const auto one = shortcutFromText(stringOrEmpty(text));
            if (one) {
                keys.push_back(*one);
            } else {
                problems.push_back(
                    {where + "." + id, "not a valid key combination", "write e.g. [\"Ctrl+Shift+Z\"]"});
            }
        }
        if (keys.empty() && !texts.empty()) continue;
        bindings.chosen_.insert_or_assign(id, std::move(keys));
    }
    return bindings;
}

}  // namespace plumb::editor
