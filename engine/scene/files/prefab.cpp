#include "scene/files/prefab.hpp"

#include <algorithm>
#include <utility>

#include "core/guarded.hpp"
#include "core/hash.hpp"
#include "core/limits.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "reflect/type_registry.hpp"
#include "scene/files/missing_file.hpp"
#include "scene/files/prefab_check.hpp"

namespace plumb {
namespace {

constexpr std::string_view kEnding = ".prefab.json";
constexpr std::string_view kRemedyForPrefab =
    "write {\"format\": 1, \"entities\": [...]} with the root as the first entity";

std::string_view textIn(const Json& object, std::string_view key) {
    const std::string* text = findText(object, key);
    return text == nullptr ? std::string_view{} : std::string_view{*text};
}

/// Applies the overrides of an instance to an entity of its prefab.
void mergeEntity(PrefabEntity& base, const Json& overrides) {
    if (const auto name = textIn(overrides, "name"); !name.empty()) base.name = name;
    if (const Json* without = findArray(overrides, "without")) {
        for (const Json& type : *without) {
            if (const std::string* name = jsonText(type)) base.components.erase(*name);
        }
    }
    const Json* components = findObject(overrides, "components");
    if (components == nullptr) return;
    for (const auto& [type, fields] : components->items()) {
        Json& merged = makeObject(base.components, type);
        if (!fields.is_object()) continue;
        for (const auto& [key, value] : fields.items()) merged[key] = value;
    }
}

/// Reads one prefab file into the flat list of its entities.
class PrefabReader {
public:
    PrefabReader(const TypeRegistry& types, Prefab& prefab) : types_{types}, prefab_{prefab} {}

    void addEntity(const Json& entity, const std::string& where, const Prefab* nested) {
        const bool isRoot = prefab_.entities.empty();
        const std::uint64_t id = hexIdIn(entity, "id");
        if (isRoot) rootId_ = id == 0 ? Prefab::kRootPart : id;
        if (id == 0 && !isRoot)
            return skip(where + ".id", "the id is missing or invalid", "write 16 hex digits in quotes");
        const std::uint64_t part = isRoot ? Prefab::kRootPart : id;
        if (prefab_.find(part) != nullptr)
            return skip(where + ".id", "another entity has this id", "write a new id");
        std::uint64_t parent = 0;
        if (!isRoot) {
            const std::uint64_t said = hexIdIn(entity, "parent");
            parent = partOf(said == 0 ? rootId_ : said);
            if (prefab_.find(parent) == nullptr) {
                return skip(where + ".parent", "no earlier entity of the prefab has this id",
                            "move the parent before this entity");
            }
        }
        if (nested == nullptr) {
            PrefabEntity made{part, parent, std::string{textIn(entity, "name")}};
            mergeEntity(made, localized(entity));
            prefab_.entities.push_back(std::move(made));
        } else {
            addNested(*nested, part, parent, entity, where);
        }
    }

    [[nodiscard]] std::uint64_t rootId() const { return rootId_; }

    void skip(std::string where, std::string what, std::string remedy) {
        prefab_.problems.push_back(
            {std::move(where), std::move(what), std::move(remedy) + "; the entity was skipped"});
    }

private:
    /// In files the root may have any id; its part id is always kRootPart.
    [[nodiscard]] std::uint64_t partOf(std::uint64_t id) const {
        return id == rootId_ ? Prefab::kRootPart : id;
    }

    [[nodiscard]] Json localized(Json entity) const {
        if (const auto components = entity.find("components"); components != entity.end()) {
            changeReferences(types_, *components, [this](std::uint64_t id) { return partOf(id); });
        }
        return entity;
    }

