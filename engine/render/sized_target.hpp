#pragma once

#include "render/render_device.hpp"

namespace plumb {

/// A render target that is created on first use, and again when another size is requested.
class SizedTarget {
public:
    explicit SizedTarget(RenderDevice& device) : device_{device} {}
    ~SizedTarget() { device_.destroyTarget(whole_.target); }
    SizedTarget(const SizedTarget&) = delete;
    SizedTarget& operator=(const SizedTarget&) = delete;

    /// Returns the whole target, created again if its size (px) differs.
    const Viewport& whole(int width, int height) {
        if (whole_.width != width || whole_.height != height) {
            device_.destroyTarget(whole_.target);
            whole_ = {device_.createTarget(width, height), 0, 0, width, height};
        }
        return whole_;
    }

private:
    RenderDevice& device_;
    Viewport whole_;
};

}  // namespace plumb
