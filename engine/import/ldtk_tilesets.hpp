#pragma once

#include <map>
#include <string>
#include <utility>

#include "import/ldtk_project.hpp"
#include "import/scene_draft.hpp"

namespace plumb {

/// Converts the tilesets of an LDtk project to tileset files, each at the first call for it.
class LdtkTilesets {
public:
    LdtkTilesets(const ldtk::Project& project, SceneDraft& draft) : project_{project}, draft_{draft} {}

    /// Returns the path of the tileset file for layers with a given cell size. Tiles that are larger than the
    /// cells are aligned to the upper left corner of their cell. Empty if the project has no such tileset.
    /// @param grid  cell size, px
    std::string file(int uid, int grid);

    /// Returns the image of a tileset; its path is empty if there is none, which is reported once.
    const StagedImage& picture(int uid);

    /// Makes a tileset with one colored tile for each value of an IntGrid. Tiles are solid if the value's
    /// name suggests it ("wall", "ground").
    /// @param solid  set to true if at least one tile is solid
    /// @return the path of the tileset file
    std::string valuesFile(const ldtk::Layer& layer, const ldtk::LayerKind& kind, bool& solid);

private:
    const ldtk::Project& project_;
    SceneDraft& draft_;
    std::map<std::pair<int, int>, std::string> files_;
    std::map<int, StagedImage> pictures_;
    /// Results of valuesFile() (file and `solid`), by uid of the layer definition.
    std::map<int, std::pair<std::string, bool>> values_;
};

}  // namespace plumb
