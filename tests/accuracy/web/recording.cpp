#include "tests/accuracy/web/recording.hpp"

#include <cmath>
#include <limits>
#include <span>
#include <string_view>

#include "core/text.hpp"

namespace plumb::accuracy {

namespace {

using scenes::Pose;
using scenes::SceneBuilder;

/// The position to which the recorded ones are relative.
Pose originOf(const SceneBuilder& scene) {
    for (std::uint32_t i = 0; i < scene.bodies().size(); ++i)
        if (scene.isDynamic({i})) return scene.poseOf({i});
    return {};
}

/// Adds the poses of the first `count` bodies.
void addMoment(const SceneBuilder& scene, std::size_t count, const Pose& origin, std::vector<float>& poses) {
    for (std::uint32_t i = 0; i < count; ++i) {
        if (!scene.alive({i})) {
            poses.insert(poses.end(), 3, std::numeric_limits<float>::quiet_NaN());
            continue;
        }
        const Pose pose = scene.poseOf({i});
        poses.push_back(static_cast<float>(pose.x - origin.x));
        poses.push_back(static_cast<float>(pose.y - origin.y));
        poses.push_back(static_cast<float>(std::atan2(pose.sin, pose.cos)));
    }
}

std::string number(float value) { return shortestText(static_cast<double>(value)); }

std::string pointJson(Vec2 point) { return format("{},{}", number(point.x), number(point.y)); }

std::string shapeJson(const SceneBuilder::Shape& shape) {
    std::string points;
    for (const Vec2 point : shape.outline.corners())
        points += format("{}{}", points.empty() ? "" : ",", pointJson(point));
    return format("{\"body\":{},\"radius\":{},\"points\":[{}]}", shape.body.index,
                  number(shape.outline.radius), points);
}

std::string jointJson(const scenes::JointSetup& joint) {
    return format("{\"a\":{},\"b\":{},\"anchors\":[{},{}]}", joint.a.index, joint.b.index,
                  pointJson(joint.anchorA), pointJson(joint.anchorB));
}

/// Returns a JSON array.
template <class Item>
std::string listJson(std::span<const Item> items, std::string (*json)(const Item&)) {
    std::string list;
    for (const Item& item : items) list += format("{}{}", list.empty() ? "" : ",", json(item));
    return format("[{}]", list);
}

std::string motionJson(const SceneBuilder::Body& body) {
    return body.motion == scenes::Motion::Dynamic ? "true" : "false";
}

}  // namespace

Recording record(const Experiment& experiment, const Method& method) {
    Recording recording;
    Pose origin;
    Trial trial{method, experiment.gravity};
    trial.watch([&](const Trial& seen) {
        const SceneBuilder& scene = seen.scene();
        if (recording.moments == 0) {
            recording.bodies.assign(scene.bodies().begin(), scene.bodies().end());
            recording.shapes.assign(scene.shapes().begin(), scene.shapes().end());
            recording.joints.assign(scene.joints().begin(), scene.joints().end());
            origin = originOf(scene);
        }
        addMoment(scene, recording.bodies.size(), origin, recording.poses);
        ++recording.moments;
    });
    experiment.run(trial);
    return recording;
}

std::string sceneJson(const Recording& recording) {
    return format("{\"moments\":{},\"moving\":{},\"shapes\":{},\"joints\":{}}", recording.moments,
                  listJson<SceneBuilder::Body>(recording.bodies, motionJson),
                  listJson<SceneBuilder::Shape>(recording.shapes, shapeJson),
                  listJson<scenes::JointSetup>(recording.joints, jointJson));
}

}  // namespace plumb::accuracy
