#pragma once

#include <array>
#include <span>
#include <string>

#include "core/file.hpp"
#include "tests/accuracy/stability/play.hpp"

namespace plumb::stability {

/// Number of cells with each score, indexed by Score.
using Counts = std::array<std::size_t, static_cast<std::size_t>(Score::Count)>;
Counts countsOf(std::span<const PlayedMap> maps);

/// Draws a map as an SVG: sign, color and error of each cell, and per row the range of good scores.
std::string pictureOf(const PlayedMap& map);
/// Draws a bar with the shares of all scores as an SVG of `width` px.
std::string shareBar(const Counts& counts, int width);
/// Draws the legend of the signs as an SVG.
std::string legendPicture();

std::string csvOf(std::span<const PlayedMap> maps);
std::string jsonOf(std::span<const PlayedMap> maps);
std::string pageOf(std::span<const PlayedMap> maps);  ///< self-contained HTML
/// @param pictures folder of the SVG files, relative to the Markdown file
std::string markdownOf(std::span<const PlayedMap> maps, std::string_view pictures);

/// Writes stability.csv, .json and .html.
Result<Done> writeReport(std::span<const PlayedMap> maps, const Path& folder);
/// Writes stability.md and stability/<map>.svg.
Result<Done> writeDocs(std::span<const PlayedMap> maps, const Path& folder);

}  // namespace plumb::stability
