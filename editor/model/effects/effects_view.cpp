#include "editor/model/effects/effects_view.hpp"

#include <algorithm>

#include "core/text.hpp"
#include "editor/model/effects/set_effect_pin.hpp"
#include "scene/loaded_scene.hpp"

namespace plumb::editor {
namespace {

constexpr std::int64_t kTicksOfCount = 15;  // faster changes of the numbers would be unreadable

const LoadedScene* sceneOf(const Document& document) {
    LoadedScenes* scenes = document.world.findResource<LoadedScenes>();
    return scenes == nullptr ? nullptr : scenes->find(document.scene);
}

}  // namespace

std::vector<Pin> pinsOf(const Document& document, const EffectTable& table) {
    const LoadedScene* scene = sceneOf(document);
    return table.readPins(scene == nullptr ? Json::object() : scene->effects, document.scenePath, nullptr);
}

std::size_t EffectsView::running() const {
    return static_cast<std::size_t>(
        std::count_if(lines_.begin(), lines_.end(), [](const Line& line) { return line.runs; }));
}

void EffectsView::refresh(const Workspace& workspace) {
    table_ = workspace.document.world.service<const EffectTable>();
    const std::int64_t ticks = workspace.play.running() ? workspace.play.ticks() : -1;
    const bool playChanged = (ticks < 0) != (ticks_ < 0);
    const bool recount = lines_.empty() || playChanged || revision_ != workspace.document.sceneRevision ||
                         ticks < ticks_ || ticks >= ticks_ + kTicksOfCount;
    if (recount) {
        revision_ = workspace.document.sceneRevision;
        ticks_ = ticks;
    }
    if (lines_.empty()) {
        for (std::size_t i = 0; i < table().rows().size(); ++i) {
            Line line;
            line.row = i;
            line.inPhysics = table().rows()[i].physics != physics::Effect::Count;
            line.zones = zonesOf(table(), i);
            lines_.push_back(std::move(line));
        }
    }
    if (workspace.play.running()) {
        lookAtGame(workspace, recount);
    } else if (recount) {
        lookAtScene(workspace, recount);
    }
}

/// Without a running game, finds the components that would require each effect.
void EffectsView::lookAtScene(const Workspace& workspace, bool) {
    const std::vector<Pin> pins = pinsOf(workspace.document, table());
    tick_ = 0.0f;
    for (Line& line : lines_) {
        line.requesters = requestersOf(workspace.document.world, table().rows()[line.row]);
        line.pin = pins[line.row];
        line.pinnedBy.clear();
        line.isRequired = !line.requesters.empty();
        line.runs = line.pin == Pin::Auto ? line.isRequired : line.pin == Pin::On;
        line.measured = false;
    }
}

void EffectsView::lookAtGame(const Workspace& workspace, bool recount) {
    const World& world = workspace.play.world();
    const auto* effects = world.service<Effects>();
    if (effects == nullptr) return lookAtScene(workspace, recount);  // the session has no Effects service
    const std::vector<Pin> pins = pinsOf(workspace.document, table());
    for (Line& line : lines_) {
        line.pin = pins[line.row];
        line.pinnedBy = effects->pinnedBy(line.row) == workspace.document.scenePath
                            ? std::string{}
                            : effects->pinnedBy(line.row);
        line.isRequired = effects->isRequired(world, line.row);
        line.runs = effects->runs(world, line.row);
        if (recount) line.requesters = requestersOf(world, table().rows()[line.row]);
    }
    readCosts(workspace.profiler);
}

void EffectsView::readCosts(const Profiler& profiler) {
    const auto& samples = profiler.samples();
    const std::size_t count = std::min(samples.size(), kTicks);
    std::vector<float> zones(profiler.zones().size());
    tick_ = 0.0f;
    for (std::size_t i = samples.size() - count; i < samples.size(); ++i) {
        tick_ += samples[i].milliseconds / static_cast<float>(count);
        for (std::size_t zone = 0; zone < samples[i].zones.size(); ++zone)
            zones[zone] += samples[i].zones[zone] / static_cast<float>(count);
    }
    if (overhead_ < 0.0f) overhead_ = static_cast<float>(zoneOverhead() * 1000.0);
    for (Line& line : lines_) {
        line.measured = count > 0 && line.runs && !line.zones.own.empty();
        line.milliseconds = 0.0f;
        for (std::size_t zone = 0; zone < zones.size(); ++zone) {
            const auto& own = line.zones.own;
            if (std::find(own.begin(), own.end(), profiler.zones()[zone].name) != own.end())
                line.milliseconds += std::max(zones[zone] - overhead_, 0.0f);
        }
        line.share = tick_ > 0.0f ? line.milliseconds / tick_ : 0.0f;
    }
}

void selectRequesters(Workspace& workspace, const EffectRow& row, const TypeInfo& type) {
    std::vector<ObjectId> ids;
    for (const EffectRequester& requester : row.requesters) {
        if (&requester.type() != &type) continue;
        workspace.shownWorld().eachOf(type, [&](EntityId entity, const void* component) {
            const bool requests = requester.requests == nullptr || requester.requests(component);
            if (const ObjectId id = requests ? workspace.shownNames().idOf(entity) : ObjectId{}; id)
                ids.push_back(id);
        });
    }
    workspace.document.selection.set(std::move(ids));
    workspace.notice = format("Selected {} entities with {} that require {}",
                              workspace.document.selection.size(), type.name, row.name);
}

void pinEffect(Workspace& workspace, std::string_view effect, Pin pin) {
    if (!workspace.canEdit()) return;
    workspace.undo.endGesture();
    workspace.undo.push(std::make_unique<SetEffectPin>(std::string{effect}, pin));
    workspace.undo.endGesture();
}

}  // namespace plumb::editor
