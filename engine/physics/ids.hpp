#pragma once

#include <cstdint>

namespace plumb::physics {

/// Handle of an object of a world: an index, and a generation that distinguishes the successive
/// objects with that index, so that a stale id never refers to a new object. The default is the null id.
template <class Thing>
struct Id {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;  ///< 0: null

    explicit constexpr operator bool() const { return generation != 0; }
    friend constexpr bool operator==(Id, Id) = default;
};

using BodyId = Id<struct Body>;
using ShapeId = Id<struct Shape>;
using JointId = Id<struct Joint>;
using FieldId = Id<struct Field>;

inline constexpr std::uint32_t kNone = 0xffffffffu;  ///< a null index

}  // namespace plumb::physics
