#include "editor/ui/overlays/cost_overlays.hpp"

#include <algorithm>
#include <span>

#include "core/text.hpp"
#include "editor/model/cost/body_errors.hpp"
#include "editor/model/cost/cost_words.hpp"
#include "physics/debug_draw.hpp"
#include "render/view.hpp"
#include "scene/physics/physics_state.hpp"
#include "scene/physics_bridge.hpp"

namespace plumb::editor::ui {
namespace {

constexpr std::size_t kMostNumbers = 12;  // maximum number of error labels
constexpr float kLine = 18.0f;            // px on screen at scale 1, line height of the legend
constexpr float kLetter = 6.6f;           // px on screen at scale 1, approximate width of a letter
constexpr Color kPaper{0, 0, 0, 150};     // background of the legend
constexpr Color kWords{255, 255, 255, 255};

using Shades = std::span<const CostShade>;

std::size_t shadeOf(Shades shades, float value) {
    std::size_t shade = 0;
    while (shade + 1 < shades.size() && value >= shades[shade + 1].from) ++shade;
    return shade;
}

/// Visible part of the scene, world px; for a running game the rectangle of the game's resolution.
AABB pictureBox(const Workspace& workspace) {
    const View& view = workspace.view.view();
    if (!workspace.play.running() || !workspace.followsGame) return visibleBox(view);
    const Vec2 picture = workspace.project.picture;
    const Vec2 size = min(view.size, picture * workspace.view.zoomFor(picture)) / view.zoom;
    return {view.center - size * 0.5f, view.center + size * 0.5f};
}

/// Draws the legend in the lower left corner, as the upper edge shows the play state.
/// @param lift  distance from the lower edge, px on screen at scale 1
void drawLegend(const Workspace& workspace, Shades shades, std::string_view title, float lift,
                Overlay& overlay) {
    const float pixel = workspace.settings.scale / workspace.view.view().zoom;
    const AABB box = pictureBox(workspace);
    std::size_t longest = title.size();
    for (const CostShade& shade : shades) longest = std::max(longest, shade.label.size());
    const Vec2 size{30.0f + kLetter * static_cast<float>(longest),
                    kLine * static_cast<float>(shades.size() + 1) + 6.0f};
    const Vec2 corner{box.min.x + 4.0f * pixel, box.max.y - (lift + 4.0f) * pixel};
    overlay.filledBox({{corner.x, corner.y - size.y * pixel}, {corner.x + size.x * pixel, corner.y}}, kPaper);
    Vec2 at{box.min.x + 10.0f * pixel, box.max.y - 8.0f * pixel - lift * pixel};
    for (std::size_t i = shades.size(); i-- > 0;) {
        const CostShade& shade = shades[i];
        const float middle = at.y - 8.0f * pixel;
        overlay.line({at.x, middle}, {at.x + 14.0f * pixel, middle}, shade.color,
                     shade.thickness * workspace.settings.scale);
        overlay.text({at.x + 20.0f * pixel, at.y}, std::string{shade.label}, kWords);
        at.y -= kLine * pixel;
    }
    overlay.text(at, std::string{title}, kWords);
}

/// Returns a flag per body: 1 if the overlay shows the body, i.e. all bodies or those of selected entities.
std::vector<std::uint8_t> chosenBodies(const Workspace& workspace, const PhysicsState& state,
                                       std::string_view overlay) {
    const bool all = workspace.reachOf(overlay) == PhysicsReach::All;
    std::vector<std::uint8_t> chosen(state.world.bodies.size(), all ? 1 : 0);
    if (all) return chosen;
    for (const ObjectId id : workspace.document.selection.all()) {
        const EntityId entity = workspace.shownEntity(id);
        if (!entity || entity.index >= state.bodyOf.size() || state.bodyOf[entity.index] == 0) continue;
        chosen[state.bodyOf[entity.index] - 1] = 1;
    }
    return chosen;
}

/// Draws shapes of the physics in one color and thickness.
class OutlineCanvas final : public physics::DebugCanvas {
public:
    OutlineCanvas(Overlay& overlay, PixelScale scale, const CostShade& shade)
        : overlay_{overlay}, scale_{scale}, shade_{shade} {}
    void line(Vec2 from, Vec2 to, physics::DebugInk) override {
        overlay_.line(toPixels(from, scale_), toPixels(to, scale_), shade_.color, shade_.thickness);
    }
    void circle(Vec2 centre, float radius, physics::DebugInk) override {
        overlay_.circle(toPixels(centre, scale_), radius * scale_.pixels, shade_.color, shade_.thickness);
    }
    void polygon(std::span<const Vec2> corners, physics::DebugInk ink) override {
        for (std::size_t i = 0; i < corners.size(); ++i)
            line(corners[i], corners[(i + 1) % corners.size()], ink);
    }
    void arrow(Vec2, Vec2, physics::DebugInk) override {}

private:
    Overlay& overlay_;
    PixelScale scale_;
    const CostShade& shade_;
};

/// Draws the errors of the worst bodies as numbers, px.
void drawNumbers(const PhysicsState& state, const std::vector<float>& errors,
                 const std::vector<std::uint8_t>& chosen, Overlay& overlay) {
    std::vector<std::uint32_t> worst;
    for (std::uint32_t body = 0; body < errors.size(); ++body) {
        if (chosen[body] != 0 && pixelsOf(errors[body], state.scale) >= kErrorShades[2].from)
            worst.push_back(body);
    }
    const std::size_t count = std::min(worst.size(), kMostNumbers);
    std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(count), worst.end(),
                      [&](std::uint32_t a, std::uint32_t b) { return errors[a] > errors[b]; });
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 at = toPixels(toVec2(state.world.bodies.pose[worst[i]].centre), state.scale);
        const float pixels = pixelsOf(errors[worst[i]], state.scale);
        overlay.text(at, format("{} px", fixedText(static_cast<double>(pixels), 1)), kWords);
    }
}

