#pragma once

#include "app/options/player_settings.hpp"
#include "platform/events.hpp"

namespace plumb::test {

/// Settings of a project with the standard keys.
inline PlayerSettings project() {
    PlayerSettings settings;
    settings.keys = ActionMap::defaults();
    return settings;
}

inline bool areValid(const PlayerSettings& settings) {
    const auto isRatio = [](float ratio) { return ratio >= 0.0f && ratio <= 1.0f; };
    return settings.scale >= 0 && settings.scale <= PlayerSettings::kMostScale && settings.frameCap >= 0 &&
           settings.frameCap <= 1000 && isRatio(settings.master) && isRatio(settings.music) &&
           isRatio(settings.sounds) && settings.keys.actions.size() == project().keys.actions.size() &&
           settings.keys.axes.size() == project().keys.axes.size();
}

inline Event keyDown(Key key) {
    Event event;
    event.kind = EventKind::KeyDown;
    event.key = key;
    return event;
}
}  // namespace plumb::test
