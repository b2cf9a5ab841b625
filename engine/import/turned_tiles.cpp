#include "import/turned_tiles.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/limits.hpp"
#include "core/text.hpp"
#include "import/tile_shapes.hpp"
#include "math/portable.hpp"

namespace plumb {
namespace {

using tiled::Gid;
using tiled::kFlipX;
using tiled::kFlipY;

constexpr float kHalfRootOf3 = 0.8660254f;                      // sine of 60 and of 120 degrees
constexpr float kCosines[] = {1.0f, 0.5f, -0.5f};               // of 0, 60 and 120 degrees
constexpr float kSines[] = {0.0f, kHalfRootOf3, kHalfRootOf3};  // clockwise on screen
constexpr std::size_t kMaxSheetBytes = std::size_t{64} << 20;   // pixels of all turned tiles of a tileset
constexpr Gid kLastGid = ~tiled::kFlags;

/// How a cell shows its tile: turned clockwise about its center, then flipped.
struct Turn {
    int steps = 0;  ///< of 60 degrees: 0, 1 or 2
    Gid flips = 0;
};

/// Tiled flips a tile before it turns it. A turn after one flip is the same flip after the opposite turn, and
/// that is half a turn (both flips) and 120 degrees for 60: so pictures of two turns are enough for all.
Turn turnOf(Gid gid) {
    constexpr Gid kBoth = kFlipX | kFlipY;
    Turn turn;
    turn.steps = ((gid & tiled::kFlipDiagonal) != 0 ? 1 : 0) + ((gid & tiled::kRotateHex) != 0 ? 2 : 0);
    turn.flips = gid & kBoth;
    const bool isMirrored = turn.flips == kFlipX || turn.flips == kFlipY;
    if (turn.steps == 3) {
        turn.steps = 0;
        turn.flips ^= kBoth;
    } else if (turn.steps != 0 && isMirrored) {
        turn.steps = 3 - turn.steps;
        turn.flips ^= kBoth;
    }
    return turn;
}

Vec2 turned(Vec2 v, int steps) {
    return {v.x * kCosines[steps] - v.y * kSines[steps], v.x * kSines[steps] + v.y * kCosines[steps]};
}
Vec2 turnedBack(Vec2 v, int steps) {
    return {v.x * kCosines[steps] + v.y * kSines[steps], v.y * kCosines[steps] - v.x * kSines[steps]};
}

using Variant = std::pair<int, int>;  // tile and steps of its turn

/// px around all pictures of a sheet, so that turned ones fit; the same for all, since a tileset has one
/// offset.
struct Margin {
    int x = 0;
    int y = 0;
};

/// A tile with a picture: its region in an image and the size at which the map draws it.
struct Picture {
    Variant variant;
    TileRegion region;
    int width = 0;  ///< px, without the margin
    int height = 0;
};

/// Draws a turned tile with its margin at a place of the sheet; of each pixel the nearest one of the image.
void drawTurned(const Image& image, const Picture& picture, Margin margin, int left, int top, Image& sheet) {
    const Rect& source = picture.region.source;
    const Vec2 size{static_cast<float>(picture.width), static_cast<float>(picture.height)};
    const Vec2 texels{source.width / size.x, source.height / size.y};
    for (int y = 0; y < picture.height + 2 * margin.y; ++y) {
        for (int x = 0; x < picture.width + 2 * margin.x; ++x) {
            const Vec2 pixel{static_cast<float>(x - margin.x) + 0.5f,
                             static_cast<float>(y - margin.y) + 0.5f};
            const Vec2 at = turnedBack(pixel - size * 0.5f, picture.variant.second) + size * 0.5f;
            if (at.x < 0.0f || at.y < 0.0f || at.x >= size.x || at.y >= size.y) continue;
            const int column = floorToInt(source.x + at.x * texels.x);
            const int row = floorToInt(source.y + at.y * texels.y);
            if (column >= image.width || row >= image.height) continue;
            const auto from =
                image.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(row) * image.width + column);
            std::copy_n(
                from, 4,
                sheet.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * sheet.width + left + x));
        }
    }
}

