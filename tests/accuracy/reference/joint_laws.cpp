#include <limits>
#include <tuple>

#include "core/text.hpp"
#include "tests/accuracy/reference/scene.hpp"

namespace plumb::reference {

namespace {

using physics::JointDefinition;
using physics::JointKind;

/// Creates the laws of one joint.
class Writer {
public:
    Writer(const physics::World& world, std::uint32_t joint, std::vector<Law>& laws)
        : hot_{world.joints.hot[joint]}, definition_{world.joints.definition[joint]}, laws_{laws} {
        usual_.joint = joint;
        usual_.a = hot_.bodyA;
        usual_.b = hot_.bodyB;
        usual_.measure.anchorA = toPoint(hot_.anchorA);
        usual_.measure.anchorB = toPoint(hot_.anchorB);
    }

    /// Adds two laws (x, y) that make both anchors coincide: rigidly, or by a spring if hertz > 0.
    void point(double hertz, double dampingRatio) {
        for (const MeasureKind kind : {MeasureKind::AnchorX, MeasureKind::AnchorY}) {
            Law law = usual_;
            law.measure.kind = kind;
            if (hertz > 0.0) law = spring(law, hertz, dampingRatio);
            law.isPoint = kind == MeasureKind::AnchorX;
            laws_.push_back(law);
        }
    }
    void hold(MeasureKind kind, double rest, double hertz = 0.0, double dampingRatio = 0.0) {
        Law law = of(kind, rest);
        laws_.push_back(hertz > 0.0 ? spring(law, hertz, dampingRatio) : law);
    }
    /// Adds the laws of a joint coordinate's spring, limits and motor, as far as they are enabled.
    void value(MeasureKind kind, double reference, bool withMotor) {
        const auto& [springs, limit, motor] =
            std::tie(definition_.spring, definition_.limit, definition_.motor);
        if (springs.on) {
            const Law law = of(kind, reference + static_cast<double>(springs.rest));
            laws_.push_back(
                spring(law, static_cast<double>(springs.hertz), static_cast<double>(springs.dampingRatio)));
        }
        if (limit.on) {
            for (const bool upper : {false, true}) {
                Law law = of(kind, reference + static_cast<double>(upper ? limit.upper : limit.lower));
                law.kind = ConstraintKind::AtLeast;
                law.sign = upper ? -1.0 : 1.0;
                laws_.push_back(law);
            }
        }
        if (motor.on && withMotor) drive(kind);
    }
    void drive(MeasureKind kind) {
        Law law = of(kind, 0.0);
        law.kind = ConstraintKind::Drive;
        law.speed = static_cast<double>(definition_.motor.speed);
        law.most = static_cast<double>(definition_.motor.maxForce);
        laws_.push_back(law);
    }
    Law& usual() { return usual_; }

private:
    [[nodiscard]] Law of(MeasureKind kind, double rest) const {
        Law law = usual_;
        law.measure.kind = kind;
        law.measure.axis = toPoint(definition_.axis);
        law.measure.axis = normalized(law.measure.axis);
        law.measure.rest = rest;
        return law;
    }
    static Law spring(Law law, double hertz, double dampingRatio) {
        law.kind = ConstraintKind::Spring;
        law.hertz = hertz;
        law.dampingRatio = dampingRatio;
        return law;
    }

    const physics::Joint& hot_;
    const JointDefinition& definition_;
    std::vector<Law>& laws_;
    Law usual_;
};

void writeMotor(Writer& writer, const JointDefinition& definition) {
    const bool own = definition.hertz > 0.0f;
    const double hertz = own ? static_cast<double>(definition.hertz) : 5.0;
    const double ratio = own ? static_cast<double>(definition.dampingRatio) : 1.0;
    writer.usual().most = static_cast<double>(definition.maxForce);
    writer.usual().measure.anchorA = writer.usual().measure.anchorA + toPoint(definition.offset);
    writer.point(hertz, ratio);
    writer.usual().most = static_cast<double>(definition.maxTorque);
    writer.hold(MeasureKind::Angle, static_cast<double>(definition.referenceAngle), hertz, ratio);
}

void writePulley(Writer& writer, const JointDefinition& definition) {
    Measure& measure = writer.usual().measure;
    measure.groundA = toPoint(definition.groundA);
    measure.groundB = toPoint(definition.groundB);
    measure.ratio = static_cast<double>(definition.ratio);
    writer.hold(MeasureKind::Pulley, static_cast<double>(definition.length));
}

void writeLaws(Writer& writer, const JointDefinition& definition) {
    const auto reference = static_cast<double>(definition.referenceAngle);
    const auto hertz = static_cast<double>(definition.hertz),
               ratio = static_cast<double>(definition.dampingRatio);
    switch (definition.kind) {
        case JointKind::Distance:
            if (!definition.spring.on && !definition.limit.on)
                writer.hold(MeasureKind::Length, static_cast<double>(definition.length), hertz, ratio);
            writer.value(MeasureKind::Length, 0.0, true);
            break;
        case JointKind::Revolute:
            writer.point(hertz, ratio);
            writer.value(MeasureKind::Angle, reference, true);
            break;
        case JointKind::Weld:
            writer.point(hertz, ratio);
            writer.hold(MeasureKind::Angle, reference, hertz, ratio);
            break;
        case JointKind::Prismatic:
            writer.hold(MeasureKind::Across, 0.0);
            writer.hold(MeasureKind::Angle, reference);
            writer.value(MeasureKind::Along, 0.0, true);
            break;
        case JointKind::Wheel:
            writer.hold(MeasureKind::Across, 0.0);
            writer.value(MeasureKind::Along, 0.0, false);
            if (definition.motor.on) writer.drive(MeasureKind::Angle);
            break;
        case JointKind::Motor: writeMotor(writer, definition); break;
        case JointKind::Pulley: writePulley(writer, definition); break;
        default: break;
    }
}

}  // namespace

Result<std::vector<Law>> lawsOf(const physics::World& world) {
    std::vector<Law> laws;
    for (std::uint32_t j = 0; j < world.joints.size(); ++j) {
        if (world.joints.hot[j].bodyA == physics::kNone) continue;
        const JointDefinition& definition = world.joints.definition[j];
        if (definition.kind == JointKind::Gear || definition.kind == JointKind::Mouse) {
            const char* const name = definition.kind == JointKind::Gear ? "gear" : "mouse";
            return Error{format("reference: joint {}", j), format("{} joints are not supported", name),
                         "remove the joint, or compare with a run with a smaller step"};
        }
        if (definition.breakForce < std::numeric_limits<float>::infinity() ||
            definition.breakTorque < std::numeric_limits<float>::infinity()) {
            return Error{format("reference: joint {}", j), "breakable joints are not supported",
                         "set breakForce and breakTorque to infinity"};
        }
        Writer writer{world, j, laws};
        writeLaws(writer, definition);
    }
    return laws;
}

}  // namespace plumb::reference
