-- A plunger: a kinematic body that the player pulls and lets go, and that pushes the ball ahead of it.
local Plunger = script {
    doc = "Goes down while the player holds an input action, and springs back afterwards.",
    action = text { "Jump", doc = "Input action that pulls it, by its name in project.json." },
    travel = number { 44, min = 1, max = 200, unit = "px", doc = "How far down it goes." },
    pull = number { 0.8, min = 0.1, max = 5, unit = "s", doc = "Time until it is all the way down." },
    speed = number { 1400, min = 0, max = 3000, unit = "px/s", doc = "Speed of its spring then." },
    noise = sound { "assets/jump.wav", doc = "Played when it springs back." },
}

function Plunger:onCreate()
    self.home = self.transform.y
    self.power = 0 -- 0 to 1: how far it was pulled
end

function Plunger:onTick(dt)
    local below = self.transform.y - self.home
    local velocity
    if input:isHeld(self.action) then
        velocity = math.min(self.travel / self.pull, (self.travel - below) / dt)
        self.power = (below + velocity * dt) / self.travel
    else
        velocity = math.max(-self.power * self.speed, -below / dt)
        if input:isReleased(self.action) and self.noise then playSound(self.noise, self.power) end
    end
    self.kinematicBody.velocity = vec(0, velocity)
end

return Plunger
