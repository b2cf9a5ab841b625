-- The score. Labels with {coins}, {all} or {message} in their text show it.
local Score = script {
    doc = "Counts the coins, and tells the gate when all are taken.",
}

function Score:onCreate()
    self.coins = 0
    self.all = #world:query("Coin")
    self.begin = world:tick()
    showText("all", self.all)
    showText("message", "")
    self:show()
end

-- Emitted by coin.lua.
function Score:onEvent_coin()
    self.coins = self.coins + 1
    self:show()
    if self.coins < self.all then return end
    emit("allCoins")
    showText("message", "The gate is open")
end

-- Emitted by exit.lua.
function Score:onEvent_won()
    local seconds = (world:tick() - self.begin) // 60
    showText("message", "Out in " .. seconds .. " s. R: again")
end

function Score:show()
    showText("coins", self.coins)
end

return Score
