-- The hero: walks in eight directions, and comes back to where it began when a chaser catches it.
local Hero = script {
    doc = "Walks with the arrow keys or W A S D, seen from above.",
    speed = number { 84, min = 0, max = 400, unit = "px/s", doc = "Walking speed." },
    back = number { 0.7, min = 0, max = 5, unit = "s", doc = "Time until it comes back." },
    pain = sound { "assets/hurt.wav", doc = "Sound of being caught." },
}

function Hero:onCreate()
    self.home = self.transform.position
end

-- Called in every tick, 60 times a second.
function Hero:onTick()
    local way = vec(input:getAxis("Horizontal"), input:getAxis("Vertical"))
    if self.away then way = vec(0, 0) end
    if way:length() > 1 then way = way:normalized() end -- not faster along diagonals
    self.rigidBody.velocity = way * self.speed
    if way.x ~= 0 then self.sprite.flipX = way.x < 0 end
    setParameter(self.entity, "speed", way:length() * self.speed) -- above 12 the animation runs
end

-- Emitted by chaser.lua.
function Hero:onEvent_caught()
    if self.away then return end
    self:vanish()
    if self.pain then playSound(self.pain) end
    shakeCamera(3, 0.3)
    self:comeBack()
end

function Hero:comeBack()
    wait(self.back) -- the game goes on meanwhile
    teleport(self.entity, self.home)
    setParameter(self.entity, "dead", false)
    self.away = false
end

-- A saved game does not contain functions that wait: they begin again.
function Hero:onLoad()
    if self.away and not self.won then self:comeBack() end
end

-- Emitted by exit.lua.
function Hero:onEvent_won()
    self.won = true
    self:vanish()
end

function Hero:vanish()
    self.away = true
    setParameter(self.entity, "dead", true)
end

return Hero
