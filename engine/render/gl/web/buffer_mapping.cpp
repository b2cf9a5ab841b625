#include "render/gl/buffer_mapping.hpp"

namespace plumb {

void* mapArrayBuffer(std::size_t) { return nullptr; }

void unmapArrayBuffer() {}

}  // namespace plumb
