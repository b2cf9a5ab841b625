#include "script/script_api.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/text.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/type_registry.hpp"
#include "script/script_entity.hpp"
#include "script/script_functions.hpp"

namespace plumb {
namespace {

using script::ScriptFunction;

// Rows of what is no function of the engine, or is made by a function that has no row of its own.

/// A function that a script may define.
struct HandlerRow {
    const char* name;
    const char* parameters;  // without self
    const char* doc;
};
constexpr std::array kHandlers{
    HandlerRow{
        "onCreate", "",
        "Once, in the first tick of the script: when the game starts, or after its entity was spawned."},
    HandlerRow{"onTick", "dt: number",
               "In every tick, before the physics. `dt` is the length of a tick: 1/60 s. Not called while an "
               "earlier onTick of this script waits."},
    HandlerRow{"onCollisionEnter", "other: Entity, contact: Contact",
               "When a collider of the entity begins to touch one of `other`."},
    HandlerRow{"onCollisionStay", "other: Entity, contact: Contact",
               "In every further tick in which they touch, unless both bodies sleep."},
    HandlerRow{"onCollisionExit", "other: Entity", "When they no longer touch."},
    HandlerRow{"onTriggerEnter", "other: Entity",
               "When a trigger of the entity begins to overlap a collider of `other`, or a collider of the "
               "entity a trigger of `other`."},
    HandlerRow{"onTriggerStay", "other: Entity", "In every further tick in which they overlap."},
    HandlerRow{"onTriggerExit", "other: Entity", "When they no longer overlap."},
    HandlerRow{"onEvent_NAME", "...: any", "When the event NAME is emitted, with up to three values."},
    HandlerRow{
        "onDestroy", "",
        "After the entity was destroyed or has lost the script, in the same tick or the next one. The "
        "entity and its components are gone, `self` still has what was assigned to it. Not called when "
        "the scene ends, and cannot wait."},
    HandlerRow{"onReload", "", "After the file of the script was changed while the game runs."},
    HandlerRow{"onLoad", "",
               "After a saved game was loaded, in the first tick in which the entity is not paused."},
};

/// A function that declares a property.
struct PropertyRow {
    const char* name;
    const char* options;  // type of its parameter
    const char* value;    // type of the property
    const char* example;
    const char* doc;
};
constexpr std::array kProperties{
    PropertyRow{"number", "number|PropertyOptions", "number", "number { 40, min = 0, unit = \"px/s\" }",
                "A number of single precision, limited to its range."},
    PropertyRow{"integer", "integer|PropertyOptions", "integer", "integer { 3, min = 0, max = 10 }",
                "A whole number."},
    PropertyRow{"boolean", "boolean|PropertyOptions", "boolean", "boolean { true }", "true or false."},
    PropertyRow{"text", "string|PropertyOptions", "string", "text { \"Hello\" }", "A text."},
    PropertyRow{"vector", "vec|PropertyOptions", "vec", "vector { vec(0, 1) }", "A vector."},
    PropertyRow{"color", "string|PropertyOptions", "string", "color { \"#ff8000ff\" }",
                "A color, as the text \"#rrggbbaa\" or \"#rrggbb\"."},
    PropertyRow{"entity", "PropertyOptions", "Entity", "entity {}", "An entity of the scene, or nil."},
    PropertyRow{"choice", "string[]|PropertyOptions", "string", "choice { \"walk\", \"fly\" }",
                "One of these names; the first is the default."},
    PropertyRow{"texture", "string|PropertyOptions", "string", "texture {}", "The path of an image, or nil."},
    PropertyRow{"tileset", "string|PropertyOptions", "string", "tileset {}",
                "The path of a tileset, or nil."},
    PropertyRow{"animation", "string|PropertyOptions", "string", "animation {}",
                "The path of an animation, or nil."},
    PropertyRow{"sound", "string|PropertyOptions", "string", "sound { \"assets/jump.wav\" }",
                "The path of a sound, or nil."},
    PropertyRow{"font", "string|PropertyOptions", "string", "font {}", "The path of a font, or nil."},
    PropertyRow{"scene", "string|PropertyOptions", "string", "scene {}", "The path of a scene, or nil."},
    PropertyRow{"prefab", "string|PropertyOptions", "string", "prefab {}", "The path of a prefab, or nil."},
};

constexpr std::array kVectorFunctions{
    ScriptFunction{"length", "(): number", "Its length.", nullptr},
    ScriptFunction{"normalized", "(): vec", "The vector of length 1 in its direction; (0, 0) of (0, 0).",
                   nullptr},
    ScriptFunction{"dot", "(other: vec): number", "The dot product.", nullptr},
    ScriptFunction{"cross", "(other: vec): number", "The cross product, x1 * y2 - y1 * x2.", nullptr},
    ScriptFunction{"distance", "(other: vec): number", "The distance between two points.", nullptr},
    ScriptFunction{"rotated", "(angle: number): vec", "The vector rotated by an angle, rad, clockwise.",
                   nullptr},
    ScriptFunction{"lerp", "(other: vec, part: number): vec",
                   "The point between the two: this one at part 0, the other at 1.", nullptr},
};

constexpr std::array kOtherFunctions{
    ScriptFunction{"vec", "(x: number, y: number): vec",
                   "A vector. Vectors have x and y, +, -, *, / and ==; they cannot be changed.", nullptr},
    ScriptFunction{"math.pow", "(base: number, exponent: number): number",
                   "A power. The operator ^ accepts only the exponent 2.", nullptr},
};

constexpr std::string_view kDefinitionsHead = R"(---@meta
-- Definitions for the Lua language server, written by the editor of Plumb. Changes to this file are lost.

---@alias Unit "px"|"px/s"|"px/s2"|"s"|"deg"|"rad"|"rad/s"|"ratio"|"kg"|"tiles"|"ticks"

---Details of a property; its default value comes first, without a name.
---@class PropertyOptions
---@field doc? string Description in the inspector.
---@field min? number The smallest value.
---@field max? number The largest value.
---@field step? number Change per px of a drag in the inspector.
---@field unit? Unit
---@field shownIf? string Name of a boolean property: the inspector shows this one only while it is true.
---@field was? string Former name of the property, in files that were saved with it.

---A contact of two colliders.
---@class Contact
---@field normal vec Direction from this entity to the other one, of length 1.
---@field point vec (px)
---@field impulse number Along the normal, kg px/s.

---A component of an entity.
---@class Component

---A vector. It cannot be changed: assign a new one.
---@class vec
---@field x number
---@field y number
---@operator add(vec): vec
---@operator sub(vec): vec
---@operator mul(number): vec
---@operator div(number): vec
---@operator unm: vec
local Vector = {}

)";

// ---- signatures

struct Parameter {
    std::string name;
    std::string type;
};
struct Signature {
    std::vector<Parameter> parameters;  // without self
    std::vector<std::string> results;
};

/// Splits at the commas that are not in parentheses.
std::vector<std::string_view> partsOf(std::string_view list) {
    std::vector<std::string_view> parts;
    int depth = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        const char c = i < list.size() ? list[i] : ',';
        if (c == '(') ++depth;
        if (c == ')') --depth;
        if (c != ',' || depth > 0) continue;
        const std::string_view part = trimmed(list.substr(begin, i - begin));
        if (!part.empty()) parts.push_back(part);
        begin = i + 1;
    }
    return parts;
}