/// Makes the tileset with the turned tiles of one tileset.
class TurnedTileset {
public:
    TurnedTileset(const tiled::Map& map, const ImportedTileset& from, const std::set<Variant>& wanted)
        : from_{from}, original_{*from.original} {
        for (const Variant& variant : wanted) {
            const TileRegion region = from.pictureOf(variant.first);
            if (region.source.empty()) continue;
            const Vec2 size = scaled(from.sizeOf(variant.first), from.scaleIn(map, variant.first));
            pictures_.push_back({variant, region, floorToInt(size.x + 0.5f), floorToInt(size.y + 0.5f)});
        }
    }

    /// @param name  of the image within the import
    /// @return the tileset; nothing if there are no pictures, or too many for one image
    std::optional<tiled::Tileset> make(ImportStage& stage, const std::string& name) {
        if (!layOut()) return std::nullopt;
        for (std::size_t i = 0; i < pictures_.size(); ++i) {
            const Image& image = stage.pixels(pictures_[i].region.texture);
            if (image.rgba.empty()) return std::nullopt;
            const Rect place = placeOf(i);
            drawTurned(image, pictures_[i], margin_, static_cast<int>(place.x), static_cast<int>(place.y),
                       sheet_);
        }
        if (!stage.addImage(name, original_.name + " turned", sheet_)) return std::nullopt;
        return tileset(name);
    }

    /// Returns the tile of the new tileset for a tile and its turn.
    [[nodiscard]] std::optional<int> idOf(const Variant& variant) const {
        const auto found = std::lower_bound(
            pictures_.begin(), pictures_.end(), variant,
            [](const Picture& picture, const Variant& other) { return picture.variant < other; });
        if (found == pictures_.end() || found->variant != variant) return std::nullopt;
        return static_cast<int>(found - pictures_.begin());
    }

private:
    bool layOut() {
        if (pictures_.empty() || pictures_.size() > static_cast<std::size_t>(kMaxLooseTiles)) return false;
        for (const Picture& picture : pictures_) {
            const auto width = static_cast<float>(picture.width);
            const auto height = static_cast<float>(picture.height);
            const float wide = width * 0.5f + height * kHalfRootOf3;  // of the turned rectangle
            const float high = width * kHalfRootOf3 + height * 0.5f;
            margin_.x = std::max(margin_.x, static_cast<int>(std::ceil((wide - width) * 0.5f)));
            margin_.y = std::max(margin_.y, static_cast<int>(std::ceil((high - height) * 0.5f)));
        }
        for (const Picture& picture : pictures_) {
            slotWidth_ = std::max(slotWidth_, picture.width + 2 * margin_.x);
            slotHeight_ = std::max(slotHeight_, picture.height + 2 * margin_.y);
        }
        const auto count = static_cast<int>(pictures_.size());
        while (columns_ * columns_ < count) ++columns_;
        const std::int64_t width = std::int64_t{slotWidth_} * columns_;
        const std::int64_t height = std::int64_t{slotHeight_} * ((count + columns_ - 1) / columns_);
        const bool fits = width <= limits::kImageSide && height <= limits::kImageSide;
        if (!fits || static_cast<std::size_t>(width * height) * 4 > kMaxSheetBytes) return false;
        sheet_.width = static_cast<int>(width);
        sheet_.height = static_cast<int>(height);
        sheet_.rgba.assign(static_cast<std::size_t>(width * height) * 4, 0);
        return true;
    }

    [[nodiscard]] Rect placeOf(std::size_t index) const {
        const int column = static_cast<int>(index) % columns_;
        const int row = static_cast<int>(index) / columns_;
        return {static_cast<float>(column * slotWidth_), static_cast<float>(row * slotHeight_),
                static_cast<float>(pictures_[index].width + 2 * margin_.x),
                static_cast<float>(pictures_[index].height + 2 * margin_.y)};
    }

