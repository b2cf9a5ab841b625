#pragma once

#include <cstdint>
#include <vector>

#include "physics/effects/field_types.hpp"

namespace plumb::physics {

/// A body that touches nothing and is tied to nothing, in a field: integrated by Settings::integrator.
struct Flyer {
    std::uint32_t slot = 0;
    std::uint32_t body = 0;
    Acceleration steady;    ///< what does not depend on its state
    bool isSteady = false;  ///< nothing does: its way is known exactly
    float linearDrag = 0.0f;
    float angularDrag = 0.0f;
    BodyState now;
    float turned = 0.0f;  ///< rad: since the start of the step
    BodyState trial;      ///< where its forces are asked for
    Acceleration at[4];   ///< what they were, see each integrator
};

/// Which fields act on whom in a step, and who flies.
struct SmoothForces {
    struct Pull {
        std::uint32_t slot;
        std::uint32_t field;
    };
    std::vector<Pull> pulls;
    std::vector<std::uint32_t> begins;  ///< by slot, and one more: its fields in `fields`
    std::vector<std::uint32_t> fields;
    std::vector<Flyer> flyers;          ///< by slot
    std::vector<std::int32_t> flyerOf;  ///< by body, or -1

    [[nodiscard]] std::span<const std::uint32_t> fieldsOf(std::size_t slot) const {
        return std::span{fields}.subspan(begins[slot], begins[slot + 1] - begins[slot]);
    }
};

}  // namespace plumb::physics
