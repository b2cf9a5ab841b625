// Cost of 100,000 particles per frame: moving and emitting them in a tick, collecting them in a draw list,
// and submitting that list to a device that draws nothing. The target applies to the sum of the first two.

#include <string>
#include <vector>

#include "core/text.hpp"
#include "reflect/type_registry.hpp"
#include "render/recording_device.hpp"
#include "scene/components/transform.hpp"
#include "scene/drawing/draw_scene.hpp"
#include "scene/particles.hpp"
#include "scene/register_components.hpp"
#include "scene/systems/particle_system.hpp"
#include "tests/bench/bench.hpp"

namespace plumb::bench {
namespace {

constexpr float kTick = 1.0f / 60.0f;
constexpr double kTargetNs = 20.0;  ///< ns per particle for step and collect: 2 ms for 100,000

struct Stage {
    TypeRegistry types;
    World world{types};
    AssetStore assets;
    RecordingDevice device;
    SceneRenderer renderer{device, assets};
    ParticleSystem system;
    DrawList list;

    /// Creates emitters that keep the number of particles constant: each tick removes as many as it adds.
    Stage(std::size_t emitters, std::size_t particles) {
        registerSceneComponents(types);
        device.recordsDraws = false;
        for (std::size_t i = 0; i < emitters; ++i) {
            const Entity entity = world.createEntity();
            entity.addComponent<Transform>(640.0f, 360.0f);
            ParticleEmitter& emitter = entity.addComponent<ParticleEmitter>();
            emitter.lifetime = 2.0f;
            emitter.maximum = 100000;
            emitter.rate = static_cast<float>(particles) / (2.0f * static_cast<float>(emitters));
            emitter.gravity = 0.05f;
            emitter.spin = 1.0f;
            emitter.prewarm = true;
        }
        for (int i = 0; i < 200; ++i) step();
    }
    void step() {
        world.beginTick();
        storePreviousTransforms(world);
        system.update(world, kTick);
    }
    void collect() {
        SceneView how;
        how.view = {.center = {640.0f, 360.0f}, .size = {1280.0f, 720.0f}};
        how.alpha = 0.5f;
        list.begin(how.view);
        renderer.collect(world, how, list);
    }
    void draw() { renderer.renderer().draw(list, {.width = 1280, .height = 720}); }
};

void measure(std::size_t emitters, std::size_t particles, const Options& options, std::vector<Row>& rows) {
    Stage stage{emitters, particles};
    const std::size_t alive = stage.world.resource<Particles>().alive();
    stage.collect();
    const std::vector<Contestant> contestants{
        {{}, [&] { stage.step(); }},
        {{}, [&] { stage.collect(); }},
        {{}, [&] { stage.draw(); }},
        {{}, [&] { stage.step(), stage.collect(); }},
    };
    const char* const names[] = {"step", "collect", "to the device", "step and collect"};
    const std::vector<Timing> timings = race(contestants, options);
    for (std::size_t i = 0; i < timings.size(); ++i) {
        const auto items = static_cast<double>(alive);
        rows.push_back({format("{} emitters, {}", emitters, names[i]), alive,
                        timings[i].minimum * 1e9 / items, timings[i].median * 1e9 / items, 0.0,
                        i == 3 ? kTargetNs : 0.0});
        print(rows.back());
    }
}

}  // namespace

int runParticles(const Options& options) {
    std::vector<Row> rows;
    printHeader();
    const std::size_t count = options.quick ? 2000 : 100000;
    for (const std::size_t emitters : {std::size_t{1}, std::size_t{10}, std::size_t{100}})
        measure(emitters, count, options, rows);
    return options.jsonPath.empty() || writeRows(options.jsonPath, rows) ? 0 : 1;
}

}  // namespace plumb::bench