    void addNested(const Prefab& nested, std::uint64_t part, std::uint64_t parent, const Json& entity,
                   const std::string& where) {
        const Json* children = findMember(entity, "children");
        if (children != nullptr && !children->is_object())
            ignore(where + ".children", "an object", *children,
                   "write {\"<part>\": {\"components\": {...}}}");
        for (const PrefabEntity& inner : nested.entities) {
            PrefabEntity made = inner;
            made.part = combinedId(part, inner.part);
            made.parent = inner.part == Prefab::kRootPart ? parent : combinedId(part, inner.parent);
            changeReferences(types_, made.components,
                             [part](std::uint64_t id) { return combinedId(part, id); });
            if (inner.part == Prefab::kRootPart) {
                mergeEntity(made, localized(entity));
            } else if (children != nullptr) {
                const std::string key = hexText(inner.part);
                const Json* overrides = findMember(*children, key);
                if (overrides != nullptr && !override(made, *overrides, format("{}.children.{}", where, key)))
                    continue;
            }
            if (made.parent == 0 || prefab_.find(made.parent) != nullptr)
                prefab_.entities.push_back(std::move(made));
        }
    }

    /// @return false if the part is removed
    bool override(PrefabEntity& part, const Json& overrides, const std::string& where) {
        const Json* removed = findMember(overrides, "removed");
        if (!overrides.is_object()) {
            ignore(where, "an object", overrides, "write {\"components\": {...}}");
        } else if (removed != nullptr && !removed->is_boolean()) {
            ignore(where + ".removed", "true or false", *removed, "write true to remove the part");
        } else if (removed != nullptr && *removed == true) {
            return false;
        }
        mergeEntity(part, localized(overrides));
        return true;
    }

    void ignore(std::string where, std::string_view expected, const Json& found, std::string remedy) {
        prefab_.problems.push_back({std::move(where),
                                    format("expected {}, found {}", expected, foundText(found)),
                                    std::move(remedy) + "; it is ignored"});
    }

