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

/// A value that changes along 0..1, e.g. over a lifetime: a few inline keys, so that it
/// stays plain data. It is linear or smooth between keys; smooth curves never exceed the
/// two adjacent keys. Before the first key and after the last the value is constant.
/// Invariant: at least one key, `at` increases from key to key; unused keys are
/// CurveKey{}, so that equal curves have equal bytes.
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

    /// The number of keys: 1..kKeys, even if `count` is invalid.
    [[nodiscard]] constexpr std::size_t size() const {
        return count == 0 ? 1 : count < kKeys ? count : kKeys;
    }
    [[nodiscard]] bool full() const { return size() == kKeys; }

    /// Returns the value at a position, exact at keys, with the same bits on every machine.
    /// Source: F. Fritsch, R. Carlson, "Monotone Piecewise Cubic Interpolation", 1980; slopes as in F.
    /// Fritsch, J. Butland, "A Method for Constructing Local Monotone Piecewise Cubic Interpolants", 1984.
    [[nodiscard]] float valueAt(float at) const;

    /// Inserts a key at its position. @return its index, or kKeys
    /// if there is no room or a key at this position already
    std::size_t insert(CurveKey key);
    /// Removes a key, unless it is the only one.
    void remove(std::size_t index);
    /// Moves a key, but not past its neighbors: it keeps a distance of kCloseness from them.
    void move(std::size_t index, CurveKey key);
    static constexpr float kCloseness = 0.005f;  ///< ratio

    friend bool operator==(const Curve&, const Curve&) = default;
};

}  // namespace plumb
