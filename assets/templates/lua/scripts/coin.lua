-- A coin: it gives points when the player touches it, vanishes, and comes back later.
local Coin = script {
    doc = "A coin that the player takes.",
    points = integer { 1, min = 1, doc = "Points that the coin gives." },
    away = number { 3, min = 0.5, unit = "s", doc = "Time until the coin comes back." },
    noise = sound { doc = "Sound of taking the coin." },
}

function Coin:onCreate()
    self.home = self.transform.position
    self.tint = self.sprite.tint
end

-- The coin's collider is a trigger: others pass through it.
function Coin:onTriggerEnter(other)
    if self.taken or not other:has("Player") then return end
    self.taken = true
    emit("score", self.points)
    if self.noise then playSound(self.noise) end
    tween(self.transform, { position = self.home - vec(0, 24) }, 0.3, "quadOut")
    tween(self.sprite, { tint = "#ffffff00" }, 0.3)
    self:comeBack()
end

function Coin:comeBack()
    wait(self.away) -- the game goes on meanwhile
    self.transform.position = self.home
    tween(self.sprite, { tint = self.tint }, 0.2)
    self.taken = false
end

-- A saved game does not contain functions that wait: they begin again.
function Coin:onLoad()
    if self.taken then self:comeBack() end
end

return Coin
