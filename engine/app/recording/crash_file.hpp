#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/crash_report.hpp"
#include "input/packed_input.hpp"
#include "input/recorder.hpp"

namespace plumb {

/// The file that a crash of a game leaves: a replay that ends with the tick of the crash. All of it is kept
/// in memory while the game runs, as a crash can only write. Replaying from the start is exact, because the
/// simulation is deterministic.
class CrashFile final : public CrashReport {
public:
    static constexpr std::int64_t kCheckTicks = 3600;  ///< ticks between two hashes

    static constexpr std::size_t kMostState = std::size_t{2} << 20;  ///< bytes of a saved game in a file

    /// @param start     project, engine, scene, seed, keys and state; the state has at most kMostState bytes
    /// @param folder    of the file; empty: none is written
    /// @param settings  a line for people: what else the game was started with
    /// @param replayed  the replay that is played; null: none. Must outlive this
    CrashFile(const Replay& start, const Path& folder, std::string settings, const Replay* replayed);
    ~CrashFile() override { setCrashReport(nullptr, {}); }
    CrashFile(const CrashFile&) = delete;
    CrashFile& operator=(const CrashFile&) = delete;

    /// To be called before each tick, with its input.
    void tickBegins(const InputFrame& input);
    /// To be called after each tick.
    void tickEnds() { ended_.store(begun_.load(std::memory_order_relaxed), std::memory_order_relaxed); }
    /// Adds the hash of the world after this tick.
    void check(std::uint64_t hash);
    /// To be called when something else than input has changed the running game: its replay differs from
    /// now on. @param why  a sentence in the past tense, without a full stop
    void changed(std::string_view why);

    void writeFile(CrashOutput& file, const Crash& crash) const override;
    void explain(CrashOutput& terminal, const Crash& crash) const override;
    [[nodiscard]] bool endsAtHang() const override { return replayed_ != nullptr; }

private:
    static constexpr std::size_t kChecks = 256;  // of the last 4 hours

    void writePlace(CrashOutput& out) const;

    std::string head_;
    std::string settings_;
    const Replay* replayed_;
    std::uint64_t replayedTicks_ = 0;
    std::optional<PackedInput> input_;               // empty: no file is written
    std::atomic<std::int64_t> begun_{0}, ended_{0};  // numbers of ticks
    std::array<char, 128> change_{};                 // why the replay differs: that of the first change
    std::atomic<std::int64_t> changedAfter_{-1};     // number of ticks; -1: never
    std::array<HashCheck, kChecks> checks_{};        // a ring
    std::atomic<std::uint64_t> checkCount_{0};       // ever added
};

}  // namespace plumb
