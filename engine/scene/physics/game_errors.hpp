#pragma once

#include <string_view>

#include "core/result.hpp"
#include "scene/physics/physics_units.hpp"

namespace plumb {

/// Returns an error of the physics as authors of games know the matter: with the field of the component
/// instead of the function of the physics, in px instead of metres. Other errors are returned unchanged, also
/// those that were converted already.
/// @param component  type of the component whose value was refused; empty if the error tells
Error gameError(const Error& error, std::string_view component, PixelScale scale);

}  // namespace plumb
