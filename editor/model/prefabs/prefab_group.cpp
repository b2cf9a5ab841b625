#include "editor/model/prefabs/prefab_group.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "core/text.hpp"
#include "reflect/json.hpp"

namespace plumb::editor {
namespace {

using Override = PrefabOverrides::Component;

/// The overrides of one entity, as in a scene file.
Json ownOf(const PrefabEdit& edit, const InstancePart& part, const PrefabScope& scope) {
    Json own = Json::object();
    for (const TypeInfo& type : edit.document.types().all()) {
        if (!canOverride(type) || (scope.type != nullptr && scope.type != &type)) continue;
        const bool here = edit.document.world.has(type, edit.document.find(part.id()));
        const bool there = part.prefabHas(type);
        const std::string name{type.name};
        if (here && there) {
            Json fields = part.differences(type);
            if (!scope.field.empty()) {
                const auto found = fields.find(std::string{scope.field});
                Json only = Json::object();
                if (found != fields.end()) only[found.key()] = *found;
                fields = std::move(only);
            }
            if (!fields.empty()) own[name] = std::move(fields);
        } else if (here != there && scope.field.empty()) {
            own[name] = here ? "added" : "removed";
        }
    }
    return own;
}

/// The overrides of one instance, or of one entity of it.
struct Variant {
    ObjectId id;
    Json own;  // overrides by part id
};

/// Variants by the path of their prefab and the part id; part id 0 if whole instances are compared.
using VariantsByPart = std::map<std::pair<std::string, std::uint64_t>, std::vector<Variant>>;

VariantsByPart variantsOf(const PrefabEdit& edit, const std::vector<ObjectId>& ids,
                          const PrefabScope& scope) {
    VariantsByPart all;
    std::vector<ObjectId> done;
    for (const ObjectId id : ids) {
        const auto part = InstancePart::of(edit.document, edit.prefabs, id);
        if (!part) continue;
        const bool whole = scope.type == nullptr;
        const ObjectId subject = whole ? part->root() : id;
        if (std::find(done.begin(), done.end(), subject) != done.end()) continue;
        done.push_back(subject);
        Json own = Json::object();
        for (const ObjectId member : whole ? part->all() : std::vector{id}) {
            const auto inner = InstancePart::of(edit.document, edit.prefabs, member);
            if (!inner) continue;
            if (Json says = ownOf(edit, *inner, scope); !says.empty())
                own[hexText(inner->base().part)] = std::move(says);
        }
        if (own.empty()) continue;
        all[{part->prefab().path, whole ? 0 : part->base().part}].push_back({id, std::move(own)});
    }
    return all;
}

std::string contradiction(const VariantsByPart& all) {
    for (const auto& [place, variants] : all) {
        const bool agree = std::all_of(variants.begin(), variants.end(),
                                       [&](const Variant& one) { return one.own == variants.front().own; });
        if (!agree)
            return format(
                "{} selected instances of {} override it with different values: select only the one to "
                "apply",
                variants.size(), place.first);
    }
    return {};
}

void join(PrefabOverrides& all, const PrefabOverrides& more) {
    for (const Override& component : more.components) {
        const auto known = std::find_if(all.components.begin(), all.components.end(),
                                        [&](const Override& one) { return one.type == component.type; });
        if (known == all.components.end()) {
            all.components.push_back(component);
            continue;
        }
        known->added = known->added || component.added;
        known->removed = known->removed || component.removed;
        for (const std::string& field : component.fields) {
            if (std::find(known->fields.begin(), known->fields.end(), field) == known->fields.end())
                known->fields.push_back(field);
        }
    }
}

}  // namespace

PrefabGroup prefabGroup(const PrefabEdit& edit, const std::vector<ObjectId>& ids) {
    PrefabGroup group;
    group.compared = ids.size() <= PrefabGroup::kMost;
    for (const ObjectId id : ids) {
        const auto part = InstancePart::of(edit.document, edit.prefabs, id);
        if (!part) continue;
        ++group.parts;
        const std::string& path = part->prefab().path;
        if (std::find(group.prefabs.begin(), group.prefabs.end(), path) == group.prefabs.end())
            group.prefabs.push_back(path);
        if (!group.compared) continue;
        const PrefabOverrides overrides = overridesOf(edit.document, edit.prefabs, id);
        group.changed += overrides.count();
        join(group.overrides, overrides);
    }
    group.overrides.isPart = group.compared && group.parts == ids.size();
    if (group.changed > 0) group.whyNotApply = whyNotApply(edit, ids);
    return group;
}

std::string whyNotApply(const PrefabEdit& edit, const std::vector<ObjectId>& ids, const PrefabScope& scope) {
    return contradiction(variantsOf(edit, ids, scope));
}

Result<Done> applyAllToPrefabs(const PrefabEdit& edit, const std::vector<ObjectId>& ids,
                               const PrefabScope& scope) {
    const VariantsByPart all = variantsOf(edit, ids, scope);
    // For one entity, `applyToPrefab` reports the more precise error.
    if (ids.size() == 1 || all.empty()) return applyToPrefab(edit, ids.back(), scope);
    if (std::string why = contradiction(all); !why.empty())
        return Error{"apply to prefab", std::move(why), ""};
    if (all.size() == 1) return applyToPrefab(edit, all.begin()->second.front().id, scope);
    Transaction transaction{edit.undo, format("apply to {} prefabs", all.size())};
    for (const auto& [place, variants] : all) {
        if (const Result<Done> applied = applyToPrefab(edit, variants.front().id, scope); !applied)
            return applied;
    }
    transaction.commit();
    return Done{};
}

}  // namespace plumb::editor
