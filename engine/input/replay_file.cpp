#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "core/os.hpp"
#include "core/text.hpp"
#include "input/packed_input.hpp"
#include "input/recorder.hpp"

// A replay file is text, so that a diff of two files shows the different input:
//
//     plumb-replay 1
//     project Sky Caves
//     engine 0.1.0
//     scene scenes/title.scene.json
//     seed 000000000000002a
//     keys {"actions":{"Jump":["K"]}}   the bindings that the player has changed, if any
//     30                        30 ticks without input
//     12 +Right                 12 ticks with Right held
//     1 +Space mouse=120,44     1 tick: Space is pressed too, and the mouse has moved
//     1 +Save2                  1 tick: there is a saved game in slot 2 now
//     check 60 9f3c1a77d2e0b154
//     end 43
//
// Each line of ticks lists the changes since the previous one: +Key -Key, +Mouse.Left, wheel=0,120, +Gamepad1
// (connected), +Gamepad1.A, Gamepad1.LeftX=-32767. The seed is in hex.
//
// The report of a crash is such a file of format 2, which app/recording/crash_file.cpp writes:
//
//     build 6f1c...
//     crash SIGSEGV, a wrong access to memory
//     running MovementSystem
//     state 48211                48211 bytes and a line break follow: the saved game that the run began with
//     packed 2100                2100 bytes of packed input and a line break follow
//     end 4711
//     ...                        what follows "end" is for people

