-- A character that the player moves. The inspector shows the properties, scenes save them.
local Player = script {
    doc = "A character that walks with the arrow keys and jumps with Space.",
    speed = number { 200, min = 0, max = 2000, unit = "px/s", doc = "Walking speed." },
    jump = number { 420, min = 0, max = 2000, unit = "px/s", doc = "Speed at the start of a jump." },
    below = number { 400, unit = "px", doc = "Comes back when it falls below this y." },
}

function Player:onCreate()
    self.home = self.transform.position
end

-- Called in every tick, 60 times a second.
function Player:onTick()
    local body = self.rigidBody
    local velocity = vec(input:getAxis("Horizontal") * self.speed, body.velocity.y)
    if body.grounded and input:isPressed("Jump") then
        velocity = vec(velocity.x, -self.jump)
    end
    body.velocity = velocity
    if self.transform.y > self.below then self:comeBack() end
end

function Player:comeBack()
    teleport(self.entity, self.home)
    self.rigidBody.velocity = vec(0, 0)
    print("The player fell and was moved back")
end

return Player
