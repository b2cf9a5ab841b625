#include "editor/model/assets/asset_catalog.hpp"

#include <algorithm>
#include <array>
#include <system_error>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr std::size_t kMaxItems = 50'000;  // a home folder opened by mistake must not hang the editor

struct Ending {
    std::string_view text;
    AssetKind kind;
};
constexpr std::array kEndings{
    Ending{".tileset.json", AssetKind::Tileset},
    Ending{".anim.json", AssetKind::Animation},
    Ending{".scene.json", AssetKind::Scene},
    Ending{".prefab.json", AssetKind::Prefab},
    Ending{".png", AssetKind::Texture},
    Ending{".jpg", AssetKind::Texture},
    Ending{".jpeg", AssetKind::Texture},
    Ending{".bmp", AssetKind::Texture},
    Ending{".wav", AssetKind::Sound},
    Ending{".ogg", AssetKind::Sound},
    Ending{".ttf", AssetKind::Font},
};

std::string lowerCase(std::string_view text) {
    std::string lower{text};
    for (char& c : lower) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return lower;
}

std::string_view folderOf(std::string_view path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string_view::npos ? std::string_view{} : path.substr(0, slash);
}

bool comesBefore(const AssetItem& a, const AssetItem& b) {
    if (a.folder != b.folder) return a.folder;
    return lowerCase(a.path) < lowerCase(b.path);
}

}  // namespace

std::string_view AssetItem::name() const { return std::string_view{path}.substr(path.rfind('/') + 1); }

std::string_view AssetItem::title() const {
    const std::string_view whole = name();
    for (const std::string_view ending : {".prefab.json", ".scene.json", ".anim.json", ".tileset.json"}) {
        if (endsWith(whole, ending)) return whole.substr(0, whole.size() - ending.size());
    }
    return whole;
}

AssetKind assetKindOf(std::string_view path) {
    const std::string lower = lowerCase(path);
    for (const Ending& ending : kEndings) {
        if (endsWith(lower, ending.text)) return ending.kind;
    }
    return AssetKind::None;
}

std::string_view nameOfKind(AssetKind kind) {
    switch (kind) {
        case AssetKind::Texture: return "picture";
        case AssetKind::Tileset: return "tileset";
        case AssetKind::Animation: return "animation";
        case AssetKind::Sound: return "sound";
        case AssetKind::Font: return "font";
        case AssetKind::Scene: return "scene";
        case AssetKind::Prefab: return "prefab";
        case AssetKind::None: break;
    }
    return "file";
}

void AssetCatalog::refresh() {
    namespace fs = std::filesystem;
    std::vector<AssetItem> found;
    std::error_code failed;
    fs::recursive_directory_iterator at{root_, fs::directory_options::skip_permission_denied, failed};
    for (; !failed && at != fs::recursive_directory_iterator{} && found.size() < kMaxItems;
         at.increment(failed)) {
        const std::string name = at->path().filename().string();
        const bool folder = at->is_directory(failed) && !at->is_symlink(failed);
        if (startsWith(name, ".") || endsWith(name, ".tmp")) {
            if (folder) at.disable_recursion_pending();
            continue;
        }
        std::string path = at->path().lexically_relative(root_).generic_string();
        const AssetKind kind = folder ? AssetKind::None : assetKindOf(path);
        found.push_back({std::move(path), kind, folder});
    }
    std::sort(found.begin(), found.end(),
              [](const AssetItem& a, const AssetItem& b) { return a.path < b.path; });
    const bool same = std::equal(found.begin(), found.end(), items_.begin(), items_.end(),
                                 [](const AssetItem& a, const AssetItem& b) { return a.path == b.path; });
    if (same) return;
    items_ = std::move(found);
    ++revision_;
}

std::vector<AssetItem> AssetCatalog::in(std::string_view folder) const {
    std::vector<AssetItem> items;
    for (const AssetItem& item : items_) {
        if (folderOf(item.path) == folder) items.push_back(item);
    }
    std::sort(items.begin(), items.end(), comesBefore);
    return items;
}

std::vector<AssetItem> AssetCatalog::search(std::string_view text) const {
    const std::string wanted = lowerCase(text);
    const std::vector<std::string_view> words = split(wanted, ' ');
    std::vector<AssetItem> items;
    for (const AssetItem& item : items_) {
        const std::string path = lowerCase(item.path);
        const bool fits = std::all_of(words.begin(), words.end(), [&](std::string_view word) {
            return path.find(word) != std::string::npos;
        });
        if (fits && !item.folder) items.push_back(item);
    }
    return items;
}

}  // namespace plumb::editor