namespace plumb {
namespace {

constexpr std::string_view kMark = "plumb-replay";
constexpr int kWritten = 1;                               // format
constexpr std::size_t kKeysBytes = std::size_t{1} << 16;  // maximum size of the changed bindings
constexpr std::size_t kNameBytes = 1024;  // maximum size of a project's, engine's or scene's name

// ---- writing ------------------------------------------------------------------------------------

void writeBit(std::string& out, bool before, bool now, std::string_view prefix, std::string_view name) {
    if (before == now) return;
    out += now ? " +" : " -";
    out += prefix;
    out += name;
}

void writePair(std::string& out, std::string_view name, std::pair<int, int> before, std::pair<int, int> now) {
    if (before != now) out += format(" {}={},{}", name, now.first, now.second);
}

void writePad(std::string& out, const PadFrame& before, const PadFrame& now, std::string_view prefix) {
    for (std::size_t i = 0; i < kPadButtonCount; ++i) {
        const auto button = static_cast<PadButton>(i);
        writeBit(out, before.has(button), now.has(button), prefix, nameOf(button));
    }
    for (std::size_t i = 0; i < kPadAxisCount; ++i) {
        if (before.axes[i] == now.axes[i]) continue;
        out += format(" {}{}={}", prefix, nameOf(static_cast<PadAxis>(i)), static_cast<int>(now.axes[i]));
    }
}

void writeChanges(std::string& out, const InputFrame& before, const InputFrame& now) {
    for (std::size_t i = 1; i < kKeyCount; ++i) {
        const auto key = static_cast<Key>(i);
        writeBit(out, before.has(key), now.has(key), "", nameOf(key));
    }
    for (std::size_t i = 0; i < kMouseButtonCount; ++i) {
        const auto button = static_cast<MouseButton>(i);
        writeBit(out, before.has(button), now.has(button), "Mouse.", nameOf(button));
    }
    writePair(out, "mouse", {before.mouseX, before.mouseY}, {now.mouseX, now.mouseY});
    writePair(out, "wheel", {before.wheelX, before.wheelY}, {now.wheelX, now.wheelY});
    for (std::size_t i = 0; i < now.pads.size(); ++i) {
        // Not "Pad1": that is a key of the number pad.
        const std::string prefix = format("Gamepad{}", i + 1);
        const auto connected = [&](const InputFrame& frame) { return (frame.connectedPads >> i & 1) != 0; };
        writeBit(out, connected(before), connected(now), prefix, "");
        writePad(out, before.pads[i], now.pads[i], prefix + ".");
    }
    for (unsigned slot = 0; slot < kSaveSlots && before.saves != now.saves; ++slot)
        writeBit(out, (before.saves >> slot & 1) != 0, (now.saves >> slot & 1) != 0,
                 format("Save{}", slot + 1), "");
}

// ---- reading ------------------------------------------------------------------------------------

std::optional<std::uint64_t> parseCount(std::string_view text, std::uint64_t limit) {
    const std::optional<std::int64_t> value = parseInt(text);
    if (!value || *value < 0 || static_cast<std::uint64_t>(*value) > limit) return std::nullopt;
    return static_cast<std::uint64_t>(*value);
}

std::optional<std::int16_t> parseShort(std::string_view text) {
    const std::optional<std::int64_t> value = parseInt(text);
    if (!value || *value < -32768 || *value > 32767) return std::nullopt;
    return static_cast<std::int16_t>(*value);
}

template <class Word>
bool setBit(Word& word, unsigned bit, bool on) {
    const auto mask = static_cast<Word>(Word{1} << bit);
    if (((word & mask) != 0) == on) return false;  // a change to the same value is an error
    word = static_cast<Word>(word ^ mask);
    return true;
}

/// A name such as "Gamepad1" or "Gamepad1.A": the gamepad's index from 0, and the part after the dot.
struct PadName {
    unsigned place = 0;
    std::string_view part;
};

std::optional<PadName> padNameOf(std::string_view name) {
    constexpr std::string_view kPad = "Gamepad";
    if (!startsWith(name, kPad) || name.size() <= kPad.size()) return std::nullopt;
    const char digit = name[kPad.size()];
    if (digit < '1' || digit >= '1' + kPadCount) return std::nullopt;
    const std::string_view rest = name.substr(kPad.size() + 1);
    if (!rest.empty() && (rest.front() != '.' || rest.size() == 1)) return std::nullopt;
    return PadName{static_cast<unsigned>(digit - '1'), rest.empty() ? rest : rest.substr(1)};
}

/// Index from 0 of a slot of saved games: "Save1".
std::optional<unsigned> saveSlotOf(std::string_view name) {
    constexpr std::string_view kSave = "Save";
    if (!startsWith(name, kSave)) return std::nullopt;
    const auto number = parseCount(name.substr(kSave.size()), kSaveSlots);
    if (!number || *number == 0) return std::nullopt;
    return static_cast<unsigned>(*number - 1);
}

bool readBit(std::string_view name, bool on, InputFrame& frame) {
    constexpr std::string_view kMouse = "Mouse.";
    if (const std::optional<Key> key = keyFromName(name)) {
        if (frame.has(*key) == on) return false;
        frame.set(*key, on);
        return true;
    }
    if (startsWith(name, kMouse)) {
        const auto button = mouseButtonFromName(name.substr(kMouse.size()));
        return button && setBit(frame.mouseButtons, static_cast<unsigned>(*button), on);
    }
    if (const std::optional<unsigned> slot = saveSlotOf(name)) return setBit(frame.saves, *slot, on);
    const std::optional<PadName> pad = padNameOf(name);
    if (!pad) return false;
    if (pad->part.empty()) return setBit(frame.connectedPads, pad->place, on);
    const auto button = padButtonFromName(pad->part);
    return button && setBit(frame.pads[pad->place].buttons, static_cast<unsigned>(*button), on);
}

bool readPair(std::string_view value, std::int16_t& x, std::int16_t& y) {
    const std::size_t comma = value.find(',');
    if (comma == std::string_view::npos) return false;
    const auto first = parseShort(value.substr(0, comma));
    const auto second = parseShort(value.substr(comma + 1));
    if (!first || !second) return false;
    x = *first;
    y = *second;
    return true;
}

bool readValue(std::string_view name, std::string_view value, InputFrame& frame) {
    if (name == "mouse") return readPair(value, frame.mouseX, frame.mouseY);
    if (name == "wheel") return readPair(value, frame.wheelX, frame.wheelY);
    const std::optional<PadName> pad = padNameOf(name);
    const auto axis = pad ? padAxisFromName(pad->part) : std::nullopt;
    const auto number = parseShort(value);
    if (!axis || !number) return false;
    frame.pads[pad->place].axes[static_cast<std::size_t>(*axis)] = *number;
    return true;
}

bool readChange(std::string_view word, InputFrame& frame) {
    if (word.size() < 2) return false;
    if (word.front() == '+' || word.front() == '-')
        return readBit(word.substr(1), word.front() == '+', frame);
    const std::size_t equals = word.find('=');
    return equals != std::string_view::npos &&
           readValue(word.substr(0, equals), word.substr(equals + 1), frame);
}

/// Reads a replay line by line. The read functions return an error message, or an empty text for success.
class ReplayReader {
public:
    ReplayReader(std::string_view text, std::string_view where) : text_{text}, where_{where} {}

