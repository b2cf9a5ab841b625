#pragma once

namespace plumb {

// OpenGL differs between desktops (3.3 core) and the web (WebGL 2, which is OpenGL ES 3.0).

/// Chooses the profile of contexts created from now on. Call it before the window is created: the window's
/// pixel format depends on it.
void requestGlProfile();

// A driver gives up the context e.g. because the graphics device hung and was reset. A browser may take it
// away at any time, e.g. while the page is hidden, and give it back later: then every object made before is
// gone.

/// True while drawing does nothing because the context is lost. False where the driver does not tell.
[[nodiscard]] bool isContextLost();
[[nodiscard]] bool canContextReturn();      ///< true in browsers
[[nodiscard]] unsigned contextsRestored();  ///< how often it was given back

/// The first line of a shader, with its line break.
[[nodiscard]] const char* shaderVersion();

}  // namespace plumb
