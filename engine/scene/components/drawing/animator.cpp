#include "scene/components/drawing/animator.hpp"

#include "assets/asset_store.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"

namespace plumb {
namespace {

/// Returns an asset name computed from the content, so that equal clips are stored once.
std::string nameOf(const AnimationSet& set) {
    return "code:" + hexText(hashText(writeAnimationSet(set))) + ".anim.json";
}

}  // namespace

Animator::Animator(World& world, const std::vector<Animation>& clips) {
    auto* assets = world.service<AssetStore>();
    if (assets == nullptr) return;  // e.g. in tests
    AnimationSet set = animationSetOf(clips);
    const std::string name = nameOf(set);
    animation = assets->addAnimation(name, std::move(set));
}

}  // namespace plumb
