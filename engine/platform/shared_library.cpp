#include "platform/shared_library.hpp"

#include <SDL.h>

namespace plumb {

Result<SharedLibrary> SharedLibrary::load(const Path& file) {
    void* handle = SDL_LoadObject(file.string().c_str());
    if (handle == nullptr)
        return Error{file.generic_string(), SDL_GetError(), "build the code again: ./plumb edit PROJECT"};
    return SharedLibrary{handle};
}

void* SharedLibrary::address(const std::string& name) const {
    return SDL_LoadFunction(handle_, name.c_str());
}

}  // namespace plumb
