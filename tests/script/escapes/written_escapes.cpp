#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/script/escapes/escape.hpp"
#include "tests/support/places.hpp"

namespace plumb::test {
namespace {

/// Reads the line `--# name | error: part`.
Escape readHead(const std::string& line) {
    constexpr std::size_t kMark = 4;
    const std::size_t bar = line.find(" | ");
    const std::size_t colon = line.find(": ", bar);
    return {line.substr(kMark, bar - kMark), "", line.substr(bar + 3, colon - bar - 3) == "error",
            line.substr(colon + 2)};
}

void readFile(const std::filesystem::path& path, std::vector<Escape>& escapes) {
    std::ifstream file{path};
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("--# ")) {
            escapes.push_back(readHead(line));
        } else if (!escapes.empty()) {
            escapes.back().script += line + "\n";
        }
    }
}

}  // namespace

std::vector<Escape> writtenEscapes() {
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator{sourceFolder() / "tests/script/escapes"}) {
        if (entry.path().extension() == ".lua") paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    std::vector<Escape> escapes;
    for (const std::filesystem::path& path : paths) readFile(path, escapes);
    return escapes;
}

}  // namespace plumb::test
