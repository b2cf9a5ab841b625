#include "scene/import/import_report.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb {

void ImportReport::note(std::string text) {
    if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(std::move(text));
}

std::string ImportReport::summary() const {
    const std::pair<int, const char*> counts[] = {
        {levels, "levels"},     {layers, "layers"}, {tiles, "tiles"}, {objects, "objects"},
        {tilesets, "tilesets"}, {images, "images"}, {clips, "clips"}};
    std::string text = scene + ":";
    for (const auto& [count, name] : counts) {
        if (count == 0) continue;
        std::string_view word = name;
        if (count == 1) word.remove_suffix(1);
        text += format("{} {} {}", text.back() == ':' ? "" : ",", count, word);
    }
    if (text.back() == ':') text += " empty";
    return text;
}

std::string ImportReport::text() const {
    std::string text = summary();
    if (problems.empty()) {
        text += "; nothing was left out\n";
    } else {
        text += format("; {} {}:\n", problems.size(), problems.size() == 1 ? "problem" : "problems");
    }
    for (const Error& problem : problems) text += "  " + problem.text() + "\n";
    for (const std::string& note : notes) text += "  note: " + note + "\n";
    return text;
}

}  // namespace plumb
