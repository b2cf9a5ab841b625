#include "scene/physics/game_errors.hpp"

#include <cctype>
#include <charconv>
#include <span>
#include <string>
#include <system_error>

#include "core/text.hpp"

namespace plumb {
namespace {

/// How a refused argument of the physics is called in a game.
struct ErrorRow {
    const char* where;             ///< Error::where of the physics; with a * for all that begin like this
    const char* field;             ///< with the component, unless the caller knows it
    const char* unit = "";         ///< unit of the game; of points and sizes the text has it
    int power = 0;                 ///< of the length in the unit: px is 1
    float factor = 1.0f;           ///< of the physics' value to the field, e.g. 2 for half a width
    const char* remedy = nullptr;  ///< null: that of the physics
};

constexpr const char* kMove = "move it back to the scene; positions so far away are not simulated";
constexpr const char* kResize =
    "use a size within this range; the scale of the Transform is included in what was found";
constexpr const char* kPoints = "move the points, or the entity instead of its points";

constexpr ErrorRow kRows[] = {
    {"BodyDefinition.position", "Transform.position", "px", 1, 1.0f, kMove},
    {"setPosition", "Transform.position", "px", 1, 1.0f, kMove},
    {"moveTo", "Transform.position", "px", 1, 1.0f, kMove},
    {"CharacterController position", "Transform.position", "px", 1, 1.0f, kMove},
    {"CharacterController::setPosition", "Transform.position", "px", 1, 1.0f, kMove},
    {"BodyDefinition.angle", "Transform.rotation", "rad"},
    {"setPosition angle", "Transform.rotation", "rad"},
    {"moveTo angle", "Transform.rotation", "rad"},
    {"setVelocity", "velocity", "px/s", 1},
    {"setAngularVelocity", "angularVelocity", "rad/s"},
    {"setAcceleration", "RigidBody.acceleration", "px/s2", 1},
    {"setGravityScale", "RigidBody.gravityScale"},
    {"setDrag linear", "RigidBody.linearDrag", "1/s"},
    {"setDrag angular", "RigidBody.angularDrag", "1/s"},
    {"setMass", "RigidBody.mass", "kg"},
    {"PhysicsSettings.gravity", "physics.gravity of project.json", "px/s2", 1},
    {"ScenePhysics.gravity", "ScenePhysics.gravity", "px/s2", 1},
    {"CharacterController::setVelocity", "CharacterController.velocity", "px/s", 1},
    {"CharacterDefinition.steepest", "CharacterController.steepest", "rad"},
    {"CharacterDefinition.stepHeight", "CharacterController.stepHeight", "px", 1},
    {"CharacterDefinition.snap", "CharacterController.snap", "px", 1},
    {"CharacterDefinition.cornerCorrection", "CharacterController.cornerCorrection", "px", 1},
    {"CharacterDefinition.gravityScale", "CharacterController.gravityScale"},
    {"CharacterDefinition.pushForce", "CharacterController.pushForce", "kg px/s2", 1},
    {"CharacterDefinition.pushMass", "CharacterController.pushMass", "kg"},
    {"CharacterDefinition.weight", "CharacterController.weight", "kg"},
    {"box.a", "offset", "px", 1, 1.0f, kPoints},
    {"box.b.x", "width", "px", 1, 2.0f, kResize},
    {"box.b.y", "height", "px", 1, 2.0f, kResize},
    {"box.radius", "rounding", "px", 1, 1.0f, kResize},
    {"circle.a", "offset", "px", 1, 1.0f, kPoints},
    {"circle.radius", "radius", "px", 1, 1.0f, kResize},
    {"capsule.a", "offset", "px", 1, 1.0f, kPoints},
    {"capsule.b", "offset", "px", 1, 1.0f, kPoints},
    {"capsule.radius", "width and height", "px", 1, 2.0f, kResize},
    {"polygon.*", "points", "px", 1, 1.0f, kPoints},
    {"createPolygon radius", "rounding", "px", 1, 1.0f, kResize},
    {"segment.*", "points", "px", 1, 1.0f, kPoints},
    {"ShapeDefinition.density", "density"},
    {"ShapeDefinition.friction", "friction"},
    {"ShapeDefinition.bounciness", "bounciness"},
    {"ShapeDefinition.surfaceSpeed", "surfaceSpeed", "px/s", 1},
    {"JointDefinition.anchorA", "otherAnchor", "px", 1},
    {"JointDefinition.anchorB", "anchor", "px", 1},
    {"JointDefinition.axis*", "axis"},
    {"JointDefinition.length", "length", "px", 1},
    {"JointDefinition.target", "target", "px", 1},
    {"JointDefinition.offset", "offset", "px", 1},
    {"JointDefinition.ratio", "ratio"},
    {"JointDefinition.maxForce", "maxForce", "kg px/s2", 1},
    {"JointDefinition.breakForce", "breakForce", "kg px/s2", 1},
    {"JointDefinition.maxTorque", "maxTorque", "kg px2/s2", 2},
    {"JointDefinition.spring.hertz", "hertz", "Hz"},
    {"JointDefinition.hertz", "hertz", "Hz"},
    {"JointDefinition.spring.dampingRatio", "dampingRatio"},
    {"JointDefinition.dampingRatio", "dampingRatio"},
    {"createRope from", "Transform.position", "px", 1, 1.0f, kMove},
    {"createRope to", "Rope.to", "px", 1, 1.0f, kMove},
    {"createCloth corner", "Transform.position", "px", 1, 1.0f, kMove},
    {"createCloth size", "Cloth.size", "px", 1, 1.0f, kResize},
    {"createJelly place", "Transform.position", "px", 1, 1.0f, kMove},
    {"createJelly point", "Jelly.radius", "px", 1, 1.0f, kResize},
    {"SoftMaterial.mass", "mass", "kg"},
    {"SoftMaterial.radius", "radius", "px", 1},
    {"FieldDefinition.place", "Transform.position", "px", 1, 1.0f, kMove},
    {"FieldDefinition.half.x", "width", "px", 1, 2.0f, kResize},
    {"FieldDefinition.half.y", "height", "px", 1, 2.0f, kResize},
    {"FieldDefinition.radius", "radius", "px", 1, 1.0f, kResize},
    {"FieldDefinition.acceleration", "acceleration", "px/s2", 1},
    {"FieldDefinition.velocity", "velocity", "px/s", 1},
};
/// Of joints that turn these are angles.
constexpr ErrorRow kTravelRows[] = {
    {"JointDefinition.limit.lower", "lower", "px", 1},
    {"JointDefinition.limit.upper", "upper", "px", 1},
    {"JointDefinition.motor.speed", "motorSpeed", "px/s", 1},
};
constexpr ErrorRow kTurnRows[] = {
    {"JointDefinition.limit.lower", "lower", "rad"},
    {"JointDefinition.limit.upper", "upper", "rad"},
    {"JointDefinition.motor.speed", "motorSpeed", "rad/s"},
};

const ErrorRow* rowOf(std::span<const ErrorRow> rows, std::string_view where) {
    for (const ErrorRow& row : rows) {
        const std::string_view name = row.where;
        const bool isFamily = name.back() == '*';
        if (isFamily ? startsWith(where, name.substr(0, name.size() - 1)) : where == name) return &row;
    }
    return nullptr;
}

/// True if a text begins with the unit m.
bool beginsWithMetres(std::string_view text) {
    return startsWith(text, " m") &&
           (text.size() == 2 || std::isalnum(static_cast<unsigned char>(text[2])) == 0);
}
bool hasMetres(std::string_view text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (beginsWithMetres(text.substr(i))) return true;
    }
    return false;
}

/// Multiplies all numbers of a text, and names their unit px where it was m.
std::string inPixels(std::string_view text, float factor) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const bool begins = result.empty() || std::isalnum(static_cast<unsigned char>(result.back())) == 0;
        double number = 0.0;
        const auto read = std::from_chars(text.data() + i, text.data() + text.size(), number);
        if (!begins || read.ec != std::errc{}) {
            result += text[i++];
            continue;
        }
        result += shortestText(static_cast<float>(number) * factor);
        i = static_cast<std::size_t>(read.ptr - text.data());
        if (!beginsWithMetres(text.substr(i))) continue;
        result += " px";
        i += 2;
    }
    return result;
}

