#include "editor/model/headless/windows_resources.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "editor/model/headless/icon_file.hpp"
#include "platform/image_file.hpp"
#include "platform/paths.hpp"

namespace plumb::editor {
namespace {

/// The first four numbers of a version: "1.2-rc3" is 1,2,3,0.
std::string fourNumbers(std::string_view version) {
    constexpr int kLargest = 65535;
    std::vector<int> numbers;
    bool inNumber = false;
    for (const char c : version) {
        const bool digit = c >= '0' && c <= '9';
        if (digit && !inNumber) numbers.push_back(0);
        if (digit) numbers.back() = std::min(numbers.back() * 10 + (c - '0'), kLargest);
        inNumber = digit;
    }
    numbers.resize(4);
    return format("{},{},{},{}", numbers[0], numbers[1], numbers[2], numbers[3]);
}

/// A text between quotes, without control characters, which a script cannot contain. Not L"...": windres
/// takes each of its bytes as a character.
std::string quotedText(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (static_cast<unsigned char>(c) < 32) continue;
        if (c == '"' || c == '\\') out += c == '"' ? '"' : '\\';
        out += c;
    }
    return out + "\"";
}

}  // namespace

std::string resourceScript(const Project& project) {
    const std::string numbers = fourNumbers(project.version);
    const std::pair<const char*, std::string> texts[] = {
        {"FileDescription", project.name},
        {"FileVersion", project.version},
        {"OriginalFilename", fileNameOf(project.name) + ".exe"},
        {"ProductName", project.name},
        {"ProductVersion", project.version}};
    std::string script = "#pragma code_page(65001)\n";  // UTF-8
    if (!project.icon.empty()) script += "1 ICON \"game.ico\"\n";
    script += format("1 VERSIONINFO\nFILEVERSION {}\nPRODUCTVERSION {}\n", numbers, numbers);
    script += "FILEOS 0x40004\nFILETYPE 1\n";  // Windows, a program
    script += "BEGIN\n  BLOCK \"StringFileInfo\"\n  BEGIN\n    BLOCK \"040904b0\"\n    BEGIN\n";
    for (const auto& [key, text] : texts) script += format("      VALUE \"{}\", {}\n", key, quotedText(text));
    // The language and the character set of the block above.
    return script +
           "    END\n  END\n  BLOCK \"VarFileInfo\"\n  BEGIN\n    VALUE \"Translation\", 0x409, 1200\n"
           "  END\nEND\n";
}

Result<Done> writeWindowsResources(const Project& project, const Path& folder) {
    if (!project.icon.empty()) {
        const Result<Path> file = pathInside(project.root, project.icon);
        if (!file) return file.error();
        const Result<std::string> bytes = readFile(*file);
        if (!bytes) return bytes.error();
        const Result<Image> picture = decodeImage(*bytes, project.icon);
        if (!picture) return picture.error();
        const Result<std::string> icon = iconFile(*picture, project.icon);
        if (!icon) return icon.error();
        if (Result<Done> done = writeFile(folder / "game.ico", *icon); !done) return done;
    }
    return writeFile(folder / "game.rc", resourceScript(project));
}

}  // namespace plumb::editor