std::vector<Parameter> parametersOf(std::string_view list) {
    std::vector<Parameter> parameters;
    for (const std::string_view part : partsOf(list)) {
        const std::size_t colon = part.find(':');
        if (colon == std::string_view::npos) continue;  // self
        parameters.push_back(
            {std::string{trimmed(part.substr(0, colon))}, std::string{trimmed(part.substr(colon + 1))}});
    }
    return parameters;
}

/// Offset of the parenthesis that closes the first one.
std::size_t endOfParameters(std::string_view signature) {
    int depth = 0;
    for (std::size_t i = 0; i < signature.size(); ++i) {
        if (signature[i] == '(') ++depth;
        if (signature[i] == ')' && --depth == 0) return i;
    }
    return signature.size();
}

/// Reads "(name: string, ...: any): Entity?".
Signature parsedSignature(std::string_view signature) {
    const std::size_t end = endOfParameters(signature);
    Signature parsed;
    parsed.parameters = parametersOf(signature.substr(1, end - 1));
    const std::size_t colon = signature.find(':', end);
    if (colon == std::string_view::npos) return parsed;
    for (const std::string_view result : partsOf(signature.substr(colon + 1)))
        parsed.results.emplace_back(result);
    return parsed;
}

std::string joined(std::span<const std::string> parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

/// "name: string, count: integer?" or, without types, "name, count".
std::string parameterList(const Signature& signature, bool withTypes) {
    std::vector<std::string> parts;
    for (const auto& [name, type] : signature.parameters)
        parts.push_back(withTypes ? format("{}: {}", name, type) : name);
    return joined(parts);
}

// ---- definitions

/// Text for a comment of one line.
std::string inOneLine(std::string_view text) {
    std::string line{text};
    for (char& c : line) {
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    }
    return line;
}

std::string commentLine(std::string_view text) {
    return text.empty() ? std::string{} : "---" + inOneLine(text) + "\n";
}

/// "---@param seconds? number" of "seconds: number?".
std::string parameterLine(const Parameter& parameter) {
    const bool isOptional = endsWith(parameter.type, "?");
    const std::string_view type =
        std::string_view{parameter.type}.substr(0, parameter.type.size() - isOptional);
    return format("---@param {}{} {}\n", parameter.name, isOptional ? "?" : "", type);
}

/// @param prefix  what stands before the name: "Entity:"
std::string functionDefinition(std::string_view prefix, const ScriptFunction& function) {
    const Signature signature = parsedSignature(function.signature);
    std::string text = commentLine(function.doc);
    for (const Parameter& parameter : signature.parameters) text += parameterLine(parameter);
    for (const std::string& result : signature.results) text += format("---@return {}\n", result);
    return text + format("function {}{}({}) end\n\n", prefix, function.name, parameterList(signature, false));
}

std::string functionDefinitions(std::string_view prefix, std::span<const ScriptFunction> functions) {
    std::string text;
    for (const ScriptFunction& function : functions) text += functionDefinition(prefix, function);
    return text;
}

std::string propertyDefinitions() {
    std::string text;
    for (const PropertyRow& row : kProperties)
        text += format("---{}\n---@param options? {}\n---@return {}\nfunction {}(options) end\n\n", row.doc,
                       row.options, row.value, row.name);
    return text + R"(---A list of properties of one kind: list(number { 1 }, 8).
---@generic T
---@param item T
---@param most? integer Number of items that it can have, 1 to 64; 16 without it.
---@return T[]
function list(item, most) end

---Declares the component of a file, with its properties.
---@generic T
---@param properties T
---@return T|Script
function script(properties) end

)";
}

