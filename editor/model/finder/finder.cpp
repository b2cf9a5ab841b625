#include "editor/model/finder/finder.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "core/text.hpp"
#include "ecs/hierarchy.hpp"
#include "editor/model/action_groups.hpp"
#include "editor/model/prefabs/prefab_edit.hpp"
#include "editor/model/prefabs/prefab_visit.hpp"
#include "editor/model/project/project_habits.hpp"
#include "editor/model/tools/tool.hpp"
#include "editor/model/workspace.hpp"

namespace plumb::editor {
namespace {

using Kind = FinderItem::Kind;

constexpr int kRecentPoints = 10;  // less than a letter scores, so that better matches still come first

Kind kindOf(const AssetItem& file) {
    if (file.kind == AssetKind::Scene) return Kind::Scene;
    return file.kind == AssetKind::Prefab ? Kind::Prefab : Kind::Asset;
}

std::string recentKey(const FinderItem& item) {
    return format("{} {}", static_cast<int>(item.kind), item.id);
}

FinderItem fileItem(Kind kind, const std::string& path, AssetKind asset) {
    return {kind, path, path.rfind('/') + 1, path, {}, asset, {}};
}

void addToMiddle(Workspace& workspace, const std::string& path) {
    const Vec2 at = snapped(workspace.view.view().center, workspace.grid.size);
    const Result<Done> added = addInstance(workspace.prefabs(), path, at);
    workspace.notice = added ? format("Added {}", path) : added.error().text();
}

/// Final sort key, which makes the order deterministic.
auto orderOf(const FinderItem& item) { return std::tie(item.kind, item.text, item.id); }

}  // namespace

void Finder::open(const Workspace& workspace, What what) {
    if (recent_.empty()) recent_ = recentChoices(workspace, kMaxRecent);
    what_ = what;
    collect(workspace, what);
    search(workspace, {});
}

void Finder::collect(const Workspace& workspace, What what) {
    collected_ = what;
    items_.clear();
    switch (what) {
        case What::Commands: collectCommands(workspace); break;
        case What::Scenes: collectScenes(workspace); break;
        case What::Prefabs: collectPrefabs(workspace); break;
        case What::Files:
            collectFiles(workspace);
            collectEntities(workspace);
            break;
    }
    recencies_.clear();
    for (const FinderItem& item : items_) recencies_.push_back(recency(item));
}

void Finder::collectFiles(const Workspace& workspace) {
    AssetCatalog catalog{workspace.project.root};
    catalog.refresh();
    for (const AssetItem& file : catalog.all()) {
        if (file.folder || file.kind == AssetKind::None) continue;
        items_.push_back(fileItem(kindOf(file), file.path, file.kind));
    }
}

void Finder::collectScenes(const Workspace& workspace) {
    for (const std::string& path : workspace.scenes()) {
        items_.push_back(fileItem(Kind::Scene, path, AssetKind::Scene));
        if (path == workspace.document.scenePath) items_.back().detail = "open now";
    }
}

void Finder::collectPrefabs(const Workspace& workspace) {
    for (const std::string& path : workspace.prefabFiles())
        items_.push_back(fileItem(Kind::Prefab, path, AssetKind::Prefab));
}

void Finder::collectEntities(const Workspace& workspace) {
    const Document& document = workspace.document;
    for (const ObjectId id : document.objects()) {
        const ObjectId parent = document.idOf(parentOf(document.world, document.find(id)));
        items_.push_back({Kind::Entity, document.nameOf(id), 0, hexText(id.value),
                          parent ? format("in {}", document.nameOf(parent)) : std::string{}, AssetKind::None,
                          id});
    }
}

void Finder::collectCommands(const Workspace& workspace) {
    for (const Action& action : actionTable()) {
        if (action.id.empty()) continue;
        const std::string menu = groupOf(action) + ": ";
        items_.push_back({Kind::Command,
                          menu + std::string{action.label},
                          menu.size(),
                          std::string{action.id},
                          workspace.settings.keys.shownOf(action).text(),
                          AssetKind::None,
                          {},
                          action.enabled(workspace)});
    }
}

std::size_t Finder::recency(const FinderItem& item) const {
    const auto at = std::find(recent_.begin(), recent_.end(), recentKey(item));
    return at == recent_.end() ? kMaxRecent : static_cast<std::size_t>(at - recent_.begin());
}

void Finder::search(const Workspace& workspace, std::string typed) {
    const bool files = what_ == What::Files;
    const bool commands = files && startsWith(typed, ">");
    if (const What wanted = commands ? What::Commands : what_; wanted != collected_)
        collect(workspace, wanted);
    const bool onlyEntities = files && startsWith(typed, "@");
    if (startsWith(typed, ">") || onlyEntities) typed.erase(0, 1);
    typed = std::string{trimmed(typed)};

    rows_.clear();
    for (std::size_t i = 0; i < items_.size(); ++i) {
        if (onlyEntities && items_[i].kind != Kind::Entity) continue;
        std::optional<FuzzyMatch> match = fuzzyMatch(typed, items_[i].text, items_[i].name);
        if (!match) continue;
        if (recencies_[i] < kMaxRecent) match->score += kRecentPoints;
        rows_.push_back({i, std::move(*match)});
    }
    const auto before = [&](const FinderRow& a, const FinderRow& b) {
        if (a.match.score != b.match.score) return a.match.score > b.match.score;
        if (recencies_[a.item] != recencies_[b.item]) return recencies_[a.item] < recencies_[b.item];
        const FinderItem &x = items_[a.item], &y = items_[b.item];
        if (typed.empty() && x.kind == Kind::Command) return a.item < b.item;  // in menu order
        if (typed.empty()) return orderOf(x) < orderOf(y);
        if (x.possible != y.possible) return x.possible;
        if (x.text.size() != y.text.size()) return x.text.size() < y.text.size();
        return orderOf(x) < orderOf(y);
    };
    found_ = rows_.size();
    const std::size_t shown = std::min(found_, kMaxRows);
    std::partial_sort(rows_.begin(), rows_.begin() + static_cast<std::ptrdiff_t>(shown), rows_.end(), before);
    rows_.resize(shown);
    chosen = 0;
    if (what_ == What::Scenes) leaveOpenScene(workspace);
}

void Finder::leaveOpenScene(const Workspace& workspace) {
    if (rows_.size() > 1 && item(rows_.front()).id == workspace.document.scenePath) chosen = 1;
}

void Finder::step(int by) {
    if (rows_.empty()) return;
    const auto count = static_cast<int>(rows_.size());
    chosen = static_cast<std::size_t>(((static_cast<int>(chosen) + by) % count + count) % count);
}

std::string Finder::choose(Workspace& workspace) {
    if (chosen >= rows_.size()) return {};
    const FinderItem& item = items_[rows_[chosen].item];
    const std::string key = recentKey(item);
    std::erase(recent_, key);
    recent_.insert(recent_.begin(), key);
    if (recent_.size() > kMaxRecent) recent_.pop_back();
    keepRecent(workspace, recent_);

    switch (item.kind) {
        case Kind::Scene: return item.id;
        case Kind::Entity:
            workspace.document.selection.set({item.object});
            runAction(workspace, "view.frame");
            break;
        case Kind::Command:
            if (!runAction(workspace, item.id))
                workspace.notice = format("\"{}\" is not available now", item.text.substr(item.name));
            break;
        case Kind::Prefab:
            if (what_ == What::Prefabs) {
                addToMiddle(workspace, item.id);
                break;
            }
            askToEditPrefab(workspace, item.id);
            workspace.assetToShow = item.id;
            break;
        case Kind::Asset:
            if (item.asset == AssetKind::Animation) workspace.assetToEdit = item.id;
            workspace.assetToShow = item.id;
            break;
    }
    return {};
}

}  // namespace plumb::editor
