#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

#include "core/file.hpp"
#include "ecs/snapshot.hpp"
#include "ecs/world.hpp"
#include "reflect/field_types.hpp"

namespace plumb::editor {

/// Serializes a world as a scene and writes it to a file in a separate thread. The caller only waits for the
/// copy of the world.
class JournalWriter {
public:
    JournalWriter(const TypeRegistry& types, Path project);
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    /// Starts to write a scene to a file.
    /// @param header  written before the scene's text
    /// @pre           !busy()
    void write(const World& world, SceneId scene, Path file, std::string header);
    /// True while a write is pending.
    [[nodiscard]] bool busy() const;
    /// Blocks until the pending write is finished.
    void wait() const;
    /// Returns and clears the message of the last write error; empty if there was none.
    [[nodiscard]] std::string takeProblem();

private:
    void run();
    [[nodiscard]] Result<Done> writeOne();

    const TypeRegistry& types_;
    Path project_;
    // Input of the pending write; used only by the writer thread while `busy_` is true.
    Snapshot snapshot_;
    World world_;
    SceneId scene_;
    Path file_;
    std::string header_;

    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    bool busy_ = false;
    bool stop_ = false;
    std::string problem_;
    std::thread thread_;
};

}  // namespace plumb::editor
