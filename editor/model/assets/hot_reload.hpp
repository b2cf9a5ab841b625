#pragma once

#include <string>
#include <vector>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Reloads project files that other programs change: images, sounds, tilesets, animations and fonts (in a
/// running game too), prefabs with all their instances, and the open scene if it has no unsaved changes, else
/// the user is asked. Also loads assets that an edit references for the first time.
class HotReload {
public:
    static constexpr double kInterval = 0.05;  ///< s between two checks, so that a change shows within 0.1 s

    explicit HotReload(Workspace& workspace) : workspace_{workspace} {}

    /// Checks for changed files every `kInterval`; takes about 2 us per loaded file.
    /// @param now  s, of any monotonic clock
    /// @return     number of changed files
    std::size_t poll(double now);

private:
    void watch();
    void loadNewlyNamed();
    void sceneChanged();
    void prefabsChanged(const std::vector<std::string>& paths);

    Workspace& workspace_;
    double next_ = 0.0;
    double nextWatch_ = 0.0;
    std::string watchedScene_;
    std::size_t knownTexts_ = 0;  // number of the document's texts when its assets were last loaded
};

}  // namespace plumb::editor
