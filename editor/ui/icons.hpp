#pragma once

#include <string_view>

#include <imgui.h>

#include "ecs/world.hpp"

namespace plumb::editor::ui {

enum class Icon : unsigned char {
    Select,
    Move,
    Rotate,
    Scale,
    Shape,
    Rectangle,
    Pick,
    Brush,
    Erase,
    Fill,
    Play,
    Stop,
    Pause,
    Step,
    StepBack,
    Watch,
    Undo,
    Redo,
    Save,
    Snap,
    Entity,
    Picture,
    Tiles,
    Text,
    Camera,
    Body,
    Soft,
    Field,
    Layers,
    Person,
    Star,
    Chevron,
    Terrain,
    Line,
    Ellipse,
    MoveTiles,
    SameTile,
    Eye,
    EyeClosed,
    Lock,
    Unlocked,
    Solo
};

/// Draws an icon of lines and shapes: sharp at any scale, no image files. @param size  px of its square
void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color);

/// What an entity mainly is.
Icon iconOf(const World& world, EntityId entity);
ImU32 iconColor(Icon icon);

/// The icon of a tool or an action, by its id.
Icon iconOfAction(std::string_view action);

}  // namespace plumb::editor::ui
