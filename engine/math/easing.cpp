#include "math/easing.hpp"

#include "math/portable.hpp"

namespace plumb {
namespace {

/// Penner's constant for Back: the curve exceeds the end by 10 %.
constexpr float kBack = 1.70158f;
constexpr float kBackBoth = kBack * 1.525f;  // for both ends, with the same excess

float backIn(float t, float excess) { return t * t * ((excess + 1.0f) * t - excess); }

float bounceOut(float t) {
    constexpr float kHeight = 7.5625f;  // 2.75^2: four parabolas with widths 1, 1, 1/2, 1/4 of 1/2.75
    constexpr float kWidth = 1.0f / 2.75f;
    if (t < kWidth) return kHeight * t * t;
    if (t < 2.0f * kWidth) return t -= 1.5f * kWidth, kHeight * t * t + 0.75f;
    if (t < 2.5f * kWidth) return t -= 2.25f * kWidth, kHeight * t * t + 0.9375f;
    return t -= 2.625f * kWidth, kHeight * t * t + 0.984375f;
}

/// A swing with a period of 0.3 whose amplitude halves every tenth of the time.
float elasticOut(float t) {
    constexpr float kPeriod = 0.3f;
    constexpr float kHalving = -6.9314718f;  // -10 ln 2
    return exponential(kHalving * t) * sine((t - kPeriod / 4.0f) * kTau / kPeriod) + 1.0f;
}

/// The curve forwards up to the middle, and reversed from there on.
template <class In>
float both(In in, float t) {
    return t < 0.5f ? in(2.0f * t) * 0.5f : 1.0f - in(2.0f - 2.0f * t) * 0.5f;
}

}  // namespace

float eased(Ease ease, float time) {
    if (!(time > 0.0f)) return 0.0f;
    if (time >= 1.0f) return 1.0f;
    const float t = time;
    const float rest = 1.0f - t;
    switch (ease) {
        case Ease::Linear: return t;
        case Ease::QuadIn: return t * t;
        case Ease::QuadOut: return 1.0f - rest * rest;
        case Ease::QuadInOut: return both([](float x) { return x * x; }, t);
        case Ease::CubicIn: return t * t * t;
        case Ease::CubicOut: return 1.0f - rest * rest * rest;
        case Ease::CubicInOut: return both([](float x) { return x * x * x; }, t);
        case Ease::SineIn: return 1.0f - cosine(t * kPi * 0.5f);
        case Ease::SineOut: return sine(t * kPi * 0.5f);
        case Ease::SineInOut: return 0.5f - 0.5f * cosine(t * kPi);
        case Ease::BackIn: return backIn(t, kBack);
        case Ease::BackOut: return 1.0f - backIn(rest, kBack);
        case Ease::BackInOut: return both([](float x) { return backIn(x, kBackBoth); }, t);
        case Ease::ElasticOut: return elasticOut(t);
        case Ease::BounceOut: return bounceOut(t);
    }
    return t;
}

}  // namespace plumb
