#include "editor/model/debug/breakpoints.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/text.hpp"
#include "reflect/json.hpp"
#include "reflect/json_fields.hpp"

namespace plumb::editor {
namespace {

constexpr int kMostLines = 1'000'000;  // highest number of a line in a file of breakpoints

bool isBefore(const Breakpoint& breakpoint, std::string_view file, int line) {
    return std::tuple{std::string_view{breakpoint.file}, breakpoint.line} < std::tuple{file, line};
}

template <class All>
auto placeOf(All& all, std::string_view file, int line) {
    return std::lower_bound(all.begin(), all.end(), line, [file](const Breakpoint& breakpoint, int wanted) {
        return isBefore(breakpoint, file, wanted);
    });
}

}  // namespace

const Breakpoint* Breakpoints::find(std::string_view file, int line) const {
    const auto at = placeOf(all_, file, line);
    return at != all_.end() && at->line == line && at->file == file ? &*at : nullptr;
}

bool Breakpoints::anyEnabled() const {
    return std::any_of(all_.begin(), all_.end(), [](const Breakpoint& one) { return one.enabled; });
}

void Breakpoints::toggle(std::string_view file, int line) {
    find(file, line) == nullptr ? set({std::string{file}, line, {}, true}) : remove(file, line);
}

void Breakpoints::set(Breakpoint breakpoint) {
    const auto at = placeOf(all_, breakpoint.file, breakpoint.line);
    if (find(breakpoint.file, breakpoint.line) != nullptr) {
        *at = std::move(breakpoint);
    } else {
        all_.insert(at, std::move(breakpoint));
    }
    ++revision_;
}

void Breakpoints::remove(std::string_view file, int line) {
    if (find(file, line) == nullptr) return;
    all_.erase(placeOf(all_, file, line));
    ++revision_;
}

void Breakpoints::follow(std::string_view file, const std::vector<int>& numbers) {
    const auto first = placeOf(all_, file, 0);
    const auto last =
        std::find_if(first, all_.end(), [file](const Breakpoint& one) { return one.file != file; });
    std::vector<Breakpoint> moved{first, last};
    bool anyMoved = false;
    for (Breakpoint& one : moved) {
        const auto index = static_cast<std::size_t>(one.line - 1);
        if (index >= numbers.size() || numbers[index] == one.line) continue;
        one.line = numbers[index];
        anyMoved = true;
    }
    if (!anyMoved) return;
    all_.erase(first, last);
    for (Breakpoint& one : moved) set(std::move(one));
}

Json Breakpoints::toJson() const {
    Json list = Json::array();
    for (const Breakpoint& breakpoint : all_) {
        Json json = Json::object();
        json["file"] = breakpoint.file;
        json["line"] = breakpoint.line;
        if (!breakpoint.condition.empty()) json["condition"] = breakpoint.condition;
        if (!breakpoint.enabled) json["enabled"] = false;
        list.push_back(std::move(json));
    }
    return list;
}

Breakpoints Breakpoints::fromJson(const Json& json, const std::string& where, std::vector<Error>& problems) {
    Breakpoints breakpoints;
    if (!json.is_array()) {
        problems.push_back({where, "expected a list of breakpoints", "no breakpoint is set"});
        return breakpoints;
    }
    std::size_t index = 0;
    for (const Json& entry : json) {
        const std::string place = format("{}[{}]", where, index++);
        JsonFields fields{entry, place, problems};
        Breakpoint breakpoint;
        breakpoint.file = fields.text("file");
        breakpoint.line = fields.whole("line", 0, 0, kMostLines);
        breakpoint.condition = fields.text("condition");
        breakpoint.enabled = fields.flag("enabled", true);
        if (!breakpoint.file.empty() && breakpoint.line > 0) {
            breakpoints.set(std::move(breakpoint));
        } else {
            problems.push_back({place, "a breakpoint needs a file and a line", "this entry is ignored"});
        }
    }
    return breakpoints;
}

}  // namespace plumb::editor