    Result<Replay> read() {
        if (text_.size() > Replay::kMaxBytes) return failure("the file is too large", "record less");
        const bool mayBePacked = startsWith(text_, format("{} {}\n", kMark, Replay::kFormat));
        if (!mayBePacked && !isUtf8(text_)) return failure("the text is not UTF-8", "record it again");
        if (std::string problem = readMark(); !problem.empty())
            return failure(std::move(problem), "record it again");
        while (!ended_ && !text_.empty()) {
            if (std::string problem = readLine(takeLine()); !problem.empty()) {
                return failure(std::move(problem), remedy("record it again, or correct the line"));
            }
        }
        if (!ended_)
            return failure("the file has no \"end\" line: it is incomplete", remedy("record it again"));
        if (!isCrash() && !trimmed(text_).empty())
            return failure("there is text after the \"end\" line", "remove it");
        return std::move(replay_);
    }

private:
    [[nodiscard]] bool isCrash() const { return format_ >= 2; }
    /// What to do about damage. A crash cannot be recorded again, but the player of the game may have the
    /// file.
    [[nodiscard]] std::string remedy(std::string_view ofRecording) const {
        return std::string{
            isCrash() ? "it was changed on its way: get the report again from the player of the game, "
                        "as a file in an archive, not as text"
                      : ofRecording};
    }

    std::string_view takeLine() {
        const std::size_t end = text_.find('\n');
        std::string_view line = text_.substr(0, end);
        text_.remove_prefix(end == std::string_view::npos ? text_.size() : end + 1);
        ++line_;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        return line;
    }

    [[nodiscard]] Error failure(std::string what, std::string remedy) const {
        return {format("{}:{}", where_, line_), std::move(what), std::move(remedy)};
    }

    std::string readMark() {
        const std::string_view line = takeLine();
        if (!startsWith(line, kMark) || line.size() <= kMark.size() || line[kMark.size()] != ' ') {
            return "the file is not a replay";
        }
        const auto version = parseCount(line.substr(kMark.size() + 1), 1'000'000);
        if (!version || *version == 0) return "the replay has no valid format number";
        if (*version > Replay::kFormat) {
            return format("the replay has format {}, this program reads up to {}", *version, Replay::kFormat);
        }
        format_ = *version;
        return {};
    }

    std::string readLine(std::string_view line) {
        if (line.empty()) return "the line is empty";
        if (!isUtf8(line)) return "the text is not UTF-8";
        if (line.front() >= '0' && line.front() <= '9') return readRun(line);
        const std::size_t space = line.find(' ');
        const std::string_view key = line.substr(0, space);
        const std::string_view value =
            space == std::string_view::npos ? std::string_view{} : line.substr(space + 1);
        if (key == "project") return readHeader(replay_.project, value);
        if (key == "engine") return readHeader(replay_.engine, value);
        if (key == "scene") return readHeader(replay_.scene, value);
        if (key == "keys") return readKeys(value);
        if (key == "seed") return readSeed(value);
        if (key == "check") return readCheckpoint(value);
        if (key == "end") return readEnd(value);
        if (isCrash() && key == "build") return readHeader(replay_.crash.build, value);
        if (isCrash() && key == "crash") return readHeader(replay_.crash.what, value);
        if (isCrash() && key == "running") return readHeader(replay_.crash.running, value);
        if (isCrash() && key == "state") return readState(value);
        if (isCrash() && key == "packed") return readPacked(value);
        return format("unknown keyword \"{}\"", key.substr(0, 40));
    }

    static std::string readHeader(std::string& field, std::string_view value) {
        if (value.size() > kNameBytes) return format("the name is longer than {} bytes", kNameBytes);
        field = value;
        return {};
    }

