#include "editor/model/field_text.hpp"

#include "core/text.hpp"
#include "editor/model/edit_fields.hpp"
#include "editor/model/workspace.hpp"
#include "math/color.hpp"
#include "reflect/component_json.hpp"
#include "reflect/field_json.hpp"
#include "reflect/json.hpp"
#include "reflect/json_members.hpp"
#include "reflect/json_text.hpp"
#include "scene/files/world_field_context.hpp"

namespace plumb::editor {
namespace {

constexpr std::string_view kMark = "plumbComponent";

/// Reads a component from a clipboard text.
Result<ComponentState> componentFromText(Workspace& workspace, const TypeInfo& type, std::string_view text) {
    const Result<Json> json = parseJson(text, "clipboard");
    if (!json) return json.error();
    const Json* fields = findMember(*json, "fields");
    if (fields == nullptr)
        return Error{"clipboard", "the component has no \"fields\"", "copy the component again"};
    WorldFieldContext context{workspace.shownWorld()};
    ComponentState scratch = defaultComponent(type);
    std::vector<FieldProblem> problems;
    componentFromJson(type, scratch.bytes.data(), *fields, context, problems);
    if (!problems.empty()) return problems.front().error;
    return componentState(workspace.shownNames(), type, scratch.bytes.data());
}

}  // namespace

std::string valueText(Workspace& workspace, const TypeInfo& type, const FieldInfo& field,
                      const FieldValue& value) {
    ComponentState scratch = defaultComponent(type);
    writeField(workspace.shownNames(), field, scratch.bytes.data(), value);
    const WorldFieldContext context{workspace.shownWorld()};
    std::string text;
    appendJson(text, fieldToJson(field, scratch.bytes.data(), context), 0);
    return text;
}

Result<FieldValue> valueFromText(Workspace& workspace, const TypeInfo& type, const FieldInfo& field,
                                 std::string_view text) {
    const Result<Json> json = parseJson(text, "clipboard");
    if (!json) return json.error();
    ComponentState scratch = defaultComponent(type);
    WorldFieldContext context{workspace.shownWorld()};
    const Result<Done> read = fieldFromJson(field, scratch.bytes.data(), *json, context);
    if (!read) return read.error();
    return readField(workspace.shownNames(), field, scratch.bytes.data());
}

Result<FieldValue> colorFromText(std::string_view text) {
    std::string digits{trimmed(text)};
    if (startsWith(digits, "#")) digits.erase(0, 1);
    if (digits.size() == 3) {
        digits = {digits[0], digits[0], digits[1], digits[1], digits[2], digits[2]};
    }
    const bool whole = digits.size() == 6 || digits.size() == 8;
    const std::optional<std::uint64_t> bits = whole ? parseHex(digits) : std::nullopt;
    if (!bits)
        return Error{"color", format("\"{}\" is not a color", text),
                     "write it as #rgb, #rrggbb or #rrggbbaa"};
    const std::uint64_t all = digits.size() == 6 ? *bits << 8 | 0xff : *bits;
    const auto part = [all](int shift) { return static_cast<std::uint8_t>(all >> shift); };
    return FieldValue::of(Color{part(24), part(16), part(8), part(0)});
}

std::string colorText(const FieldValue& color) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string text = "#";
    const bool opaque = color.bytes[3] == std::byte{0xff};
    for (std::size_t i = 0; i < (opaque ? 3u : 4u); ++i) {
        const auto part = std::to_integer<std::size_t>(color.bytes[i]);
        text += kDigits[part >> 4];
        text += kDigits[part & 15];
    }
    return text;
}

std::string componentText(Workspace& workspace, const TypeInfo& type, ObjectId id) {
    const World& world = workspace.shownWorld();
    const WorldFieldContext context{workspace.shownWorld()};
    Json fields = Json::object();
    for (const FieldInfo& field : type.fields) {
        if (!field.transient)
            fields[std::string{field.name}] =
                fieldToJson(field, world.find(type, workspace.shownEntity(id)), context);
    }
    Json whole = Json::object();
    whole[std::string{kMark}] = std::string{type.name};
    whole["fields"] = std::move(fields);
    return writeJson(whole);
}

const TypeInfo* componentInText(const TypeRegistry& types, std::string_view text) {
    constexpr std::size_t kBeginning = 120;
    const std::string_view start = text.substr(0, kBeginning);
    const std::size_t mark = start.find(format("\"{}\"", kMark));
    if (mark == std::string_view::npos) return nullptr;
    const std::size_t from = start.find('"', mark + kMark.size() + 2);
    if (from == std::string_view::npos) return nullptr;
    const std::size_t to = start.find('"', from + 1);
    if (to == std::string_view::npos) return nullptr;
    return types.find(start.substr(from + 1, to - from - 1));
}

Result<Done> pasteComponent(Workspace& workspace, const std::vector<ObjectId>& ids, std::string_view text) {
    const TypeInfo* type = componentInText(workspace.document.types(), text);
    if (type == nullptr) return Error{"clipboard", "contains no component", "copy a component first"};
    const Result<ComponentState> state = componentFromText(workspace, *type, text);
    if (!state) return state.error();
    setComponent(workspace, ids, *state, format("paste {}", type->name));
    return Done{};
}

}  // namespace plumb::editor