std::string_view nameOf(Unit unit) {
    switch (unit) {
        case Unit::None: break;
        case Unit::Pixels: return "px";
        case Unit::PixelsPerSecond: return "px/s";
        case Unit::PixelsPerSecondSquared: return "px/s2";
        case Unit::Seconds: return "s";
        case Unit::Radians: return "rad";
        case Unit::RadiansPerSecond: return "rad/s";
        case Unit::Ratio: return "ratio";
        case Unit::Kilograms: return "kg";
        case Unit::Tiles: return "tiles";
        case Unit::Ticks: return "ticks";
        case Unit::Degrees: return "deg";
    }
    return "";
}

std::string choiceType(const FieldInfo& field) {
    std::string type;
    for (const EnumName& name : field.names) type += format("{}\"{}\"", type.empty() ? "" : "|", name.name);
    return type.empty() ? "string" : type;
}

std::string typeOf(const FieldInfo& field, FieldKind kind) {
    switch (kind) {
        case FieldKind::Bool: return "boolean";
        case FieldKind::Int: return "integer";
        case FieldKind::Float: return "number";
        case FieldKind::Vec2: return "vec";
        case FieldKind::Rect: return "number[]";
        case FieldKind::Color:
        case FieldKind::Text: return "string";
        case FieldKind::Enum: return choiceType(field);
        case FieldKind::Entity: return "Entity?";
        case FieldKind::Asset: return "string?";
        case FieldKind::Tiles: return "nil";
        case FieldKind::List: break;
    }
    return isCurve(field) ? "any[]" : format("({})[]", typeOf(field, field.element));
}

