#include "physics/debug/picture.hpp"
#include "physics/model/bodies.hpp"

namespace plumb::physics {

namespace {

constexpr float kFlowLength = 0.2f;   // s: meters drawn for 1 m/s of wind or current
constexpr float kLevelWidth = 4.0f;   // m: half the drawn width of an unbounded fluid's surface
constexpr float kPullRadius = 0.25f;  // m: size of the symbol of an attractor
constexpr float kSpringEnd = 0.06f;   // m

/// Returns the point of a body to which a spring is attached, or the fixed end of the spring.
Vec2 endOf(const Picture& picture, BodyId body, Vec2 anchor, WorldPosition place) {
    return alive(picture.world, body) ? apply(picture.frame(body.index), anchor) : picture.seen(place);
}

void drawSpring(const Picture& picture, const FieldDefinition& field) {
    const Vec2 a = endOf(picture, field.a, field.anchorA, field.place),
               b = endOf(picture, field.b, field.anchorB, field.place);
    picture.canvas.line(a, b, DebugRole::Field);
    for (const Vec2 end : {a, b}) picture.canvas.circle(end, kSpringEnd, DebugRole::Field);
}

void drawRegion(const Picture& picture, const FieldDefinition& field) {
    const Vec2 middle = picture.seen(field.place);
    const Vec2 side{kLevelWidth, 0.0f};
    if (field.region == RegionKind::Box)
        picture.canvas.box({middle - field.half, middle + field.half}, DebugRole::Field);
    else if (field.region == RegionKind::Circle)
        picture.canvas.circle(middle, field.radius, DebugRole::Field);
    else if (field.kind == FieldKind::Buoyancy)
        picture.canvas.line(middle - side, middle + side, DebugRole::Field);
}

/// Returns the arrow (m) for a flow or an acceleration.
Vec2 arrowOf(const FieldDefinition& field) {
    return limited(field.kind == FieldKind::AreaGravity ? kArrowPerAcceleration * field.acceleration
                                                        : kFlowLength * field.velocity);
}

/// Draws four arrows towards the center of an attractor, or away from it.
void drawPull(const Picture& picture, Vec2 centre, bool inwards) {
    for (const Vec2 side : {Vec2{1.0f, 0.0f}, Vec2{0.0f, 1.0f}, Vec2{-1.0f, 0.0f}, Vec2{0.0f, -1.0f}}) {
        const Vec2 far = centre + 2.0f * kPullRadius * side, near = centre + kPullRadius * side;
        picture.canvas.arrow(inwards ? far : near, inwards ? near : far, DebugRole::Field);
    }
}

void drawField(const Picture& picture, const FieldDefinition& field) {
    if (field.kind == FieldKind::Spring) return drawSpring(picture, field);
    drawRegion(picture, field);
    const Vec2 centre = field.kind == FieldKind::Attractor && alive(picture.world, field.a)
                            ? picture.centre(field.a.index)
                            : picture.seen(field.place);
    if (const Vec2 displacement = arrowOf(field); displacement != Vec2{})
        picture.canvas.arrow(centre - 0.5f * displacement, centre + 0.5f * displacement, DebugRole::Field);
    if (field.strength != 0.0f) drawPull(picture, centre, field.strength > 0.0f);
}

bool isShown(const Picture& picture, std::size_t field) {
    if (picture.isAmong(picture.choice.fields, field)) return true;
    const FieldDefinition& definition = picture.world.fields.all[field].definition;
    const auto isChosen = [&](BodyId body) {
        return alive(picture.world, body) && picture.shows(body.index);
    };
    return definition.kind == FieldKind::Spring && (isChosen(definition.a) || isChosen(definition.b));
}

}  // namespace

void drawFields(const Picture& picture) {
    const auto& all = picture.world.fields.all;
    for (std::size_t f = 0; f < all.size(); ++f) {
        if (all[f].isAlive && isShown(picture, f)) drawField(picture, all[f].definition);
    }
}

}  // namespace plumb::physics