    std::string readKeys(std::string_view value) {
        if (value.size() > kKeysBytes) return format("the keys are longer than {} bytes", kKeysBytes);
        replay_.keys = value;
        return {};
    }

    std::string readSeed(std::string_view value) {
        const std::optional<std::uint64_t> seed = parseHex(value);
        if (!seed) return "the seed is not a hexadecimal number";
        replay_.seed = *seed;
        return {};
    }

    std::string readCheckpoint(std::string_view value) {
        const std::size_t space = value.find(' ');
        if (space == std::string_view::npos) return "expected a tick and a hash after \"check\"";
        const auto tick = parseCount(value.substr(0, space), Replay::kMaxTicks);
        const auto hash = parseHex(value.substr(space + 1));
        if (!tick || !hash) return "expected a tick and a hash after \"check\"";
        if (!replay_.checkpoints.empty() && replay_.checkpoints.back().tick >= *tick)
            return "the checks are not in order of their ticks";
        if (replay_.checkpoints.size() == Replay::kMaxCheckpoints) return "too many checks";
        replay_.checkpoints.push_back({*tick, *hash});
        return {};
    }

    std::string readEnd(std::string_view value) {
        ended_ = true;
        if (parseCount(value, Replay::kMaxTicks) != ticks_)
            return format("expected {}, the number of ticks in the lines above", ticks_);
        return {};
    }

    /// Takes the bytes that follow a line with their number. @return an error message; empty: none
    std::string takeBytes(std::string_view count, std::string_view& bytes) {
        const auto size = parseCount(count, Replay::kMaxBytes);
        if (!size || *size >= text_.size() || text_[*size] != '\n')
            return "expected the number of bytes that follow, after which the line ends";
        bytes = text_.substr(0, *size);
        text_.remove_prefix(*size + 1);
        return {};
    }

    std::string readState(std::string_view value) {
        std::string_view bytes;
        std::string problem = takeBytes(value, bytes);
        replay_.state = bytes;
        return problem;
    }

    std::string readPacked(std::string_view value) {
        std::string_view bytes;
        if (std::string problem = takeBytes(value, bytes); !problem.empty()) return problem;
        std::string problem = unpackInput(bytes, replay_, ticks_);
        if (!replay_.runs.empty()) frame_ = replay_.runs.back().frame;
        return problem;
    }

    std::string readRun(std::string_view line) {
        std::size_t space = line.find(' ');
        const auto ticks = parseCount(line.substr(0, space), Replay::kMaxTicks);
        if (!ticks || *ticks == 0 || ticks_ + *ticks > Replay::kMaxTicks) {
            return format("expected 1 to {} ticks", Replay::kMaxTicks - ticks_);
        }
        while (space != std::string_view::npos) {
            line.remove_prefix(space + 1);
            space = line.find(' ');
            const std::string_view word = line.substr(0, space);
            if (!readChange(word, frame_))
                return format("\"{}\" is not a valid change of the input", word.substr(0, 40));
        }
        ticks_ += *ticks;
        if (!replay_.runs.empty() && replay_.runs.back().frame == frame_) {
            replay_.runs.back().ticks += *ticks;
            return {};
        }
        if (replay_.runs.size() == Replay::kMaxRuns) return "too many changes of input";
        replay_.runs.push_back({frame_, *ticks});
        return {};
    }

    std::string_view text_;
    std::string_view where_;
    Replay replay_;
    InputFrame frame_;
    std::uint64_t ticks_ = 0;
    std::uint64_t format_ = 0;
    int line_ = 0;
    bool ended_ = false;
};

/// Replaces control characters by spaces, because a name must fit on one line. Cuts a long one between two
/// characters, as a part of a character is not UTF-8.
std::string oneLine(std::string_view text) {
    std::size_t end = std::min(text.size(), kNameBytes);
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) --end;
    std::string line{text.substr(0, end)};
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    }
    return line;
}

std::string headerOf(const Replay& replay) {
    const std::string keys = replay.keys.empty() ? "" : format("keys {}\n", replay.keys);
    return format("{} {}\n", kMark, kWritten) + keys +
           format("project {}\nengine {}\nscene {}\nseed {}\n", oneLine(replay.project),
                  oneLine(replay.engine), oneLine(replay.scene), hexText(replay.seed));
}

