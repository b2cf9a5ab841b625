#include "editor/model/assets/animation_edit.hpp"

#include <algorithm>
#include <cmath>

#include "assets/asset_store.hpp"
#include "core/text.hpp"
#include "editor/model/assets/asset_catalog.hpp"
#include "editor/model/assets/state_machine_edit.hpp"
#include "editor/model/commands/write_asset.hpp"
#include "editor/model/input/key_words.hpp"

namespace plumb::editor {
namespace {

constexpr float kUsualSeconds = 0.1f;

template <class T>
bool isIndex(const std::vector<T>& items, int index) {
    return index >= 0 && index < static_cast<int>(items.size());
}

std::string freeName(const AnimationSet& set, std::string_view wanted) {
    std::string name{wanted};
    for (int number = 2; set.findClip(name) >= 0; ++number) name = format("{} {}", wanted, number);
    return name;
}

std::string stopFirst(const Workspace& workspace) {
    return format("Stop the game to edit animations ({})", keysFor(workspace, "run.play"));
}

}  // namespace

std::string AnimationEdit::open(std::string_view path) {
    std::string wanted{path};
    if (assetKindOf(path) == AssetKind::Texture) {
        wanted = wanted.substr(0, wanted.rfind('.')) + ".anim.json";
        std::error_code ignored;
        if (!std::filesystem::exists(workspace_.project.root / wanted, ignored)) {
            if (!workspace_.canEdit()) return stopFirst(workspace_);
            AnimationSet set;
            set.image = path;
            workspace_.undo.endGesture();
            workspace_.undo.push(std::make_unique<WriteAsset>(format("create {}", wanted),
                                                              workspace_.project.root, workspace_.assets,
                                                              wanted, writeAnimationSet(set)));
            workspace_.undo.endGesture();
        }
    }
    if (assetKindOf(wanted) != AssetKind::Animation)
        return format("{} is neither an animation nor an image", path);
    path_ = wanted;
    id_ = workspace_.assets.loadAnimation(path_);
    static_cast<void>(workspace_.assets.pollChanges(workspace_.assets.size()));
    if (!set().image.empty() && set().frameWidth == 0) detectCells();
    return {};
}

const AnimationSet& AnimationEdit::set() const { return workspace_.assets.animation(id_); }

const Image& AnimationEdit::sheet() {
    static const Image none;
    return set().texture.empty() ? none : workspace_.assets.image(set().texture);
}

int AnimationEdit::columns() {
    return set().frameWidth > 0 ? std::max(sheet().width / set().frameWidth, 1) : 1;
}
int AnimationEdit::rows() {
    return set().frameHeight > 0 ? std::max(sheet().height / set().frameHeight, 1) : 1;
}

Rect AnimationEdit::cellOf(const AnimationFrame& frame) const {
    const auto width = static_cast<float>(set().frameWidth);
    const auto height = static_cast<float>(set().frameHeight);
    return {static_cast<float>(frame.cellX) * width, static_cast<float>(frame.cellY) * height, width, height};
}

bool AnimationEdit::change(std::string label, const std::function<void(AnimationSet&)>& edit) {
    if (path_.empty()) return false;
    AnimationSet changed = set();
    edit(changed);
    if (changed == set()) return false;
    if (!workspace_.canEdit()) {  // a change would make replayed ticks of the game differ
        workspace_.notice = stopFirst(workspace_);
        return false;
    }
    workspace_.undo.endGesture();
    workspace_.undo.push(std::make_unique<WriteAsset>(std::move(label), workspace_.project.root,
                                                      workspace_.assets, path_, writeAnimationSet(changed)));
    workspace_.undo.endGesture();
    return true;
}

void AnimationEdit::setCells(CellSize cells) {
    change("cut the sheet into cells", [&](AnimationSet& set) {
        set.frameWidth = std::clamp(cells.width, 0, 16384);
        set.frameHeight = std::clamp(cells.height, 0, 16384);
    });
}

bool AnimationEdit::detectCells() {
    const CellSize cells = guessCells(sheet());
    if (cells == CellSize{}) return false;
    setCells(cells);
    return true;
}

void AnimationEdit::addClipOfAll() {
    const Image& image = sheet();
    change("add a clip of all cells", [&](AnimationSet& set) {
        Animation clip;
        clip.name = freeName(set, "all");
        for (int y = 0; y < rows(); ++y) {
            for (int x = 0; x < columns(); ++x) {
                const AnimationFrame frame{x, y, kUsualSeconds, ""};
                if (hasContent(image, cellOf(frame))) clip.frames.push_back(frame);
            }
        }
        if (!clip.frames.empty()) set.clips.push_back(std::move(clip));
    });
}

void AnimationEdit::addClip() {
    change("add a clip", [&](AnimationSet& set) {
        Animation clip;
        clip.name = freeName(set, "clip");
        clip.frames.push_back({0, 0, kUsualSeconds, ""});
        set.clips.push_back(std::move(clip));
    });
}

void AnimationEdit::removeClip(int clip) {
    change("remove a clip", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip)) return;
        set.clips.erase(set.clips.begin() + clip);
        for (int state = static_cast<int>(set.states.size()) - 1; state >= 0; --state) {
            if (set.states[static_cast<std::size_t>(state)].clip == clip) eraseState(set, state);
        }
        for (AnimationState& state : set.states) {
            if (state.clip > clip) --state.clip;
        }
    });
}

