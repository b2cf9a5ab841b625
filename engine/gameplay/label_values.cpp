#include "gameplay/label_values.hpp"

#include <algorithm>

namespace plumb {
namespace {

constexpr auto kByWord = [](const auto& value, std::string_view word) { return value.first < word; };

}  // namespace

void LabelValues::set(std::string_view word, std::string_view text) {
    const auto at = std::lower_bound(values.begin(), values.end(), word, kByWord);
    if (at != values.end() && at->first == word) {
        at->second = text;
    } else {
        values.emplace(at, word, text);
    }
}

const std::string* LabelValues::find(std::string_view word) const {
    const auto at = std::lower_bound(values.begin(), values.end(), word, kByWord);
    return at != values.end() && at->first == word ? &at->second : nullptr;
}

void LabelValues::archive(StateArchive& archive) {
    const std::size_t count = archive.count(values.size());
    if (archive.reading()) values.assign(count, {});
    for (auto& [word, text] : values) {
        archive.text(word);
        archive.text(text);
    }
}

void LabelValues::addTo(Hasher& hasher) const {
    for (const auto& [word, text] : values) {
        hasher.add(hashText(word));
        hasher.add(hashText(text));
    }
}

}  // namespace plumb