/// Outlines: their errors count points, too, so that only numbers with a unit are lengths.
Error outlineError(const Error& error, std::string_view component, PixelScale scale) {
    const bool isForProgrammers = error.remedy.find("metres") != std::string::npos;
    const bool isTooSmall = error.remedy.find(" mm ") != std::string::npos;
    return {format("{}.points", component.empty() ? "PolygonCollider" : component),
            hasMetres(error.what) ? inPixels(error.what, scale.pixels) : error.what,
            isForProgrammers ? kPoints
            : isTooSmall     ? "make it larger"
                             : error.remedy};
}

}  // namespace

Error gameError(const Error& error, std::string_view component, PixelScale scale) {
    if (error.where == "decompose" || error.where == "hull" || startsWith(error.where, "createChain"))
        return outlineError(error, component, scale);
    const bool turns = component == "RevoluteJoint" || component == "WheelJoint";
    const ErrorRow* row = rowOf(kRows, error.where);
    if (row == nullptr) row = rowOf(turns ? std::span{kTurnRows} : std::span{kTravelRows}, error.where);
    if (row == nullptr) return error;
    Error result = error;
    const bool isKnown =
        component.empty() || std::string_view{row->field}.find('.') != std::string_view::npos;
    result.where = isKnown ? std::string{row->field} : format("{}.{}", component, row->field);
    if (row->unit[0] != '\0') result.where += format(" ({})", row->unit);
    if (row->power != 0)
        result.what =
            inPixels(error.what, row->factor * (row->power == 2 ? scale.pixels : 1.0f) * scale.pixels);
    if (row->remedy != nullptr) result.remedy = row->remedy;
    return result;
}

}  // namespace plumb
