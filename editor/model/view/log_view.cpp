#include "editor/model/view/log_view.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kIdDigits = 16;

std::string lowerCase(std::string_view text) {
    std::string lower{text};
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

ObjectId byId(const Document& document, std::string_view line) {
    for (std::size_t at = line.find('@'); at != std::string_view::npos; at = line.find('@', at + 1)) {
        const std::string_view digits = line.substr(at + 1, kIdDigits);
        const auto id = digits.size() == kIdDigits ? parseHex(digits) : std::nullopt;
        if (id && document.find({*id})) return {*id};
    }
    return {};
}

ObjectId byPlace(const Document& document, std::string_view line) {
    constexpr std::string_view kList = ": entities[";
    const std::size_t at = line.find(kList);
    if (at == std::string_view::npos || document.scenePath.empty()) return {};
    if (!endsWith(line.substr(0, at), document.scenePath)) return {};
    const std::string_view rest = line.substr(at + kList.size());
    const auto place = parseInt(rest.substr(0, rest.find(']')));
    const std::vector<ObjectId>& all = document.objects();
    if (!place || *place < 0 || static_cast<std::size_t>(*place) >= all.size()) return {};
    return all[static_cast<std::size_t>(*place)];
}

}  // namespace

std::string_view nameOf(LogLevel level) {
    switch (level) {
        case LogLevel::Detail: return "Detail";
        case LogLevel::Note: return "Note";
        case LogLevel::Warning: return "Warning";
        case LogLevel::Error: break;
    }
    return "Error";
}

std::string textOf(const LogEntry& line) {
    const std::string tick = line.tick < 0 ? "" : format(", tick {}", line.tick);
    return format("{} s{}  {}  {}: {}", fixedText(line.seconds, 2), tick, line.channel, nameOf(line.level),
                  line.text);
}

void LogView::update(const LogBook& book) {
    Made now{book.revision(), levels, hiddenChannels, search, once};
    if (now == made_) return;
    made_ = std::move(now);
    ++revision_;
    rows_.clear();
    counts_.fill(0);
    channels_.clear();
    // Number of equal lines.
    std::map<std::tuple<LogLevel, std::string_view, std::string_view>, std::size_t> known;
    const auto& lines = book.lines();
    // Backwards, so that the last of equal lines is shown.
    for (std::size_t i = lines.size(); i-- > 0;) {
        const LogEntry& line = lines[i];
        ++counts_[static_cast<std::size_t>(line.level)];
        channels_.insert(line.channel);
        if (!shows(line)) continue;
        const std::size_t times = ++known[{line.level, line.channel, line.text}];
        if (times == 1 || !once) rows_.push_back({i, 1});
    }
    std::reverse(rows_.begin(), rows_.end());
    if (!once) return;
    for (Row& row : rows_) {
        const LogEntry& line = lines[row.line];
        row.times = known[{line.level, line.channel, line.text}];
    }
}

bool LogView::shows(const LogEntry& line) const {
    if (!levels[static_cast<std::size_t>(line.level)]) return false;
    if (hiddenChannels.find(line.channel) != hiddenChannels.end()) return false;
    if (search.empty()) return true;
    const std::string text = lowerCase(line.channel + " " + line.text);
    const std::string wanted = lowerCase(search);
    const std::vector<std::string_view> words = split(wanted, ' ');
    return std::all_of(words.begin(), words.end(),
                       [&](std::string_view word) { return text.find(word) != std::string::npos; });
}

std::string LogView::text(const LogBook& book) const {
    std::string all;
    for (const Row& row : rows_) {
        all += textOf(book.lines()[row.line]);
        if (row.times > 1) all += format("  ({} times)", row.times);
        all += '\n';
    }
    return all;
}

ObjectId entityIn(const Document& document, std::string_view line) {
    const ObjectId id = byId(document, line);
    return id ? id : byPlace(document, line);
}

}  // namespace plumb::editor
