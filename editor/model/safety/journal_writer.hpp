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

/// Turns a world into the text of its scene and writes that, in a thread of its own: the editor only waits
/// for the copy of the world.
class JournalWriter {
public:
    JournalWriter(const TypeRegistry& types, Path project);
    ~JournalWriter();
    JournalWriter(const JournalWriter&) = delete;
    JournalWriter& operator=(const JournalWriter&) = delete;

    /// @param header  stands before the scene's text
    /// @pre           !busy()
    void write(const World& world, SceneId scene, Path file, std::string header);
    [[nodiscard]] bool busy() const;
    /// Until what was asked for is on the disk.
    void wait() const;
    /// What went wrong since the last question; empty when nothing did.
    [[nodiscard]] std::string takeProblem();

private:
    void run();
    [[nodiscard]] Result<Done> writeOne();

    const TypeRegistry& types_;
    Path project_;
    // What is to be written; the thread's own while busy_.
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
