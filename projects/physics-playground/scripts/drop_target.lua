-- A drop target: falls when it is hit, and comes back later. Targets with the same parent are a bank.
local DropTarget = script {
    doc = "Falls when the ball hits it, and comes back after a while.",
    points = integer { 250, min = 0, doc = "Points for a hit." },
    bonus = integer { 2500, min = 0, doc = "Points when the whole bank has fallen." },
    away = number { 12, min = 0.5, max = 60, unit = "s", doc = "Time until it comes back." },
    fallen = color { "#343a5c60", doc = "Color while it has fallen." },
    noise = sound { "assets/choose.wav", doc = "Played when it falls." },
}

function DropTarget:onCreate()
    self.tint = self.sprite.tint
end

-- A target that has fallen is a trigger: the ball passes through it.
function DropTarget:setFallen(fallen)
    self.boxCollider.isTrigger = fallen
    tween(self.sprite, { tint = fallen and self.fallen or self.tint }, 0.15)
end

function DropTarget:hasBankFallen()
    for _, target in ipairs(self:parent():children()) do
        if not target.boxCollider.isTrigger then return false end
    end
    return true
end

function DropTarget:onCollisionEnter(ball, contact)
    self:setFallen(true)
    if self.noise then playSound(self.noise, 0.5) end
    emit("score", self:hasBankFallen() and self.bonus or self.points, contact.point)
    self:comeBack()
end

function DropTarget:comeBack()
    wait(self.away) -- this function goes on later; the game does not stop
    waitUntil(function() return not self.isCovered end)
    self:setFallen(false)
end

-- A saved game does not contain functions that wait: they begin again.
function DropTarget:onLoad()
    if self.boxCollider.isTrigger then self:comeBack() end
end

function DropTarget:onTriggerEnter() self.isCovered = true end
function DropTarget:onTriggerExit() self.isCovered = false end

return DropTarget
