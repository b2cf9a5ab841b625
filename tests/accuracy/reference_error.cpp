#include "tests/accuracy/reference_error.hpp"

#include <cmath>
#include <map>
#include <string>

#include "tests/accuracy/reference/reference.hpp"

namespace plumb::accuracy {

namespace {

constexpr double kPatience = 8.0;  // limit of the wall time per scene, s; chaotic scenes never converge

/// Returns the reference solution of a scene. It is cached, because it
/// takes seconds to compute and is compared with the results of all methods.
const Result<reference::Answer>& answerOf(std::string_view scene, const physics::World& start,
                                          double seconds) {
    static std::map<std::string, Result<reference::Answer>, std::less<>> known;
    const auto found = known.find(scene);
    if (found != known.end()) return found->second;
    return known
        .emplace(std::string{scene}, reference::solveReference(start, seconds, {.patience = kPatience}))
        .first->second;
}

}  // namespace

std::optional<double> referenceError(std::string_view scene, const physics::World& start,
                                     const physics::World& end, double seconds) {
    const Result<reference::Answer>& answer = answerOf(scene, start, seconds);
    if (!answer || answer->bodies.empty()) return std::nullopt;
    double sum = 0.0;
    for (const reference::BodyAnswer& body : answer->bodies) {
        const physics::WorldPosition place = end.bodies.pose[body.body.index].centre;
        sum += std::hypot(place.x - body.centre.x, place.y - body.centre.y);
    }
    const double mean = sum / static_cast<double>(answer->bodies.size());
    // The reference solution must be at least a hundred times as accurate as the measured error.
    if (!answer->canJudge(mean)) return std::nullopt;
    return mean;
}

}  // namespace plumb::accuracy
