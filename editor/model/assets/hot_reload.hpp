#pragma once

#include <string>

#include "editor/model/workspace.hpp"

namespace plumb::editor {

/// Follows what other programs do to the files of the project: pictures, sounds, tilesets, animations and
/// fonts change where they are shown, in a running game too; prefabs change their instances; the scene is
/// read again while it has no changes of its own; else the safety net asks. Files that an edit names for the
/// first time are loaded.
class HotReload {
public:
    static constexpr double kInterval = 0.05;  ///< s between two looks, so that 0.1 s are kept

    explicit HotReload(Workspace& workspace) : workspace_{workspace} {}

    /// Looks when it is time to. About 2 us for each file that is loaded.
    /// @param now  s, of any clock that goes on
    /// @return     how many files were taken up
    std::size_t poll(double now);

private:
    void watch();
    void loadNewlyNamed();
    void sceneChanged();
    void prefabChanged();

    Workspace& workspace_;
    double next_ = 0.0;
    double nextWatch_ = 0.0;
    std::string watchedScene_;
    std::size_t knownTexts_ = 0;  // of the document, when its assets were loaded
};

}  // namespace plumb::editor
