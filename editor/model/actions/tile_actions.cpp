#include <array>
#include <vector>

#include "core/text.hpp"
#include "editor/model/actions/action_rows.hpp"
#include "editor/model/document/tile_layers.hpp"
#include "editor/model/tiles/tile_clipboard.hpp"
#include "editor/model/tiles/tile_layer_edit.hpp"
#include "editor/model/tools/move_tiles_tool.hpp"

namespace plumb::editor {
namespace {

bool painting(const Workspace& w) { return editable(w) && w.paintsTiles(); }
bool withCells(const Workspace& w) { return painting(w) && !w.tiles.selected.empty(); }
bool withTiles(const Workspace& w) { return painting(w) && tilesFromText(w.clipboard).has_value(); }
bool withLayer(const Workspace& w) { return editable(w) && activeTileLayer(w.document, w.tiles); }
ObjectId layer(const Workspace& w) { return activeTileLayer(w.document, w.tiles); }

template <TileStamp (*Change)(const TileStamp&)>
void changeStamp(Workspace& w) {
    w.tiles.stamp = Change(w.tiles.stamp);
}

void takeStamp(Workspace& w, const TileStamp& stamp) {
    w.tiles.stamp = stamp;
    w.useTool("tool.brush");
}
void copyCells(Workspace& w) { w.clipboard = tilesAsText(selectedTiles(w.tools())); }
void clearCells(Workspace& w) { clearSelectedTiles(w.tools()); }
void cutCells(Workspace& w) { copyCells(w), clearCells(w); }
void pasteCells(Workspace& w) {
    if (const auto stamp = tilesFromText(w.clipboard)) takeStamp(w, *stamp);
}
void selectAllCells(Workspace& w) {
    const TileGrid* grid = gridOf(w.document, layer(w));
    if (grid == nullptr) return;
    std::vector<CellPlace> cells;
    for (int y = 0; y < grid->height(); ++y) {
        for (int x = 0; x < grid->width(); ++x) {
            if (grid->at(x, y) != 0) cells.push_back({x, y});
        }
    }
    w.tiles.selected.set(std::move(cells));
}

constexpr std::array<Key, TilePaint::kKept> kDigits{Key::Digit1, Key::Digit2, Key::Digit3,
                                                    Key::Digit4, Key::Digit5, Key::Digit6,
                                                    Key::Digit7, Key::Digit8, Key::Digit9};
constexpr std::array<std::array<std::string_view, 4>, TilePaint::kKept> kStampRows{{
    {"tiles.keep1", "Store tile pattern 1", "tiles.recall1", "Paint with tile pattern 1"},
    {"tiles.keep2", "Store tile pattern 2", "tiles.recall2", "Paint with tile pattern 2"},
    {"tiles.keep3", "Store tile pattern 3", "tiles.recall3", "Paint with tile pattern 3"},
    {"tiles.keep4", "Store tile pattern 4", "tiles.recall4", "Paint with tile pattern 4"},
    {"tiles.keep5", "Store tile pattern 5", "tiles.recall5", "Paint with tile pattern 5"},
    {"tiles.keep6", "Store tile pattern 6", "tiles.recall6", "Paint with tile pattern 6"},
    {"tiles.keep7", "Store tile pattern 7", "tiles.recall7", "Paint with tile pattern 7"},
    {"tiles.keep8", "Store tile pattern 8", "tiles.recall8", "Paint with tile pattern 8"},
    {"tiles.keep9", "Store tile pattern 9", "tiles.recall9", "Paint with tile pattern 9"},
}};

std::string keysOf(const Workspace& w, std::string_view action) {
    return w.settings.keys.shownOf(*findAction(action)).text();
}

template <std::size_t Slot>
void keepStamp(Workspace& w) {
    w.tiles.kept[Slot] = w.tiles.stamp;
    w.notice = format("Stored as tile pattern {}; press {} to paint with it", Slot + 1,
                      keysOf(w, kStampRows[Slot][2]));
}
template <std::size_t Slot>
void recallStamp(Workspace& w) {
    if (w.tiles.kept[Slot]) {
        takeStamp(w, *w.tiles.kept[Slot]);
    } else {
        w.notice = format("This tile pattern is empty; press {} to store the current one",
                          keysOf(w, kStampRows[Slot][0]));
    }
}

template <int X, int Y>
void nudgeCells(Workspace& w) {
    moveSelectedTiles(w.tools(), X, Y, false);
}

template <std::size_t... Slots>
void addStampRows(std::vector<Action>& rows, std::index_sequence<Slots...>) {
    // In no menu: 18 rows would hide the others.
    const auto add = [&](std::string_view id, std::string_view label, Shortcut keys,
                         void (*run)(Workspace&)) {
        rows.push_back({id, "", label, keys, painting, run, nullptr, {}, During::Tiles});
    };
    (add(kStampRows[Slots][0], kStampRows[Slots][1], control(kDigits[Slots]), keepStamp<Slots>), ...);
    (add(kStampRows[Slots][2], kStampRows[Slots][3], {kDigits[Slots]}, recallStamp<Slots>), ...);
}

/// An action on tiles, enabled while a tile tool is active.
constexpr Action row(std::string_view id, std::string_view label, Shortcut keys,
                     bool (*enabled)(const Workspace&), void (*run)(Workspace&),
                     bool (*on)(const Workspace&) = nullptr, Shortcut alternative = {}) {
    return {id, "Tiles", label, keys, enabled, run, on, alternative, During::Tiles};
}
constexpr Action layerRow(std::string_view id, std::string_view label, Shortcut keys, void (*run)(Workspace&),
                          bool (*on)(const Workspace&) = nullptr) {
    return {id, "Tiles", label, keys, withLayer, run, on};
}

std::vector<Action> makeRows() {
    std::vector<Action> rows{
        row("tiles.flipX", "Flip left to right", {Key::X}, painting, changeStamp<flippedX>),
        row("tiles.flipY", "Flip upside down", {Key::Y}, painting, changeStamp<flippedY>),
        row("tiles.turn", "Rotate right", {Key::Z}, painting, changeStamp<turned>),
        row("tiles.turnBack", "Rotate left", shifted(Key::Z), painting, changeStamp<turnedBack>),
        row(
            "tiles.random", "Random tiles of the pattern", {Key::D}, painting,
            [](Workspace& w) { w.tiles.random = !w.tiles.random; },
            [](const Workspace& w) { return w.tiles.random; }),
        line("Tiles"),
        row("tiles.cut", "Cut tiles", control(Key::X), withCells, cutCells),
        row("tiles.copy", "Copy tiles", control(Key::C), withCells, copyCells),
        row("tiles.paste", "Paint with the copied tiles", control(Key::V), withTiles, pasteCells),
        row("tiles.clear", "Clear tiles", {Key::Delete}, withCells, clearCells, nullptr, {Key::Backspace}),
        row("tiles.selectAll", "Select all tiles", control(Key::A), painting, selectAllCells),
        row("tiles.left", "Move tiles left", {Key::Left}, withCells, nudgeCells<-1, 0>),
        row("tiles.right", "Move tiles right", {Key::Right}, withCells, nudgeCells<1, 0>),
        row("tiles.up", "Move tiles up", {Key::Up}, withCells, nudgeCells<0, -1>),
        row("tiles.down", "Move tiles down", {Key::Down}, withCells, nudgeCells<0, 1>),
        line("Tiles"),
        layerRow(
            "tiles.collision", "Show collision of tiles", {Key::K},
            [](Workspace& w) { w.toggleOverlay("collision"); },
            [](const Workspace& w) { return w.shows("collision"); }),
        layerRow(
            "tiles.rightErases", "Right mouse button erases", {},
            [](Workspace& w) { w.tiles.rightErases = !w.tiles.rightErases; },
            [](const Workspace& w) { return w.tiles.rightErases; }),
        layerRow("tiles.retile", "Update terrain tiles", {}, retileLayer),
        line("Tiles"),
        Action{"layer.add", "Tiles", "Add layer", {}, editable, addTileLayer},
        layerRow("layer.above", "Layer above", control(Key::PageUp),
                 [](Workspace& w) { selectNextTileLayer(w, 1); }),
        layerRow("layer.below", "Layer below", control(Key::PageDown),
                 [](Workspace& w) { selectNextTileLayer(w, -1); }),
        layerRow("layer.raise", "Raise layer", control(Key::PageUp, true),
                 [](Workspace& w) { moveTileLayer(w, 1); }),
        layerRow("layer.lower", "Lower layer", control(Key::PageDown, true),
                 [](Workspace& w) { moveTileLayer(w, -1); }),
        layerRow(
            "layer.solo", "Show only this layer", {Key::H},
            [](Workspace& w) { w.document.view.toggleSolo(layer(w)); },
            [](const Workspace& w) { return w.document.view.solo() && w.document.view.solo() == layer(w); }),
        layerRow(
            "layer.hide", "Hide layer", control(Key::H),
            [](Workspace& w) { w.document.view.toggleHidden(layer(w)); },
            [](const Workspace& w) { return w.document.view.isHidden(layer(w)); }),
        layerRow(
            "layer.lock", "Lock layer", control(Key::L),
            [](Workspace& w) { w.document.view.toggleLocked(layer(w)); },
            [](const Workspace& w) { return w.document.view.locks(layer(w)); }),
    };
    addStampRows(rows, std::make_index_sequence<TilePaint::kKept>{});
    return rows;
}

}  // namespace

std::span<const Action> tileActions() {
    static const std::vector<Action> rows = makeRows();
    return rows;
}

}  // namespace plumb::editor
