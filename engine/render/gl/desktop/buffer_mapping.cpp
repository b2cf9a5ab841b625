#include "render/gl/buffer_mapping.hpp"

#include <epoxy/gl.h>

namespace plumb {

void* mapArrayBuffer(std::size_t bytes) {
    return glMapBufferRange(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes),
                            GL_MAP_WRITE_BIT | GL_MAP_UNSYNCHRONIZED_BIT);
}

void unmapArrayBuffer() { glUnmapBuffer(GL_ARRAY_BUFFER); }

}  // namespace plumb
