-- A driven wheel: the player sets the speed of the motor of its joint.
local Wheel = script {
    doc = "Drives the wheel with the arrow keys or A and D. Needs a WheelJoint.",
    speed = number { 18, min = 0, max = 100, unit = "rad/s", doc = "Speed of the motor." },
}

-- Called in every tick, 60 times a second.
function Wheel:onTick()
    local axis = input:getAxis("Horizontal")
    self.wheelJoint.motor = axis ~= 0 -- rolls freely otherwise
    self.wheelJoint.motorSpeed = axis * self.speed
end

return Wheel
