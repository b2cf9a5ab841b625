#include "app/recording/run_records.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include "app/recording/replay_choice.hpp"
#include "core/crash_report.hpp"
#include "core/log.hpp"
#include "core/text.hpp"

namespace plumb {
namespace {

constexpr std::int64_t kCheckTicks = 600;  ///< ticks between two hashes of a recording
constexpr double kLongestTick = 5.0;       ///< s: a tick that takes longer is reported as a hang

}  // namespace

bool RunRecords::begin(const PlayerOptions& options, const Replay& start, const Setting& setting) {
    recorder_.replay = start;
    const bool hasState = !start.state.empty();
    if (!options.record.empty()) {
        if (hasState) {
            logError("Input", Error{nameOfReplay(options), "it begins with a saved game, a recording cannot",
                                    "leave out --record: the report itself replays"});
            return false;
        }
        Result<RecordingFile> file = RecordingFile::create(options.record, start);
        if (!file) {
            logError("Input", file.error());
            return false;
        }
        recording_ = std::move(*file);
        recordingName_ = options.record;
    }
    if (hasState) whyNoLink_ = "it begins with a saved game";
    if (!hasState && (options.printLink || setting.onPage)) link_.emplace(start);
    return beginCrashFile(options, setting);
}

/// Without an option, a game that is played leaves a file in its folder.
bool RunRecords::beginCrashFile(const PlayerOptions& options, const Setting& setting) {
    if (!canReportCrashes() || recorder_.replay.state.size() > CrashFile::kMostState) return true;
    const bool isAsked = !options.crashReports.empty();
    const Path folder = isAsked ? Path{options.crashReports} : setting.played ? setting.folder : Path{};
    std::error_code failed;
    if (isAsked) std::filesystem::create_directories(folder, failed);
    if (failed) {
        logError("Engine",
                 Error{folder.generic_string(), "the folder for reports of crashes cannot be created",
                       "choose another one with --crash-reports"});
        return false;
    }
    if (folder.empty() && setting.replayed == nullptr) return true;
    const std::string threads =
        options.threads > 0 ? format("{} threads", options.threads) : std::string{"automatic threads"};
    crashFolder_ = folder;
    crashSettings_ = format("{}, {} of the physics", setting.inWindow ? "in a window" : "headless", threads);
    crashFile_.emplace(recorder_.replay, folder, crashSettings_, setting.replayed);
    watchdog_.emplace(kLongestTick, &reportHang);
    return true;
}

void RunRecords::tickBegins(const InputFrame& input) {
    if (link_) link_->record(input);
    if (recording_) {
        recorder_.record(input);
        recorder_.full() ? closeRecording("a recording holds no more input") : updateRecording();
    }
    if (!crashFile_) return;
    crashFile_->tickBegins(input);
    watchdog_->begin();
}

void RunRecords::tickEnds(const World& world) {
    ++ticks_;
    ++recorded_;
    if (crashFile_) {
        watchdog_->end();
        crashFile_->tickEnds();
        if (ticks_ % CrashFile::kCheckTicks == 0) crashFile_->check(world.hash());
    }
    if (recording_ && ticks_ % kCheckTicks == 0) recorder_.check(world.hash());
}

void RunRecords::end(const World& world) {
    if (!recording_) return;
    recorder_.check(world.hash());
    updateRecording();
}

void RunRecords::changed(const std::string& why, std::uint64_t hash) {
    if (crashFile_) crashFile_->changed(why);
    endRecording(why, hash);
}

void RunRecords::loaded(std::string state, std::string keys, std::uint64_t hash) {
    const std::string why = "a saved game was loaded";
    endRecording(why, hash);
    if (!crashFile_ || crashFolder_.empty()) return;
    if (state.size() > CrashFile::kMostState) return crashFile_->changed(why);
    Replay start = recorder_.replay;
    start.runs.clear();
    start.checkpoints.clear();
    start.keys = std::move(keys);
    start.state = std::move(state);
    crashFile_.reset();  // the new one takes its place
    crashFile_.emplace(start, crashFolder_, crashSettings_, nullptr);
    ticks_ = 0;
}

/// Ends the recording and the link.
void RunRecords::endRecording(const std::string& why, std::uint64_t hash) {
    if (link_) {
        link_.reset();
        whyNoLink_ = format("{} after tick {}", why, recorded_);
    }
    if (!recording_) return;
    recorder_.check(hash);
    closeRecording(why);
}

/// Ends the recording and says why.
void RunRecords::closeRecording(const std::string& why) {
    updateRecording();
    if (!recording_) return;
    recording_.reset();
    logWarning("Input", Error{recordingName_, format("the recording ends with tick {}: {}", recorded_, why),
                              "start the game again to record another one"});
}

/// Writes what the recorder has to the file. Ends the recording, but not the game, if that is impossible.
void RunRecords::updateRecording() {
    const Result<Done> written = recording_->update(recorder_);
    if (written) return;
    logError("Input", written.error());
    recording_.reset();
    failed_ = true;
}

Result<std::string> RunRecords::link(std::optional<std::uint64_t> hash) const {
    if (link_) return link_->link(hash);
    return Error{"link",
                 format("the run has no link: {}", whyNoLink_.empty() ? "none was asked for" : whyNoLink_),
                 "start the game again to get one"};
}

}  // namespace plumb
