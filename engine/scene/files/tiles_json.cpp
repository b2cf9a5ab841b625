#include "scene/files/tiles_json.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "scene/files/tile_texts.hpp"
#include "scene/files/zlib_block.hpp"

namespace plumb {
namespace {

constexpr std::size_t kMostCellsAsText = 256 * 256;       // larger grids are written as blocks
constexpr std::size_t kBandCells = 131072;                // cells per band in files without blocks
constexpr std::size_t kMostCells = std::size_t{1} << 26;  // limit for formats that store empty cells
constexpr int kBlockChunks = 4;  // chunks per side of a block, which is one line of the file
constexpr int kBlockSide = kBlockChunks * TileGrid::kChunkSide;
using Block = std::array<TileCell, std::size_t{kBlockSide} * kBlockSide>;

struct Flip {
    TileCell bit;
    char letter;
};
constexpr std::array kFlips{Flip{kTileFlipX, 'x'}, Flip{kTileFlipY, 'y'}, Flip{kTileFlipDiagonal, 'd'}};

void appendCell(std::string& row, TileCell cell) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), cell & ~kTileFlips).ptr;
    row.append(digits.data(), end);
    for (const Flip& flip : kFlips) {
        if ((cell & flip.bit) != 0) row += flip.letter;
    }
}

std::string rowText(const TileGrid& grid, int y) {
    std::string row;
    row.reserve(static_cast<std::size_t>(grid.width()) * 2);
    for (int x = 0; x < grid.width(); ++x) {
        if (x > 0) row += ' ';
        appendCell(row, grid.at(x, y));
    }
    return row;
}

/// Appends the cells of a row's text.
/// @return false if a cell is invalid
bool readRow(std::string_view text, std::vector<TileCell>& cells) {
    const char* at = text.data();
    const char* const end = at + text.size();
    while (true) {
        while (at != end && *at == ' ') ++at;
        if (at == end) return true;
        TileCell cell = 0;
        const auto [behind, failure] = std::from_chars(at, end, cell);
        if (failure != std::errc{} || (cell & kTileFlips) != 0) return false;
        at = behind;
        for (; at != end && *at != ' '; ++at) {
            const auto flip =
                std::find_if(kFlips.begin(), kFlips.end(), [at](const Flip& f) { return f.letter == *at; });
            if (flip == kFlips.end()) return false;
            cell |= flip->bit;
        }
        cells.push_back(cell);
    }
}

std::size_t bandRows(std::size_t width) { return std::clamp<std::size_t>(kBandCells / width, 1, 64); }

int blocksFor(int cells) { return (cells + kBlockSide - 1) / kBlockSide; }

BlockStamps stampsOf(const TileGrid& grid, int column, int row) {
    BlockStamps stamps{};
    static_assert(std::tuple_size_v<BlockStamps> == std::size_t{kBlockChunks} * kBlockChunks);
    std::size_t at = 0;
    for (int y = row * kBlockChunks; y < (row + 1) * kBlockChunks; ++y) {
        for (int x = column * kBlockChunks; x < (column + 1) * kBlockChunks; ++x, ++at) {
            if (x >= grid.chunkColumns() || y >= grid.chunkRows()) continue;
            if (const TileGrid::Chunk* chunk = grid.chunk(x, y)) stamps[at] = chunk->stamp;
        }
    }
    return stamps;
}

/// Returns "3 0 =5x" for a block of equal cells, otherwise "3 0 eNrt…"; empty for an empty block.
std::string blockText(const TileGrid& grid, int column, int row, Block& block) {
    const BlockStamps stamps = stampsOf(grid, column, row);
    if (stamps == BlockStamps{}) return {};
    if (const auto known = knownTileText(stamps)) return format("{} {} {}", column, row, *known);
    for (int y = 0; y < kBlockSide; ++y) {
        grid.copyRow(column * kBlockSide, row * kBlockSide + y, kBlockSide,
                     block.data() + static_cast<std::size_t>(y) * kBlockSide);
    }
    const bool plain =
        std::all_of(block.begin(), block.end(), [&](TileCell cell) { return cell == block[0]; });
    if (plain && block[0] == 0) return {};
    std::string text = format("{} {} ", column, row);
    if (!plain) {
        const std::string packed = packedText(block);
        rememberTileText(stamps, packed);
        return text + packed;
    }
    text += '=';
    appendCell(text, block[0]);
    return text;
}

