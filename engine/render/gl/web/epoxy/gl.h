#pragma once

// In place of libepoxy: WebGL 2 is OpenGL ES 3.0, which has all that Plumb uses of OpenGL 3.3 except for mapped buffers.

#include <GLES3/gl3.h>

inline int epoxy_gl_version() { return 33; }
