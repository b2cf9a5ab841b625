#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "physics/effects/field_types.hpp"

namespace plumb::physics {

/// A body in a field, without contacts and joints: integrated by Settings::integrator.
struct Flyer {
    std::uint32_t slot = 0;
    std::uint32_t body = 0;
    Acceleration steady;    ///< the part that does not depend on the state
    bool isSteady = false;  ///< all of it is steady: the trajectory has a closed form
    float linearDrag = 0.0f;
    float angularDrag = 0.0f;
    BodyState now;
    float turned = 0.0f;  ///< rad since the start of the step
    BodyState trial;      ///< state in which its forces are evaluated
    Acceleration at[4];   ///< accelerations of the stages, see each integrator
};

/// Which fields act on which bodies in a step, and which bodies are integrated freely.
struct SmoothForces {
    struct Pull {
        std::uint32_t slot;
        std::uint32_t field;
    };
    std::vector<Pull> pulls;
    std::vector<std::uint32_t> begins;  ///< by slot: start of its list in `fields`; one more entry at the end
    std::vector<std::uint32_t> fields;
    std::vector<Flyer> flyers;          ///< in order of their slots
    std::vector<std::int32_t> flyerOf;  ///< by body: index in `flyers`, or -1

    [[nodiscard]] std::span<const std::uint32_t> fieldsOf(std::size_t slot) const {
        return std::span{fields}.subspan(begins[slot], begins[slot + 1] - begins[slot]);
    }
};

}  // namespace plumb::physics
