#include "app/sound_place.hpp"

#include <algorithm>
#include <cmath>

#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/scene_stack.hpp"
#include "scene/systems/camera_system.hpp"
#include "scene/world_transform.hpp"

namespace plumb {
namespace {

constexpr float kWidest = 0.8f;  ///< pan at the edge of the view; below 1, so both channels play the sound

}  // namespace

float panOf(const World& world, EntityId source) {
    if (!world.alive(source) || !world.has<Transform>(source)) return 0.0f;
    const auto* picture = world.findResource<PictureSize>();
    const Vec2 size = picture != nullptr ? picture->size : PictureSize{}.size;
    const View view = cameraView(world, size, 1.0f, static_cast<int>(placeOf(world, source)));
    const float from = toScreen(view, worldPose(world, source).position).x / size.x * 2.0f - 1.0f;
    return std::isfinite(from) ? kWidest * std::clamp(from, -1.0f, 1.0f) : 0.0f;
}

}  // namespace plumb
