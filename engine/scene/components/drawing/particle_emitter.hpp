#pragma once

#include <cstdint>

#include "math/color.hpp"
#include "math/curve.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// What particles are given in: the world, where they stay when the emitter moves on, or the emitter.
enum class ParticleSpace : std::uint8_t { World, Local };
enum class ParticleBlend : std::uint8_t { Normal, Additive };
enum class EmitterArea : std::uint8_t { Point, Box, Circle };

/// Sends out particles: small pictures that fly, change and vanish, such as sparks, smoke, leaves or rain.
/// They are only seen: nothing collides with them. Which ones come follows from the entity's lasting id.
struct ParticleEmitter {
    bool playing = true;
    float rate = 50.0f;     ///< particles a second
    int burst = 0;          ///< particles at once when it begins, and again with each turn
    float duration = 1.0f;  ///< s of a turn
    bool loop = true;
    bool prewarm = false;         ///< begins as if it had sent for long
    int maximum = 1000;           ///< particles at a time
    float lifetime = 0.9f;        ///< s
    float lifetimeSpread = 0.4f;  ///< ratio: as much longer or shorter at most

    EmitterArea area = EmitterArea::Point;
    Vec2 areaSize{64.0f, 16.0f};  ///< px, around the Transform
    float areaRadius = 32.0f;     ///< px

    float direction = -1.57079637f;  ///< rad, clockwise from the right; up
    float spread = 1.22173048f;      ///< rad: how wide the fan is around the direction
    float speed = 150.0f;            ///< px/s
    float speedSpread = 0.5f;        ///< ratio
    float gravity = 0.35f;           ///< ratio of the scene's
    float drag = 1.0f;               ///< 1/s: which part of the speed is lost in a second, when it is small
    float spin = 0.0f;               ///< rad/s
    float spinSpread = 0.0f;         ///< rad/s, to either side
    bool randomTurn = false;         ///< each begins turned in another way
    ParticleSpace space = ParticleSpace::World;

    TextureId texture;
    Rect source;              ///< px in the texture; empty: all of it
    float size = 3.0f;        ///< px, the longer side
    float sizeSpread = 0.5f;  ///< ratio
    Curve sizeOverLife = Curve::line(1.0f, 0.3f);
    Curve opacityOverLife = {{CurveKey{0.0f, 1.0f}, CurveKey{0.6f, 0.9f}, CurveKey{1.0f, 0.0f}}, 3};
    Color colorStart{255, 214, 102, 255};
    Color colorEnd{214, 58, 26, 255};
    ParticleBlend blend = ParticleBlend::Normal;
    int layer = 10;  ///< order of drawing: higher is in front

