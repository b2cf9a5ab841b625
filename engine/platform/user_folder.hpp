#pragma once

namespace plumb {

/// Prepares the environment for SDL_GetPrefPath(). Returns false if the system does not say where the files
/// of its user are.
bool findUserFolder();

}  // namespace plumb
