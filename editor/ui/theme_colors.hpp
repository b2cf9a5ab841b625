#pragma once

#include <imgui.h>

namespace plumb::editor::ui {

/// A color of the editor by its name: in the dark theme and in the light one. It stands for the one of the
/// theme in use, so what it gives is not kept.
struct Swatch {
    ImU32 dark;
    ImU32 light;

    operator ImU32() const;  // wherever ImGui wants a color
};

/// Every color of the editor. One accent; everything else is calm grey. What is drawn over pictures,
/// whose colors are unknown, is the same in both themes.
namespace palette {
// clang-format off
// Surfaces, from the back to the front.
inline constexpr Swatch kLine         {IM_COL32( 20,  21,  25, 255), IM_COL32(190, 195, 204, 255)};  ///< between panels
inline constexpr Swatch kCanvas       {IM_COL32( 23,  24,  28, 255), IM_COL32(208, 212, 219, 255)};  ///< behind scene and pictures
inline constexpr Swatch kField        {IM_COL32( 26,  28,  33, 255), IM_COL32(255, 255, 255, 255)};  ///< where values are typed
inline constexpr Swatch kFieldHovered {IM_COL32( 33,  36,  42, 255), IM_COL32(250, 251, 253, 255)};
inline constexpr Swatch kChrome       {IM_COL32( 30,  32,  37, 255), IM_COL32(226, 229, 234, 255)};  ///< bars around the panels
inline constexpr Swatch kChromePlaying{IM_COL32( 26,  58,  42, 255), IM_COL32(205, 233, 215, 255)};
inline constexpr Swatch kChromePaused {IM_COL32( 66,  52,  26, 255), IM_COL32(246, 229, 193, 255)};
inline constexpr Swatch kPanel        {IM_COL32( 37,  40,  46, 255), IM_COL32(244, 245, 248, 255)};  ///< the panels themselves
inline constexpr Swatch kHeader       {IM_COL32( 45,  48,  56, 255), IM_COL32(232, 235, 240, 255)};  ///< titles, component headers
inline constexpr Swatch kHeaderHovered{IM_COL32( 54,  58,  67, 255), IM_COL32(221, 225, 232, 255)};
inline constexpr Swatch kPopup        {IM_COL32( 43,  46,  53, 255), IM_COL32(252, 252, 254, 255)};  ///< menus, questions, tooltips
inline constexpr Swatch kButton       {IM_COL32( 56,  60,  69, 255), IM_COL32(219, 223, 230, 255)};
inline constexpr Swatch kButtonHovered{IM_COL32( 65,  70,  80, 255), IM_COL32(205, 210, 219, 255)};
inline constexpr Swatch kScroll       {IM_COL32( 68,  73,  84, 255), IM_COL32(184, 190, 200, 255)};
inline constexpr Swatch kScrollHovered{IM_COL32( 86,  92, 105, 255), IM_COL32(160, 167, 179, 255)};
inline constexpr Swatch kScrollActive {IM_COL32(100, 107, 122, 255), IM_COL32(136, 144, 158, 255)};
inline constexpr Swatch kBorder       {IM_COL32( 58,  62,  71, 255), IM_COL32(196, 201, 210, 255)};
inline constexpr Swatch kShade        {IM_COL32( 10,  11,  13, 150), IM_COL32( 60,  66,  76, 110)};  ///< over all behind a question
// Words and signs.
inline constexpr Swatch kText         {IM_COL32(221, 224, 229, 255), IM_COL32( 27,  31,  38, 255)};
inline constexpr Swatch kTextSoft     {IM_COL32(176, 182, 192, 255), IM_COL32( 62,  69,  80, 255)};  ///< names of values as they are at first
inline constexpr Swatch kTextDim      {IM_COL32(162, 169, 181, 255), IM_COL32( 78,  86,  98, 255)};
inline constexpr Swatch kIconOff      {IM_COL32(116, 122, 134, 255), IM_COL32(118, 125, 137, 255)};  ///< of what cannot be done now
inline constexpr Swatch kPlay         {IM_COL32( 88, 201, 130, 255), IM_COL32( 18, 108,  56, 255)};
inline constexpr Swatch kWarning      {IM_COL32(240, 185,  74, 255), IM_COL32(134,  82,   0, 255)};
inline constexpr Swatch kError        {IM_COL32(245, 118, 118, 255), IM_COL32(176,  32,  32, 255)};
inline constexpr Swatch kOnStatus     {IM_COL32( 16,  22,  18, 255), IM_COL32(255, 255, 255, 255)};  ///< words on the three above
// What is chosen, pointed at, or held.
inline constexpr Swatch kAccent       {IM_COL32( 77, 163, 255, 255), IM_COL32( 10,  88, 180, 255)};
inline constexpr Swatch kAccentSoft   {IM_COL32( 77, 163, 255,  70), IM_COL32( 30, 120, 225,  52)};
inline constexpr Swatch kAccentPressed{IM_COL32( 77, 163, 255, 120), IM_COL32( 30, 120, 225, 100)};
inline constexpr Swatch kAccentGrab   {IM_COL32( 77, 163, 255, 150), IM_COL32( 30, 120, 225, 170)};  ///< of sliders
inline constexpr Swatch kHover        {IM_COL32(255, 255, 255,  16), IM_COL32(  0,  10,  30,  20)};
inline constexpr Swatch kCard         {IM_COL32(255, 255, 255,  10), IM_COL32(  0,  10,  30,  10)};  ///< a sheet on a panel
inline constexpr Swatch kCardLine     {IM_COL32(255, 255, 255,  70), IM_COL32(  0,  10,  30,  80)};
inline constexpr Swatch kNothing      {IM_COL32(  0,   0,   0,   0), IM_COL32(  0,   0,   0,   0)};
// Kinds of entities and files.
inline constexpr Swatch kViolet       {IM_COL32(190, 150, 240, 255), IM_COL32(112,  62, 176, 255)};  ///< cameras, prefabs
inline constexpr Swatch kOrange       {IM_COL32(230, 160,  96, 255), IM_COL32(158,  76,  10, 255)};  ///< tiles, scenes
inline constexpr Swatch kSand         {IM_COL32(232, 200, 150, 255), IM_COL32(122,  88,  36, 255)};  ///< soft bodies, folders, fonts
inline constexpr Swatch kLime         {IM_COL32(190, 232,  90, 255), IM_COL32( 76, 104,   8, 255)};  ///< fields
inline constexpr Swatch kTeal         {IM_COL32(110, 190, 190, 255), IM_COL32(  8, 104, 108, 255)};  ///< layers
inline constexpr Swatch kGreen        {IM_COL32(120, 190, 120, 255), IM_COL32( 34, 104,  38, 255)};  ///< tilesets
inline constexpr Swatch kBlue         {IM_COL32(110, 170, 240, 255), IM_COL32( 24,  92, 172, 255)};  ///< sounds
// The timeline.
inline constexpr Swatch kPast         {IM_COL32( 88, 201, 130, 110), IM_COL32( 40, 150,  90, 110)};
inline constexpr Swatch kPastLine     {IM_COL32(120, 225, 160, 255), IM_COL32( 18, 108,  56, 240)};
inline constexpr Swatch kAhead        {IM_COL32(240, 185,  74,  70), IM_COL32(200, 130,  10,  80)};
inline constexpr Swatch kTick         {IM_COL32(255, 255, 255,  22), IM_COL32(  0,  10,  30,  28)};
inline constexpr Swatch kTickMark     {IM_COL32(255, 255, 255,  60), IM_COL32(  0,  10,  30,  90)};
// Over pictures: the same in both.
inline constexpr Swatch kCellLine     {IM_COL32(128, 128, 128,  90), IM_COL32(  90,  90,  90, 90)};  ///< between cells and tiles
inline constexpr Swatch kCellHovered  {IM_COL32(255, 255, 255, 160), IM_COL32(255, 255, 255, 200)};
inline constexpr Swatch kFaded        {IM_COL32(255, 255, 255,  60), IM_COL32(255, 255, 255,  60)};  ///< tint of what was not looked for
inline constexpr Swatch kSolid        {IM_COL32(110, 230, 140, 200), IM_COL32(110, 230, 140, 200)};
inline constexpr Swatch kOneWay       {IM_COL32(120, 200, 255, 220), IM_COL32(120, 200, 255, 220)};
inline constexpr Swatch kHalo         {IM_COL32(  0,   0,   0, 190), IM_COL32(  0,   0,   0, 190)};  ///< around lines over the scene
inline constexpr Swatch kHaloText     {IM_COL32(  0,   0,   0, 200), IM_COL32(  0,   0,   0, 200)};
// clang-format on
}  // namespace palette

}  // namespace plumb::editor::ui