    [[nodiscard]] tiled::Tileset tileset(const std::string& name) const {
        tiled::Tileset made;
        made.name = original_.name + " turned";
        made.type = original_.type;
        made.properties = original_.properties;
        made.tileWidth = original_.tileWidth;
        made.tileHeight = original_.tileHeight;
        made.offsetX = original_.offsetX - margin_.x;
        made.offsetY = original_.offsetY + margin_.y;
        for (std::size_t i = 0; i < pictures_.size(); ++i) {
            tiled::Tile tile = tileOf(pictures_[i]);
            tile.id = static_cast<int>(i);
            tile.image = name;
            tile.source = placeOf(i);
            made.tiles.push_back(std::move(tile));
        }
        return made;
    }

    [[nodiscard]] tiled::Tile tileOf(const Picture& picture) const {
        const auto [id, steps] = picture.variant;
        tiled::Tile tile;
        const tiled::Tile* known = original_.find(id);
        if (known == nullptr) return tile;
        tile.type = known->type;
        tile.probability = known->probability;
        tile.properties = known->properties;
        for (const tiled::Frame& frame : known->animation) {
            if (const std::optional<int> shown = idOf({frame.tile, steps}))
                tile.animation.push_back({*shown, frame.milliseconds});
        }
        tile.collision = turnedShapes(*known, picture);
        return tile;
    }

    [[nodiscard]] std::vector<tiled::Object> turnedShapes(const tiled::Tile& tile,
                                                          const Picture& picture) const {
        const Vec2 size{static_cast<float>(picture.width), static_cast<float>(picture.height)};
        const Vec2 image = from_.sizeOf(tile.id);
        const Vec2 scale{size.x / image.x, size.y / image.y};
        const Vec2 center = size * 0.5f + Vec2{static_cast<float>(margin_.x), static_cast<float>(margin_.y)};
        std::vector<tiled::Object> shapes;
        for (const CollisionLine& line : collisionLinesOf(tile, original_, image.y)) {
            tiled::Object& shape = shapes.emplace_back();
            shape.id = static_cast<int>(shapes.size());
            shape.shape = line.closed ? tiled::Shape::Polygon : tiled::Shape::Polyline;
            for (const Vec2 point : line.points)
                shape.points.push_back(turned(scaled(point, scale) - size * 0.5f, picture.variant.second) +
                                       center);
        }
        return shapes;
    }

    const ImportedTileset& from_;
    const tiled::Tileset& original_;
    std::vector<Picture> pictures_;  // sorted by variant
    Margin margin_;
    int slotWidth_ = 0;  // px, with the margin
    int slotHeight_ = 0;
    int columns_ = 1;
    Image sheet_;
};

/// Replaces the turned tiles in the layers of a map.
class TurnedTiles {
public:
    TurnedTiles(tiled::Map& map, std::vector<ImportedTileset>& tilesets, SceneDraft& draft)
        : map_{map}, tilesets_{tilesets}, draft_{draft} {}

    void replace(const std::string& key) {
        const std::size_t count = map_.tilesets.size();
        for (std::size_t i = 0; i < count; ++i) {
            const std::vector<tiled::Layer*> layers = layersWithTurned(static_cast<int>(i));
            if (!layers.empty()) replaceIn(layers, i, format("turned/{}{}", key, i));
        }
        for (tiled::Layer& layer : map_.layers) {
            for (Gid& gid : layer.cells) gid = (gid & ~tiled::kFlags) | turnOf(gid).flips;
        }
    }

private:
    [[nodiscard]] std::vector<tiled::Layer*> layersWithTurned(int tileset) const {
        std::vector<tiled::Layer*> layers;
        for (tiled::Layer& layer : map_.layers) {
            const bool has = std::any_of(layer.cells.begin(), layer.cells.end(), [&](Gid gid) {
                return turnOf(gid).steps != 0 && map_.resolve(gid).tileset == tileset;
            });
            if (has) layers.push_back(&layer);
        }
        return layers;
    }

