#include "gameplay/key_names.hpp"

#include <algorithm>
#include <vector>

#include "ecs/world.hpp"
#include "input/input.hpp"

namespace plumb {
namespace {

void append(std::string& out, const std::vector<Binding>& bindings) {
    const auto key = std::find_if(bindings.begin(), bindings.end(),
                                  [](const Binding& binding) { return binding.kind == BindingKind::Key; });
    if (bindings.empty()) {
        out.append("none");
    } else {
        out.append(toText(key != bindings.end() ? *key : bindings.front()));
    }
}

}  // namespace

bool appendKey(const World& world, std::string_view name, std::string& out) {
    const Input* input = world.findResource<Input>();
    if (input == nullptr) return false;
    const ActionMap& map = input->map();
    if (const int action = map.find(Action{name}); action >= 0) {
        append(out, map.actions[static_cast<std::size_t>(action)].bindings);
        return true;
    }
    const int axis = map.find(Axis{name});
    if (axis < 0) return false;
    append(out, map.axes[static_cast<std::size_t>(axis)].negative);
    out.append("/");
    append(out, map.axes[static_cast<std::size_t>(axis)].positive);
    return true;
}

}  // namespace plumb
