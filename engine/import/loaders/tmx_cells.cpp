#include "import/loaders/tmx_cells.hpp"

#include <algorithm>

#include "codec/base64.hpp"
#include "codec/compression.hpp"
#include "core/limits.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

using tiled::Gid;
using Cells = std::vector<Gid>;

/// Uncompressed size below which any compression ratio is accepted, since empty layers compress very well.
constexpr std::size_t kAlwaysAllowedBytes = std::size_t{64} << 20;

Error valueError(std::string_view where, std::string what, std::string remedy) {
    return Error{std::string{where}, std::move(what), std::move(remedy)};
}

std::string_view attribute(const XmlElement& element, std::string_view name) {
    const std::string* found = element.find(name);
    return found ? std::string_view{*found} : std::string_view{};
}

Result<Gid> parseGid(std::string_view text, std::string_view where) {
    const std::optional<std::int64_t> value = parseInt(trimmed(text));
    if (value && *value >= 0 && *value <= 0xffffffffll) return static_cast<Gid>(*value);
    return valueError(where, format("\"{}\" is not a tile id", text.substr(0, 20)), "export the map again");
}

Result<Cells> cellsFromElements(const XmlElement& data, std::string_view where) {
    Cells cells;
    for (const XmlElement& tile : data.children) {
        if (tile.name != "tile") continue;
        const std::string* gid = tile.find("gid");
        const Result<Gid> cell = gid ? parseGid(*gid, where) : Result<Gid>{Gid{0}};
        if (!cell) return cell.error();
        cells.push_back(*cell);
    }
    return cells;
}

Result<Cells> cellsFromCsv(std::string_view text, std::size_t count, std::string_view where) {
    Cells cells;
    cells.reserve(std::min(count, text.size() / 2 + 1));
    text = trimmed(text);
    if (endsWith(text, ",")) text.remove_suffix(1);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(','), text.size());
        const Result<Gid> cell = parseGid(text.substr(0, end), where);
        if (!cell) return cell.error();
        cells.push_back(*cell);
        if (end == text.size()) break;
        text.remove_prefix(end + 1);
        if (text.empty()) return valueError(where, "a tile id is missing at the end", "export the map again");
    }
    return cells;
}

Result<std::string> unpacked(std::string bytes, std::string_view compression, std::size_t size,
                             std::string_view where) {
    if (compression.empty() || compression == "none") return bytes;
    const std::size_t plausible = std::max(kAlwaysAllowedBytes, bytes.size() * limits::kCompressionRatio);
    if (size > plausible) {
        return valueError(where, "the data is too short for the number of cells",
                          "check the size of the layer; export the map again");
    }
    if (compression == "zlib") return unpackZlib(bytes, size, where);
    if (compression == "gzip") return unpackGzip(bytes, size, where);
    if (compression == "zstd") return unpackZstd(bytes, size, where);
    return valueError(where, format("the compression \"{}\" is not supported", compression),
                      "select zlib, gzip or zstd in Tiled");
}

Result<Cells> cellsFromBase64(const XmlElement& data, std::string_view compression, std::size_t count,
                              std::string_view where) {
    Result<std::string> packed = bytesFromBase64(data.text, where);
    if (!packed) return packed.error();
    const Result<std::string> bytes = unpacked(std::move(*packed), compression, count * 4, where);
    if (!bytes) return bytes.error();
    Cells cells;
    cells.reserve(bytes->size() / 4);
    for (std::size_t at = 0; at + 4 <= bytes->size(); at += 4) {
        Gid cell = 0;
        for (std::size_t i = 0; i < 4; ++i)
            cell |= Gid{static_cast<unsigned char>((*bytes)[at + i])} << (8 * i);
        cells.push_back(cell);
    }
    return cells;
}

/// Reads exactly `count` cells from `<data>` or `<chunk>`. @param part  `data` or one of its chunks
Result<Cells> readCells(const XmlElement& part, const XmlElement& data, std::size_t count,
                        std::string_view where) {
    const std::string_view encoding = attribute(data, "encoding");
    Result<Cells> cells = encoding.empty()    ? cellsFromElements(part, where)
                          : encoding == "csv" ? cellsFromCsv(part.text, count, where)
                          : encoding == "base64"
                              ? cellsFromBase64(part, attribute(data, "compression"), count, where)
                              : valueError(where, format("the encoding \"{}\" is not supported", encoding),
                                           "select csv or base64 in Tiled");
    if (cells && cells->size() != count) {
        return valueError(where,
                          format("found {} cells, expected {} for the layer's size", cells->size(), count),
                          "export the map again");
    }
    return cells;
}