Json blocksToJson(const TileGrid& grid) {
    const auto block = std::make_unique<Block>();
    Json blocks = Json::array();
    for (int row = 0; row < blocksFor(grid.height()); ++row) {
        for (int column = 0; column < blocksFor(grid.width()); ++column) {
            std::string text = blockText(grid, column, row, *block);
            if (!text.empty()) blocks.push_back(std::move(text));
        }
    }
    return blocks;
}

Error wrongSize(const Json& json, const char* key) {
    const auto found = json.find(key);
    return {key,
            format("expected 0 to {}, found {}", limits::kTileSide,
                   found == json.end() ? "nothing" : foundText(*found)),
            "write the number of tiles"};
}

std::optional<int> sideOf(const Json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_number_integer()) return std::nullopt;
    const auto number = found->get<std::int64_t>();
    if (number < 0 || number > limits::kTileSide) return std::nullopt;
    return static_cast<int>(number);
}

Result<ReadTiles> readRows(const Json& rows, int width, int height) {
    ReadTiles read;
    std::vector<TileCell> cells(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    std::vector<TileCell> row;
    int wrongRows = 0;
    int firstWrong = 0;
    for (int y = 0; y < static_cast<int>(std::min<std::size_t>(rows.size(), limits::kTileSide)); ++y) {
        const Json& item = rows[static_cast<std::size_t>(y)];
        row.clear();
        if (!item.is_string() || !readRow(*item.get_ptr<const std::string*>(), row)) {
            return Error{format("rows[{}]", y), "expected tile numbers, found " + foundText(item),
                         "write numbers with spaces between, 0 for empty, e.g. \"1 2 0 5x\""};
        }
        if (row.size() != static_cast<std::size_t>(width) && wrongRows++ == 0) firstWrong = y;
        row.resize(static_cast<std::size_t>(width));
        if (y < height) std::copy(row.begin(), row.end(), cells.begin() + std::ptrdiff_t{y} * width);
    }
    if (wrongRows > 0) {
        read.problem = format("{} of {} rows do not have {} tiles, the first is rows[{}]", wrongRows,
                              rows.size(), width, firstWrong);
    } else if (rows.size() != static_cast<std::size_t>(height)) {
        read.problem = format("found {} rows, the height is {}", rows.size(), height);
    }
    read.remedy = "missing tiles are empty, surplus ones are dropped; make width, height and rows agree";
    read.grid.replaceCells(width, height, cells);
    return read;
}

Result<ReadTiles> readBands(const Json& bands, int width, int height) {
    const auto columns = static_cast<std::size_t>(width);
    std::vector<TileCell> cells(columns * static_cast<std::size_t>(height));
    const std::size_t step = columns == 0 ? 1 : bandRows(columns) * columns;
    const std::size_t wanted = (cells.size() + step - 1) / step;
    if (!bands.is_array() || bands.size() != wanted) {
        return Error{"base64", format("expected a list of {} strings, found {}", wanted, foundText(bands)),
                     "export the map again from the program that created it"};
    }
    for (std::size_t band = 0; band < wanted; ++band) {
        const auto* text = bands[band].get_ptr<const std::string*>();
        const std::size_t count = std::min(step, cells.size() - band * step);
        if (text == nullptr || !unpackText(*text, {cells.data() + band * step, count})) {
            return Error{format("base64[{}]", band), "the compressed tiles are damaged",
                         "export the map again from the program that created it"};
        }
    }
    ReadTiles read;
    read.grid.replaceCells(width, height, cells);
    return read;
}

/// Removes the next number from the text and returns it; nullopt if there is none in 0 .. count - 1.
std::optional<int> takeNumber(std::string_view& text, int count) {
    int number = -1;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (failure != std::errc{} || number < 0 || number >= count) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    if (text.empty() || text.front() != ' ') return std::nullopt;
    text.remove_prefix(1);
    return number;
}

class BlockReader {
public:
    explicit BlockReader(TileGrid& grid) : grid_{grid} {}

    /// @return false if the text is not a block
    bool read(std::string_view text) {
        const std::optional<int> column = takeNumber(text, blocksFor(grid_.width()));
        const std::optional<int> row = column ? takeNumber(text, blocksFor(grid_.height())) : std::nullopt;
        if (!row || text.empty()) return false;
        column_ = *column, row_ = *row;
        return text.front() == '=' ? fill(text.substr(1)) : unpack(text);
    }

private:
    bool fill(std::string_view text) {
        std::vector<TileCell> cells;
        if (!readRow(text, cells) || cells.size() != 1) return false;
        // Large areas of one tile share one chunk.
        if (plain_ == nullptr || plain_->cells.front() != cells.front())
            plain_ = TileGrid::filled(cells.front());
        eachChunk([&](int x, int y) { grid_.put(x, y, plain_); });
        return true;
    }

    bool unpack(std::string_view text) {
        if (!unpackText(text, *block_)) return false;
        eachChunk([&](int x, int y) {
            constexpr int kSide = TileGrid::kChunkSide;
            auto chunk = TileGrid::filled(1);
            for (int line = 0; line < kSide; ++line) {
                const int from =
                    ((y % kBlockChunks) * kSide + line) * kBlockSide + (x % kBlockChunks) * kSide;
                std::copy_n(block_->begin() + from, kSide,
                            chunk->cells.begin() + std::ptrdiff_t{line} * kSide);
            }
            const bool empty = std::all_of(chunk->cells.begin(), chunk->cells.end(),
                                           [](TileCell cell) { return cell == 0; });
            grid_.put(x, y, empty ? nullptr : std::move(chunk));
        });
        rememberTileText(stampsOf(grid_, column_, row_), std::string{text});
        return true;
    }

    template <class Visit>
    void eachChunk(Visit visit) const {
        for (int y = row_ * kBlockChunks; y < std::min((row_ + 1) * kBlockChunks, grid_.chunkRows()); ++y) {
            for (int x = column_ * kBlockChunks;
                 x < std::min((column_ + 1) * kBlockChunks, grid_.chunkColumns()); ++x)
                visit(x, y);
        }
    }

    TileGrid& grid_;
    std::unique_ptr<Block> block_ = std::make_unique<Block>();
    std::shared_ptr<TileGrid::Chunk> plain_;
    int column_ = 0;
    int row_ = 0;
};

Result<ReadTiles> readBlocks(const Json& blocks, int width, int height) {
    if (!blocks.is_array())
        return Error{"blocks", "expected a list, found " + foundText(blocks),
                     "export the map again from the program that created it"};
    ReadTiles read;
    read.grid = TileGrid{width, height};
    BlockReader reader{read.grid};
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const auto* text = blocks[i].get_ptr<const std::string*>();
        if (text == nullptr || !reader.read(*text)) {
            return Error{
                format("blocks[{}]", i),
                "expected \"column row =tile\" or \"column row data\", found " + foundText(blocks[i]),
                "export the map again from the program that created it"};
        }
    }
    return read;
}

}  // namespace