void AnimationEdit::renameClip(int clip, std::string_view name) {
    change("rename a clip", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip) || name.empty() || set.findClip(name) >= 0) return;
        set.clips[static_cast<std::size_t>(clip)].name = name;
    });
}

void AnimationEdit::addFrame(int clip, int cellX, int cellY) {
    change("add a frame", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip)) return;
        std::vector<AnimationFrame>& frames = set.clips[static_cast<std::size_t>(clip)].frames;
        frames.push_back({cellX, cellY, frames.empty() ? kUsualSeconds : frames.back().seconds, ""});
    });
}

void AnimationEdit::removeFrame(int clip, int frame) {
    change("remove a frame", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip)) return;
        std::vector<AnimationFrame>& frames = set.clips[static_cast<std::size_t>(clip)].frames;
        if (isIndex(frames, frame) && frames.size() > 1) frames.erase(frames.begin() + frame);
    });
}

void AnimationEdit::moveFrame(int clip, int from, int to) {
    change("move a frame", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip)) return;
        std::vector<AnimationFrame>& frames = set.clips[static_cast<std::size_t>(clip)].frames;
        if (!isIndex(frames, from) || !isIndex(frames, to)) return;
        const AnimationFrame moved = frames[static_cast<std::size_t>(from)];
        frames.erase(frames.begin() + from);
        frames.insert(frames.begin() + to, moved);
    });
}

void AnimationEdit::setSeconds(int clip, int frame, float seconds) {
    change("change the duration of a frame", [&](AnimationSet& set) {
        if (!isIndex(set.clips, clip)) return;
        std::vector<AnimationFrame>& frames = set.clips[static_cast<std::size_t>(clip)].frames;
        if (isIndex(frames, frame))
            frames[static_cast<std::size_t>(frame)].seconds = std::clamp(seconds, 0.001f, 3600.0f);
    });
}

void AnimationEdit::setLoop(int clip, LoopMode loop) {
    change("change how a clip repeats", [&](AnimationSet& set) {
        if (isIndex(set.clips, clip)) set.clips[static_cast<std::size_t>(clip)].loop = loop;
    });
}

int frameAt(const Animation& clip, double seconds) {
    double total = 0.0;
    for (const AnimationFrame& frame : clip.frames) total += static_cast<double>(frame.seconds);
    if (!(total > 0.0) || !(seconds >= 0.0)) return 0;
    const bool both = clip.loop == LoopMode::PingPong;
    double rest = clip.loop == LoopMode::Once ? std::min(seconds, total - 1e-6)
                                              : std::fmod(seconds, both ? total * 2.0 : total);
    if (both && rest >= total) rest = total * 2.0 - rest - 1e-9;
    for (std::size_t i = 0; i < clip.frames.size(); ++i) {
        rest -= static_cast<double>(clip.frames[i].seconds);
        if (rest < 0.0) return static_cast<int>(i);
    }
    return static_cast<int>(clip.frames.size()) - 1;
}

}  // namespace plumb::editor
