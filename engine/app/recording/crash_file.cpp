#include "app/recording/crash_file.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"

namespace plumb {
namespace {

/// The lines of a replay up to its input.
std::string headOf(const Replay& start) {
    std::string text = writeReplay(start);
    const std::size_t version = text.find(' ') + 1;
    text.replace(version, text.find('\n') - version, format("{}", Replay::kFormat));
    text.erase(text.rfind("end "));
    const std::string build = buildId();
    if (!build.empty()) text += format("build {}\n", build);
    if (!start.state.empty()) text += format("state {}\n", start.state.size()) + start.state + "\n";
    return text;
}

}  // namespace

CrashFile::CrashFile(const Replay& start, const Path& folder, std::string settings, const Replay* replayed)
    : head_{headOf(start)},
      settings_{std::move(settings)},
      replayed_{replayed},
      replayedTicks_{replayed != nullptr ? replayed->ticks() : 0} {
    if (!folder.empty()) input_.emplace(PackedInput::kBytes - start.state.size());
    setCrashReport(this, folder);
}

void CrashFile::tickBegins(const InputFrame& input) {
    if (input_) input_->record(input);
    begun_.store(begun_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
}

void CrashFile::check(std::uint64_t hash) {
    if (input_ && input_->full()) return;  // a replay does not get here
    const std::uint64_t count = checkCount_.load(std::memory_order_relaxed);
    checks_[count % kChecks] = {static_cast<std::uint64_t>(begun_.load()), hash};
    checkCount_.store(count + 1, std::memory_order_release);
}

void CrashFile::changed(std::string_view why) {
    if (changedAfter_.load() >= 0) return;
    why.copy(change_.data(), change_.size() - 1);
    changedAfter_.store(begun_.load(), std::memory_order_release);
}

void CrashFile::writePlace(CrashOutput& out) const {
    const std::int64_t begun = begun_.load(), ended = ended_.load();
    out.text(begun != ended ? "during tick " : "after tick ").number(static_cast<std::uint64_t>(begun));
}

void CrashFile::writeFile(CrashOutput& file, const Crash& crash) const {
    file.text(head_).text("crash ").text(crash.what);
    if (!crash.reason.empty()) file.text(": ").text(crash.reason);
    file.text("\n");
    if (!crash.running.empty()) file.text("running ").text(crash.running).text("\n");
    // The number of hashes is read before the input: every tick with a hash is in it.
    const std::uint64_t count = checkCount_.load(std::memory_order_acquire);
    const PackedInput::Content input = input_->content();
    // Not the oldest of the ring, which may be half overwritten.
    for (std::uint64_t i = count - std::min<std::uint64_t>(count, kChecks - 1); i < count; ++i) {
        const HashCheck& check = checks_[i % kChecks];
        file.text("check ").number(check.tick).text(" ").hex(check.hash).text("\n");
    }
    file.text("packed ").number(input.closed.size() + input.openSize).text("\n");
    file.text(input.closed).text({input.open.data(), input.openSize}).text("\n");
    file.text("end ").number(input.ticks).text("\n\n");
    writePlace(file);
    file.text("\n").text(settings_).text("\n");
    if (input_->full()) file.text("The memory for the input was full: the replay ends before the crash.\n");
    if (const std::int64_t changed = changedAfter_.load(std::memory_order_acquire); changed >= 0) {
        file.text("After tick ").number(static_cast<std::uint64_t>(changed)).text(", ");
        file.text(change_.data()).text(": the replay may differ from the game.\n");
    }
}

void CrashFile::explain(CrashOutput& terminal, const Crash&) const {
    writePlace(terminal);
    if (replayed_ == nullptr) {
        terminal.text(
            "\nit repeats the game up to here: ./plumb play PROJECT --replay FILE, or in the editor, 2 s "
            "before: ./plumb edit PROJECT --replay FILE\n");
        return;
    }
    terminal.text(" of ").number(replayedTicks_).text(" of the replay");
    const RecordedCrash& recorded = replayed_->crash;
    if (!recorded.what.empty()) {
        terminal.text("; recorded: ").text(recorded.what);
        if (!recorded.running.empty()) terminal.text(", running ").text(recorded.running);
    }
    terminal.text("\n");
}

}  // namespace plumb
