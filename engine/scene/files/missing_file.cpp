#include "scene/files/missing_file.hpp"

#include <string>
#include <vector>

#include "core/text.hpp"

namespace plumb {
namespace {

/// Returns the name of a file without its folder and ending.
std::string_view stemOf(std::string_view path, std::string_view ending) {
    const std::string_view name = path.substr(path.rfind('/') + 1);
    return endsWith(name, ending) ? name.substr(0, name.size() - ending.size()) : name;
}

/// Returns the file whose name is closest to that of a path; empty if none is close.
std::string nearestFile(std::string_view path, const std::vector<std::string>& files,
                        std::string_view ending) {
    std::vector<std::string_view> names;
    for (const std::string& file : files) names.push_back(stemOf(file, ending));
    const std::string_view near = closestName(stemOf(path, ending), names);
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!near.empty() && names[i].data() == near.data()) return files[i];
    }
    return {};
}

}  // namespace

Error missingFile(const Path& root, std::string_view path, std::string_view ending) {
    std::vector<std::string> files = filesBelow(root, ending);
    // Hidden folders hold backups.
    std::erase_if(files, [](const std::string& file) {
        return startsWith(file, ".") || file.find("/.") != std::string::npos;
    });
    const std::string near = nearestFile(path, files, ending);
    return {std::string{path}, "there is no such file",
            near.empty() ? "check the name, or put the file there" : format("did you mean \"{}\"?", near)};
}

}  // namespace plumb
