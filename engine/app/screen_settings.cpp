#include "app/screen_settings.hpp"

namespace plumb {

ScreenSettings withOptions(ScreenSettings settings, const PlayerOptions& options) {
    if (options.scale > 0) {
        settings.windowWidth = static_cast<int>(settings.picture.x) * options.scale;
        settings.windowHeight = static_cast<int>(settings.picture.y) * options.scale;
    }
    if (options.window != PixelSize{}) {
        settings.windowWidth = options.window.width;
        settings.windowHeight = options.window.height;
    }
    settings.fullscreen = settings.fullscreen || options.fullscreen;
    return settings;
}

}  // namespace plumb
