#include "assets/animation.hpp"

#include <utility>

namespace plumb {
namespace {

template <class Item>
int indexOf(const std::vector<Item>& items, std::string_view name) {
    for (std::size_t i = 0; i < items.size(); ++i) {
        if (items[i].name == name) return static_cast<int>(i);
    }
    return -1;
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): sample code of the specification uses this name
const std::vector<Animation> playerAnimations{
    {"idle", {{0, 0, 0.5f, ""}, {1, 0, 0.5f, ""}}, LoopMode::Loop},
    {"run", {{0, 0, 0.1f, "step"}, {1, 0, 0.1f, ""}, {2, 0, 0.1f, "step"}, {3, 0, 0.1f, ""}}, LoopMode::Loop},
    {"jump", {{2, 0, 0.1f, "jump"}, {3, 0, 0.1f, ""}}, LoopMode::Once},
};

int AnimationSet::findClip(std::string_view name) const { return indexOf(clips, name); }
int AnimationSet::findState(std::string_view name) const { return indexOf(states, name); }
int AnimationSet::findParameter(std::string_view name) const { return indexOf(parameters, name); }

AnimationSet animationSetOf(std::vector<Animation> clips) {
    AnimationSet set;
    set.clips = std::move(clips);
    return set;
}

}  // namespace plumb
