-- A coin: the hero takes it by a touch. Its collider is a trigger: bodies pass through it.
local Coin = script {
    doc = "A coin that the hero takes.",
    noise = sound { "assets/coin.wav", doc = "Sound of taking the coin." },
}

function Coin:onTriggerEnter(other)
    if self.taken or not other:has("Hero") then return end
    self.taken = true
    emit("coin")
    if self.noise then playSound(self.noise) end
    tween(self.transform, { position = self.transform.position - vec(0, 16) }, 0.25, "quadOut")
    tween(self.sprite, { tint = "#ffffff00" }, 0.25)
    self:vanish()
end

function Coin:vanish()
    wait(0.25)
    self:destroy()
end

-- A saved game does not contain functions that wait: they begin again.
function Coin:onLoad()
    if self.taken then self:vanish() end
end

return Coin
