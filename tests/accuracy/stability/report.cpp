#include "tests/accuracy/stability/report.hpp"

#include "core/text.hpp"

namespace plumb::stability {

Result<Done> writeReport(std::span<const PlayedMap> maps, const Path& folder) {
    if (const auto csv = writeFile(folder / "stability.csv", csvOf(maps)); !csv) return csv;
    if (const auto json = writeFile(folder / "stability.json", jsonOf(maps)); !json) return json;
    return writeFile(folder / "stability.html", pageOf(maps));
}

Result<Done> writeDocs(std::span<const PlayedMap> maps, const Path& folder) {
    const Path pictures = folder / "stability";
    for (const PlayedMap& map : maps) {
        const auto picture = writeFile(pictures / format("{}.svg", map.map->name), pictureOf(map));
        if (!picture) return picture;
    }
    if (const auto legend = writeFile(pictures / "legend.svg", legendPicture()); !legend) return legend;
    return writeFile(folder / "stability.md", markdownOf(maps, "stability"));
}

}  // namespace plumb::stability
