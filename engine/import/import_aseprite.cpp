#include "import/import_aseprite.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "import/loaders/aseprite_loader.hpp"
#include "import/scene_draft.hpp"
#include "platform/image_file.hpp"
#include "reflect/json_text.hpp"

namespace plumb {
namespace {

using aseprite::Frame;
using aseprite::Sheet;

constexpr std::string_view kEnding = ".anim.json";
constexpr std::size_t kMaxLaidOutBytes = std::size_t{128} << 20;  // pixels of the new sheet

struct Cells {
    int width = 0;  ///< px
    int height = 0;
    int columns = 1;
    std::vector<std::pair<int, int>> places;  ///< column and row of each frame
};

/// Returns the cell of each frame if all frames are full cells of one grid that starts at the image's corner.
std::optional<Cells> cellsAsTheyLie(const Sheet& sheet) {
    Cells cells;
    cells.width = sheet.frames.front().width;
    cells.height = sheet.frames.front().height;
    if (cells.width <= 0 || cells.height <= 0) return {};
    for (const Frame& frame : sheet.frames) {
        const bool whole = !frame.rotated && frame.width == cells.width && frame.height == cells.height &&
                           frame.area.width == static_cast<float>(cells.width) &&
                           frame.area.height == static_cast<float>(cells.height);
        const float column = frame.area.x / static_cast<float>(cells.width);
        const float row = frame.area.y / static_cast<float>(cells.height);
        if (!whole || column != std::floor(column) || row != std::floor(row)) return {};
        cells.places.emplace_back(static_cast<int>(column), static_cast<int>(row));
    }
    return cells;
}

Cells newCells(const Sheet& sheet) {
    Cells cells;
    for (const Frame& frame : sheet.frames) {
        cells.width = std::max(cells.width, frame.width);
        cells.height = std::max(cells.height, frame.height);
    }
    const auto count = static_cast<double>(sheet.frames.size());
    const int fitting = std::max(limits::kImageSide / std::max(cells.width, 1), 1);
    cells.columns = std::clamp(static_cast<int>(std::ceil(std::sqrt(count))), 1, fitting);
    for (int i = 0; i < static_cast<int>(sheet.frames.size()); ++i)
        cells.places.emplace_back(i % cells.columns, i / cells.columns);
    return cells;
}

/// Returns the byte offset of a frame's pixel in the sheet. Packers rotate frames by 90 degrees clockwise.
std::size_t pixelOf(const Frame& frame, const Image& image, int x, int y) {
    const int column =
        static_cast<int>(frame.area.x) + (frame.rotated ? static_cast<int>(frame.area.width) - 1 - y : x);
    const int row = static_cast<int>(frame.area.y) + (frame.rotated ? x : y);
    const bool inside = column >= 0 && row >= 0 && column < image.width && row < image.height;
    return inside ? (static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(column)) *
                        4
                  : image.rgba.size();
}

/// Copies a frame to its cell, without the pixels that are outside of the cell or of the sheet.
void copyFrame(const Frame& frame, const Image& from, Image& to, const Cells& cells, int index) {
    const auto [column, row] = cells.places[static_cast<std::size_t>(index)];
    const int inX = static_cast<int>(frame.trimmed.x);
    const int inY = static_cast<int>(frame.trimmed.y);
    const int width = static_cast<int>(frame.rotated ? frame.area.height : frame.area.width);
    const int height = static_cast<int>(frame.rotated ? frame.area.width : frame.area.height);
    for (int y = std::max(-inY, 0); y < std::min(height, cells.height - inY); ++y) {
        for (int x = std::max(-inX, 0); x < std::min(width, cells.width - inX); ++x) {
            const int toX = column * cells.width + inX + x;
            const int toY = row * cells.height + inY + y;
            const std::size_t source = pixelOf(frame, from, x, y);
            if (source >= from.rgba.size()) continue;
            const auto target = (static_cast<std::ptrdiff_t>(toY) * to.width + toX) * 4;
            std::copy_n(from.rgba.begin() + static_cast<std::ptrdiff_t>(source), 4, to.rgba.begin() + target);
        }
    }
}

Result<std::string> laidOut(const Sheet& sheet, const Cells& cells, const Image& from) {
    const auto count = static_cast<int>(sheet.frames.size());
    Image to;
    to.width = cells.width * cells.columns;
    to.height = cells.height * ((count + cells.columns - 1) / cells.columns);
    const std::size_t bytes = static_cast<std::size_t>(std::max(to.width, 0)) *
                              static_cast<std::size_t>(std::max(to.height, 0)) * 4;
    if (bytes == 0 || to.width > limits::kImageSide || to.height > limits::kImageSide ||
        bytes > kMaxLaidOutBytes)
        return Error{
            sheet.image,
            format("the {} frames of {} x {} px do not fit into one image", count, cells.width, cells.height),
            "export fewer frames, or smaller ones"};
    to.rgba.resize(bytes);
    for (int i = 0; i < count; ++i) copyFrame(sheet.frames[static_cast<std::size_t>(i)], from, to, cells, i);
    return encodePng(to);
}

/// Reports frames that reach beyond the sheet's image; the pixels outside stay transparent.
void tellOutside(const Sheet& sheet, ImageSize size, ImportReport& report) {
    const auto isOutside = [size](const Frame& frame) {
        return frame.area.x < 0.0f || frame.area.y < 0.0f ||
               frame.area.x + frame.area.width > static_cast<float>(size.width) ||
               frame.area.y + frame.area.height > static_cast<float>(size.height);
    };
    const auto count = std::count_if(sheet.frames.begin(), sheet.frames.end(), isOutside);
    if (count == 0) return;
    report.problems.push_back(
        {sheet.image, format("{} frames reach beyond the image's {} x {} px", count, size.width, size.height),
         "export the sheet and its .json together again; the pixels outside are transparent"});
}

Json clipJson(const aseprite::Tag& tag, const Sheet& sheet, const Cells& cells, ImportReport& report) {
    const bool pingPong = startsWith(tag.direction, "pingpong");
    const bool backwards = endsWith(tag.direction, "reverse");
    Json clip = Json::object();
    clip["name"] = tag.name;
    clip["loop"] = pingPong ? "pingPong" : tag.repeat == 1 ? "once" : "loop";
    for (int i = 0; i <= tag.to - tag.from; ++i) {
        const auto index = static_cast<std::size_t>(backwards ? tag.to - i : tag.from + i);
        Json frame = Json::object();
        frame["cell"] = Json::array({cells.places[index].first, cells.places[index].second});
        frame["seconds"] = static_cast<float>(std::max(sheet.frames[index].milliseconds, 1)) / 1000.0f;
        clip["frames"].push_back(std::move(frame));
    }
    Json notes = tag.notes;
    if (tag.repeat > 1 || (tag.repeat == 1 && pingPong)) {
        notes["repeat"] = tag.repeat;
        report.note(format("clip {}: loops forever; Aseprite repeats it {} times", tag.name, tag.repeat));
    }
    if (!notes.empty()) clip["aseprite"] = std::move(notes);
    return clip;
}

Json sheetJson(const Sheet& sheet, const Cells& cells, const std::string& image, ImportReport& report) {
    std::vector<aseprite::Tag> tags = sheet.tags;
    if (tags.empty())
        tags.push_back({"all", 0, static_cast<int>(sheet.frames.size()) - 1, "forward", 0, Json::object()});
    Json json = Json::object();
    json["format"] = 1;
    json["image"] = image;
    json["frameSize"] = Json::array({cells.width, cells.height});
    for (const aseprite::Tag& tag : tags) json["clips"].push_back(clipJson(tag, sheet, cells, report));
    Json notes = Json::object();
    if (!sheet.slices.empty()) notes["slices"] = sheet.slices;
    if (!sheet.layers.empty()) notes["layers"] = sheet.layers;
    if (!notes.empty()) json["aseprite"] = std::move(notes);
    if (!sheet.slices.empty())
        report.note(format("{} slices are kept as data under \"aseprite\"", sheet.slices.size()));
    report.clips = static_cast<int>(tags.size());
    return json;
}

}  // namespace

Result<ImportReport> importAseprite(const Path& file, const Path& animation) {
    Result<ImportTarget> place = ImportTarget::of(animation, kEnding);
    if (!place) return place.error();
    ImportReport report;
    report.from = "Aseprite sheet";
    report.scene = place->path;
    const Result<std::string> text = readFile(file);
    if (!text) return text.error();
    const Result<Sheet> sheet = aseprite::parseSheet(*text, file.filename().string(), report.problems);
    if (!sheet) return sheet.error();
    const Path picture = file.parent_path() / Path{sheet->image}.filename();
    const Result<std::string> bytes = readFile(picture);
    if (!bytes)
        return Error{file.filename().string(), format("the sheet's image {} was not found", sheet->image),
                     "export the image to the folder of the .json"};

    const Result<ImageSize> size = readImageSize(*bytes, sheet->image);
    if (!size) return size.error();
    tellOutside(*sheet, *size, report);

    ImportStage stage{Path{place->path}.parent_path().generic_string()};
    const std::optional<Cells> lying = cellsAsTheyLie(*sheet);
    const Cells cells = lying ? *lying : newCells(*sheet);
    std::string image;
    if (lying) {
        image = stage.add(place->name, ".png", *bytes);
    } else {
        const Result<Image> pixels = decodeImage(*bytes, sheet->image);
        if (!pixels) return pixels.error();
        const Result<std::string> png = laidOut(*sheet, cells, *pixels);
        if (!png) return png.error();
        image = stage.add(place->name, ".png", *png);
        report.note("the packed frames were copied to a new sheet with cells of equal size");
    }
    std::vector<ImportedFile> files = stage.takeFiles();
    files.push_back({place->path, writeJson(sheetJson(*sheet, cells, image, report))});
    if (const Result<Done> done = commitImport(place->root, files); !done) return done.error();
    report.images = 1;
    for (const ImportedFile& written : files) report.files.push_back(written.path);
    return report;
}

}  // namespace plumb
