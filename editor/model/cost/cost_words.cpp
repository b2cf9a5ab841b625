#include "editor/model/cost/cost_words.hpp"

#include <algorithm>
#include <cmath>

#include "core/text.hpp"

namespace plumb::editor {
namespace {

constexpr float kAlike = 1.1f;  // errors that differ by a smaller factor count as equal

std::string number(float value) {
    const int digits = value < 0.0995f ? 2 : value < 9.95f ? 1 : 0;
    return fixedText(static_cast<double>(value), digits);
}

std::string seconds(int ticks) { return fixedText(ticks / 60.0, 1); }

bool isSameCost(float a, float b) { return std::abs(a - b) < std::max(2.0f, 0.05f * std::max(a, b)); }

std::string costDifference(float microseconds) {
    return format("{}{}", microseconds < 0.0f ? "-" : "+", costWords(std::abs(microseconds)));
}

}  // namespace

float pixelsOf(float metres, PixelScale scale) { return metres * scale.pixels; }

std::string lengthWords(float metres, PixelScale scale) {
    if (metres < 1.0e-5f) return "less than 0.01 mm";
    const std::string millimetres =
        metres < 0.995f ? format("{} mm", number(metres * 1000.0f)) : format("{} m", number(metres));
    return format("{} ({} px)", millimetres, number(pixelsOf(metres, scale)));
}

std::string costWords(float microseconds) {
    const float milliseconds = microseconds * 0.001f;
    if (milliseconds < 0.00995f) return format("{} µs", fixedText(static_cast<double>(microseconds), 1));
    const int digits = milliseconds < 0.0995f ? 3 : milliseconds < 9.95f ? 2 : 1;
    return format("{} ms", fixedText(static_cast<double>(milliseconds), digits));
}

std::string qualityWords(const WhatIfResult& result, const WhatIfPoint& point, const WhatIfPoint* below) {
    const std::string error = lengthWords(point.error(), result.scale);
    if (below == nullptr)
        return format("Quality {}: {}, largest error {}.", point.quality, costWords(point.microseconds),
                      error);
    return format("Quality {}: {}, error {}.", point.quality,
                  costDifference(point.microseconds - below->microseconds), error);
}

const WhatIfPoint* enoughQuality(const WhatIfResult& result) {
    const WhatIfPoint* best = nullptr;
    for (int quality = 0; quality <= physics::kMaxQuality; ++quality) {
        const WhatIfPoint* point = result.find(WhatIfKind::Quality, quality);
        if (point == nullptr) return nullptr;
        if (pixelsOf(point->error(), result.scale) < kSeenPixels) return point;
        if (best == nullptr || point->error() * kAlike < best->error()) best = point;
    }
    return best;
}

std::string verdictWords(const WhatIfResult& result) {
    const WhatIfPoint* now = result.present();
    const WhatIfPoint* enough = enoughQuality(result);
    if (!result.complete || now == nullptr || enough == nullptr) return {};
    const float pixels = pixelsOf(now->error(), result.scale);
    const std::string use = format(
        "Current quality {}{}: {} per tick, largest error {}, which {}.", now->quality,
        now->kind == WhatIfKind::Automatic ? " with automatic quality" : "", costWords(now->microseconds),
        lengthWords(now->error(), result.scale), pixels < kSeenPixels ? "is not visible" : "may be visible");
    if (enough->quality == now->quality)
        return format("{} {}", use,
                      pixels < kSeenPixels ? "No cheaper quality has an invisible error."
                                           : "A higher quality does not reduce it much here.");
    if (isSameCost(enough->microseconds, now->microseconds))
        return format("{} {}", use,
                      pixels < kSeenPixels ? "A lower quality would save almost nothing."
                                           : format("Quality {} costs the same, error {}.", enough->quality,
                                                    lengthWords(enough->error(), result.scale)));
    const bool dearer = enough->microseconds > now->microseconds;
    return format("{} Quality {} {} {}{}, error {}.", use, enough->quality, dearer ? "costs" : "saves",
                  costWords(std::abs(enough->microseconds - now->microseconds)), dearer ? " more" : "",
                  lengthWords(enough->error(), result.scale));
}

std::string methodWords(const WhatIfResult& result, bool wasPlaying, std::uint32_t leftOut) {
    std::string words = format("Measured: {} {} s{}, {} bodies, only physics, none asleep. ",
                               wasPlaying ? "the last" : "the scene's first", seconds(result.ticks),
                               result.ticks < result.ticksOnTape
                                   ? format(" (of {}: more would take too long)", seconds(result.ticksOnTape))
                                   : std::string{},
                               result.bodies);
    words +=
        "Error: the largest overlap or joint gap, median over the second half. "
        "Reference: quality 6 with half the time step.";
    if (leftOut > 0)
        words += format(" {} bodies and joints that were created meanwhile are left out.", leftOut);
    return words;
}

}  // namespace plumb::editor
