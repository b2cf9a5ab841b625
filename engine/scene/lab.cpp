#include "scene/lab.hpp"

#include <algorithm>

namespace plumb {

const void* Lab::startOf(EntityId entity, std::string_view component) const {
    for (const LabStart& start : starts) {
        if (start.entity != entity) continue;
        if (component == "Transform") return &start.transform;
        return component == "RigidBody" ? &start.body : nullptr;
    }
    return nullptr;
}

void Lab::archive(StateArchive& archive) {
    archive.value(experiment);
    archive.list(starts);
    archive.value(run);
    archive.value(sliderMoved);
    archive.value(sliderReleased);
}

void Lab::addTo(Hasher& hasher) const {
    const auto add = [&hasher](auto... values) { (hasher.add(values), ...); };
    add(std::uint64_t{experiment.index}, std::uint64_t{experiment.generation}, run,
        std::uint64_t{sliderMoved});
    for (const LabStart& start : starts) {
        add(std::uint64_t{start.entity.index}, start.transform.position.x, start.transform.position.y);
        add(start.transform.rotation, start.body.velocity.x, start.body.velocity.y);
        add(start.body.angularVelocity, start.body.mass);
    }
}

const GhostWorlds::One* GhostWorlds::find(EntityId ghost) const {
    const auto found =
        std::find_if(all.begin(), all.end(), [ghost](const One& one) { return one.ghost == ghost; });
    return found != all.end() ? &*found : nullptr;
}

const PlotPast::Curve* PlotPast::find(EntityId plot, EntityId source) const {
    const auto found = std::find_if(curves.begin(), curves.end(), [&](const Curve& curve) {
        return curve.plot == plot && curve.source == source;
    });
    return found != curves.end() ? &*found : nullptr;
}

}  // namespace plumb
