#include "editor/model/finder/fuzzy.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

// Scores. Only the ranking matters: adjacent letters from the start of a word rank above starts of several
// words, these above adjacent letters inside a word, and these above scattered letters.
constexpr int kLetter = 16;
constexpr int kWordStart = 12;  // also for each letter of a run that starts there
constexpr int kInRun = 7;
constexpr int kTextStart = 4;  // in addition to kWordStart
constexpr int kInName = 3;
constexpr int kSameCase = 1;
constexpr int kGap = 2;       // subtracted for each letter between two matched ones …
constexpr int kMostGap = 12;  // … up to this maximum
constexpr int kUnmatched = -1'000'000;

constexpr std::size_t kLongestText = 512;  // longer texts are cut off
constexpr std::size_t kLongestWord = 64;

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool isLower(char c) { return c >= 'a' && c <= 'z'; }
bool isUpper(char c) { return c >= 'A' && c <= 'Z'; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isSeparator(char c) { return std::string_view{" /_-.:,()\"#"}.find(c) != std::string_view::npos; }

/// True at the start of a word, like c and 1 in "oneCell", "one_cell", "one cell", "level1".
bool startsWord(std::string_view text, std::size_t i) {
    if (i == 0) return true;
    const char before = text[i - 1], now = text[i];
    return isSeparator(before) || (isLower(before) && isUpper(now)) || (!isDigit(before) && isDigit(now));
}

bool hasInOrder(std::string_view word, std::string_view text) {
    std::size_t next = 0;
    for (const char c : text) {
        if (next < word.size() && lower(c) == lower(word[next])) ++next;
    }
    return next == word.size();
}

int gapCost(std::size_t letters) { return std::min(static_cast<int>(letters) * kGap, kMostGap); }

/// Finds the best match of one word by dynamic programming: for each letter and each index in the text, the
/// highest score of the word up to this letter with the letter at this index.
class WordSearch {
public:
    WordSearch(std::string_view word, std::string_view text, std::size_t name)
        : word_{word}, text_{text}, name_{name}, cells_(word.size() * text.size()) {
        for (std::size_t letter = 0; letter < word_.size(); ++letter) {
            for (std::size_t place = letter; place < text_.size(); ++place) {
                if (lower(word_[letter]) == lower(text_[place])) cell(letter, place) = best(letter, place);
            }
        }
    }

    /// Appends the indices of the best match to `at`. @return its score
    int best(std::vector<std::uint32_t>& at) const {
        std::size_t place = 0;
        const std::size_t last = word_.size() - 1;
        for (std::size_t i = 1; i < text_.size(); ++i) {
            if (cell(last, i).points > cell(last, place).points) place = i;
        }
        const int points = cell(last, place).points;
        for (std::size_t letter = word_.size(); letter-- > 0; place = cell(letter, place).from)
            at.push_back(static_cast<std::uint32_t>(place));
        return points;
    }

private:
    struct Cell {
        int points = kUnmatched;
        int run = 0;           ///< score of the next letter if adjacent
        std::size_t from = 0;  ///< index of the previous letter
    };
    [[nodiscard]] Cell& cell(std::size_t letter, std::size_t place) {
        return cells_[letter * text_.size() + place];
    }
    [[nodiscard]] const Cell& cell(std::size_t letter, std::size_t place) const {
        return cells_[letter * text_.size() + place];
    }

    /// Returns the best cell for the letter at this index, from the cells of the previous letter.
    [[nodiscard]] Cell best(std::size_t letter, std::size_t place) const {
        const int start = startsWord(text_, place) ? kWordStart : 0;
        const int alone = pointsOf(letter, place);
        if (letter == 0) return {alone + start, std::max(start, kInRun), 0};
        Cell found;
        for (std::size_t last = letter - 1; last < place; ++last) {
            const Cell& before = cell(letter - 1, last);
            if (before.points == kUnmatched) continue;
            const bool follows = last + 1 == place;
            const int points = before.points + alone +
                               (follows ? std::max(start, before.run) : start - gapCost(place - last - 1));
            if (points > found.points)
                found = {points, follows ? std::max(start, before.run) : std::max(start, kInRun), last};
        }
        return found;
    }

    [[nodiscard]] int pointsOf(std::size_t letter, std::size_t place) const {
        int points = kLetter;
        if (place == name_ || place == 0) points += kTextStart;
        if (place >= name_) points += kInName;
        if (word_[letter] == text_[place]) points += kSameCase;
        return points;
    }

    std::string_view word_;
    std::string_view text_;
    std::size_t name_;
    std::vector<Cell> cells_;
};

}  // namespace

std::optional<FuzzyMatch> fuzzyMatch(std::string_view typed, std::string_view text, std::size_t name) {
    text = text.substr(0, kLongestText);
    FuzzyMatch match;
    const std::vector<std::string_view> words = split(typed, ' ');
    for (const std::string_view word : words) {
        if (word.size() > kLongestWord || !hasInOrder(word, text)) return std::nullopt;
    }
    for (const std::string_view word : words) {
        if (!word.empty()) match.score += WordSearch{word, text, name}.best(match.at);
    }
    std::sort(match.at.begin(), match.at.end());
    match.at.erase(std::unique(match.at.begin(), match.at.end()), match.at.end());
    return match;
}

}  // namespace plumb::editor
