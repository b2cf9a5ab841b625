#include "platform/paths.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <system_error>

#include <SDL.h>

#include "core/os.hpp"

namespace plumb {
namespace {

/// Converts and frees a path text from SDL; empty for null.
Path takePath(char* text) {
    Path path = text != nullptr ? Path{text} : Path{};
    SDL_free(text);
    return path;
}

/// True for a name of a device, which no file of Windows can have, whatever its ending is.
bool isDevice(std::string_view stem) {
    std::string upper;
    for (const char c : stem) upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    if (upper.size() == 4 && upper[3] >= '1' && upper[3] <= '9') upper[3] = '1';
    constexpr std::array<std::string_view, 6> kDevices{"CON", "PRN", "AUX", "NUL", "COM1", "LPT1"};
    return std::find(kDevices.begin(), kDevices.end(), upper) != kDevices.end();
}

Path findEngineAssets() {
    std::error_code ignored;
    const char* chosen = std::getenv("PLUMB_ASSETS");
    const Path beside = executableFolder();
    const std::array candidates{
        Path{chosen != nullptr ? chosen : ""},
        beside / "assets",
        beside / "../share/plumb/assets",  // where cmake --install puts them
        beside / "../../../assets",        // build/<preset>/bin/plumb-player
        Path{PLUMB_SOURCE_ASSETS},
    };
    for (const Path& candidate : candidates) {
        if (!candidate.empty() && folderExists(candidate / "fonts")) {
            return std::filesystem::weakly_canonical(candidate, ignored);
        }
    }
    return beside / "assets";
}

}  // namespace

Path executableFolder() {
    static const Path folder = takePath(SDL_GetBasePath());
    return folder.empty() ? Path{"."} : folder;
}

const Path& engineAssets() {
    static const Path folder = findEngineAssets();
    return folder;
}

Path codeGameFolder(const Path& program) {
    const Path beside = executableFolder();
    const Path inTree = beside / "../../../projects" / program;  // build/<preset>/bin/hello-code
    std::error_code ignored;
    for (const Path& candidate : {beside, inTree}) {
        if (!program.empty() && std::filesystem::is_directory(candidate / "assets", ignored))
            return std::filesystem::weakly_canonical(candidate, ignored);
    }
    return std::filesystem::current_path(ignored);
}

std::string fileNameOf(std::string_view game) {
    std::string name;
    for (const char c : game) {
        const bool isRefused = static_cast<unsigned char>(c) < 32 ||
                               std::string_view{"<>:\"/\\|?*"}.find(c) != std::string_view::npos;
        if (!isRefused) name += c;
    }
    // Windows ignores dots and spaces at the end of a name.
    while (!name.empty() && (name.back() == '.' || name.back() == ' ')) name.pop_back();
    if (name.empty() || name.front() == '.') return "game";
    std::string_view stem = std::string_view{name}.substr(0, name.find('.'));
    while (!stem.empty() && stem.back() == ' ') stem.remove_suffix(1);
    if (isDevice(stem)) name.insert(stem.size(), "_");
    return name;
}

Result<Path> dataFolder(std::string_view game) {
    constexpr const char* kWhere = "folder for saved games and settings";
    if (!os::findUserFolder())
        return Error{kWhere, "neither HOME nor XDG_DATA_HOME is set to an absolute path",
                     "set HOME, or name a folder with --saves DIR"};
    Path folder = takePath(SDL_GetPrefPath("", fileNameOf(game).c_str()));
    if (!folder.empty()) return folder;
    return Error{kWhere, SDL_GetError(), "check the permissions, or name another folder with --saves DIR"};
}

}  // namespace plumb