Json tilesToJson(const TileGrid& grid) {
    Json json = Json::object();
    json["width"] = grid.width();
    json["height"] = grid.height();
    if (grid.cellCount() > kMostCellsAsText) {
        json["blocks"] = blocksToJson(grid);
        return json;
    }
    Json& rows = json["rows"] = Json::array();
    for (int y = 0; y < grid.height(); ++y) rows.push_back(rowText(grid, y));
    return json;
}

Result<ReadTiles> tilesFromJson(const Json& json) {
    if (json.is_null()) return ReadTiles{};
    if (!json.is_object()) {
        return Error{"", "expected an object, found " + foundText(json),
                     "write {\"width\": 2, \"height\": 1, \"rows\": [\"1 2\"]}"};
    }
    const std::optional<int> width = sideOf(json, "width");
    if (!width) return wrongSize(json, "width");
    const std::optional<int> height = sideOf(json, "height");
    if (!height) return wrongSize(json, "height");
    if (const auto blocks = json.find("blocks"); blocks != json.end())
        return readBlocks(*blocks, *width, *height);
    if (static_cast<std::size_t>(*width) * static_cast<std::size_t>(*height) > kMostCells) {
        return Error{"width", format("{} x {} tiles exceed the limit of {}", *width, *height, kMostCells),
                     "split the map"};
    }
    if (const auto bands = json.find("base64"); bands != json.end())
        return readBands(*bands, *width, *height);
    const auto rows = json.find("rows");
    if (rows == json.end() || !rows->is_array()) {
        return Error{"rows",
                     "expected a list of rows, found " + (rows == json.end() ? "nothing" : foundText(*rows)),
                     "write one string per row, e.g. [\"1 2 0\", \"0 0 3\"]"};
    }
    return readRows(*rows, *width, *height);
}

}  // namespace plumb