    const TypeRegistry& types_;
    Prefab& prefab_;
    std::uint64_t rootId_ = Prefab::kRootPart;
};

void changeReference(Json& value, const std::function<std::uint64_t(std::uint64_t)>& change) {
    if (const std::uint64_t id = hexIdOf(value)) value = hexText(change(id));
}

}  // namespace

const PrefabEntity* Prefab::find(std::uint64_t part) const {
    const auto found = std::find_if(entities.begin(), entities.end(),
                                    [part](const PrefabEntity& e) { return e.part == part; });
    return found == entities.end() ? nullptr : &*found;
}

std::uint64_t combinedId(std::uint64_t outer, std::uint64_t part) {
    if (part == Prefab::kRootPart) return outer;
    if (outer == Prefab::kRootPart) return part;
    const std::uint64_t mixed = mixBits(outer ^ (mixBits(part) + 0x9e3779b97f4a7c15ull));
    return mixed > Prefab::kRootPart ? mixed : mixed + 2;
}

void changeReferences(const TypeRegistry& types, Json& components,
                      const std::function<std::uint64_t(std::uint64_t)>& change) {
    if (!components.is_object()) return;
    for (auto& [name, fields] : *components.get_ptr<Json::object_t*>()) {
        const TypeInfo* type = types.find(name);
        if (type == nullptr || !fields.is_object()) continue;
        for (const FieldInfo& field : type->fields) {
            const auto value = fields.find(std::string{field.name});
            if (value == fields.end()) continue;
            if (field.kind == FieldKind::Entity) {
                changeReference(*value, change);
            } else if (field.kind == FieldKind::List && field.element == FieldKind::Entity &&
                       value->is_array()) {
                for (Json& item : *value) changeReference(item, change);
            }
        }
    }
}

namespace {

void addAsset(std::vector<PrefabAsset>& assets, AssetKind kind, const Json& path) {
    const auto* text = path.get_ptr<const std::string*>();
    if (text == nullptr || text->empty()) return;
    PrefabAsset asset{kind, *text};
    if (std::find(assets.begin(), assets.end(), asset) == assets.end()) assets.push_back(std::move(asset));
}

/// Returns the assets that the fields of the components name, and the files of nested prefabs.
std::vector<PrefabAsset> assetsOf(const TypeRegistry& types, const Prefab& prefab,
                                  const std::vector<const Prefab*>& nested) {
    std::vector<PrefabAsset> assets;
    for (const Prefab* inner : nested) {
        if (inner == nullptr) continue;
        addAsset(assets, AssetKind::Prefab, inner->path);
        for (const PrefabAsset& asset : inner->assets) {
            if (asset.kind == AssetKind::Prefab) addAsset(assets, asset.kind, asset.path);
        }
    }
    for (const PrefabEntity& entity : prefab.entities) {
        for (const auto& [name, fields] : *entity.components.get_ptr<const Json::object_t*>()) {
            const TypeInfo* type = types.find(name);
            if (type == nullptr || !fields.is_object()) continue;
            for (const auto& [key, value] : *fields.get_ptr<const Json::object_t*>()) {
                const FieldInfo* field = type->find(key);
                if (field == nullptr || field->asset == AssetKind::None) continue;
                if (!value.is_array()) addAsset(assets, field->asset, value);
                for (std::size_t i = 0; value.is_array() && i < value.size(); ++i)
                    addAsset(assets, field->asset, value[i]);
            }
        }
    }
    return assets;
}

Error tooDeep(std::string where) {
    return {std::move(where), format("prefabs are nested more than {} levels deep", limits::kPrefabDepth),
            "reduce the nesting"};
}

/// Adds the place of the instance to the error of its prefab, unless the error names a place in a file.
Error nestedError(const std::string& where, std::string_view path, Error error) {
    if (error.where != path) return error;
    return {where + ".prefab", error.where + ": " + error.what, std::move(error.remedy)};
}

}  // namespace

void PrefabLibrary::add(std::string_view path, std::string text) {
    forget();
    for (Source& source : replacedTexts_) {
        if (source.path == path) return static_cast<void>(source.text = std::move(text));
    }
    replacedTexts_.push_back({std::string{path}, std::move(text)});
}

void PrefabLibrary::forget() {
    prefabs_.clear();
    names_.clear();
    missing_.clear();
    problems_.clear();
    reported_.clear();
}

void PrefabLibrary::readAgain(const std::vector<std::string>& changed) {
    PrefabLibrary fresh{types_, root_};
    fresh.replacedTexts_ = replacedTexts_;
    bool complete = true;
    for (const std::string& path : changed) {
        const Result<const Prefab*> found = fresh.find(path);
        if (!found) logError("Scene", found.error());
        complete = complete && found.ok();
    }
    for (const Prefab& prefab : prefabs_) {
        complete = complete && (!has(prefab.path) || fresh.find(prefab.path).ok());
    }
    if (!complete) return;
    forget();
    for (const std::string& path : changed) static_cast<void>(named(path));  // logs what is wrong
}

Result<const Prefab*> PrefabLibrary::find(std::string_view path) {
    std::vector<std::string> open;
    return guarded(path, [&] { return find(path, open); });
}

const Prefab* PrefabLibrary::named(std::string_view name) {
    for (const Name& known : names_) {
        if (known.name == name) return known.prefab;
    }
    const Result<const Prefab*> found = find(pathOf(name));
    for (const Error& problem : takeProblems()) logWarning("Scene", problem);
    if (!found) {
        if (isNew(found.error())) logError("Scene", found.error());
        return nullptr;
    }
    names_.push_back({std::string{name}, *found});
    return *found;
}

std::string PrefabLibrary::pathOf(std::string_view name) const {
    const std::string file = std::string{name}.append(endsWith(name, ".json") ? "" : kEnding);
    if (file.find('/') != std::string::npos || has(file)) return file;
    const std::string inAssets = "assets/" + file;
    const std::string inPrefabs = "prefabs/" + file;
    return !has(inPrefabs) && has(inAssets) ? inAssets : inPrefabs;
}

std::vector<const Prefab*> PrefabLibrary::readAll(std::vector<std::string> paths) {
    std::vector<const Prefab*> prefabs;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const std::string path = pathOf(paths[i]);
        if (!has(path)) continue;
        const Result<const Prefab*> found = find(path);
        if (!found) {
            if (isNew(found.error())) problems_.push_back(found.error());
            continue;
        }
        if (std::find(prefabs.begin(), prefabs.end(), *found) != prefabs.end()) continue;
        prefabs.push_back(*found);
        for (const PrefabAsset& asset : (*found)->assets) {
            if (asset.kind == AssetKind::Prefab) paths.push_back(asset.path);
        }
    }
    return prefabs;
}

/// True at the first call for the error of a prefab that cannot be read.
bool PrefabLibrary::isNew(const Error& failure) {
    std::string text = failure.text();
    if (std::find(reported_.begin(), reported_.end(), text) != reported_.end()) return false;
    reported_.push_back(std::move(text));
    return true;
}