    void replaceIn(const std::vector<tiled::Layer*>& layers, std::size_t index, const std::string& name) {
        const auto tileset = static_cast<int>(index);
        TurnedTileset turned{map_, tilesets_[index], variantsIn(layers, tileset)};
        std::optional<tiled::Tileset> made = turned.make(draft_.stage, name);
        const Gid first = firstFreeGid();
        if (!made || first + made->tiles.size() > kLastGid) return tellUnturned(layers, index);
        for (tiled::Layer* layer : layers) {
            for (Gid& gid : layer->cells) {
                const tiled::TileRef tile = map_.resolve(gid);
                if (tile.tileset != tileset) continue;
                const Turn turn = turnOf(gid);
                if (const std::optional<int> id = turned.idOf({tile.id, turn.steps}))
                    gid = (first + static_cast<Gid>(*id)) | turn.flips;
            }
        }
        made->firstGid = first;
        addTileset(std::move(*made), index);
    }

    [[nodiscard]] std::set<Variant> variantsIn(const std::vector<tiled::Layer*>& layers, int tileset) const {
        std::set<Variant> variants;
        for (const tiled::Layer* layer : layers) {
            for (const Gid gid : layer->cells) {
                const tiled::TileRef tile = map_.resolve(gid);
                if (tile.tileset != tileset) continue;
                const int steps = turnOf(gid).steps;
                if (!variants.insert({tile.id, steps}).second) continue;
                const tiled::Tile* known = map_.tilesets[static_cast<std::size_t>(tileset)].find(tile.id);
                if (known == nullptr) continue;
                for (const tiled::Frame& frame : known->animation) variants.insert({frame.tile, steps});
            }
        }
        return variants;
    }

    [[nodiscard]] Gid firstFreeGid() const {
        Gid last = 0;
        for (const tiled::Tileset& tileset : map_.tilesets) last = std::max(last, tileset.firstGid);
        for (const tiled::Layer& layer : map_.layers) {
            for (const Gid gid : layer.cells) last = std::max(last, gid & ~tiled::kFlags);
        }
        return last + 1;
    }

    void addTileset(tiled::Tileset made, std::size_t from) {
        draft_.report.note(format("tileset {}: turned tiles have pictures of their own, in tileset {}",
                                  map_.tilesets[from].name, made.name));
        map_.tilesets.push_back(std::move(made));
        tilesets_.push_back(importTileset(map_, map_.tilesets.back(), draft_.stage));
        for (std::size_t i = 0; i < tilesets_.size(); ++i) tilesets_[i].original = &map_.tilesets[i];
        ++draft_.report.tilesets;
    }

    void tellUnturned(const std::vector<tiled::Layer*>& layers, std::size_t index) {
        int cells = 0;
        for (const tiled::Layer* layer : layers) {
            cells += static_cast<int>(std::count_if(layer->cells.begin(), layer->cells.end(), [&](Gid gid) {
                return turnOf(gid).steps != 0 && map_.resolve(gid).tileset == static_cast<int>(index);
            }));
        }
        draft_.report.problems.push_back(
            {format("tileset {}", map_.tilesets[index].name),
             format("{} cells are turned by 60 or 120 degrees, but no picture of that could be made", cells),
             "check that the image is there; split the tileset if it has very many tiles. The tiles are not "
             "turned"});
    }

    tiled::Map& map_;
    std::vector<ImportedTileset>& tilesets_;
    SceneDraft& draft_;
};

}  // namespace

void addTurnedTiles(tiled::Map& flat, std::vector<ImportedTileset>& tilesets, SceneDraft& draft,
                    const std::string& key) {
    TurnedTiles{flat, tilesets, draft}.replace(key);
}

}  // namespace plumb
