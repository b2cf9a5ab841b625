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

/// Returns the element of this name; null if there is none.
template <class Named>
const Named* named(const std::vector<Named>& list, std::string_view name) {
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const Named& each) { return each.name == name; });
    return at != list.end() ? &*at : nullptr;
}

}  // namespace

bool appendKey(const World& world, std::string_view name, std::string& out) {
    const Input* input = world.findResource<Input>();
    if (input == nullptr) return false;
    if (const ActionBindings* action = named(input->map().actions, name)) {
        append(out, action->bindings);
        return true;
    }
    const AxisBindings* axis = named(input->map().axes, name);
    if (axis == nullptr) return false;
    append(out, axis->negative);
    out.append("/");
    append(out, axis->positive);
    return true;
}

}  // namespace plumb
