#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.hpp"
#include "reflect/json_fwd.hpp"

namespace plumb::editor {

/// A line of a script at which the game stops.
struct Breakpoint {
    std::string file;       ///< "scripts/slime.lua"
    int line = 0;           ///< from 1
    std::string condition;  ///< expression of Lua over the variables of the line; empty: stops always
    bool enabled = true;

    friend bool operator==(const Breakpoint&, const Breakpoint&) = default;
};

/// The breakpoints of a project, sorted by file and line.
class Breakpoints {
public:
    [[nodiscard]] const std::vector<Breakpoint>& all() const { return all_; }
    [[nodiscard]] const Breakpoint* find(std::string_view file, int line) const;
    [[nodiscard]] bool anyEnabled() const;

    /// Adds a breakpoint, or removes the one of this line.
    void toggle(std::string_view file, int line);
    /// Changes the breakpoint of the same line, or adds it.
    void set(Breakpoint breakpoint);
    void remove(std::string_view file, int line);
    /// Moves the breakpoints of a file whose text has changed.
    /// @param numbers  present number of each former line (linesAfterEdit)
    void follow(std::string_view file, const std::vector<int>& numbers);
    void clear() { all_.clear(), ++revision_; }
    [[nodiscard]] std::size_t revision() const { return revision_; }  ///< grows with every change

    [[nodiscard]] Json toJson() const;
    /// Skips and reports entries that are not valid.
    /// @param where  name of the file, for messages
    static Breakpoints fromJson(const Json& json, const std::string& where, std::vector<Error>& problems);

private:
    std::vector<Breakpoint> all_;
    std::size_t revision_ = 0;
};

}  // namespace plumb::editor
