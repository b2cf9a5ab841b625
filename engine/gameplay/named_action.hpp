#pragma once

#include "core/text_store.hpp"
#include "input/action.hpp"

namespace plumb {

/// The action whose name a component holds.
inline Action actionNamed(TextId name) {
    Action action{""};
    action.id = name;
    return action;
}

}  // namespace plumb
