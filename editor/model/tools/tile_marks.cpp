#include "editor/model/tools/tile_marks.hpp"

#include <cstdlib>

#include "core/text.hpp"

namespace plumb::editor::marks {
namespace {

constexpr std::size_t kMostRuns = 4000;  // maximum number of drawn runs, and of cells with borders

}  // namespace

void drawSelection(const ToolContext& context, ObjectId layer, Overlay& overlay) {
    drawCells(context.document, layer, context.tiles.selected, kSelectedFill, kSelected, overlay);
}

void drawCells(const Document& document, ObjectId layer, const CellSelection& selected, Color fill,
               Color line, Overlay& overlay) {
    const std::vector<CellPlace>& cells = selected.all();
    std::size_t runs = 0;
    for (std::size_t first = 0; first < cells.size() && runs < kMostRuns; ++runs) {
        std::size_t last = first;
        while (last + 1 < cells.size() && cells[last + 1] == CellPlace{cells[last].x + 1, cells[last].y})
            ++last;
        const AABB box = boxOfCells(document, layer, cells[first], cells[last]);
        overlay.filledBox(box, fill);
        const bool alone = runs == 0 && last + 1 == cells.size();
        if (alone) overlay.box(box, line, 1.5f);
        first = last + 1;
    }
    const auto edge = [&](CellPlace cell, int dx, int dy) {
        if (selected.has({cell.x + dx, cell.y + dy})) return;
        const AABB box = boxOfCell(document, layer, cell);
        const Vec2 from = dx > 0 ? Vec2{box.max.x, box.min.y} : dy > 0 ? Vec2{box.min.x, box.max.y} : box.min;
        const Vec2 to = dx < 0 ? Vec2{box.min.x, box.max.y} : dy < 0 ? Vec2{box.max.x, box.min.y} : box.max;
        overlay.line(from, to, line, 1.5f);
    };
    for (std::size_t i = 0; i < cells.size() && i < kMostRuns; ++i) {
        edge(cells[i], -1, 0), edge(cells[i], 1, 0), edge(cells[i], 0, -1), edge(cells[i], 0, 1);
    }
}

void drawLayer(const ToolContext& context, ObjectId layer, Overlay& overlay) {
    const TileGrid* grid = gridOf(context.document, layer);
    if (grid == nullptr || grid->width() == 0 || grid->height() == 0) return;
    const AABB box = boxOfCells(context.document, layer, {0, 0}, {grid->width() - 1, grid->height() - 1});
    overlay.box(box, kLayer);
    if (tilesetOf(context.document, layer) == nullptr)
        overlay.text(box.min, "this layer has no tileset; select one in the Inspector", kErase);
    if (context.document.view.locks(layer)) overlay.text(box.min, "this layer is locked", kErase);
    if (context.document.view.hides(layer)) overlay.text(box.min, "this layer is hidden", kErase);
    drawSelection(context, layer, overlay);
}

void drawSize(const AABB& box, CellPlace from, CellPlace to, Overlay& overlay) {
    overlay.text(box.min, format("{} x {}", std::abs(to.x - from.x) + 1, std::abs(to.y - from.y) + 1),
                 kCursor);
}

AABB cornerBox(const Document& document, ObjectId layer, CellPlace corner) {
    const AABB box = boxOfCell(document, layer, corner);
    const Vec2 half = box.size() * 0.5f;
    return {box.min - half, box.min + half};
}

}  // namespace plumb::editor::marks
