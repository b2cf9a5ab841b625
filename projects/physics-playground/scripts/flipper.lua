-- A flipper: a kinematic body that turns up while the player holds its key, and back afterwards.
local Flipper = script {
    doc = "Turns up while the player holds an input action.",
    action = text { "FlipLeft", doc = "Input action that lifts it, by its name in project.json." },
    lift = number { 0.94, min = -1.6, max = 1.6, unit = "rad", doc = "How far it turns; above 0 clockwise." },
    speed = number { 18, min = 1, max = 60, unit = "rad/s", doc = "How fast it turns." },
    noise = sound { "assets/step.wav", doc = "Played when it goes up." },
}

function Flipper:onCreate()
    self.rest = self.transform.rotation -- as it is placed in the scene
end

function Flipper:onTick(dt)
    local goal = self.rest
    if input:isHeld(self.action) then goal = goal + self.lift end
    if input:isPressed(self.action) and self.noise then playSound(self.noise, 0.5) end
    local needed = (goal - self.transform.rotation) / dt -- reaches the goal within this tick
    self.kinematicBody.angularVelocity = math.max(-self.speed, math.min(needed, self.speed))
end

return Flipper
