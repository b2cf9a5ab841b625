-- Drops things where the mouse is. The oldest ones vanish, so that there are never too many.
local Dropper = script {
    doc = "Drops things at the mouse when the player asks for it.",
    action = text { "Drop", doc = "Input action that drops one, by its name in project.json." },
    things = list(prefab {}, 8),
    most = integer { 40, min = 1, max = 500, doc = "Number of things that may lie about." },
    noise = sound { "assets/step.wav", doc = "Sound of dropping one." },
}

function Dropper:onCreate()
    self.dropped = {}
    self.count = 0
end

function Dropper:onTick()
    if not input:isPressed(self.action) then return end
    local slot = self.count % self.most
    local oldest = self.dropped[slot]
    if oldest and oldest:isAlive() then oldest:destroy() end
    self.dropped[slot] = spawn(self.things[self.count % #self.things + 1], mouseInWorld())
    self.count = self.count + 1
    if self.noise then playSound(self.noise) end
end

return Dropper
