#pragma once

#include <cstdint>

namespace plumb::physics {

/// Names a thing of a world: its place, and which user of that place it is, so that an old name never means
/// a new thing. The default names nobody.
template <class Thing>
struct Id {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;  ///< 0 names nobody

    explicit constexpr operator bool() const { return generation != 0; }
    friend constexpr bool operator==(Id, Id) = default;
};

using BodyId = Id<struct Body>;
using ShapeId = Id<struct Shape>;
using JointId = Id<struct Joint>;
using FieldId = Id<struct Field>;

inline constexpr std::uint32_t kNone = 0xffffffffu;  ///< an index that means nothing

}  // namespace plumb::physics
