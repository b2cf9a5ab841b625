#include "scene/components/drawing/animator.hpp"

#include "assets/asset_store.hpp"
#include "core/hash.hpp"
#include "core/text.hpp"
#include "ecs/world.hpp"

namespace plumb {
namespace {

/// A name for clips made by code: equal clips get equal names, so that they are kept once.
std::string nameOf(const AnimationSet& set) {
    return "code:" + hexText(hashText(writeAnimationSet(set))) + ".anim.json";
}

}  // namespace

Animator::Animator(World& world, const std::vector<Animation>& clips) {
    auto* assets = world.service<AssetStore>();
    if (assets == nullptr) return;  // a world without assets has nothing to show
    AnimationSet set = animationSetOf(clips);
    const std::string name = nameOf(set);
    animation = assets->addAnimation(name, std::move(set));
}

}  // namespace plumb
