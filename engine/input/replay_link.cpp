#include "input/replay_link.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/text.hpp"
#include "input/link_format.hpp"

namespace plumb {
namespace {

using link_format::apply, link_format::Change, link_format::eachChange, link_format::kHeadBytes,
    link_format::kMaxKeysBytes, link_format::kMaxNameBytes, link_format::kVersion, link_format::LinkModel,
    link_format::Part;

constexpr std::string_view kEscapedMark = "%23r=";
constexpr const char* kWhere = "link";

Error tooLong(std::uint64_t ticks) {
    return Error{kWhere, format("after {} ticks the run is too long for a link", ticks),
                 "record it to a file: --record FILE"};
}

Error damaged(std::string what) { return Error{kWhere, std::move(what), "copy the whole link again"}; }

}  // namespace

// ---- writing

struct LinkWriter::State {
    RangeEncoder encoder;
    LinkModel model;
    InputFrame frame;         // of the current run
    std::uint64_t run = 0;    // ticks of the current run; it is not in the stream yet
    std::uint64_t ticks = 0;  // of all runs
    std::size_t runs = 0;
    bool isFull = false;

    void beginRun(const InputFrame& next) {
        Part last = Part::End;
        const auto write = [&](const Change& change) {
            model.code(encoder, change, last, frame);
            apply(change, frame);
            last = change.part;
        };
        eachChange(InputFrame{frame}, next, write);
        // The first run has a list even if nothing is pressed in it: an empty one would be the end.
        if (last == Part::End) write({Part::Mouse});
        model.endList(encoder, last, frame);
        ++runs;
    }

    void endRun() {
        if (run > 0) model.codeTicks(encoder, run);
        run = 0;
    }

    [[nodiscard]] bool hasRoom() const {
        return runs < kMaxLinkRuns && ticks < Replay::kMaxTicks &&
               encoder.size() < kMaxLinkBytes / 4 * 3 - 1024;
    }
};

LinkWriter::LinkWriter(const Replay& begin) : state_{std::make_unique<State>()} {
    for (const std::string* name : {&begin.project, &begin.engine, &begin.scene}) {
        std::string text = name->substr(0, kMaxNameBytes);
        state_->model.code(state_->encoder, text);
    }
    std::string keys = begin.keys.size() > kMaxKeysBytes ? std::string{} : begin.keys;
    state_->isFull = keys.size() != begin.keys.size();
    state_->model.code(state_->encoder, keys, kMaxKeysBytes);
    state_->encoder.bits(begin.seed, 64);
}
LinkWriter::LinkWriter(LinkWriter&&) noexcept = default;
LinkWriter& LinkWriter::operator=(LinkWriter&&) noexcept = default;
LinkWriter::~LinkWriter() = default;

std::uint64_t LinkWriter::ticks() const { return state_->ticks; }

void LinkWriter::record(const InputFrame& frame) {
    State& state = *state_;
    state.isFull = state.isFull || !state.hasRoom();
    if (state.isFull) return;
    if (state.runs == 0 || frame != state.frame) {
        state.endRun();
        state.beginRun(frame);
    }
    ++state.run;
    ++state.ticks;
}

Result<std::string> LinkWriter::link(std::optional<std::uint64_t> hash) const {
    if (state_->isFull) return tooLong(state_->ticks);
    const auto end = std::make_unique<State>(*state_);  // too large for the stack
    RangeEncoder& encoder = end->encoder;
    end->endRun();
    end->model.code(encoder, Change{}, Part::End, end->frame);
    encoder.bits(hash ? 1 : 0, 1);
    if (hash) encoder.bits(*hash, 64);
    return link_format::linkOfStream(encoder.finish());
}

Result<std::string> linkOf(const Replay& replay) {
    LinkWriter writer{replay};
    for (const InputRun& run : replay.runs) {
        for (std::uint64_t i = 0; i < run.ticks; ++i) writer.record(run.frame);
    }
    const bool isChecked = !replay.checkpoints.empty() && replay.checkpoints.back().tick == writer.ticks();
    return writer.link(isChecked ? std::optional{replay.checkpoints.back().hash} : std::nullopt);
}

// ---- reading

namespace {

bool isLine(std::string_view text, std::uint64_t maxBytes) {
    const auto isControl = [](char c) { return static_cast<unsigned char>(c) < 32; };
    return text.size() <= maxBytes && isUtf8(text) && std::none_of(text.begin(), text.end(), isControl);
}

/// Reads the stream of a link.
class LinkReader {
public:
    explicit LinkReader(std::string_view stream) : decoder_{stream} {}