std::string rangeOf(const FieldInfo& field) {
    using Limits = std::numeric_limits<float>;
    const bool hasMin = field.min > Limits::lowest();
    const bool hasMax = field.max < Limits::max();
    if (hasMin && hasMax) return format("{} to {}", shortestText(field.min), shortestText(field.max));
    if (hasMin) return format("at least {}", shortestText(field.min));
    return hasMax ? format("at most {}", shortestText(field.max)) : std::string{};
}

/// The form of a value that is a table or a text of a special form.
std::string_view formOf(const FieldInfo& field) {
    if (field.kind == FieldKind::Rect) return "{x, y, width, height}";
    if (field.kind == FieldKind::Color) return "\"#rrggbbaa\"";
    if (field.kind == FieldKind::Tiles) return "not available in scripts";
    return isCurve(field) ? "{\"smooth\", {0, 1}, {1, 0}}" : "";
}

/// The unit in scripts, where angles are in rad. Descriptions are those of the inspector, which shows
/// degrees.
std::string unitOf(const FieldInfo& field) {
    const bool isInDegrees = field.doc.find("degrees") != std::string_view::npos;
    const std::string unit{nameOf(field.unit)};
    return isInDegrees && startsWith(unit, "rad") ? format("in scripts {}, not degrees", unit) : unit;
}

/// The description of a field, with its unit, its range and its form in parentheses.
std::string docOf(const FieldInfo& field) {
    std::vector<std::string> details;
    for (std::string detail : {unitOf(field), rangeOf(field), std::string{formOf(field)}}) {
        if (!detail.empty()) details.push_back(std::move(detail));
    }
    if (details.empty()) return std::string{field.doc};
    return format("{}{}({})", field.doc, field.doc.empty() ? "" : " ", joined(details));
}

std::string fieldLine(std::string_view name, std::string_view type, std::string_view doc) {
    return inOneLine(format("---@field {} {}{}{}", name, type, doc.empty() ? "" : " ", doc)) + "\n";
}

bool isOfScript(const TypeInfo& type) {
    return isReloadable(type.key) && !type.fields.empty() && type.fields[0].name == "stopped";
}

std::string componentDefinition(const TypeInfo& type) {
    std::string text = commentLine(type.doc);
    text += format("---@class {} : {}\n", type.name, isOfScript(type) ? "Script" : "Component");
    for (const FieldInfo& field : type.fields) {
        text += fieldLine(field.name, typeOf(field, field.kind), docOf(field));
        if (field.kind != FieldKind::Vec2 || field.name != "position" || type.find("x") != nullptr) continue;
        text += fieldLine("x", "number", "The same as position.x, but can be assigned. (px)");
        text += fieldLine("y", "number", "The same as position.y, but can be assigned. (px)");
    }
    return text + "\n";
}

bool isEntityFunction(std::string_view name) {
    const std::span<const ScriptFunction> functions = script::entityFunctions();
    return std::any_of(functions.begin(), functions.end(),
                       [name](const ScriptFunction& function) { return function.name == name; });
}

