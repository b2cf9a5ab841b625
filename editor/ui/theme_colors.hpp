#pragma once

#include <imgui.h>

namespace plumb::editor::ui {

/// A named color of the editor, with a value for the dark and one for the light theme. It converts to the
/// value of the theme in use, so the converted value must not be stored.
struct ThemeColor {
    ImU32 dark;
    ImU32 light;

    operator ImU32() const;  // implicit, as ImGui's functions take ImU32
};

/// All colors of the editor: one accent color on grey. Colors drawn over images, whose colors are unknown,
/// are the same in both themes.
namespace palette {
// clang-format off
// Surfaces, from the back to the front.
inline constexpr ThemeColor kLine         {IM_COL32( 20,  21,  25, 255), IM_COL32(190, 195, 204, 255)};  ///< between panels
inline constexpr ThemeColor kCanvas       {IM_COL32( 23,  24,  28, 255), IM_COL32(208, 212, 219, 255)};  ///< behind scene and images
inline constexpr ThemeColor kField        {IM_COL32( 26,  28,  33, 255), IM_COL32(255, 255, 255, 255)};  ///< input fields
inline constexpr ThemeColor kFieldHovered {IM_COL32( 33,  36,  42, 255), IM_COL32(250, 251, 253, 255)};
inline constexpr ThemeColor kChrome       {IM_COL32( 30,  32,  37, 255), IM_COL32(226, 229, 234, 255)};  ///< bars around the panels
inline constexpr ThemeColor kChromePlaying{IM_COL32( 26,  58,  42, 255), IM_COL32(205, 233, 215, 255)};  ///< bars while a game runs
inline constexpr ThemeColor kChromePaused {IM_COL32( 66,  52,  26, 255), IM_COL32(246, 229, 193, 255)};  ///< bars while a game is paused
inline constexpr ThemeColor kPanel        {IM_COL32( 37,  40,  46, 255), IM_COL32(244, 245, 248, 255)};  ///< background of panels
inline constexpr ThemeColor kHeader       {IM_COL32( 45,  48,  56, 255), IM_COL32(232, 235, 240, 255)};  ///< titles, component headers
inline constexpr ThemeColor kHeaderHovered{IM_COL32( 54,  58,  67, 255), IM_COL32(221, 225, 232, 255)};
inline constexpr ThemeColor kPopup        {IM_COL32( 43,  46,  53, 255), IM_COL32(252, 252, 254, 255)};  ///< menus, dialogs, tooltips
inline constexpr ThemeColor kButton       {IM_COL32( 56,  60,  69, 255), IM_COL32(219, 223, 230, 255)};
inline constexpr ThemeColor kButtonHovered{IM_COL32( 65,  70,  80, 255), IM_COL32(205, 210, 219, 255)};
inline constexpr ThemeColor kScroll       {IM_COL32( 68,  73,  84, 255), IM_COL32(184, 190, 200, 255)};
inline constexpr ThemeColor kScrollHovered{IM_COL32( 86,  92, 105, 255), IM_COL32(160, 167, 179, 255)};
inline constexpr ThemeColor kScrollActive {IM_COL32(100, 107, 122, 255), IM_COL32(136, 144, 158, 255)};
inline constexpr ThemeColor kBorder       {IM_COL32( 58,  62,  71, 255), IM_COL32(196, 201, 210, 255)};
inline constexpr ThemeColor kShade        {IM_COL32( 10,  11,  13, 150), IM_COL32( 60,  66,  76, 110)};  ///< over everything behind a dialog
// Text and icons.
inline constexpr ThemeColor kText         {IM_COL32(221, 224, 229, 255), IM_COL32( 27,  31,  38, 255)};
inline constexpr ThemeColor kTextSoft     {IM_COL32(176, 182, 192, 255), IM_COL32( 62,  69,  80, 255)};  ///< names of fields with default values
inline constexpr ThemeColor kTextDim      {IM_COL32(162, 169, 181, 255), IM_COL32( 78,  86,  98, 255)};
inline constexpr ThemeColor kIconOff      {IM_COL32(116, 122, 134, 255), IM_COL32(118, 125, 137, 255)};  ///< icons of disabled actions
inline constexpr ThemeColor kPlay         {IM_COL32( 88, 201, 130, 255), IM_COL32( 18, 108,  56, 255)};
inline constexpr ThemeColor kWarning      {IM_COL32(240, 185,  74, 255), IM_COL32(134,  82,   0, 255)};
inline constexpr ThemeColor kError        {IM_COL32(245, 118, 118, 255), IM_COL32(176,  32,  32, 255)};
inline constexpr ThemeColor kOnStatus     {IM_COL32( 16,  22,  18, 255), IM_COL32(255, 255, 255, 255)};  ///< text on kPlay, kWarning, kError
// Selected, hovered and pressed items.
inline constexpr ThemeColor kAccent       {IM_COL32( 77, 163, 255, 255), IM_COL32( 10,  88, 180, 255)};
inline constexpr ThemeColor kAccentSoft   {IM_COL32( 77, 163, 255,  70), IM_COL32( 30, 120, 225,  52)};  ///< background of active buttons
inline constexpr ThemeColor kAccentPressed{IM_COL32( 77, 163, 255, 120), IM_COL32( 30, 120, 225, 100)};
inline constexpr ThemeColor kAccentGrab   {IM_COL32( 77, 163, 255, 150), IM_COL32( 30, 120, 225, 170)};  ///< grab of a slider
inline constexpr ThemeColor kHover        {IM_COL32(255, 255, 255,  16), IM_COL32(  0,  10,  30,  20)};
inline constexpr ThemeColor kCard         {IM_COL32(255, 255, 255,  10), IM_COL32(  0,  10,  30,  10)};  ///< a raised area on a panel
inline constexpr ThemeColor kCardLine     {IM_COL32(255, 255, 255,  70), IM_COL32(  0,  10,  30,  80)};
inline constexpr ThemeColor kNothing      {IM_COL32(  0,   0,   0,   0), IM_COL32(  0,   0,   0,   0)};  ///< transparent
// Kinds of entities and files.
inline constexpr ThemeColor kViolet       {IM_COL32(190, 150, 240, 255), IM_COL32(112,  62, 176, 255)};  ///< cameras, prefabs
inline constexpr ThemeColor kOrange       {IM_COL32(230, 160,  96, 255), IM_COL32(158,  76,  10, 255)};  ///< tiles, scenes
inline constexpr ThemeColor kSand         {IM_COL32(232, 200, 150, 255), IM_COL32(122,  88,  36, 255)};  ///< soft bodies, folders, fonts
inline constexpr ThemeColor kLime         {IM_COL32(190, 232,  90, 255), IM_COL32( 76, 104,   8, 255)};  ///< fields
inline constexpr ThemeColor kTeal         {IM_COL32(110, 190, 190, 255), IM_COL32(  8, 104, 108, 255)};  ///< layers
inline constexpr ThemeColor kGreen        {IM_COL32(120, 190, 120, 255), IM_COL32( 34, 104,  38, 255)};  ///< tilesets
inline constexpr ThemeColor kBlue         {IM_COL32(110, 170, 240, 255), IM_COL32( 24,  92, 172, 255)};  ///< sounds
// The timeline.
inline constexpr ThemeColor kPast         {IM_COL32( 88, 201, 130, 110), IM_COL32( 40, 150,  90, 110)};  ///< recorded ticks up to the shown one
inline constexpr ThemeColor kPastLine     {IM_COL32(120, 225, 160, 255), IM_COL32( 18, 108,  56, 240)};  ///< mark of the shown tick
inline constexpr ThemeColor kAhead        {IM_COL32(240, 185,  74,  70), IM_COL32(200, 130,  10,  80)};  ///< recorded ticks after the shown one
inline constexpr ThemeColor kTick         {IM_COL32(255, 255, 255,  22), IM_COL32(  0,  10,  30,  28)};  ///< lines at each second; grid lines
inline constexpr ThemeColor kTickMark     {IM_COL32(255, 255, 255,  60), IM_COL32(  0,  10,  30,  90)};  ///< lines every 5 seconds
// Over images: the same in both themes.
inline constexpr ThemeColor kCellLine     {IM_COL32(128, 128, 128,  90), IM_COL32(  90,  90,  90, 90)};  ///< lines between cells; thin lines of plots
inline constexpr ThemeColor kCellHovered  {IM_COL32(255, 255, 255, 160), IM_COL32(255, 255, 255, 200)};
inline constexpr ThemeColor kFaded        {IM_COL32(255, 255, 255,  60), IM_COL32(255, 255, 255,  60)};  ///< tint of tiles not found by the search
inline constexpr ThemeColor kSolid        {IM_COL32(110, 230, 140, 200), IM_COL32(110, 230, 140, 200)};  ///< collision shapes
inline constexpr ThemeColor kOneWay       {IM_COL32(120, 200, 255, 220), IM_COL32(120, 200, 255, 220)};  ///< collision shapes solid from above only
inline constexpr ThemeColor kHalo         {IM_COL32(  0,   0,   0, 190), IM_COL32(  0,   0,   0, 190)};  ///< dark border of lines drawn over the scene
inline constexpr ThemeColor kHaloText     {IM_COL32(  0,   0,   0, 200), IM_COL32(  0,   0,   0, 200)};  ///< shadow of text over the scene
// clang-format on
}  // namespace palette

}  // namespace plumb::editor::ui
