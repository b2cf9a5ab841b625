#include "scene/files/scene_path.hpp"

#include "core/text.hpp"

namespace plumb {

std::string scenePath(std::string_view name) {
    constexpr std::string_view kFolder = "scenes/";
    const bool isFile = endsWith(name, ".scene.json") || endsWith(name, ".scene.bin");
    const bool hasFolder = isFile ? name.find('/') != std::string_view::npos : startsWith(name, kFolder);
    return format("{}{}{}", hasFolder ? "" : kFolder, name, isFile ? "" : ".scene.json");
}

}  // namespace plumb