/// "rigidBody" of RigidBody: the name of a component as a member of entities.
std::string memberName(std::string_view type) {
    std::string name{type};
    if (!name.empty() && name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
    return name;
}

std::string entityDefinition(const TypeRegistry& types) {
    std::string text = "---An entity. A component that it does not have is nil.\n---@class Entity\n";
    for (const TypeInfo& type : types.all()) {
        const std::string name = memberName(type.name);
        if (!isEntityFunction(name)) text += fieldLine(name, type.name, type.doc);
    }
    return text + "local Entity = {}\n\n" + functionDefinitions("Entity:", script::entityFunctions());
}

/// "fun(self: Script, other: Entity)".
std::string handlerType(const HandlerRow& handler) {
    const std::string_view parameters = handler.parameters;
    return format("fun(self: Script{}{})", parameters.empty() ? "" : ", ", parameters);
}

std::string handlerDefinitions() {
    std::string text = commentLine(
        "What script {...} returns, and `self` in its functions. All that its entity has is found in "
        "it too: self.transform, self:destroy().");
    text += "---@class Script : Entity\n";
    text += fieldLine("entity", "Entity", "The entity that has this script.");
    text += fieldLine("stopped", "boolean", "True after an error: the script does not run.");
    for (const HandlerRow& handler : kHandlers)
        text += fieldLine(format("{}?", handler.name), handlerType(handler), handler.doc);
    return text + "\n";
}

// ---- reference

/// Text for a cell of a table.
std::string inCell(std::string_view text) {
    std::string cell;
    for (const char c : text) cell += c == '|' ? std::string{"\\|"} : std::string(1, c);
    return cell;
}

std::string row(std::string_view left, std::string_view right) {
    return format("| `{}` | {} |\n", inCell(left), inCell(right));
}

std::string tableHead(std::string_view title, std::string_view left, std::string_view right) {
    return format("### {}\n\n| {} | {} |\n|---|---|\n", title, left, right);
}

std::string functionTable(std::string_view title, std::string_view prefix,
                          std::span<const ScriptFunction> functions) {
    std::string text = tableHead(title, "function", "what it does");
    for (const ScriptFunction& function : functions) {
        const Signature signature = parsedSignature(function.signature);
        const std::string results = joined(signature.results);
        text += row(format("{}{}({}){}{}", prefix, function.name, parameterList(signature, true),
                           results.empty() ? "" : ": ", results),
                    function.doc);
    }
    return text + "\n";
}

std::string handlerTable() {
    std::string text = tableHead("Handlers", "handler", "when it is called");
    for (const HandlerRow& handler : kHandlers)
        text += row(format("{}({})", handler.name, handler.parameters), handler.doc);
    return text + "\n";
}

std::string propertyTable() {
    std::string text = tableHead("Properties", "declaration", "value");
    for (const PropertyRow& property : kProperties) text += row(property.example, property.doc);
    return text +
           row("list(number { 1 }, 8)", "A list of at most 8 values of one kind; 1 to 64, 16 without it.") +
           "\n";
}

}  // namespace

std::string scriptDefinitions(const TypeRegistry& types) {
    std::string text{kDefinitionsHead};
    text += functionDefinitions("Vector:", kVectorFunctions);
    text += functionDefinitions("", kOtherFunctions);
    text += entityDefinition(types);
    for (const TypeInfo& type : types.all()) text += componentDefinition(type);
    text += handlerDefinitions();
    text += propertyDefinitions();
    text += functionDefinitions("", script::timeFunctions());
    text += functionDefinitions("", script::gameFunctions());
    text += "world = {}\n\n" + functionDefinitions("world:", script::worldFunctions());
    text += "input = {}\n\n" + functionDefinitions("input:", script::inputFunctions());
    return text;
}

std::string scriptReference() {
    return handlerTable() + propertyTable() +
           functionTable("Waiting, events and tweens", "", script::timeFunctions()) +
           functionTable("The game", "", script::gameFunctions()) +
           functionTable("Entities", "entity:", script::entityFunctions()) +
           functionTable("The world", "world:", script::worldFunctions()) +
           functionTable("Input", "input:", script::inputFunctions()) +
           functionTable("Numbers and vectors", "", kOtherFunctions) +
           functionTable("Functions of vectors", "v:", kVectorFunctions);
}

}  // namespace plumb
