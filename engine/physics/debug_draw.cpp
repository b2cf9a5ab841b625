#include "physics/debug_draw.hpp"

#include "physics/debug/picture.hpp"

namespace plumb::physics {

namespace {

struct Part {
    std::uint32_t bit;
    void (*draw)(const Picture& picture);
};

/// Large elements first, so that small ones are drawn over them.
constexpr Part kDrawnParts[] = {
    {kDrawFields, drawFields},     {kDrawBroadPhase, drawBroadPhase},
    {kDrawBounds, drawBounds},     {kDrawIslands, drawIslands},
    {kDrawShapes, drawShapes},     {kDrawTriggers, drawTriggers},
    {kDrawRest, drawRest},         {kDrawSweeps, drawSweeps},
    {kDrawJoints, drawJoints},     {kDrawCentres, drawCentres},
    {kDrawPaths, drawPaths},       {kDrawVelocities, drawVelocities},
    {kDrawNormals, drawNormals},   {kDrawImpulses, drawImpulses},
    {kDrawFriction, drawFriction}, {kDrawJointForces, drawJointForces},
    {kDrawContacts, drawContacts},
};

}  // namespace

void debugDraw(const World& world, DebugCanvas& canvas, const DebugOptions& choice) {
    const Picture picture{world, canvas, choice};
    for (const Part& part : kDrawnParts) {
        if ((choice.parts & part.bit) != 0) part.draw(picture);
    }
}

}  // namespace plumb::physics
