#include "tests/accuracy/families/goals.hpp"

#include <algorithm>

#include "tests/bench/physics/scene_error.hpp"

namespace plumb::families {

Goal staysWithin(std::vector<std::uint32_t> bodies, double distance) {
    const auto error = [bodies = std::move(bodies)](const Stage& stage) {
        double furthest = 0.0;
        for (const std::uint32_t body : bodies)
            if (stage.has(body)) furthest = std::max(furthest, stage.displacementOf(body));
        return furthest;
    };
    return {"stands", error, distance};
}

Goal sleeps() {
    const auto error = [](const Stage& stage) {
        const physics::World* world = stage.world();
        if (world == nullptr || !stage.variation().sleeping) return 0.0;
        return static_cast<double>(std::count_if(
            world->awake.begin(), world->awake.end(),
            [&](std::uint32_t body) { return world->bodies.info[body].kind == physics::BodyKind::Dynamic; }));
    };
    return {"sleeps", error, 0.0};
}

Goal staysIn(std::vector<std::uint32_t> bodies, Vec2 low, Vec2 high) {
    const auto error = [bodies = std::move(bodies), low, high](const Stage& stage) {
        double outside = 0.0;
        for (const std::uint32_t body : bodies) {
            if (!stage.has(body)) continue;
            const scenes::Point at = stage.positionOf(body);
            const bool in = at.x >= static_cast<double>(low.x) && at.x <= static_cast<double>(high.x) &&
                            at.y >= static_cast<double>(low.y) && at.y <= static_cast<double>(high.y);
            outside += in ? 0.0 : 1.0;
        }
        return outside;
    };
    return {"stays in", error, 0.0};
}

Goal overlapsAtMost(double depth) {
    const auto error = [](const Stage& stage) {
        return scenes::errorOf(stage.scene()).maxPenetration / static_cast<double>(stage.scale());
    };
    return {"overlaps", error, depth};
}

Goal rests(std::vector<std::uint32_t> bodies, double speed) {
    const auto error = [bodies = std::move(bodies)](const Stage& stage) {
        double fastest = 0.0;
        for (const std::uint32_t body : bodies)
            if (stage.has(body))
                fastest = std::max(fastest, static_cast<double>(length(stage.velocityOf(body))));
        return fastest;
    };
    return {"rests", error, speed};
}

Goal keepsJoints(double gap) {
    const auto error = [](const Stage& stage) {
        return scenes::errorOf(stage.scene()).maxJointError /
               static_cast<double>(stage.variation().placement.scale);
    };
    return {"keeps its joints", error, gap};
}

bool takesPart(const Stage& stage, std::uint32_t body) {
    return stage.has(body) && stage.plan().bodies[body].setup.motion == Motion::Dynamic;
}

}  // namespace plumb::families
