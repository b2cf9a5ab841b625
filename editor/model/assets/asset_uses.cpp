#include "editor/model/assets/asset_uses.hpp"

#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kAssets = "assets/";

/// Returns the index of the closing quote of a JSON string that starts at `from`, after its opening quote;
/// npos if there is none.
std::size_t endOfText(std::string_view json, std::size_t from) {
    for (std::size_t at = from; at < json.size(); ++at) {
        if (json[at] == '\\') {
            ++at;
        } else if (json[at] == '"') {
            return at;
        }
    }
    return std::string_view::npos;
}

/// Returns the name by which JSON files may reference a file directly in assets/; empty for other files.
std::string_view bareName(std::string_view path) {
    if (!startsWith(path, kAssets)) return {};
    path.remove_prefix(kAssets.size());
    return path.find('/') == std::string_view::npos ? path : std::string_view{};
}

/// Returns the renamed path if the text is the path `from` or (`folder`) lies below it; else the text itself.
std::string renamed(std::string_view text, std::string_view from, std::string_view to, bool folder) {
    if (folder) {
        const bool below = startsWith(text, from) && text.size() > from.size() && text[from.size()] == '/';
        return below ? std::string{to} + std::string{text.substr(from.size())} : std::string{text};
    }
    if (text == from) return std::string{to};
    if (!bareName(from).empty() && text == bareName(from))
        return std::string{bareName(to).empty() ? to : bareName(to)};
    return std::string{text};
}

}  // namespace

std::string withRenamedAsset(std::string_view json, std::string_view from, std::string_view to, bool folder,
                             int* times) {
    std::string result;
    std::size_t copied = 0;
    for (std::size_t at = json.find('"'); at != std::string_view::npos; at = json.find('"', at)) {
        const std::size_t end = endOfText(json, ++at);
        if (end == std::string_view::npos) break;
        const std::string_view text = json.substr(at, end - at);
        if (const std::string next = renamed(text, from, to, folder); next != text) {
            result.append(json.substr(copied, at - copied)).append(next);
            copied = end;
            if (times != nullptr) ++*times;
        }
        at = end + 1;
    }
    result.append(json.substr(copied));
    return result;
}

std::vector<AssetUse> usesOfAsset(const Path& root, std::string_view path, bool folder) {
    std::vector<AssetUse> uses;
    for (const std::string& file : filesBelow(root, ".json")) {
        const Result<std::string> text = readFile(root / file);
        if (!text || file == path) continue;
        int times = 0;
        static_cast<void>(withRenamedAsset(*text, path, "/", folder, &times));
        if (times > 0) uses.push_back({file, times});
    }
    return uses;
}

}  // namespace plumb::editor
