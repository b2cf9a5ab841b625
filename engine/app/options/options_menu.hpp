#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/options/player_settings.hpp"
#include "math/rect.hpp"
#include "platform/events.hpp"

namespace plumb {

/// The menu of the player's settings that each game has: its state and what keys, mouse and pads do.
/// drawOptions() draws it. Lengths are px of the menu: see layOut().
class OptionsMenu {
public:
    enum class Kind : std::uint8_t { Choice, Volume, Binding, Command };
    enum class Request : std::uint8_t { None, Close, Quit };

    struct Row {
        Kind kind = Kind::Command;
        std::string label;
        std::string value;    ///< of a Choice, a Volume and a Binding
        float ratio = 0.0f;   ///< of a Volume, 0..1
        bool begins = false;  ///< the first of a group: a gap is above it
        AABB box;
    };

    /// @param project  settings without changes of the player
    OptionsMenu(PlayerSettings settings, PlayerSettings project);

    void open();
    [[nodiscard]] bool isOpen() const { return isOpen_; }
    /// Offers window sizes up to this one. @param scale  1..PlayerSettings::kMostScale
    void setMostScale(int scale) { mostScale_ = scale; }
    /// False while the game is recorded or replayed: its bindings are those of the start.
    void allowKeys(bool allowed) { keysAllowed_ = allowed; }
    /// Follows a change that was made elsewhere, e.g. with F11.
    void setFullscreen(bool on);

    /// Places the rows. @param screen  px of the menu
    void layOut(Vec2 screen);
    /// @param mouse  px of the menu, of a mouse event
    Request handle(const Event& event, Vec2 mouse);

    [[nodiscard]] const PlayerSettings& settings() const { return settings_; }
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    [[nodiscard]] std::size_t selected() const { return selected_; }
    [[nodiscard]] std::string_view title() const;
    [[nodiscard]] std::string hint() const;  ///< what the selected row does
    [[nodiscard]] bool warns() const { return captures_ || !conflict().empty(); }
    [[nodiscard]] bool captures() const { return captures_; }  ///< the next key is bound
    [[nodiscard]] const AABB& panel() const { return panel_; }
    [[nodiscard]] std::size_t firstShown() const { return first_; }
    [[nodiscard]] std::size_t shownRows() const { return shown_; }

    static constexpr float kSlider = 120.0f;  ///< px, length of the track of a Volume
    static constexpr float kMargin = 16.0f;   ///< px, between the panel's sides and its rows
    static constexpr float kRow = 22.0f;      ///< px, height of a row
    static constexpr float kHead = 40.0f;     ///< px, height of the title
    static constexpr float kFoot = 30.0f;     ///< px, height of the hint
    /// The range of x in which the value of a row is shown.
    [[nodiscard]] static AABB valueBox(const Row& row);

private:
    enum class Page : std::uint8_t { Main, Keys };
    /// A list of bindings that can be changed: of an action, or of a direction of an axis.
    struct Bound {
        std::string label;
        std::vector<Binding>* bindings = nullptr;
    };

    void rebuild();
    void show(Page page);
    Request activate();
    bool beginsPush(const Event& event);
    Request press(Key key);
    Request back();
    void change(int direction);
    void select(int step);
    void scroll();
    void capture(const Event& event);
    void bind(Binding binding);
    [[nodiscard]] static std::vector<Bound> boundsOf(ActionMap& keys);
    [[nodiscard]] std::string conflict() const;

    PlayerSettings settings_;
    PlayerSettings project_;
    std::vector<Row> rows_;
    AABB panel_;
    Vec2 screen_{640.0f, 360.0f};
    Page page_ = Page::Main;
    std::size_t selected_ = 0;
    std::size_t first_ = 0;         // index of the first row that is shown
    std::size_t shown_ = 0;         // number of rows that are shown
    std::optional<PadAxis> stick_;  // of a stick that is pushed, so that it moves once
    bool isOpen_ = false;
    bool captures_ = false;
    int mostScale_ = PlayerSettings::kMostScale;
    bool keysAllowed_ = true;
    bool drags_ = false;  // the mouse moves a volume
};

}  // namespace plumb
