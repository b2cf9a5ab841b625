-- The way out: dark and shut until all coins are taken.
local Exit = script {
    doc = "A gate that opens when all coins are taken, and ends the game.",
    dark = color { "#3a4468ff", doc = "Color multiplied with the picture while it is shut." },
    opens = sound { "assets/checkpoint.wav", doc = "Sound of opening." },
    ends = sound { "assets/goal.wav", doc = "Sound of going through." },
}

function Exit:onCreate()
    self.sprite.tint = self.dark
    self.animator.playing = false
end

-- Emitted by score.lua.
function Exit:onEvent_allCoins()
    self.open = true
    self.animator.playing = true
    tween(self.sprite, { tint = "#ffffffff" }, 0.5)
    if self.opens then playSound(self.opens) end
end

function Exit:onTriggerEnter(other)
    if not self.open or not other:has("Hero") then return end
    self.open = false
    emit("won")
    if self.ends then playSound(self.ends) end
end

return Exit
