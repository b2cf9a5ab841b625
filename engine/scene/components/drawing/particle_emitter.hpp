#pragma once

#include <cstdint>

#include "math/color.hpp"
#include "math/curve.hpp"
#include "math/rect.hpp"
#include "math/vec2.hpp"
#include "reflect/curve_field.hpp"
#include "reflect/type_builder.hpp"

namespace plumb {

/// Coordinate space of particles. World: they stay behind when the emitter moves; Local: they move with it.
enum class ParticleSpace : std::uint8_t { World, Local };
enum class ParticleBlend : std::uint8_t { Normal, Additive };
enum class EmitterArea : std::uint8_t { Point, Box, Circle };

/// Emits particles: small sprites that move, change and vanish, such as sparks, smoke, leaves or rain. They
/// do not collide. Their random numbers are seeded with the entity's stable id.
struct ParticleEmitter {
    bool playing = true;
    float rate = 50.0f;           ///< particles per second
    int burst = 0;                ///< particles emitted at once at the start of each cycle
    float duration = 1.0f;        ///< s, length of an emission cycle
    bool loop = true;             ///< repeats the cycle
    bool prewarm = false;         ///< starts with the particles that a long emission would have left
    int maximum = 1000;           ///< maximum number of particles alive at a time
    float lifetime = 0.9f;        ///< s, mean lifetime of a particle
    float lifetimeSpread = 0.4f;  ///< maximum deviation from the mean lifetime, as a ratio of it

    EmitterArea area = EmitterArea::Point;
    Vec2 areaSize{64.0f, 16.0f};  ///< px, size of the box around the Transform
    float areaRadius = 32.0f;     ///< px, radius of the circle around the Transform

    float direction = -1.57079637f;  ///< rad, clockwise from the right; default: up
    float spread = 1.22173048f;      ///< rad: full angle of the fan around the direction
    float speed = 150.0f;            ///< px/s, mean initial speed
    float speedSpread = 0.5f;        ///< maximum deviation from the mean speed, as a ratio of it
    float gravity = 0.35f;           ///< ratio to the scene's gravity
    float drag = 1.0f;               ///< 1/s: decay rate of the velocity
    float spin = 0.0f;               ///< rad/s, mean angular velocity
    float spinSpread = 0.0f;         ///< rad/s: maximum deviation from the mean angular velocity
    bool randomTurn = false;         ///< each particle starts with a random rotation
    ParticleSpace space = ParticleSpace::World;

    TextureId texture;
    Rect source;                                   ///< px: the part of the texture to draw; empty: all of it
    float size = 3.0f;                             ///< px, mean length of the longer side
    float sizeSpread = 0.5f;                       ///< maximum deviation from the mean size, as a ratio of it
    Curve sizeOverLife = Curve::line(1.0f, 0.3f);  ///< multiplier of the size over the lifetime
    Curve opacityOverLife = {{CurveKey{0.0f, 1.0f}, CurveKey{0.6f, 0.9f}, CurveKey{1.0f, 0.0f}}, 3};
    Color colorStart{255, 214, 102, 255};  ///< color of a particle when it is emitted
    Color colorEnd{214, 58, 26, 255};      ///< color of a particle at the end of its lifetime
    ParticleBlend blend = ParticleBlend::Normal;
    int layer = 10;  ///< drawing layer; higher numbers are in front

