#include "editor/model/play/play_edits.hpp"

#include <algorithm>

#include "editor/model/cost/scene_physics_edit.hpp"
#include "editor/model/play/played_keys.hpp"

namespace plumb::editor {

void PlayEdits::add(const PlayEdit& edit) {
    const auto same = [&edit](const PlayEdit& other) { return edit.sameField(other); };
    // Dragging a slider in a paused game sets one field many times after the same tick; only the last value
    // counts.
    if (!log_.empty() && log_.back().tick == edit.tick && same(log_.back())) {
        log_.back() = edit;
    } else {
        log_.push_back(edit);
    }
    if (const auto known = std::find_if(last_.begin(), last_.end(), same); known != last_.end()) {
        *known = edit;
    } else {
        last_.push_back(edit);
    }
}

void PlayEdits::replay(World& world, const ObjectNames& names, std::int64_t tick) const {
    auto at = std::lower_bound(log_.begin(), log_.end(), tick,
                               [](const PlayEdit& edit, std::int64_t t) { return edit.tick < t; });
    for (; at != log_.end() && at->tick == tick; ++at) {
        writePlayed(world, names, *at);
    }
}

void PlayEdits::cut(std::int64_t tick) {
    while (!log_.empty() && log_.back().tick > tick) log_.pop_back();
    for (PlayEdit& edit : last_) {
        edit.rewound = edit.rewound || edit.tick > tick;
    }
}

void PlayEdits::forgetBefore(std::int64_t tick) {
    const auto end =
        std::find_if(log_.begin(), log_.end(), [tick](const PlayEdit& edit) { return edit.tick >= tick; });
    log_.erase(log_.begin(), end);
}

bool writePlayed(World& world, const ObjectNames& names, const PlayEdit& edit) {
    if (isOfKeys(edit)) return writeKeys(world, edit), true;
    const EntityId entity = names.find(edit.object);
    if (!entity) return false;
    if (!world.has(*edit.type, entity)) {
        if (!isAddedOnEdit(*edit.type)) return false;
        world.add(*edit.type, entity);
    }
    writeField(names, *edit.field, world.find(*edit.type, entity), edit.value);
    return true;
}

}  // namespace plumb::editor
