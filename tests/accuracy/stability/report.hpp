#pragma once

#include <array>
#include <span>
#include <string>

#include "core/file.hpp"
#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// Number of cells with each score, by Score.
using Counts = std::array<std::size_t, static_cast<std::size_t>(Score::Count)>;
Counts countsOf(std::span<const PlayedMap> maps);

/// A map as a separate SVG: a letter, a color and an error in each cell, and the range in which a row holds.
std::string pictureOf(const PlayedMap& map);
/// One bar of the shares of all scores, as an SVG.
std::string shareBar(const Counts& counts, int width);
/// The legend of the signs, as an SVG.
std::string legendPicture();

std::string csvOf(std::span<const PlayedMap> maps);
std::string jsonOf(std::span<const PlayedMap> maps);
std::string pageOf(std::span<const PlayedMap> maps);  ///< self-contained HTML
/// @param pictures the folder of the pictures, relative to the text
std::string markdownOf(std::span<const PlayedMap> maps, std::string_view pictures);

/// stability.csv, .json and .html.
Result<Done> writeReport(std::span<const PlayedMap> maps, const Path& folder);
/// stability.md and stability/<map>.svg.
Result<Done> writeDocs(std::span<const PlayedMap> maps, const Path& folder);

}  // namespace plumb::stability
