#include "physics/effects/field_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/effects/field_types.hpp"
#include "physics/tuning.hpp"

namespace plumb::physics {

namespace {

/// Up to this many fields a look at each costs less than a search.
constexpr std::size_t kFew = 8;

/// Box around a place, larger by the rounding of floats here and in actsOn(): at most 16 times 2^-24 of the
/// largest coordinate.
AABB boxAround(WorldPosition place, Vec2 half) {
    const Vec2 at = toVec2(place);
    const float far = std::max(std::fabs(at.x) + half.x, std::fabs(at.y) + half.y);
    return grown({at - half, at + half}, 2.0f * kRounding * far);
}

AABB boundsOf(const World& world, const FieldDefinition& field) {
    constexpr float kEndless = std::numeric_limits<float>::max();
    const RegionKind region = regionOf(field);
    if (region == RegionKind::Everywhere) return {{-kEndless, -kEndless}, {kEndless, kEndless}};
    const Vec2 half = region == RegionKind::Circle ? Vec2{field.radius, field.radius} : field.half;
    return boxAround(centreOf(world, field), half);
}

}  // namespace

void updateFieldBoxes(const World& world, Workspace& work) {
    std::vector<std::uint32_t>& searched = work.searchedFields;
    searched.clear();
    for (std::uint32_t f = 0; f < world.fields.all.size(); ++f) {
        const Field& field = world.fields.all[f];
        const FieldKind kind = field.definition.kind;
        if (!field.isAlive || kind == FieldKind::Spring) continue;
        if (world.manifest.runs(fieldTypeOf(kind).effect)) searched.push_back(f);
    }
    if (searched.size() <= kFew) return;
    BoxProxies& boxes = work.fieldBoxes;
    bool isCurrent = boxes.search != nullptr && boxes.bounds.size() == searched.size();
    boxes.bounds.resize(searched.size());
    boxes.filters.resize(searched.size());
    boxes.motions.assign(searched.size(), ProxyMotion::Awake);
    for (std::size_t i = 0; i < searched.size(); ++i) {
        const FieldDefinition& field = world.fields.all[searched[i]].definition;
        const AABB bounds = boundsOf(world, field);
        const std::uint32_t kind = 1u << static_cast<unsigned>(field.kind);
        isCurrent = isCurrent && bounds == boxes.bounds[i] && kind == boxes.filters[i].layers;
        boxes.bounds[i] = bounds;
        boxes.filters[i].layers = kind;
    }
    if (isCurrent) return;
    if (boxes.search == nullptr) boxes.search = makeBroadPhase(BroadPhaseKind::Tree);
    boxes.search->rebuild(boxes.view());
}

std::span<const std::uint32_t> fieldsNear(const World& world, Workspace& work, std::uint32_t body,
                                          std::uint32_t kinds) {
    if (work.searchedFields.size() <= kFew) return work.searchedFields;
    const float reach = world.bodies.info[body].reach;
    std::vector<std::uint32_t>& found = work.candidates;
    found.clear();
    work.fieldBoxes.search->query(boxAround(world.bodies.pose[body].centre, {reach, reach}), kinds, found);
    std::sort(found.begin(), found.end());
    for (std::uint32_t& field : found) field = work.searchedFields[field];
    return found;
}

}  // namespace plumb::physics