    static void describe(TypeBuilder<ParticleEmitter>& type) {
        type.name("ParticleEmitter")
            .doc("Sends out particles: sparks, smoke, leaves, rain. They are only seen.");
        describeSending(type);
        describeMotion(type);
        describeLook(type);
    }

private:
    static void describeSending(TypeBuilder<ParticleEmitter>& type) {
        type.field<&ParticleEmitter::playing>("playing").doc("Off sends no more; on again begins anew.");
        type.field<&ParticleEmitter::rate>("rate").range(0.0f, 100000.0f).doc("Particles a second.");
        type.field<&ParticleEmitter::burst>("burst")
            .range(0.0f, 100000.0f)
            .doc("Particles at once when it begins, and again with each turn of a loop.");
        type.field<&ParticleEmitter::duration>("duration")
            .unit(Unit::Seconds)
            .range(0.05f, 600.0f)
            .doc("How long it sends; a loop then begins its next turn.");
        type.field<&ParticleEmitter::loop>("loop").doc("Off sends for one duration only.");
        type.field<&ParticleEmitter::prewarm>("prewarm").shownIf("loop").doc(
            "Begins as if it had sent for long: the air is full of leaves already.");
        type.field<&ParticleEmitter::maximum>("maximum")
            .range(1.0f, 100000.0f)
            .doc("Particles at a time; while there are as many, no more come.");
        type.field<&ParticleEmitter::lifetime>("lifetime")
            .unit(Unit::Seconds)
            .range(0.01f, 600.0f)
            .doc("How long a particle lives.");
        type.field<&ParticleEmitter::lifetimeSpread>("lifetimeSpread")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Lives are longer or shorter by this part of it at most.");
        type.field<&ParticleEmitter::area>("area")
            .names({{"point", 0}, {"box", 1}, {"circle", 2}})
            .doc("Where particles begin, around the Transform.");
        type.field<&ParticleEmitter::areaSize>("areaSize")
            .unit(Unit::Pixels)
            .shownIf("area", 1)
            .doc("Of the box.");
        type.field<&ParticleEmitter::areaRadius>("areaRadius")
            .unit(Unit::Pixels)
            .range(0.0f, 1e5f)
            .shownIf("area", 2)
            .doc("Of the circle.");
    }
    static void describeMotion(TypeBuilder<ParticleEmitter>& type) {
        type.field<&ParticleEmitter::direction>("direction")
            .unit(Unit::Radians)
            .doc("0 is right, 90 down, -90 up.");
        type.field<&ParticleEmitter::spread>("spread")
            .unit(Unit::Radians)
            .range(0.0f, 6.28318530f)
            .doc("How wide the fan around the direction is; 360 sends to all sides.");
        type.field<&ParticleEmitter::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(-1e5f, 1e5f)
            .doc("With which they begin.");
        type.field<&ParticleEmitter::speedSpread>("speedSpread")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Faster or slower by this part of it at most.");
        type.field<&ParticleEmitter::gravity>("gravity")
            .unit(Unit::Ratio)
            .range(-100.0f, 100.0f)
            .doc("How many times the scene's gravity; negative rises.");
        type.field<&ParticleEmitter::drag>("drag")
            .range(0.0f, 100.0f)
            .doc("Air that slows them: after 1 / drag seconds a third of the speed is left.");
        type.field<&ParticleEmitter::spin>("spin").unit(Unit::RadiansPerSecond).doc("Clockwise on screen.");
        type.field<&ParticleEmitter::spinSpread>("spinSpread")
            .unit(Unit::RadiansPerSecond)
            .range(0.0f, 1000.0f)
            .doc("Each spins by up to as much more or less.");
        type.field<&ParticleEmitter::randomTurn>("randomTurn").doc("Each begins turned in another way.");
        type.field<&ParticleEmitter::space>("space")
            .names({{"world", 0}, {"local", 1}})
            .doc("Particles of the world stay behind when the emitter moves; local ones go with it.");
    }
    static void describeLook(TypeBuilder<ParticleEmitter>& type) {
        type.field<&ParticleEmitter::texture>("texture").doc("The image file; without one, squares.");
        type.field<&ParticleEmitter::source>("source")
            .unit(Unit::Pixels)
            .doc("Part of the texture; empty for all of it.");
        type.field<&ParticleEmitter::size>("size")
            .unit(Unit::Pixels)
            .range(0.0f, 4096.0f)
            .doc("The longer side of a particle.");
        type.field<&ParticleEmitter::sizeSpread>("sizeSpread")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Larger or smaller by this part of it at most.");
        type.field<&ParticleEmitter::sizeOverLife>("sizeOverLife")
            .unit(Unit::Ratio)
            .range(0.0f, 10.0f)
            .doc("By how much the size is multiplied, from birth to death.");
        type.field<&ParticleEmitter::opacityOverLife>("opacityOverLife")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("How much of it is seen, from birth to death.");
        type.field<&ParticleEmitter::colorStart>("colorStart")
            .doc("At birth; multiplies the picture's colors.");
        type.field<&ParticleEmitter::colorEnd>("colorEnd").doc("At death.");
        type.field<&ParticleEmitter::blend>("blend")
            .names({{"normal", 0}, {"additive", 1}})
            .doc("Additive ones shine: they add light instead of covering.");
        type.field<&ParticleEmitter::layer>("layer").range(-1000.0f, 1000.0f).doc("Higher is in front.");
    }
};

}  // namespace plumb
