#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace plumb {

enum class CurveShape : std::uint32_t { Smooth, Linear };

struct CurveKey {
    float at = 0.0f;  ///< ratio, 0..1
    float value = 0.0f;
    friend bool operator==(CurveKey, CurveKey) = default;
};

/// A value that changes along 0..1, e.g. over a life: a few keys in place, so that what holds it stays plain
/// data. Between keys it is straight or smooth, and smooth never swings beyond the two keys beside it.
/// Before the first key and after the last it stays at theirs.
/// Invariant: at least one key, `at` grows from key to key; unused keys are CurveKey{}, so that equal curves
/// have equal bytes.
struct Curve {
    static constexpr std::size_t kKeys = 8;

    std::array<CurveKey, kKeys> keys{CurveKey{0.0f, 1.0f}};
    std::uint32_t count = 1;
    CurveShape shape = CurveShape::Smooth;

    static constexpr Curve constant(float value) {
        Curve curve;
        curve.keys[0].value = value;
        return curve;
    }
    static constexpr Curve line(float from, float to) {
        Curve curve;
        curve.keys[0] = {0.0f, from};
        curve.keys[1] = {1.0f, to};
        curve.count = 2;
        return curve;
    }
    static constexpr Curve hump(float ends, float middle) {
        Curve curve = line(ends, middle);
        curve.keys[1].at = 0.5f;
        curve.keys[2] = {1.0f, ends};
        curve.count = 3;
        return curve;
    }

    /// 1..kKeys, whatever memory says.
    [[nodiscard]] constexpr std::size_t size() const {
        return count == 0 ? 1 : count < kKeys ? count : kKeys;
    }
    [[nodiscard]] bool full() const { return size() == kKeys; }

    /// The same bits on every machine. Exact at keys.
    /// Source: F. Fritsch, R. Carlson, "Monotone Piecewise Cubic Interpolation", 1980; slopes as in F.
    /// Fritsch, J. Butland, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants", 1984.
    [[nodiscard]] float valueAt(float at) const;

    /// Puts a key in its place among the others. @return its index, or kKeys when there is no room or a key
    /// stands there already
    std::size_t insert(CurveKey key);
    /// The last key stays: nothing happens then.
    void remove(std::size_t index);
    /// Moves a key, not past its neighbours: it stays kCloseness away from them.
    void move(std::size_t index, CurveKey key);
    static constexpr float kCloseness = 0.005f;  ///< ratio

    friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace plumb
