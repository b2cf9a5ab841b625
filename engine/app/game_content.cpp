#include "app/game_content.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "app/effect_rows.hpp"
#include "app/engine_types.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "ecs/component_type.hpp"
#include "gameplay/delayed_events.hpp"
#include "gameplay/systems.hpp"
#include "gameplay/tweens.hpp"
#include "reflect/convert_component.hpp"
#include "reflect/type_check.hpp"
#include "script/script_system.hpp"

namespace plumb {
namespace {

TypeInfo described(const Module::Resource& resource) {
    TypeRegistry types;
    resource.describe(types);
    return types.all().front();
}

/// Systems of a project's code run before this one by default: earlier systems control and simulate, this one
/// handles the events that code emits for scripts, and later ones display the result.
constexpr std::string_view kAfterCode = ScriptEventSystem::kName;

auto rowOf(std::vector<SystemRow>& rows, std::string_view name) {
    return std::find_if(rows.begin(), rows.end(), [&](const SystemRow& row) { return row.name == name; });
}

/// Returns a system of the code as errors name it: a handler as the code registers it, because its type's
/// name is that of a class of the engine.
std::string whereOf(const Module::System& system) {
    const std::string_view name = system.row.name;
    return system.isHandler ? format("code: module.on{}", name.substr(name.find('<')))
                            : format("code: system \"{}\"", name);
}

Error unknownSystem(const Module::System& system, std::string_view name) {
    return {whereOf(system), format("there is no system \"{}\" to run before or after", name),
            "use a system of the engine, e.g. before<PhysicsSystem>(), or one that the code adds earlier"};
}

Error nameIsUsed(const Module::System& system) {
    if (system.isHandler)
        return {whereOf(system), "this function is registered for this event already",
                "remove one of the two lines; if they mean functions of two files, rename one of these"};
    return {whereOf(system), "there is a system of this name already",
            "add each system once; to give a system another name, rename its type or its kName"};
}

void addMistakes(std::vector<Error>& problems, const TypeInfo& type) {
    for (Error& mistake : mistakesOf(type)) {
        mistake.where = "code: " + mistake.where;
        problems.push_back(std::move(mistake));
    }
}

/// @param where  what gives the type its name: "describe()", or the path of a script, whose name is that of
/// the type
/// @param other  the same of the type that has the name already; empty: the engine
Error nameIsUsed(std::string_view kind, const TypeInfo& type, std::string_view user,
                 std::string_view where = "describe()", std::string_view other = {}) {
    const bool isScript = endsWith(where, ".lua");
    const std::string_view by = other.empty() ? "" : endsWith(other, ".lua") ? other : "the code";
    return {
        isScript ? std::string{where} : format("code: {} \"{}\"", kind, type.name),
        isScript
            ? format("there is a component \"{}\" already{}{}", type.name, by.empty() ? "" : ", that of ", by)
            : format("there is a {} of this name already", user),
        isScript ? std::string{"give the file another name"} : format("choose another name in {}", where)};
}

/// Returns the position in `rows` at which a system of the code must be inserted.
auto positionOf(std::vector<SystemRow>& rows, const Module::System& system, std::vector<Error>& problems) {
    const bool after = !system.position.after.empty();
    const std::string_view name = after ? system.position.after : system.position.before;
    if (!name.empty()) {
        const auto found = rowOf(rows, name);
        if (found != rows.end()) return after ? std::next(found) : found;
        problems.push_back(unknownSystem(system, name));
    }
    return rowOf(rows, kAfterCode);
}

}  // namespace

GameContent::GameContent(Module code, std::vector<Error>& problems)
    : types_{engineTypes()}, effects_{engineEffects()} {
    static_cast<void>(update(std::move(code), problems));
}

ContentChange GameContent::update(Module code, std::vector<Error>& problems) {
    ContentChange change;
    change.newCode = true;
    change.before = std::exchange(code_, std::move(code));
    for (const Module::System& system : change.before.systems()) change.systems.push_back(system.row.key());
    updateTypes(change, problems);
    checkResources(problems);
    updateSystems(problems);
    return change;
}

ContentChange GameContent::readScripts(const Path& folder, std::vector<Error>& problems) {
    ContentChange change;
    const std::uint64_t version = scripts_.version();
    scripts_.read(folder, problems);
    if (scripts_.version() != version) updateTypes(change, problems);
    return change;
}

ContentChange GameContent::useScripts(const std::vector<std::pair<std::string, std::string>>& texts,
                                      std::vector<Error>& problems) {
    ContentChange change;
    scripts_.readTexts(texts, problems);
    updateTypes(change, problems);
    return change;
}

std::vector<GameContent::ProjectType> GameContent::projectTypes() const {
    std::vector<ProjectType> types;
    for (const auto add : code_.componentTypes()) {
        TypeRegistry described;
        add(described);
        types.push_back({described.all().front(), "describe()"});
    }
    for (const ScriptSet::File& file : scripts_.files()) {
        if (file.type) types.push_back({*file.type, file.path});
    }
    return types;
}

void GameContent::updateTypes(ContentChange& change, std::vector<Error>& problems) {
    const std::vector<std::string> former = std::exchange(projectTypes_, {});
    const auto contains = [](const std::vector<std::string>& names, std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    const std::vector<ProjectType> all = projectTypes();
    for (const auto& [type, where] : all) {
        if (!type.cppName.empty()) addMistakes(problems, type);
        if (type.name.empty()) continue;
        const TypeInfo* known = types_.find(type.name);
        const bool isOfProject = contains(projectTypes_, type.name);
        const bool isOfEngine = known != nullptr && !isOfProject && !contains(former, type.name);
        if (isOfEngine || isOfProject) {
            const auto other =
                std::find_if(all.begin(), all.end(),
                             [&, name = type.name](const ProjectType& t) { return t.type.name == name; });
            problems.push_back(nameIsUsed("component", type, "component", where,
                                          isOfEngine ? std::string_view{} : std::string_view{other->where}));
            continue;
        }
        projectTypes_.emplace_back(type.name);
        if (known != nullptr && !sameLayout(*known, type)) change.types.push_back({*known, known});
        const TypeInfo& now = types_.update(type);
        if (known == nullptr) change.added.push_back(&now);
        updateComponentType(now);
    }
    for (const std::string& name : former) {
        if (contains(projectTypes_, name)) continue;
        change.types.push_back({*types_.find(name), nullptr});
        types_.remove(name);
    }
    scripts_.typesChanged();
}

/// Values of resources are kept by their names when the code is loaded again, so names must differ.
void GameContent::checkResources(std::vector<Error>& problems) const {
    std::vector<std::string_view> names;
    for (const Module::Resource& resource : code_.resourceTypes()) {
        const TypeInfo type = described(resource);
        addMistakes(problems, type);
        if (types_.find(type.name) != nullptr) problems.push_back(nameIsUsed("resource", type, "component"));
        if (std::find(names.begin(), names.end(), type.name) != names.end())
            problems.push_back(nameIsUsed("resource", type, "resource"));
        names.push_back(type.name);
    }
}

void GameContent::updateSystems(std::vector<Error>& problems) {
    systems_.assign(systemTable().begin(), systemTable().end());
    std::vector<EffectRow> effects = engineEffects().rows();
    std::vector<EffectSystem> gated = engineEffects().systems();
    for (const Module::System& system : code_.systems()) {
        if (rowOf(systems_, system.row.name) != systems_.end()) {
            problems.push_back(nameIsUsed(system));
            continue;
        }
        systems_.insert(positionOf(systems_, system, problems), system.row);
        gated.push_back({system.row.key(), system.row.name, system.row.effect});
        if (!system.effect.name.empty()) effects.push_back(system.effect);
    }
    for (EffectRow& effect : effects) {
        if (effect.name == "pads" && !code_.systems().empty())
            effect.isRequired = [](const World&) { return true; };  // systems may read them
    }
    effects_ = EffectTable{std::move(effects), std::move(gated)};
}

void GameContent::useSystemOrder(World& world) const {
    std::vector<std::string_view> names;
    for (const SystemRow& system : systems_) {
        names.push_back(system.name);
    }
    world.setSystemOrder(names);
}

void GameContent::addSystems(World& world) const {
    useSystemOrder(world);
    for (const SystemRow& system : systems_) {
        system.add(world);
    }
}

namespace {

/// A resource of the code, with its value in the previous version of the code.
struct KeptResource {
    TypeInfo type;
    std::vector<std::byte> value;
};

std::vector<KeptResource> keepResources(const World& world, const Module& code) {
    std::vector<KeptResource> kept;
    for (const Module::Resource& resource : code.resourceTypes()) {
        const auto* value = static_cast<const std::byte*>(resource.find(world));
        if (value == nullptr) continue;
        KeptResource& keep = kept.emplace_back();
        keep.type = described(resource);
        keep.value.assign(value, value + keep.type.size);
    }
    return kept;
}

}  // namespace

namespace {

/// Removes the tweens of components whose layout may be another now.
void dropTweens(World& world, const GameContent& content, const ContentChange& change) {
    auto* tweens = world.findResource<Tweens>();
    if (tweens == nullptr) return;
    for (const ContentChange::Type& type : change.types) tweens->drop(type.before.key);
    std::erase_if(tweens->entries, [&](const Tweens::Entry& tween) {
        return isReloadable(tween.type) && content.types().find(tween.type) == nullptr;
    });
}

/// Lets the new version of the code emit the events that the former one delayed.
void keepTimers(World& world) {
    auto* delayed = world.findResource<DelayedEvents>();
    if (delayed == nullptr) return;
    for (const std::string& name : delayed->followCode()) {
        logWarning("Code",
                   Error{format("event {}", name),
                         "its timers were removed: in the new version of the code its size is another, "
                         "or emitAfter() never delays it",
                         "restart the game to set them again"});
    }
}

/// Replaces systems, resources and events of the code by those of its new version.
void convertCode(World& world, const GameContent& content, const ContentChange& change) {
    const std::vector<KeptResource> kept = keepResources(world, change.before);
    world.dropReloadable();
    keepTimers(world);
    world.reports().forget();
    for (const TypeKey system : change.systems) world.removeSystem(system);
    for (const Module::Resource& resource : content.code().resourceTypes()) {
        const TypeInfo now = described(resource);
        for (const KeptResource& before : kept) {
            if (before.type.name == now.name)
                convertComponent(before.type, before.value.data(), now, resource.make(world));
        }
    }
    if (world.systemNames().empty()) return;  // a scene that is edited: it has no systems
    content.addSystems(world);
}

}  // namespace

void convertWorld(World& world, const GameContent& content, const ContentChange& change) {
    dropTweens(world, content, change);
    for (const ContentChange::Type& type : change.types) world.convert(type.before, type.now);
    // The code may have used them before it listed them.
    for (const TypeInfo* type : change.added) world.convert(*type, nullptr);
    content.scripts().addTexts(world);
    if (change.newCode) convertCode(world, content, change);
}

const GameContent& engineContent() {
    static std::vector<Error> none;
    static const GameContent kContent{Module{}, none};
    return kContent;
}

}  // namespace plumb