struct Chunk {
    const XmlElement* element;
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

Result<int> chunkNumber(const XmlElement& chunk, std::string_view name, int min, int max,
                        std::string_view where) {
    const std::optional<std::int64_t> value = parseInt(attribute(chunk, name));
    if (value && *value >= min && *value <= max) return static_cast<int>(*value);
    return valueError(where, format("a chunk's {} is \"{}\", out of range", name, attribute(chunk, name)),
                      "export the map again");
}

Result<std::vector<Chunk>> findChunks(const XmlElement& data, std::string_view where) {
    constexpr int kFar = 1 << 28;
    std::vector<Chunk> chunks;
    for (const XmlElement& child : data.children) {
        if (child.name != "chunk") continue;
        Chunk chunk{&child};
        const struct {
            std::string_view name;
            int min;
            int max;
            int* value;
        } numbers[] = {{"x", -kFar, kFar, &chunk.x},
                       {"y", -kFar, kFar, &chunk.y},
                       {"width", 1, limits::kTileSide, &chunk.width},
                       {"height", 1, limits::kTileSide, &chunk.height}};
        for (const auto& number : numbers) {
            const Result<int> value = chunkNumber(child, number.name, number.min, number.max, where);
            if (!value) return value.error();
            *number.value = *value;
        }
        chunks.push_back(chunk);
    }
    return chunks;
}

std::size_t area(int width, int height) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// Sets the layer's position and size to the box around all chunks.
Result<Done> encloseChunks(const std::vector<Chunk>& chunks, tiled::Layer& layer, std::size_t room,
                           std::string_view where) {
    const Chunk& first = chunks.front();
    int right = first.x + first.width;
    int bottom = first.y + first.height;
    layer.x = first.x, layer.y = first.y;
    for (const Chunk& chunk : chunks) {
        layer.x = std::min(layer.x, chunk.x), layer.y = std::min(layer.y, chunk.y);
        right = std::max(right, chunk.x + chunk.width), bottom = std::max(bottom, chunk.y + chunk.height);
    }
    layer.width = right - layer.x, layer.height = bottom - layer.y;
    // Two chunks far apart would need a huge grid, nearly all of it empty.
    constexpr std::size_t kSmall = std::size_t{1} << 22;
    std::size_t filled = 0;
    for (const Chunk& chunk : chunks) filled += area(chunk.width, chunk.height);
    const bool fits = layer.width <= limits::kTileSide && layer.height <= limits::kTileSide;
    const std::size_t cells = fits ? area(layer.width, layer.height) : 0;
    if (!fits || cells > room || (cells > kSmall && cells / 64 > filled)) {
        return valueError(where, "the layer's chunks are too far apart",
                          "move the distant tiles closer to the others in Tiled");
    }
    return Done{};
}

Result<Done> readChunks(const std::vector<Chunk>& chunks, const XmlElement& data, tiled::Layer& layer,
                        std::size_t& room, std::string_view where) {
    if (const Result<Done> enclosed = encloseChunks(chunks, layer, room, where); !enclosed)
        return enclosed.error();
    layer.cells.assign(area(layer.width, layer.height), 0);
    room -= layer.cells.size();
    for (const Chunk& chunk : chunks) {
        const Result<Cells> cells = readCells(*chunk.element, data, area(chunk.width, chunk.height), where);
        if (!cells) return cells.error();
        for (int row = 0; row < chunk.height; ++row) {
            const auto from = cells->begin() + static_cast<std::ptrdiff_t>(area(chunk.width, row));
            const std::size_t to =
                area(layer.width, chunk.y - layer.y + row) + static_cast<std::size_t>(chunk.x - layer.x);
            std::copy(from, from + chunk.width, layer.cells.begin() + static_cast<std::ptrdiff_t>(to));
        }
    }
    return Done{};
}

}  // namespace

Result<Done> readTmxCells(const XmlElement& data, tiled::Layer& layer, std::size_t& room,
                          std::string_view where) {
    const Result<std::vector<Chunk>> chunks = findChunks(data, where);
    if (!chunks) return chunks.error();
    if (!chunks->empty()) return readChunks(*chunks, data, layer, room, where);

    const std::size_t count = area(layer.width, layer.height);
    const bool infiniteAndEmpty = data.children.empty() && trimmed(data.text).empty();
    if (count > room) return valueError(where, "the map has too many cells", "split it into several maps");
    if (infiniteAndEmpty) {
        layer.width = layer.height = 0;
        return Done{};
    }
    Result<Cells> cells = readCells(data, data, count, where);
    if (!cells) return cells.error();
    room -= count;
    layer.cells = std::move(*cells);
    return Done{};
}

}  // namespace plumb