    static void describe(TypeBuilder<ParticleEmitter>& type) {
        type.name("ParticleEmitter").doc("Emits particles without collision: sparks, smoke, leaves, rain.");
        describeSending(type);
        describeMotion(type);
        describeLook(type);
    }

private:
    static void describeSending(TypeBuilder<ParticleEmitter>& type) {
        type.field<&ParticleEmitter::playing>("playing").doc(
            "Emits particles; switching it on again restarts the cycle.");
        type.field<&ParticleEmitter::rate>("rate")
            .range(0.0f, 100000.0f)
            .doc("Number of particles emitted per second.");
        type.field<&ParticleEmitter::burst>("burst")
            .range(0.0f, 100000.0f)
            .doc("Number of particles emitted at once at the start of each cycle.");
        type.field<&ParticleEmitter::duration>("duration")
            .unit(Unit::Seconds)
            .range(0.05f, 600.0f)
            .doc("Length of an emission cycle, s; with loop the next cycle follows.");
        type.field<&ParticleEmitter::loop>("loop").doc(
            "Repeats the emission cycle; off emits for one duration only.");
        type.field<&ParticleEmitter::prewarm>("prewarm").shownIf("loop").doc(
            "Starts with the particles that a long emission would have left.");
        type.field<&ParticleEmitter::maximum>("maximum")
            .range(1.0f, 100000.0f)
            .doc("Maximum number of particles alive at a time; none are emitted beyond it.");
        type.field<&ParticleEmitter::lifetime>("lifetime")
            .unit(Unit::Seconds)
            .range(0.01f, 600.0f)
            .doc("Mean lifetime of a particle, s.");
        type.field<&ParticleEmitter::lifetimeSpread>("lifetimeSpread")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Maximum deviation from the mean lifetime, as a ratio of it.");
        type.field<&ParticleEmitter::area>("area")
            .names({{"point", 0}, {"box", 1}, {"circle", 2}})
            .doc("Shape of the area around the Transform in which particles appear.");
        type.field<&ParticleEmitter::areaSize>("areaSize")
            .unit(Unit::Pixels)
            .shownIf("area", 1)
            .doc("Size of the emission box, px.");
        type.field<&ParticleEmitter::areaRadius>("areaRadius")
            .unit(Unit::Pixels)
            .range(0.0f, 1e5f)
            .shownIf("area", 2)
            .doc("Radius of the emission circle, px.");
    }
    static void describeMotion(TypeBuilder<ParticleEmitter>& type) {
        type.field<&ParticleEmitter::direction>("direction")
            .unit(Unit::Radians)
            .doc("Direction of emission, degrees: 0 is right, 90 down, -90 up.");
        type.field<&ParticleEmitter::spread>("spread")
            .unit(Unit::Radians)
            .range(0.0f, 6.28318530f)
            .doc("Full angle of the fan around the direction, degrees; 360 emits to all sides.");
        type.field<&ParticleEmitter::speed>("speed")
            .unit(Unit::PixelsPerSecond)
            .range(-1e5f, 1e5f)
            .doc("Mean initial speed of a particle, px/s.");
        type.field<&ParticleEmitter::speedSpread>("speedSpread")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Maximum deviation from the mean speed, as a ratio of it.");
        type.field<&ParticleEmitter::gravity>("gravity")
            .unit(Unit::Ratio)
            .range(-100.0f, 100.0f)
            .doc("Gravity of the particles as a ratio to the scene's; negative makes them rise.");
        type.field<&ParticleEmitter::drag>("drag")
            .range(0.0f, 100.0f)
            .doc("Decay rate of the velocity, 1/s: after 1 / drag seconds 37 % of the speed is left.");
        type.field<&ParticleEmitter::spin>("spin")
            .unit(Unit::RadiansPerSecond)
            .doc("Mean angular velocity, degrees/s, clockwise on screen.");
        type.field<&ParticleEmitter::spinSpread>("spinSpread")
            .unit(Unit::RadiansPerSecond)
            .range(0.0f, 1000.0f)
            .doc("Maximum deviation from the mean angular velocity, degrees/s.");
        type.field<&ParticleEmitter::randomTurn>("randomTurn")
            .doc("Gives each particle a random initial rotation.");
        type.field<&ParticleEmitter::space>("space")
            .names({{"world", 0}, {"local", 1}})
            .doc(
                "Coordinate space: world particles stay behind when the emitter moves, local ones move with "
                "it.");
    }
    static void describeLook(TypeBuilder<ParticleEmitter>& type) {
        type.field<&ParticleEmitter::texture>("texture").doc("Image file of a particle; none draws squares.");
        type.field<&ParticleEmitter::source>("source")
            .unit(Unit::Pixels)
            .doc("Rectangle of the texture to draw, px; empty for the whole texture.");
        type.field<&ParticleEmitter::size>("size")
            .unit(Unit::Pixels)
            .range(0.0f, 4096.0f)
            .doc("Mean length of a particle's longer side, px.");
        type.field<&ParticleEmitter::sizeSpread>("sizeSpread")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Maximum deviation from the mean size, as a ratio of it.");
        type.field<&ParticleEmitter::sizeOverLife>("sizeOverLife")
            .unit(Unit::Ratio)
            .range(0.0f, 10.0f)
            .doc("Multiplier of the size over the particle's lifetime.");
        type.field<&ParticleEmitter::opacityOverLife>("opacityOverLife")
            .unit(Unit::Ratio)
            .range(0.0f, 1.0f)
            .doc("Opacity over the particle's lifetime, 0 to 1.");
        type.field<&ParticleEmitter::colorStart>("colorStart")
            .doc("Color at the start of the lifetime; multiplies the texture's colors.");
        type.field<&ParticleEmitter::colorEnd>("colorEnd")
            .doc("Color at the end of the lifetime; multiplies the texture's colors.");
        type.field<&ParticleEmitter::blend>("blend")
            .names({{"normal", 0}, {"additive", 1}})
            .doc("Blend mode; additive adds the particle's light to the background.");
        type.field<&ParticleEmitter::layer>("layer")
            .range(-1000.0f, 1000.0f)
            .doc("Drawing layer; higher numbers are in front.");
    }
};

}  // namespace plumb
