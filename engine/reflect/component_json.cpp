#include "reflect/component_json.hpp"

#include <string_view>

#include "core/text.hpp"
#include "reflect/compare.hpp"
#include "reflect/field_context.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"

namespace plumb {
namespace {

const FieldInfo* findByKey(const TypeInfo& type, std::string_view key) {
    if (const FieldInfo* field = type.find(key)) return field->transient ? nullptr : field;
    for (const FieldInfo& field : type.fields) {
        if (!field.was.empty() && field.was == key && !field.transient) return &field;
    }
    return nullptr;
}

Error unknownField(const TypeInfo& type, std::string_view key) {
    std::vector<std::string_view> names;
    std::string list;
    for (const FieldInfo& field : type.fields) {
        if (field.transient) continue;
        names.push_back(field.name);
        list += (list.empty() ? "" : ", ") + std::string{field.name};
    }
    const std::string_view near = closestName(key, names);
    std::string remedy = "it is kept unchanged; ";
    remedy += !near.empty()  ? format("did you mean \"{}\"?", near)
              : list.empty() ? "this component has no fields"
                             : "the fields are: " + list;
    return {format("{}.{}", type.name, key), format("{} has no such field", type.name), std::move(remedy)};
}

bool sameValue(const FieldInfo& field, const void* a, const void* b, const FieldContext& context) {
    if (fieldsEqual(field, a, b)) return true;
    if (field.kind != FieldKind::Tiles) return false;
    return context.sameTiles(*static_cast<const TilesId*>(field.in(a)),
                             *static_cast<const TilesId*>(field.in(b)));
}

}  // namespace

Json componentToJson(const TypeInfo& type, const void* object, const void* defaults,
                     const FieldContext& context) {
    Json json = Json::object();
    auto& properties = *json.get_ptr<Json::object_t*>();
    for (const FieldInfo& field : type.fields) {
        if (field.transient || sameValue(field, object, defaults, context)) continue;
        properties.emplace_back(std::string{field.name}, fieldToJson(field, object, context));
    }
    return json;
}

void componentFromJson(const TypeInfo& type, void* object, const Json& json, FieldContext& context,
                       std::vector<FieldProblem>& problems) {
    if (!json.is_object()) {
        problems.push_back({"",
                            {std::string{type.name}, "expected an object, found " + foundText(json),
                             "write {} for the defaults"}});
        return;
    }
    for (const auto& [key, value] : *json.get_ptr<const Json::object_t*>()) {
        const FieldInfo* field = findByKey(type, key);
        if (field == nullptr) {
            problems.push_back({key, unknownField(type, key)});
            continue;
        }
        if (auto read = fieldFromJson(*field, object, value, context); !read) {
            Error error = read.error();
            error.where = format("{}.{}", type.name, error.where);
            problems.push_back({key, std::move(error)});
        }
    }
}

}  // namespace plumb
