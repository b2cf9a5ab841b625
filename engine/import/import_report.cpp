#include "import/import_report.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/text.hpp"

namespace plumb {

void ImportReport::note(std::string text) {
    if (std::find(notes.begin(), notes.end(), text) == notes.end()) notes.push_back(std::move(text));
}

void ImportReport::addEditorKeys(std::string_view owner, const std::set<std::string>& keys) {
    editor = owner;
    editorKeys.insert(keys.begin(), keys.end());
}

std::vector<Error> ImportReport::foldedProblems() const {
    std::vector<Error> folded;
    // Key: text and remedy. Value: index in `folded`, and number of further places.
    std::map<std::pair<std::string, std::string>, std::pair<std::size_t, int>> known;
    for (const Error& problem : problems) {
        const auto [at, isNew] = known.try_emplace({problem.what, problem.remedy}, folded.size(), 0);
        if (isNew) {
            folded.push_back(problem);
        } else if (folded[at->second.first].where != problem.where) {
            ++at->second.second;
        }
    }
    for (const auto& [what, place] : known) {
        const auto [index, more] = place;
        if (more > 0) folded[index].where += format(" and {} more {}", more, more == 1 ? "place" : "places");
    }
    return folded;
}

std::string ImportReport::leftOut() const {
    if (editorKeys.empty()) return {};
    constexpr std::size_t kShown = 3;
    std::string some;
    for (auto at = editorKeys.begin(); at != editorKeys.end(); ++at) {
        if (std::distance(editorKeys.begin(), at) == kShown) break;
        some += (some.empty() ? "" : ", ") + *at;
    }
    const bool all = editorKeys.size() <= kShown;
    return format("{} {} that only {} needs {} left out: {}{}", editorKeys.size(),
                  editorKeys.size() == 1 ? "key" : "keys", editor, editorKeys.size() == 1 ? "was" : "were",
                  some, all ? "" : " etc.");
}

std::string ImportReport::summary() const {
    const std::pair<int, const char*> counts[] = {
        {levels, "levels"},       {layers, "layers"},     {tiles, "tiles"},   {objects, "objects"},
        {colliders, "colliders"}, {tilesets, "tilesets"}, {images, "images"}, {clips, "clips"}};
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
    for (const Error& problem : foldedProblems()) text += "  " + problem.text() + "\n";
    for (const std::string& note : notes) text += "  note: " + note + "\n";
    if (const std::string keys = leftOut(); !keys.empty()) text += "  note: " + keys + "\n";
    return text;
}

}  // namespace plumb
