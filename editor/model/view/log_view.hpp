#pragma once

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document/document.hpp"
#include "editor/model/view/log_book.hpp"

namespace plumb::editor {

/// What of the log the console shows: levels, channels and words, equal lines once.
class LogView {
public:
    static constexpr std::size_t kLevels = 4;
    struct Row {
        std::size_t line = 0;   ///< of LogBook::lines(): the last one of those that are equal
        std::size_t times = 1;  ///< how often it was said
    };

    // What one wants to see.
    std::array<bool, kLevels> levels{true, true, true, true};
    std::set<std::string, std::less<>> hiddenChannels;
    std::string search;  ///< words; a line has to have all of them, in any case
    bool once = true;    ///< equal lines are one row, where they were said last

    /// Computes the rows again if the log or the filter changed.
    void update(const LogBook& book);
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    /// Of all lines, shown or not.
    [[nodiscard]] std::size_t count(LogLevel level) const { return counts_[static_cast<std::size_t>(level)]; }
    /// All there are, shown or not.
    [[nodiscard]] const std::set<std::string, std::less<>>& channels() const { return channels_; }
    /// Grows when the rows are others.
    [[nodiscard]] std::size_t revision() const { return revision_; }
    /// The rows as text, one a line, for the clipboard.
    [[nodiscard]] std::string text(const LogBook& book) const;

private:
    /// What the rows were made of.
    struct Made {
        std::size_t book = static_cast<std::size_t>(-1);
        std::array<bool, kLevels> levels{};
        std::set<std::string, std::less<>> hiddenChannels;
        std::string search;
        bool once = false;

        friend bool operator==(const Made&, const Made&) = default;
    };
    [[nodiscard]] bool shows(const LogEntry& line) const;

    Made made_;
    std::vector<Row> rows_;
    std::array<std::size_t, kLevels> counts_{};
    std::set<std::string, std::less<>> channels_;
    std::size_t revision_ = 0;
};

/// "Detail", "Note", "Warning", "Error".
std::string_view nameOf(LogLevel level);

/// "12.34 s, tick 40  Physics  Warning: …"
std::string textOf(const LogEntry& line);

/// The entity of the open scene that a line names: as "@9f3c1a77d2e0b154", by its id, or as
/// "scenes/cave.scene.json: entities[3]", by its place in the file. Null when it names none that is there.
ObjectId entityIn(const Document& document, std::string_view line);

}  // namespace plumb::editor
