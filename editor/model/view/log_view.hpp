#pragma once

#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "editor/model/document/document.hpp"
#include "editor/model/view/log_book.hpp"

namespace plumb::editor {

/// The lines of the log that the console shows, filtered by level, channel and search words; equal lines can
/// be merged.
class LogView {
public:
    static constexpr std::size_t kLevels = 4;
    struct Row {
        std::size_t line = 0;   ///< index in LogBook::lines(); of merged lines the last one
        std::size_t times = 1;  ///< number of merged lines
    };

    // The filter.
    std::array<bool, kLevels> levels{true, true, true, true};
    std::set<std::string, std::less<>> hiddenChannels;
    std::string search;  ///< words; a shown line contains all of them, ignoring case
    bool once = true;    ///< merges equal lines into one row, at the position of the last one

    /// Computes the rows again if the log or the filter changed.
    void update(const LogBook& book);
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    /// Number of lines of a level, shown or not.
    [[nodiscard]] std::size_t count(LogLevel level) const { return counts_[static_cast<std::size_t>(level)]; }
    /// Channels of all lines, shown or not.
    [[nodiscard]] const std::set<std::string, std::less<>>& channels() const { return channels_; }
    /// Changes when the rows are computed again.
    [[nodiscard]] std::size_t revision() const { return revision_; }
    /// Returns the rows as text for the clipboard, one per line.
    [[nodiscard]] std::string text(const LogBook& book) const;

private:
    /// The revision of the log and the filter for which the rows were computed.
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

/// Returns "Detail", "Note", "Warning" or "Error".
std::string_view nameOf(LogLevel level);

/// Returns a line with its time, tick, channel and level: "12.34 s, tick 40  Physics  Warning: ..."
std::string textOf(const LogEntry& line);

/// Returns the entity of the open scene that a line refers to: by its id, as in "@9f3c1a77d2e0b154", or by
/// its index in the file, as in "scenes/cave.scene.json: entities[3]". Null if the line refers to no existing
/// entity.
ObjectId entityIn(const Document& document, std::string_view line);

}  // namespace plumb::editor