    Result<Replay> read() {
        for (std::string* name : {&replay_.project, &replay_.engine, &replay_.scene}) {
            model_.code(decoder_, *name);
            if (!isLine(*name, kMaxNameBytes)) return damaged("the link has an invalid name");
        }
        model_.code(decoder_, replay_.keys, kMaxKeysBytes);
        if (!isLine(replay_.keys, kMaxKeysBytes)) return damaged("the link has invalid keys");
        replay_.seed = decoder_.bits(0, 64);
        for (;;) {
            const Result<bool> goesOn = readRun();
            if (!goesOn) return goesOn.error();
            if (!*goesOn) break;
        }
        if (decoder_.bits(0, 1) != 0) replay_.checkpoints.push_back({ticks_, decoder_.bits(0, 64)});
        if (!decoder_.isAtEnd()) return incomplete();
        return std::move(replay_);
    }

private:
    static Error incomplete() { return damaged("the link is incomplete"); }

    /// @return false at the end of the replay
    Result<bool> readRun() {
        Part last = Part::End;
        unsigned lastIndex = 0;
        for (;;) {
            const Change change = model_.code(decoder_, Change{}, last, frame_);
            if (decoder_.isBeyondEnd()) return incomplete();
            if (change.part == Part::End) break;
            const bool isInOrder = std::pair{change.part, change.index} > std::pair{last, lastIndex};
            if (!isInOrder || !apply(change, frame_))
                return damaged("the link has input that no device gives");
            last = change.part;
            lastIndex = change.index;
        }
        if (last == Part::End) return false;
        if (!isPossible(frame_)) return damaged("the link has input that no device gives");
        model_.lastPart = last;
        const std::uint64_t ticks = model_.codeTicks(decoder_, 1);
        if (ticks > Replay::kMaxTicks - ticks_ || replay_.runs.size() == kMaxLinkRuns)
            return damaged("the link has more ticks than a replay may have");
        replay_.runs.push_back({frame_, ticks});
        ticks_ += ticks;
        return true;
    }

    RangeDecoder decoder_;
    LinkModel model_;
    InputFrame frame_;
    Replay replay_;
    std::uint64_t ticks_ = 0;
};

constexpr std::string_view kSpace = " \t\r\n";

/// What is after the mark, up to another part of the address.
Result<std::string_view> afterMark(std::string_view text) {
    for (const std::string_view mark : {link_format::kMark, kEscapedMark}) {
        const std::size_t at = text.find(mark);
        if (at != std::string_view::npos)
            return text.substr(at + mark.size(), text.find('&', at) - at - mark.size());
    }
    if (startsWith(text, link_format::kMark.substr(1))) {
        text.remove_prefix(link_format::kMark.size() - 1);
    } else if (text.find_first_of(":/#") != std::string_view::npos) {
        return Error{kWhere, "the address contains no replay",
                     format("it must end with {}...", link_format::kMark)};
    }
    return text.substr(0, text.find('&'));
}

/// Without white space, plain or escaped ("%20"): programs for mail break long lines.
std::string withoutSpace(std::string_view text) {
    std::string digits;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const std::string_view escape = text.substr(i, 3);
        if (escape == "%20" || escape == "%09" || escape == "%0A" || escape == "%0D") {
            i += 2;
        } else if (kSpace.find(text[i]) == std::string_view::npos) {
            digits += text[i];
        }
    }
    return digits;
}

/// @param digits  base64url
Result<Replay> replayOfDigits(std::string_view digits) {
    if (digits.empty())
        return Error{kWhere, "the link is empty", format("give the text from {} on", link_format::kMark)};
    if (digits.size() > kMaxLinkBytes)
        return Error{kWhere, format("the link has {} characters", digits.size()),
                     format("the longest have {}", kMaxLinkBytes)};
    const Result<std::string> bytes = bytesFromBase64Url(digits, kWhere);
    if (!bytes) return damaged(format("the link is damaged or incomplete: {}", bytes.error().what));
    if (bytes->size() < kHeadBytes) return damaged("the link is incomplete");
    const unsigned version = static_cast<unsigned char>(bytes->front());
    if (version != kVersion)
        return Error{kWhere, format("the link has version {}, this program reads {}", version, kVersion),
                     "play it with the version of the game that made it"};
    const std::string_view stream = std::string_view{*bytes}.substr(kHeadBytes);
    if (!startsWith(*bytes, link_format::headOf(stream))) return damaged("the link is damaged or incomplete");
    return std::make_unique<LinkReader>(stream)->read();  // too large for the stack
}

}  // namespace

Result<Replay> replayOfLink(std::string_view text) {
    const Result<std::string_view> link = afterMark(text);
    if (!link) return link.error();
    Result<Replay> replay = replayOfDigits(withoutSpace(*link));
    if (replay) return replay;
    // Other words may follow the link.
    const std::string_view first = trimmed(*link);
    const std::size_t end = first.find_first_of(kSpace);
    if (end == std::string_view::npos) return replay;
    Result<Replay> ofFirst = replayOfDigits(first.substr(0, end));
    return ofFirst ? ofFirst : replay;
}

}  // namespace plumb
