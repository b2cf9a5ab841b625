#pragma once

namespace plumb {

// OpenGL differs between desktops (3.3 core) and the web (WebGL 2, which is OpenGL ES 3.0).

/// Chooses the profile of contexts created from now on. Call it before the window is created: the window's
/// pixel format depends on it.
void requestGlProfile();

/// True if the driver has given up the current context, e.g. because the graphics device hung and was reset:
/// drawing does nothing any more. False where the driver does not tell.
[[nodiscard]] bool isContextLost();

/// The first line of a shader, with its line break.
[[nodiscard]] const char* shaderVersion();

}  // namespace plumb
