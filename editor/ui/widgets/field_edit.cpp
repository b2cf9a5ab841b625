#include "editor/ui/widgets/field_edit.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "core/text.hpp"
#include "editor/model/tile_stamp.hpp"
#include "editor/ui/widgets/pickers.hpp"
#include "math/angle.hpp"

namespace plumb::editor::ui {
namespace {

/// What the editors of all kinds need.
struct Edit {
    Ui& ui;
    const std::string& path;
    const FieldInfo& field;
    FieldValue& value;  ///< edited in place
};

template <class T>
T load(const FieldValue& value, std::size_t at = 0) {
    T out;
    std::memcpy(&out, value.bytes.data() + at, sizeof(T));
    return out;
}
template <class T>
void store(FieldValue& value, const T& in, std::size_t at = 0) {
    std::memcpy(value.bytes.data() + at, &in, sizeof(T));
}

bool isAngle(Unit unit) { return unit == Unit::Radians || unit == Unit::RadiansPerSecond; }

float dragSpeed(const FieldInfo& field) {
    switch (field.unit) {
        case Unit::Ratio: return 0.01f;
        case Unit::Seconds: return 0.01f;
        case Unit::Radians:
        case Unit::RadiansPerSecond:
        case Unit::Pixels:
        case Unit::PixelsPerSecond: return 1.0f;
        case Unit::PixelsPerSecondSquared: return 5.0f;
        default: return 0.1f;
    }
}

bool editNumber(const Edit& edit, float& number, const std::string& path) {
    const FieldInfo& field = edit.field;
    const float factor = isAngle(field.unit) ? degreesFromRadians(1.0f) : 1.0f;
    float shown = number * factor;
    const bool limited = field.min > std::numeric_limits<float>::lowest();
    const float speed = dragSpeed(field);
    const char* format = shown == static_cast<float>(static_cast<int>(std::clamp(shown, -1e6f, 1e6f)))
                             ? "%.0f"
                         : speed < 0.1f ? "%.3f"
                                        : "%.2f";
    const bool changed = ImGui::DragFloat("##number", &shown, speed, limited ? field.min * factor : 0.0f,
                                          limited ? field.max * factor : 0.0f, format,
                                          limited ? ImGuiSliderFlags_AlwaysClamp : 0);
    edit.ui.widgets.mark(path, shortestText(number));
    if (ImGui::IsItemDeactivated()) edit.ui.workspace.undo.endGesture();
    if (changed) number = factor == 1.0f ? shown : radiansFromDegrees(shown);
    return changed;
}

/// Several numbers side by side, each with its letter.
bool editNumbers(const Edit& edit, const char* letters) {
    const auto count = static_cast<int>(std::strlen(letters));
    const float spacing = edit.ui.px(4.0f);
    const float letterWidth = edit.ui.px(13.0f);
    const int perRow = std::min(count, 2);
    const float width = (ImGui::GetContentRegionAvail().x - spacing * static_cast<float>(perRow - 1)) /
                            static_cast<float>(perRow) -
                        letterWidth;
    const float start = ImGui::GetCursorPosX();
    bool changed = false;
    for (int i = 0; i < count; ++i) {
        if (i % perRow != 0) ImGui::SameLine(0.0f, spacing);
        if (i > 0 && i % perRow == 0) ImGui::SetCursorPosX(start);
        ImGui::PushID(i);
        ImGui::AlignTextToFramePadding();
        const char letter[2] = {letters[i], '\0'};
        const float letterStart = ImGui::GetCursorPosX();
        ImGui::TextDisabled("%s", letter);
        ImGui::SameLine(0.0f, 0.0f);
        ImGui::SetCursorPosX(letterStart + letterWidth);
        ImGui::SetNextItemWidth(width);
        const std::size_t at = static_cast<std::size_t>(i) * sizeof(float);
        auto number = load<float>(edit.value, at);
        if (editNumber(edit, number,
                       edit.path + "." +
                           (letters[i] == 'w'   ? std::string{"width"}
                            : letters[i] == 'h' ? std::string{"height"}
                                                : std::string{letter}))) {
            store(edit.value, number, at);
            changed = true;
        }
        ImGui::PopID();
    }
    return changed;
}

ImGuiDataType intType(const FieldInfo& field) {
    switch (field.size) {
        case 1: return field.isSigned ? ImGuiDataType_S8 : ImGuiDataType_U8;
        case 2: return field.isSigned ? ImGuiDataType_S16 : ImGuiDataType_U16;
        case 4: return field.isSigned ? ImGuiDataType_S32 : ImGuiDataType_U32;
        default: return field.isSigned ? ImGuiDataType_S64 : ImGuiDataType_U64;
    }
}

bool editInt(const Edit& edit) {
    const FieldInfo& field = edit.field;
    ImGui::SetNextItemWidth(-1.0f);
    void* number = edit.value.bytes.data();
    bool changed = false;
    if (!field.isSigned && field.size >= 4) {  // bits
        changed =
            ImGui::InputScalar("##bits", intType(field), number, nullptr, nullptr,
                               field.size == 4 ? "%08X" : "%016llX", ImGuiInputTextFlags_CharsHexadecimal);
    } else if (field.size == 4 && field.min > std::numeric_limits<float>::lowest()) {
        auto value = load<int>(edit.value);
        changed = ImGui::DragInt("##int", &value, 0.2f, static_cast<int>(field.min),
                                 static_cast<int>(field.max), "%d", ImGuiSliderFlags_AlwaysClamp);
        if (changed) store(edit.value, value);
    } else {
        changed = ImGui::DragScalar("##int", intType(field), number, 0.2f);
    }
    edit.ui.widgets.mark(edit.path);
    return changed;
}

bool editBool(const Edit& edit) {
    bool on = load<bool>(edit.value);
    const bool changed = ImGui::Checkbox("##on", &on);
    edit.ui.widgets.mark(edit.path, on ? "true" : "false");
    if (changed) store(edit.value, on);
    return changed;
}

bool editColor(const Edit& edit) {
    const auto color = load<Color>(edit.value);
    std::array<float, 4> parts{static_cast<float>(color.r) / 255.0f, static_cast<float>(color.g) / 255.0f,
                               static_cast<float>(color.b) / 255.0f, static_cast<float>(color.a) / 255.0f};
    ImGui::SetNextItemWidth(-1.0f);
    const bool changed = ImGui::ColorEdit4(
        "##color", parts.data(), ImGuiColorEditFlags_DisplayHex | ImGuiColorEditFlags_AlphaPreviewHalf);
    edit.ui.widgets.mark(edit.path);
    if (!changed) return false;
    const auto byteOf = [](float part) {
        return static_cast<std::uint8_t>(std::clamp(part, 0.0f, 1.0f) * 255.0f + 0.5f);
    };
    store(edit.value, Color{byteOf(parts[0]), byteOf(parts[1]), byteOf(parts[2]), byteOf(parts[3])});
    return true;
}

bool editText(const Edit& edit) {
    World& world = edit.ui.workspace.shownWorld();
    const std::string_view text = world.texts().find(load<TextId>(edit.value));
    std::array<char, 2048> buffer{};
    const std::size_t length = std::min(text.size(), buffer.size() - 1);
    std::copy_n(text.begin(), length, buffer.begin());
    ImGui::SetNextItemWidth(-1.0f);
    if (text.find('\n') == std::string_view::npos) {
        ImGui::InputText("##text", buffer.data(), buffer.size());
    } else {
        ImGui::InputTextMultiline("##text", buffer.data(), buffer.size(), {-1.0f, edit.ui.px(66.0f)});
    }
    edit.ui.widgets.mark(edit.path, text);
    // The text counts when it is left, so that half-typed words are no steps of undo.
    if (!ImGui::IsItemDeactivatedAfterEdit() || text == buffer.data()) return false;
    store(edit.value, world.texts().add(buffer.data()));
    return true;
}

bool editEnum(const Edit& edit) {
    const int value = edit.field.size == 1 ? load<std::uint8_t>(edit.value) : load<int>(edit.value);
    const auto& names = edit.field.names;
    const auto now =
        std::find_if(names.begin(), names.end(), [&](const EnumName& name) { return name.value == value; });
    const std::string shown = now == names.end() ? format("{}", value) : std::string{now->name};
    bool changed = false;
    ImGui::SetNextItemWidth(-1.0f);
    const bool open = ImGui::BeginCombo("##enum", shown.c_str());
    edit.ui.widgets.mark(edit.path, shown);
    if (!open) return false;
    for (const EnumName& name : names) {
        if (ImGui::Selectable(std::string{name.name}.c_str(), name.value == value)) {
            if (edit.field.size == 1) {
                store(edit.value, static_cast<std::uint8_t>(name.value));
            } else {
                store(edit.value, name.value);
            }
            changed = true;
        }
        edit.ui.widgets.mark(edit.path + "/" + std::string{name.name});
    }
    ImGui::EndCombo();
    return changed;
}

bool editList(const Edit& edit) {
    const FieldInfo& field = edit.field;
    const std::uint32_t count = *field.listCount(edit.value.bytes.data());
    if (field.element != FieldKind::Float) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextDisabled("%u of %u entries", count, static_cast<unsigned>(field.capacity));
        return false;
    }
    bool changed = false;
    for (std::uint32_t i = 0; i < count; ++i) {
        ImGui::PushID(static_cast<int>(i));
        ImGui::SetNextItemWidth(-1.0f);
        auto number = load<float>(edit.value, i * sizeof(float));
        if (editNumber(edit, number, format("{}.{}", edit.path, i))) {
            store(edit.value, number, i * sizeof(float));
            changed = true;
        }
        ImGui::PopID();
    }
    if (count == 0) ImGui::TextDisabled("empty");
    return changed;
}

constexpr int kMostCells = 4096;  // along one side, so that a slip of the finger costs no gigabyte

/// One side of a grid; counts when Enter is pressed.
bool editSide(const Edit& edit, const char* letter, int& cells, float width, const std::string& path) {
    ImGui::PushID(letter);
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", letter);
    ImGui::SameLine(0.0f, edit.ui.px(5.0f));
    ImGui::SetNextItemWidth(width - edit.ui.px(14.0f));
    int typed = cells;
    const bool done = ImGui::InputInt("##side", &typed, 0, 0, ImGuiInputTextFlags_EnterReturnsTrue);
    edit.ui.widgets.mark(path, format("{}", cells));
    tooltip("Cells. Enter makes the layer larger or cuts it off, at its right and lower edges.");
    ImGui::PopID();
    if (!done || typed == cells) return false;
    cells = std::clamp(typed, 1, kMostCells);
    return true;
}

/// The size of a grid of tiles; the tiles themselves are painted in the scene.
bool editTiles(const Edit& edit) {
    World& world = edit.ui.workspace.shownWorld();
    const TileGrid* grid = world.tiles().find(load<TilesId>(edit.value));
    int width = grid == nullptr ? 0 : grid->width();
    int height = grid == nullptr ? 0 : grid->height();
    const float half = (ImGui::GetContentRegionAvail().x - edit.ui.px(4.0f)) * 0.5f;
    bool changed = editSide(edit, "w", width, half, edit.path + ".width");
    ImGui::SameLine(0.0f, edit.ui.px(4.0f));
    changed |= editSide(edit, "h", height, half, edit.path + ".height");
    if (!changed || !edit.ui.workspace.canEdit()) return false;
    // The old grid stays in the store: undo only names it again.
    store(edit.value, world.tiles().add(resized(grid == nullptr ? TileGrid{} : *grid, std::max(width, 1),
                                                std::max(height, 1))));
    return true;
}

}  // namespace