void writeCheck(std::string& out, const HashCheck& check) {
    out += format("check {} {}\n", check.tick, hexText(check.hash));
}

void writeEnd(std::string& out, std::uint64_t ticks) { out += format("end {}\n", ticks); }

}  // namespace

std::string writeReplay(const Replay& replay) {
    std::string out = headerOf(replay);
    InputFrame before;
    for (const InputRun& run : replay.runs) {
        if (run.ticks == 0) continue;
        out += format("{}", run.ticks);
        writeChanges(out, before, run.frame);
        out += '\n';
        before = run.frame;
    }
    for (const HashCheck& check : replay.checkpoints) writeCheck(out, check);
    writeEnd(out, replay.ticks());
    return out;
}

Result<Replay> parseReplay(std::string_view text, std::string_view where) {
    return ReplayReader{text, where}.read();
}

Result<RecordingFile> RecordingFile::create(const Path& path, const Replay& replay) {
    const std::string header = headerOf(replay);
    std::string text = header;
    writeEnd(text, 0);
    if (const Result<Done> written = writeFile(path, text); !written) return written.error();
    Handle file{os::openFile(path, "r+b"), &std::fclose};
    if (!file)
        return Error{path.generic_string(), format("could not be opened: {}", std::strerror(errno)),
                     "check its permissions"};
    std::setvbuf(file.get(), nullptr, _IONBF, 0);  // a buffer would be lost in a crash
    return RecordingFile{path, std::move(file), header};
}

RecordingFile::RecordingFile(Path path, Handle file, std::string_view header)
    : path_{std::move(path)}, file_{std::move(file)}, final_{static_cast<long>(header.size())} {
    writeEnd(end_, 0);
}

/// Writes a text after the final part. The file never becomes shorter, because numbers of ticks only grow.
bool RecordingFile::write(std::string_view text) {
    return std::fseek(file_.get(), final_, SEEK_SET) == 0 &&
           std::fwrite(text.data(), 1, text.size(), file_.get()) == text.size();
}

/// Makes the file what it was before a write that failed. Needs no space on the disk.
bool RecordingFile::restoreEnd() {
    if (!write(end_)) return false;
    std::error_code failed;
    std::filesystem::resize_file(path_, static_cast<std::uintmax_t>(final_) + end_.size(), failed);
    return !failed;
}

Result<Done> RecordingFile::update(const Recorder& recorder) {
    const Replay& replay = recorder.replay;
    const auto addRun = [&](const InputRun& run) {
        text_ += format("{}", run.ticks);
        text_ += changes_;
        text_ += '\n';
    };
    text_.clear();
    for (; runs_ < replay.runs.size(); ++runs_) {
        const InputRun* before = runs_ > 0 ? &replay.runs[runs_ - 1] : nullptr;
        if (before != nullptr) addRun(*before);
        changes_.clear();
        writeChanges(changes_, before != nullptr ? before->frame : InputFrame{}, replay.runs[runs_].frame);
    }
    for (; checks_ < replay.checkpoints.size(); ++checks_) writeCheck(text_, replay.checkpoints[checks_]);
    const auto becameFinal = static_cast<long>(text_.size());
    if (!replay.runs.empty()) addRun(replay.runs.back());
    writeEnd(text_, recorder.ticks());
    if (!write(text_)) {
        const std::string why = std::strerror(errno);
        return Error{path_.generic_string(),
                     restoreEnd() ? format("the recording ends after {} ticks: {}", ticks_, why)
                                  : format("the recording is damaged after {} ticks: {}", ticks_, why),
                     "free some space on the disk and record again"};
    }
    final_ += becameFinal;
    end_.assign(text_, static_cast<std::size_t>(becameFinal));
    ticks_ = recorder.ticks();
    return Done{};
}

Result<Replay> loadReplay(const Path& path) {
    const Result<std::string> text = readFile(path, Replay::kMaxBytes);
    if (!text) return text.error();
    return parseReplay(*text, path.generic_string());
}

}  // namespace plumb
