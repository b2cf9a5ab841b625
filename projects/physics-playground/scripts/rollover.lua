-- A rollover: lights up when the ball rolls over it. All that have the same parent raise the multiplier.
local Rollover = script {
    doc = "Lights up when the ball rolls over it.",
    points = integer { 50, min = 0, doc = "Points each time." },
    light = color { "#f6b352ff", doc = "Color while it is lit." },
    isLit = boolean { false, doc = "It is lit at the start." },
    noise = sound { "assets/step.wav", doc = "Played when the ball rolls over it." },
}

function Rollover:onCreate()
    self.tint = self.sprite.tint
end

function Rollover:setLit(isLit)
    self.isLit = isLit
    tween(self.sprite, { tint = isLit and self.light or self.tint }, 0.2)
end

function Rollover:onTriggerEnter()
    self:setLit(true)
    if self.noise then playSound(self.noise, 0.5) end
    emit("score", self.points, self.transform.position)
    local lanes = self:parent():children()
    for _, lane in ipairs(lanes) do
        if not lane.rollover.isLit then return end
    end
    emit("multiply")
    for _, lane in ipairs(lanes) do lane.rollover:setLit(false) end
end

return Rollover