bool PrefabLibrary::has(std::string_view path) const {
    const bool isReplaced = std::any_of(replacedTexts_.begin(), replacedTexts_.end(),
                                        [path](const Source& source) { return source.path == path; });
    if (isReplaced || root_.empty()) return isReplaced;
    const Result<Path> file = pathInside(root_, path);
    return file && fileExists(*file);
}

/// The error of a file that does not exist. Kept, because looking for a file of a similar name is slow.
Error PrefabLibrary::missing(std::string_view path) {
    for (const Error& known : missing_) {
        if (known.where == path) return known;
    }
    return missing_.emplace_back(missingFile(root_, path, kEnding));
}

Result<std::string> PrefabLibrary::textOf(std::string_view path) {
    for (const Source& source : replacedTexts_) {
        if (source.path == path) return source.text;
    }
    if (root_.empty()) return Error{std::string{path}, "there is no such prefab", "add its text with add()"};
    const Result<Path> file = pathInside(root_, path);
    if (!file) return file.error();
    if (!fileExists(*file)) return missing(path);
    Result<std::string> text = readFile(*file);
    if (!text) return Error{std::string{path}, text.error().what, text.error().remedy};
    return text;
}

Result<const Prefab*> PrefabLibrary::find(std::string_view path, std::vector<std::string>& open) {
    for (const Prefab& prefab : prefabs_) {
        if (prefab.path == path) return &prefab;
    }
    Result<Prefab> read = this->read(path, open);
    if (!read) return read.error();
    problems_.insert(problems_.end(), read->problems.begin(), read->problems.end());
    problems_.insert(problems_.end(), read->warnings.begin(), read->warnings.end());
    return &prefabs_.emplace_back(std::move(*read));
}

Result<Prefab> PrefabLibrary::read(std::string_view path, std::vector<std::string>& open) {
    const std::string name{path};
    if (std::find(open.begin(), open.end(), name) != open.end()) {
        return Error{name, "the prefab contains itself, through " + open.back(),
                     "remove it from one of the two"};
    }
    if (open.size() >= static_cast<std::size_t>(limits::kPrefabDepth)) return tooDeep(name);
    Result<std::string> text = textOf(path);
    if (!text) return text.error();
    Result<Json> json = parseJson(*text, path);
    if (!json) return json.error();
    const Json* entities = findArray(*json, "entities");
    if (entities == nullptr || entities->empty()) {
        return Error{name, "expected a prefab with at least one entity", std::string{kRemedyForPrefab}};
    }
    if (const Json* number = findMember(*json, "format"); number != nullptr && *number != Prefab::kFormat) {
        return Error{name + ": format", format("expected {}, found {}", Prefab::kFormat, foundText(*number)),
                     "open it with the version of the engine that wrote it"};
    }

    Prefab prefab;
    prefab.path = name;
    PrefabReader reader{types_, prefab};
    std::vector<const Prefab*> nested(entities->size());
    open.push_back(name);
    for (std::size_t i = 0; i < entities->size(); ++i) {
        const Json& entity = (*entities)[i];
        const std::string where = format("{}: entities[{}]", name, i);
        if (!entity.is_object()) {
            reader.skip(where, "expected an object, found " + foundText(entity), "write {\"id\": ...}");
            continue;
        }
        if (const std::string_view inner = textIn(entity, "prefab"); !inner.empty()) {
            const Result<const Prefab*> found = find(inner, open);
            if (!found) return nestedError(where, inner, found.error());
            nested[i] = *found;
            prefab.depth = std::max(prefab.depth, (*found)->depth + 1);
        }
        reader.addEntity(entity, where, nested[i]);
    }
    open.pop_back();
    if (prefab.depth > limits::kPrefabDepth) return tooDeep(name);
    if (prefab.entities.empty())
        return Error{name, "no entity of the prefab could be read", std::string{kRemedyForPrefab}};
    prefab.assets = assetsOf(types_, prefab, nested);
    prefab.warnings = checkPrefab(types_, prefab, *json, nested, reader.rootId());
    return prefab;
}

}  // namespace plumb
