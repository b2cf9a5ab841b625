#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tests/accuracy/report/options.hpp"
#include "tests/accuracy/report/row.hpp"
#include "tests/accuracy/report/scene_texts.hpp"

namespace plumb::accuracy {

/// In words: when, what was asked for, how long it took.
std::string howItRan(const Options& options, const std::vector<Row>& rows, double seconds);

/// The scenes whose plots stand in docs/accuracy.md, as accuracy/NAME.svg.
std::span<const std::string_view> guideScenes();

/// docs/accuracy.md.
std::string guideOf(const std::vector<Row>& rows, std::string_view how);

}  // namespace plumb::accuracy