const char* shownUnit(Unit unit) {
    switch (unit) {
        case Unit::None:
        case Unit::Ratio: return "";
        case Unit::Pixels: return "px";
        case Unit::PixelsPerSecond: return "px/s";
        case Unit::PixelsPerSecondSquared: return "px/s\xc2\xb2";
        case Unit::Seconds: return "s";
        case Unit::Radians: return "deg";
        case Unit::RadiansPerSecond: return "deg/s";
        case Unit::Kilograms: return "kg";
        case Unit::Tiles: return "tiles";
        case Unit::Ticks: return "ticks";
    }
    return "";
}

std::optional<FieldValue> editField(Ui& ui, const std::string& path, const FieldInfo& field,
                                    const void* component) {
    FieldValue value = readField(ui.workspace.shownNames(), field, component);
    const Edit edit{ui, path, field, value};
    bool changed = false;
    switch (field.kind) {
        case FieldKind::Bool: changed = editBool(edit); break;
        case FieldKind::Int: changed = editInt(edit); break;
        case FieldKind::Float: {
            auto number = load<float>(value);
            ImGui::SetNextItemWidth(-1.0f);
            changed = editNumber(edit, number, path);
            if (changed) store(value, number);
            break;
        }
        case FieldKind::Vec2: changed = editNumbers(edit, "xy"); break;
        case FieldKind::Rect: changed = editNumbers(edit, "xywh"); break;
        case FieldKind::Color: changed = editColor(edit); break;
        case FieldKind::Text: changed = editText(edit); break;
        case FieldKind::Enum: changed = editEnum(edit); break;
        case FieldKind::Entity: {
            auto id = load<ObjectId>(value);
            changed = pickEntity(ui, path, id);
            if (changed) store(value, id);
            break;
        }
        case FieldKind::Asset: {
            auto id = load<TextId>(value);
            changed = pickAsset(ui, path, field.asset, id);
            if (changed) store(value, id);
            break;
        }
        case FieldKind::Tiles: changed = editTiles(edit); break;
        case FieldKind::List: changed = editList(edit); break;
    }
    if (ImGui::IsItemDeactivated() && field.kind != FieldKind::Text && !changed)
        ui.workspace.undo.endGesture();
    if (!changed) return std::nullopt;
    return value;
}

FieldValue withChangedParts(const FieldInfo& field, FieldValue into, const FieldValue& from,
                            const FieldValue& to) {
    const std::size_t part = field.kind == FieldKind::Color                                   ? 1
                             : field.kind == FieldKind::Vec2 || field.kind == FieldKind::Rect ? sizeof(float)
                                                                                              : field.size;
    for (std::size_t at = 0; at + part <= field.size; at += part) {
        if (std::memcmp(&from.bytes[at], &to.bytes[at], part) != 0)
            std::memcpy(&into.bytes[at], &to.bytes[at], part);
    }
    return into;
}

}  // namespace plumb::editor::ui
