-- A bumper: kicks the ball away, lights up and scores.
local Bumper = script {
    doc = "Kicks away the ball that touches it.",
    kick = number { 450, min = 0, max = 2000, unit = "px/s", doc = "Speed that the ball gains." },
    points = integer { 100, min = 0, doc = "Points for a hit." },
    light = color { "#ffffffff", doc = "Color at a hit." },
    fade = number { 0.3, min = 0, max = 5, unit = "s", doc = "Time until it has its own color again." },
    noise = sound { "assets/choose.wav", doc = "Played at a hit." },
}

function Bumper:onCreate()
    self.tint = self.sprite.tint
end

-- The normal of the contact points from this entity to the other one.
function Bumper:onCollisionEnter(ball, contact)
    local body = ball.rigidBody
    body.velocity = body.velocity + contact.normal * self.kick
    self.sprite.tint = self.light
    tween(self.sprite, { tint = self.tint }, self.fade)
    if self.noise then playSound(self.noise, 0.5) end
    emit("score", self.points, contact.point)
end

return Bumper