const PhysicsState* playedPhysics(const Workspace& workspace, const World& world) {
    return workspace.play.running() ? world.findResource<PhysicsState>() : nullptr;
}

}  // namespace

void drawBodyErrors(const Workspace& workspace, const World& world, Overlay& overlay) {
    const PhysicsState* state = playedPhysics(workspace, world);
    if (state == nullptr) return;
    const std::vector<float> errors = bodyErrors(state->world);
    const std::vector<std::uint8_t> chosen = chosenBodies(workspace, *state, "bodyErrors");
    const AABB seen = visibleBox(workspace.view.view());
    const AABB sight{toMetres(seen.min, state->scale), toMetres(seen.max, state->scale)};
    for (const CostShade& shade : kErrorShades) {
        std::vector<std::uint8_t> bodies(chosen.size());
        for (std::uint32_t body = 0; body < bodies.size(); ++body) {
            const bool isDynamic = state->world.bodies.info[body].kind == physics::BodyKind::Dynamic;
            const CostShade& own = kErrorShades[shadeOf(kErrorShades, pixelsOf(errors[body], state->scale))];
            bodies[body] = isDynamic && chosen[body] != 0 && &own == &shade ? 1 : 0;
        }
        physics::DebugOptions choice;
        choice.parts = physics::kDrawShapes;
        choice.sight = &sight;
        choice.selectedOnly = true;
        choice.bodies = bodies;
        OutlineCanvas canvas{overlay, state->scale, shade};
        physics::debugDraw(state->world, canvas, choice);
    }
    drawNumbers(*state, errors, chosen, overlay);
    drawLegend(workspace, kErrorShades, "Body errors: overlap or joint error", 0.0f, overlay);
}

void drawContactForces(const Workspace& workspace, const World& world, Overlay& overlay) {
    const PhysicsState* state = playedPhysics(workspace, world);
    if (state == nullptr) return;
    const std::vector<std::uint8_t> chosen = chosenBodies(workspace, *state, "contactForces");
    const AABB seen = visibleBox(workspace.view.view());
    const float pixel = workspace.settings.scale / workspace.view.view().zoom;
    for (const ContactPush& push : contactPushes(state->world)) {
        if (chosen[push.bodyA] == 0 && chosen[push.bodyB] == 0) continue;
        const Vec2 at = toPixels(toVec2(push.place), state->scale);
        if (!contains(seen, at)) continue;
        const CostShade& shade = kForceShades[shadeOf(kForceShades, push.weights)];
        // A circle of radius r/2 with thickness r looks like a disc of radius r.
        overlay.circle(at, shade.thickness * 0.5f * pixel, shade.color,
                       shade.thickness * workspace.settings.scale);
    }
    const bool both = workspace.shows("bodyErrors");
    drawLegend(workspace, kForceShades, "Contact forces", both ? kLine * 6.0f : 0.0f, overlay);
}

}  // namespace plumb::editor::ui
