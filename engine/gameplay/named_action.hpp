#pragma once

#include "core/text_store.hpp"
#include "input/action.hpp"

namespace plumb {

/// Returns the input action with this name.
inline Action actionNamed(TextId name) {
    Action action{""};
    action.id = name;
    return action;
}

}  // namespace plumb
