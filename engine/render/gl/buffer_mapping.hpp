#pragma once

#include <cstddef>

namespace plumb {

/// Maps the beginning of the bound array buffer for writing, without waiting for the graphics card.
/// @return null where buffers cannot be mapped
void* mapArrayBuffer(std::size_t bytes);
void unmapArrayBuffer();

}  // namespace plumb
