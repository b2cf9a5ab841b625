#include "platform/open_file.hpp"

#include <string_view>

#include <SDL.h>

namespace plumb {

std::string urlOf(const Path& file) {
    constexpr std::string_view kPlain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._~/:";
    constexpr std::string_view kDigits = "0123456789ABCDEF";
    std::error_code failed;
    const std::string path = std::filesystem::absolute(file, failed).lexically_normal().generic_string();
    std::string url = path.empty() || path.front() != '/' ? "file:///" : "file://";
    for (const char letter : path) {
        const auto byte = static_cast<unsigned char>(letter);
        if (kPlain.find(letter) != std::string_view::npos) {
            url += letter;
        } else {
            url += {'%', kDigits[byte >> 4], kDigits[byte & 15]};
        }
    }
    return url;
}

Result<Done> openFile(const Path& file) {
    if (SDL_OpenURL(urlOf(file).c_str()) == 0) return Done{};
    return Error{file.generic_string(), SDL_GetError(), "assign a program to files of this type"};
}

}  // namespace plumb
