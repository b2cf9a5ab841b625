#pragma once

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "physics/terrain/terrain_outlines.hpp"

namespace plumb::physics::test {

/// All corners of random terrains are multiples of this length (units), so that edges consist of whole steps.
inline constexpr std::int32_t kStep = kCellUnits / 4;

/// Number of random terrains of a test: the environment variable PLUMB_MASKS if set, otherwise `usual`.
inline int masksToTry(int usual) {
    const char* wanted = std::getenv("PLUMB_MASKS");
    return wanted != nullptr ? std::max(std::atoi(wanted), 1) : usual;
}

/// Random cells: from full tiles only up to all tile forms, polygons, materials and layers.
class RandomCells {
public:
    RandomCells(TilePalette& palette, Random& random) : random_{random} {
        const std::uint32_t richness = random.below(4);
        forms_ = {TileForm::Full};
        if (richness >= 1)
            forms_.insert(forms_.end(),
                          {TileForm::Full, TileForm::OneWay, TileForm::SlopeUp, TileForm::SlopeDown});
        for (int form = 1; form < static_cast<int>(TileForm::Count) && richness >= 2; ++form) {
            forms_.push_back(*palette.flipped(static_cast<TileForm>(form), random.next()));
        }
        for (int i = 0; i < 6 && richness >= 3; ++i) addPolygon(palette);
        for (std::uint32_t i = random.below(3); i > 0; --i)
            materials_.push_back(*palette.addMaterial({.friction = static_cast<float>(i)}));
        constexpr TileLayers kLayers[] = {{2}, {3}, {1, 7}};
        for (std::uint32_t i = random.below(6); i >= 3; --i)
            layers_.push_back(*palette.addLayers(kLayers[i - 3]));
        density_ = random.between(0.05f, 1.0f);
    }

    MaskCell next() {
        if (random_.unit() >= density_) return {};
        return {pick(forms_), pick(materials_), pick(layers_)};
    }

private:
    template <class T>
    T pick(const std::vector<T>& list) {
        return list[random_.below(static_cast<std::uint32_t>(list.size()))];
    }

    /// Adds a polygon with random corners on a grid of quarter cells, unless it is not convex.
    void addPolygon(TilePalette& palette) {
        std::vector<Vec2> points;
        for (std::uint32_t i = 3 + random_.below(3); i > 0; --i) {
            points.push_back(
                {static_cast<float>(random_.below(5)) / 4, static_cast<float>(random_.below(5)) / 4});
        }
        const auto form =
            palette.addPolygon(points, static_cast<OneWay>(random_.below(8) < 6 ? 0 : random_.below(5)));
        if (form.ok()) forms_.push_back(*form);
    }

    Random& random_;
    std::vector<TileForm> forms_;
    std::vector<std::uint8_t> materials_{0};
    std::vector<std::uint8_t> layers_{0};
    float density_ = 0.5f;
};

/// Creates a random mask: independent random cells, sometimes with uniform rectangles on top.
inline TileMask randomMask(int width, int height, Random& random) {
    TileMask mask{width, height};
    RandomCells cells{mask.palette, random};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) mask.set(x, y, cells.next());
    }
    for (std::uint32_t areas = random.below(2) * random.below(8); areas > 0; --areas) {
        const MaskCell cell = cells.next();
        const int x0 = static_cast<int>(random.below(static_cast<std::uint32_t>(width)));
        const int y0 = static_cast<int>(random.below(static_cast<std::uint32_t>(height)));
        const int x1 = x0 + static_cast<int>(random.below(12));
        const int y1 = y0 + static_cast<int>(random.below(12));
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) mask.set(x, y, cell);
        }
    }
    return mask;
}

/// Twice the signed area of an outline, units^2.
inline std::int64_t doubleAreaOf(const TileOutline& outline) {
    std::int64_t sum = 0;
    for (const TileOutline::Edge& edge : outline.edges) sum += cross(edge.a, edge.b);
    return sum;
}

/// Twice the area of all solid cells of a mask, computed from the tile outlines, units^2.
inline std::int64_t doubleAreaOf(const TileMask& mask) {
    std::int64_t sum = 0;
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            const TileOutline& outline = mask.palette.outline(mask.at(x, y).form);
            if (outline.isSolid()) sum += doubleAreaOf(outline);
        }
    }
    return sum;
}

/// Builds a mask from characters: # full, - one-way, / slope up, \ slope down, any other empty.
inline TileMask drawn(const std::vector<const char*>& rows) {
    const auto width = static_cast<int>(std::string_view{rows.front()}.size());
    TileMask mask{width, static_cast<int>(rows.size())};
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < width; ++x) {
            const char c = rows[static_cast<std::size_t>(y)][x];
            if (c == '#') mask.set(x, y, {TileForm::Full});
            if (c == '-') mask.set(x, y, {TileForm::OneWay});
            if (c == '/') mask.set(x, y, {TileForm::SlopeUp});
            if (c == '\\') mask.set(x, y, {TileForm::SlopeDown});
        }
    }
    return mask;
}

inline TerrainOutlines built(TileMask mask, int chunkCells = TerrainOutlines::kChunkCells) {
    TerrainOutlines terrain{std::move(mask), chunkCells};
    terrain.update();
    return terrain;
}

inline std::vector<TerrainSegment> allSegments(const TerrainOutlines& terrain) {
    std::vector<TerrainSegment> all;
    for (const TerrainOutline& outline : terrain.chunks())
        all.insert(all.end(), outline.begin(), outline.end());
    return all;
}

}  // namespace plumb::physics::test
