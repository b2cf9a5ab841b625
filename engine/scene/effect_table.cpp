#include "scene/effect_table.hpp"

#include "core/text.hpp"
#include "reflect/field_json.hpp"
#include "scene/components/name.hpp"
#include "scene/components/scene_entity.hpp"

namespace plumb {
namespace {

constexpr std::string_view kPinNames[] = {"auto", "on", "off"};

/// Returns e.g. "torch @9f3c1a77d2e0b154", in which the editor's console finds the entity.
std::string entityText(const World& world, EntityId entity, const SceneEntity& source) {
    const Name* name = world.find<Name>(entity);
    const std::string_view text = name == nullptr ? std::string_view{} : world.texts().find(name->text);
    return format("{} @{}", text.empty() ? "entity" : text, hexText(source.id));
}

}  // namespace

std::string_view nameOf(Pin pin) { return kPinNames[static_cast<std::size_t>(pin)]; }

std::size_t EffectRequester::requesters(const World& world) const {
    if (requests == nullptr) return count(world);
    std::size_t requesters = 0;
    world.eachOf(type(), [&](EntityId, const void* component) { requesters += requests(component) ? 1 : 0; });
    return requesters;
}

std::size_t EffectTable::find(std::string_view name) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (rows_[i].name == name) return i;
    }
    return kNone;
}

std::string EffectTable::allNames() const {
    std::string names;
    for (const EffectRow& row : rows_) names.append(names.empty() ? "" : ", ").append(row.name);
    return names;
}

std::vector<Pin> EffectTable::readPins(const Json& json, std::string_view path,
                                       std::vector<Error>* problems) const {
    std::vector<Pin> pins(rows_.size(), Pin::Auto);
    if (!json.is_object()) return pins;
    const auto tell = [&](const std::string& key, std::string what, std::string remedy) {
        if (problems == nullptr) return;
        problems->push_back({format("{}: effects.{}", path, key), std::move(what), std::move(remedy)});
    };
    for (const auto& [key, value] : json.items()) {
        const std::size_t row = find(key);
        if (row == kNone) {
            std::vector<std::string_view> names;
            for (const EffectRow& known : rows_) names.push_back(known.name);
            const std::string_view near = closestName(key, names);
            tell(key, format("there is no effect \"{}\"", key),
                 format("it is kept unchanged; {}effects: {}",
                        near.empty() ? std::string{} : format("did you mean \"{}\"? ", near), allNames()));
            continue;
        }
        const auto* text = value.get_ptr<const std::string*>();
        bool known = false;
        for (const Pin pin : {Pin::Auto, Pin::On, Pin::Off}) {
            if (text == nullptr || *text != nameOf(pin)) continue;
            pins[row] = pin;
            known = true;
        }
        if (!known) {
            tell(key, format("expected \"on\", \"off\" or \"auto\", found {}", foundText(value)),
                 "it is kept unchanged, and read as \"auto\"");
        }
    }
    return pins;
}

void EffectTable::checkNeeds(const World& world, SceneId scene, std::string_view path,
                             std::span<const Pin> pins, std::vector<Error>& problems) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        if (pins[i] != Pin::Off || rows_[i].byDefault) continue;
        for (const EffectRequester& requester : rows_[i].requesters) {
            EntityId first;
            std::string firstText;
            std::size_t count = 0;
            world.eachOf(requester.type(), [&](EntityId entity, const void* component) {
                if (requester.requests != nullptr && !requester.requests(component)) return;
                const auto* source = world.find<SceneEntity>(entity);
                if (source == nullptr || !(source->scene == scene)) return;
                if (++count == 1 || entity.index < first.index)
                    first = entity, firstText = entityText(world, entity, *source);
            });
            if (count == 0) continue;
            const bool alone = count == 1;
            problems.push_back(
                {format("{}: effects.{}", path, rows_[i].name),
                 format("it is \"off\", but {}{} {} {}, which needs it", firstText,
                        alone ? std::string{} : format(" and {} more", count - 1), alone ? "has" : "have",
                        requester.type().name),
                 format("remove {}, or write \"auto\"; the effect stays off", requester.type().name)});
        }
    }
}

}  // namespace plumb
