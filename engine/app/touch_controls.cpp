#include "app/touch_controls.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "platform/key.hpp"
#include "platform/key_codes.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"

namespace plumb {
namespace {

std::optional<Key> firstKey(std::span<const Binding> bindings) {
    const auto isKey = [](const Binding& binding) { return binding.kind == BindingKind::Key; };
    const auto found = std::find_if(bindings.begin(), bindings.end(), isKey);
    return found == bindings.end() ? std::nullopt : std::optional{static_cast<Key>(found->code)};
}

Json keyJson(Key key) { return {{"key", std::string{nameOf(key)}}, {"usage", usageOf(key)}}; }

}  // namespace

std::string touchControls(const ActionMap& map, const Input::Asked& asked) {
    Json axes = Json::array();
    Json actions = Json::array();
    std::set<Key> used;
    for (std::size_t i = 0; i < map.axes.size(); ++i) {
        const AxisBindings& axis = map.axes[i];
        const std::optional<Key> negative = firstKey(axis.negative), positive = firstKey(axis.positive);
        if ((asked.axes >> i & 1) == 0 || !negative || !positive) continue;
        axes.push_back(
            {{"name", axis.name}, {"negative", keyJson(*negative)}, {"positive", keyJson(*positive)}});
    }
    for (std::size_t i = 0; i < map.actions.size(); ++i) {
        const ActionBindings& action = map.actions[i];
        const std::optional<Key> key = firstKey(action.bindings);
        if ((asked.actions >> i & 1) == 0 || !key || !used.insert(*key).second) continue;
        Json button{{"name", action.name}};
        button.update(keyJson(*key));
        actions.push_back(std::move(button));
    }
    return compactText({{"axes", std::move(axes)}, {"actions", std::move(actions)}});
}

bool TouchControls::look(Input& input) {
    const std::string before = std::exchange(text_, touchControls(input.map(), input.takeAsked()));
    return text_ != before;
}

}  // namespace plumb
