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
    Pick,  ///< eyedropper
    Brush,
    Erase,
    Fill,
    Play,
    Stop,
    Pause,
    Step,
    StepBack,
    Watch,  ///< two triangles: fast forward
    Undo,
    Redo,
    Save,
    Snap,
    Entity,
    Picture,
    Tiles,
    Text,
    Camera,
    Body,   ///< rigid body
    Soft,   ///< soft body
    Field,  ///< force field
    Layers,
    Person,
    Star,
    Chevron,  ///< triangle that points down
    Terrain,
    Line,
    Ellipse,
    MoveTiles,
    SameTile,  ///< tool that selects all equal tiles
    Eye,
    EyeClosed,
    Lock,
    Unlocked,
    Solo  ///< show one layer alone
};

/// Draws an icon as vector shapes, which are sharp at any scale. @param size  px: side length of the icon
void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color);

/// Returns the icon for the most characteristic component of an entity.
Icon iconOf(const World& world, EntityId entity);
ImU32 iconColor(Icon icon);

/// Returns the icon of an action, also of one that selects a tool. @param action  id of the action
Icon iconOfAction(std::string_view action);

}  // namespace plumb::editor::ui
