#pragma once

#include <map>
#include <string>
#include <utility>

#include "import/ldtk_project.hpp"
#include "import/scene_draft.hpp"

namespace plumb {

/// The tilesets of an LDtk project as files of ours, written when the first layer needs them.
class LdtkTilesets {
public:
    LdtkTilesets(const ldtk::Project& project, SceneDraft& draft) : project_{project}, draft_{draft} {}

    /// The file of a tileset for layers of a grid. Tiles that are larger than its cells stand on the upper
    /// left corner of theirs. Empty for a tileset that the project does not have.
    /// @param grid  px
    std::string file(int uid, int grid);

    /// The picture of a tileset; its path is empty when there is none, which is reported once.
    const StagedImage& picture(int uid);

    /// A set made of the values of an IntGrid, one colored tile each, solid where its name says so.
    /// @return its file; `solid` says whether some value is
    std::string valuesFile(const ldtk::Layer& layer, const ldtk::LayerKind& kind, bool& solid);

private:
    const ldtk::Project& project_;
    SceneDraft& draft_;
    std::map<std::pair<int, int>, std::string> files_;
    std::map<int, StagedImage> pictures_;
    std::map<int, std::pair<std::string, bool>> values_;  ///< by kind of layer
};

}  // namespace plumb
