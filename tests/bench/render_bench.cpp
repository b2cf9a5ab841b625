#include <cstdio>
#include <cstdlib>
#include <memory>

#include "core/random.hpp"
#include "platform/window.hpp"
#include "render/gl/gl_device.hpp"
#include "render/renderer.hpp"
#include "render/texture_atlas.hpp"
#include "tests/bench/bench.hpp"

namespace plumb::bench {
namespace {

constexpr PixelSize kWindow{1280, 720};
constexpr double kTargetNs = 30.0;  ///< ns per sprite: 1.5 ms for 50,000
constexpr std::size_t kMaxDrawCalls = 8;

/// Selects Mesa's no-op driver, which draws nothing, so that only the CPU time of an application
/// with a graphics card is measured. Other drivers ignore the variable.
void askForTheNoopDriver() {
#if !defined(_WIN32)
    setenv("GALLIUM_NOOP", "true", 0);
    setenv("SDL_VIDEODRIVER", "offscreen", 0);
#endif
}

/// A window, its device and the sprites to draw.
class Stage {
public:
    static std::unique_ptr<Stage> open() {
        askForTheNoopDriver();
        std::unique_ptr<Stage> stage{new Stage};
        auto window = Window::open({.title = "bench",
                                    .width = kWindow.width,
                                    .height = kWindow.height,
                                    .hidden = true,
                                    .vsync = false});
        if (!window) return std::printf("%s\n", window.error().text().c_str()), nullptr;
        auto device = GlDevice::create();
        if (!device) return std::printf("%s\n", device.error().text().c_str()), nullptr;
        stage->window_ = std::move(*window);
        stage->device_ = std::move(*device);
        stage->device_->setWindowSize(kWindow);
        stage->atlas_ = std::make_unique<TextureAtlas>(*stage->device_);
        stage->renderer_ = std::make_unique<Renderer>(*stage->device_);
        return stage;
    }

    /// Makes rotated sprites of 32 px on 4 layers with random textures, one in eight translucent.
    void fill(std::size_t count, int textures, bool byY) {
        Random random = Random::seeded(1);
        std::vector<TextureRegion> regions;
        const Image image{32, 32, std::vector<std::uint8_t>(32 * 32 * 4, 255)};
        for (int i = 0; i < textures; ++i) regions.push_back(atlas_->add(image));
        quads_.clear();
        for (std::size_t i = 0; i < count; ++i) {
            const TextureRegion& region = regions[random.below(static_cast<std::uint32_t>(textures))];
            SpriteQuad quad{.center = {random.between(0.0f, 1280.0f), random.between(0.0f, 720.0f)},
                            .half = {16.0f, 16.0f},
                            .rotation = random.between(0.0f, 6.0f),
                            .texture = region.texture,
                            .source = region.whole()};
            quad.tint.a = random.below(8) == 0 ? 128 : 255;
            quad.layer = static_cast<int>(random.below(4));
            if (byY) quad.sortY = quad.center.y;
            quads_.push_back(quad);
        }
    }

    void collect() {
        list_.begin({.center = {640.0f, 360.0f}, .size = {1280.0f, 720.0f}});
        for (const SpriteQuad& quad : quads_) list_.sprite(quad);
    }
    void draw() {
        renderer_->resetCounts();
        renderer_->draw(list_, {.width = kWindow.width, .height = kWindow.height});
        window_->swap();
    }
    [[nodiscard]] std::size_t drawCalls() const { return renderer_->counts().drawCalls; }
    [[nodiscard]] std::string driver() const { return device_->description(); }

private:
    Stage() = default;

    // In this order: the device must be destroyed before its window, the atlas before the device.
    std::unique_ptr<Window> window_;
    std::unique_ptr<GlDevice> device_;
    std::unique_ptr<TextureAtlas> atlas_;
    std::unique_ptr<Renderer> renderer_;
    DrawList list_;
    std::vector<SpriteQuad> quads_;
};

struct Case {
    std::string_view name;
    std::size_t count;
    int textures;
    bool byY;
    double targetNs;
};

constexpr Case kCases[] = {
    {"sprites", 1000, 4, false, 0.0},        {"sprites", 10000, 4, false, 0.0},
    {"sprites", 50000, 4, false, kTargetNs}, {"sprites, 100 pictures", 10000, 100, false, 0.0},
    {"sprites by y", 50000, 4, true, 0.0},
};

Row row(std::string_view name, const Case& item, const Timing& timing, double targetNs) {
    const double perSprite = 1e9 / static_cast<double>(item.count);
    Row result;
    result.name = std::string{item.name} + ": " + std::string{name};
    result.n = item.count;
    result.ns = timing.minimum * perSprite;
    result.median = timing.median * perSprite;
    result.target = targetNs;
    return result;
}

}  // namespace

int runRender(const Options& options) {
    const std::unique_ptr<Stage> stage = Stage::open();
    if (stage == nullptr) return 1;
    std::printf("driver: %s\n", stage->driver().c_str());
    printHeader();
    std::vector<Row> rows;
    for (const Case& item : kCases) {
        stage->fill(item.count, item.textures, item.byY);
        const Contestant contestants[] = {
            {{}, [&] { stage->collect(); }},
            {[&] { stage->collect(); }, [&] { stage->draw(); }},
        };
        const std::vector<Timing> timings = race(contestants, options);
        rows.push_back(row("collect", item, timings[0], 0.0));
        rows.push_back(row("sort, fill, submit", item, timings[1], item.targetNs));
        for (std::size_t i = rows.size() - 2; i < rows.size(); ++i) print(rows[i]);
        const bool few = stage->drawCalls() <= kMaxDrawCalls;
        std::printf("    %zu draw call(s)%s\n", stage->drawCalls(), few ? "" : ": too many");
    }
    if (!options.jsonPath.empty() && !writeRows(options.jsonPath, rows)) return 1;
    return 0;
}

}  // namespace plumb::bench
