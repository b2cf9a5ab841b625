#include "editor/model/safety/journal_writer.hpp"

#include <utility>

#include "core/assert.hpp"
#include "editor/model/document/prefab_file.hpp"
#include "scene/files/prefab.hpp"
#include "scene/physics/physics_state.hpp"

namespace plumb::editor {

JournalWriter::JournalWriter(const TypeRegistry& types, Path project)
    : types_{types}, project_{std::move(project)}, world_{types}, thread_{[this] { run(); }} {}

JournalWriter::~JournalWriter() {
    {
        const std::lock_guard lock{mutex_};
        stop_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

void JournalWriter::write(const World& world, SceneId scene, Path file, std::string header) {
    PLUMB_ASSERT(!busy(), "write is called while another one is pending");
    // In an edited scene the physics state is only used for drawing, and it is much larger than the scene.
    PhysicsState* drawn = world.findResource<PhysicsState>();
    PhysicsState aside = drawn != nullptr ? std::exchange(*drawn, {}) : PhysicsState{};
    world.save(snapshot_);
    if (drawn != nullptr) *drawn = std::move(aside);
    scene_ = scene;
    file_ = std::move(file);
    header_ = std::move(header);
    {
        const std::lock_guard lock{mutex_};
        busy_ = true;
    }
    changed_.notify_all();
}

bool JournalWriter::busy() const {
    const std::lock_guard lock{mutex_};
    return busy_;
}

void JournalWriter::wait() const {
    std::unique_lock lock{mutex_};
    changed_.wait(lock, [this] { return !busy_; });
}

std::string JournalWriter::takeProblem() {
    const std::lock_guard lock{mutex_};
    return std::exchange(problem_, {});
}

void JournalWriter::run() {
    std::unique_lock lock{mutex_};
    while (true) {
        changed_.wait(lock, [this] { return busy_ || stop_; });
        if (!busy_) return;
        lock.unlock();
        const Result<Done> written = writeOne();
        lock.lock();
        if (!written) problem_ = written.error().text();
        busy_ = false;
        changed_.notify_all();
    }
}

Result<Done> JournalWriter::writeOne() {
    world_.restore(snapshot_);
    PrefabLibrary prefabs{types_, project_};  // a separate library: the main thread uses the editor's
    return writeFile(file_, header_ + fileText(world_, {types_, &prefabs, project_}, scene_));
}

}  // namespace plumb::editor
