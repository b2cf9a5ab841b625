#pragma once

#include "editor/model/document/cell_selection.hpp"
#include "tests/editor/support/editor_fixture.hpp"
#include "tests/editor/support/terrain_set.hpp"

namespace plumb::editor {

/// An editor whose active tile layer has 8 x 4 empty cells of 16 px, with its corner at the origin.
class TileScene : public EditorFixture {
protected:
    TileScene() {
        World& world = workspace.document.world;
        auto& tiles = world.get<TileLayer>(workspace.document.find(layer()));
        tiles.cells = world.tiles().add(TileGrid{8, 4});
        workspace.tiles.layer = layer();
    }
    [[nodiscard]] ObjectId layer() const { return named("ground"); }
    void useTileset(Tileset set) {
        workspace.document.world.get<TileLayer>(workspace.document.find(layer())).tileset =
            workspace.assets.addTileset("assets/made.tileset.json", std::move(set));
    }
    static Vec2 middleOf(int x, int y) {
        return {static_cast<float>(x) * 16.0f + 8.0f, static_cast<float>(y) * 16.0f + 8.0f};
    }
    /// Drags the current tool from the center of one cell to the center of another.
    void stroke(CellPlace from, CellPlace to, Pointer how = {}) {
        how.position = middleOf(from.x, from.y);
        workspace.tool().press(workspace.tools(), how);
        how.position = middleOf(to.x, to.y);
        workspace.tool().drag(workspace.tools(), how);
        workspace.tool().release(workspace.tools(), how);
    }
};

}  // namespace plumb::editor
