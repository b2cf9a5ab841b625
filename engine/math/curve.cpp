#include "math/curve.hpp"

#include <algorithm>

namespace plumb {
namespace {

float slopeBetween(const CurveKey& from, const CurveKey& to) {
    return (to.value - from.value) / (to.at - from.at);
}

/// The slope at a key: 0 at a local extremum, else the harmonic mean of the adjacent slopes,
/// weighted so that monotone data gives a monotone curve. At an end: the slope to the only neighbor.
float slopeAt(const Curve& curve, std::size_t index) {
    const auto& keys = curve.keys;
    const std::size_t last = curve.size() - 1;
    if (index == 0) return slopeBetween(keys[0], keys[1]);
    if (index == last) return slopeBetween(keys[last - 1], keys[last]);
    const float before = slopeBetween(keys[index - 1], keys[index]);
    const float after = slopeBetween(keys[index], keys[index + 1]);
    if (!(before * after > 0.0f)) return 0.0f;
    const float left = keys[index].at - keys[index - 1].at;
    const float right = keys[index + 1].at - keys[index].at;
    const float leftWeight = 2.0f * right + left;
    const float rightWeight = right + 2.0f * left;
    return (leftWeight + rightWeight) / (leftWeight / before + rightWeight / after);
}

}  // namespace

float Curve::valueAt(float at) const {
    const std::size_t last = size() - 1;
    if (!(at > keys[0].at)) return keys[0].value;  // also for NaN
    if (at >= keys[last].at) return keys[last].value;
    std::size_t right = 1;
    while (keys[right].at <= at) ++right;
    const CurveKey& from = keys[right - 1];
    const CurveKey& to = keys[right];
    const float width = to.at - from.at;
    const float t = (at - from.at) / width;
    const float rise = to.value - from.value;
    float value = from.value + rise * t;
    if (shape == CurveShape::Smooth) {
        // Hermite's polynomial, as the difference from the straight line.
        const float start = slopeAt(*this, right - 1) * width - rise;
        const float end = slopeAt(*this, right) * width - rise;
        const float back = 1.0f - t;
        value += t * back * (start * back - end * t);
    }
    // Rounding could exceed the values of the keys.
    return std::clamp(value, std::min(from.value, to.value), std::max(from.value, to.value));
}

std::size_t Curve::insert(CurveKey key) {
    if (full()) return kKeys;
    std::size_t index = 0;
    while (index < size() && keys[index].at < key.at) ++index;
    if (index < size() && keys[index].at == key.at) return kKeys;
    for (std::size_t i = size(); i > index; --i) keys[i] = keys[i - 1];
    keys[index] = key;
    ++count;
    return index;
}

void Curve::remove(std::size_t index) {
    if (count <= 1 || index >= size()) return;
    for (std::size_t i = index; i + 1 < size(); ++i) keys[i] = keys[i + 1];
    keys[size() - 1] = {};
    --count;
}

void Curve::move(std::size_t index, CurveKey key) {
    if (index >= size()) return;
    const float low = index == 0 ? 0.0f : keys[index - 1].at + kCloseness;
    const float high = index + 1 == size() ? 1.0f : keys[index + 1].at - kCloseness;
    keys[index] = {high < low ? keys[index].at : std::clamp(key.at, low, high), key.value};
}

}  // namespace plumb
