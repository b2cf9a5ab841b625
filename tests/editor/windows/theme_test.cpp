#include "editor/ui/theme.hpp"

#include <gtest/gtest.h>

#include "core/text.hpp"
#include "editor/ui/icons.hpp"
#include "tests/editor/support/contrast.hpp"

namespace plumb::editor::ui {
namespace {

struct Named {
    const char* name;
    ThemeColor swatch;
};
#define SWATCH(name) \
    Named { #name, palette::name }

ImU32 shade(const ThemeColor& swatch, Theme theme) {
    return theme == Theme::Light ? swatch.light : swatch.dark;
}
/// Returns a theme colour as it is written in theme_colors.hpp, so that it can be searched there.
std::string text(const ThemeColor& swatch, Theme theme) {
    const ImU32 color = shade(swatch, theme);
    return format("({}, {}, {})", color & 0xff, color >> 8 & 0xff, color >> 16 & 0xff);
}
class Contrast : public testing::TestWithParam<Theme> {
protected:
    void expectAll(std::initializer_list<ThemeColor> fronts, std::initializer_list<ThemeColor> backs,
                   float least) {
        for (const ThemeColor& back : backs) {
            for (const ThemeColor& front : fronts) {
                const ImU32 below = shade(back, GetParam());
                EXPECT_GE(contrast(over(shade(front, GetParam()), below), below), least)
                    << text(front, GetParam()) << " on " << text(back, GetParam());
            }
        }
    }
    /// Expects a contrast of at least `least` on the surface `back` covered by the translucent `between`.
    void expectOn(const ThemeColor& front, const ThemeColor& between, const ThemeColor& back, float least) {
        const ImU32 below = over(shade(between, GetParam()), shade(back, GetParam()));
        EXPECT_GE(contrast(shade(front, GetParam()), below), least)
            << text(front, GetParam()) << " on " << text(between, GetParam()) << " on "
            << text(back, GetParam());
    }
};

TEST_P(Contrast, textIsLegibleOnEverySurface) {
    expectAll({palette::kText},
              {palette::kChrome, palette::kChromePlaying, palette::kChromePaused, palette::kPanel,
               palette::kHeader, palette::kHeaderHovered, palette::kPopup, palette::kField,
               palette::kFieldHovered, palette::kButton, palette::kButtonHovered, palette::kCanvas},
              7.0f);
    expectAll({palette::kTextSoft, palette::kTextDim},
              {palette::kChrome, palette::kChromePlaying, palette::kChromePaused, palette::kPanel,
               palette::kHeader, palette::kPopup, palette::kField, palette::kFieldHovered, palette::kCanvas},
              4.5f);
    expectAll({palette::kWarning, palette::kError, palette::kPlay},
              {palette::kPanel, palette::kPopup, palette::kField, palette::kChrome}, 4.5f);
    expectAll({palette::kOnStatus}, {palette::kPlay, palette::kWarning, palette::kError}, 4.5f);
    expectAll({palette::kViolet, palette::kOrange, palette::kSand, palette::kGreen, palette::kBlue},
              {palette::kPanel}, 4.5f);
}

TEST_P(Contrast, textIsLegibleOnSelectedHoveredAndPressedItems) {
    for (const ThemeColor& back : {palette::kPanel, palette::kPopup, palette::kChrome}) {
        for (const ThemeColor& between :
             {palette::kAccentSoft, palette::kAccentPressed, palette::kHover, palette::kCard})
            expectOn(palette::kText, between, back, 4.5f);
        expectOn(palette::kTextDim, palette::kHover, back, 4.5f);
        expectOn(palette::kTextDim, palette::kCard, back, 4.5f);
    }
    expectOn(palette::kText, palette::kAccentPressed, palette::kField, 4.5f);
}

TEST_P(Contrast, iconsAreVisibleOnEverySurface) {
    expectAll({palette::kAccent, palette::kPlay, palette::kWarning, palette::kError, palette::kIconOff,
               palette::kViolet, palette::kOrange, palette::kSand, palette::kLime, palette::kTeal,
               palette::kGreen, palette::kBlue},
              {palette::kChrome, palette::kPanel, palette::kPopup}, 3.0f);
    expectAll({palette::kPlay, palette::kWarning, palette::kError, palette::kText},
              {palette::kChromePlaying, palette::kChromePaused}, 3.0f);
    expectAll({palette::kAccent}, {palette::kField, palette::kFieldHovered, palette::kHeader},
              3.0f);                                                           // check marks on fields
    expectOn(palette::kAccent, palette::kAccentSoft, palette::kChrome, 3.0f);  // icon of the active tool
    expectOn(palette::kAccent, palette::kAccentSoft, palette::kPanel, 3.0f);
    expectOn(palette::kPastLine, palette::kPast, palette::kField, 3.0f);
}

TEST_P(Contrast, iconsOfEntitiesAreVisible) {
    ImGuiContext* context = ImGui::CreateContext();
    applyColors(GetParam());
    const ImU32 panel = palette::kPanel;
    for (int icon = 0; icon <= static_cast<int>(Icon::Solo); ++icon)
        EXPECT_GE(contrast(iconColor(static_cast<Icon>(icon)), panel), 3.0f) << icon;
    ImGui::DestroyContext(context);
}

INSTANTIATE_TEST_SUITE_P(Themes, Contrast, testing::Values(Theme::Dark, Theme::Light),
                         [](const auto& theme) { return theme.param == Theme::Dark ? "Dark" : "Light"; });

TEST(Themes, aSwatchFollowsTheThemeInUse) {
    ImGuiContext* context = ImGui::CreateContext();
    applyColors(Theme::Dark);
    const ImU32 dark = palette::kPanel;
    applyColors(Theme::Light);
    EXPECT_NE(static_cast<ImU32>(palette::kPanel), dark);
    EXPECT_EQ(static_cast<ImU32>(palette::kPanel), palette::kPanel.light);
    applyColors(Theme::Dark);
    EXPECT_EQ(static_cast<ImU32>(palette::kPanel), dark);
    ImGui::DestroyContext(context);
}

}  // namespace
}  // namespace plumb::editor::ui
