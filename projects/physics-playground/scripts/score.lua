-- The score: other scripts emit the event "score" with points and the place where they were made.
local Score = script {
    doc = "Counts points. Labels with {score}, {best} or {times} in their text show them.",
    points = integer { 0, min = 0, doc = "Points in this game." },
    best = integer { 0, min = 0, doc = "Most points in a game so far." },
    times = integer { 1, min = 1, doc = "Points are multiplied by this." },
    most = integer { 5, min = 1, max = 20, doc = "Largest multiplier." },
    popup = prefab { "prefabs/points.prefab.json", doc = "Label that shows points where they are made." },
}

function Score:onEvent_score(points, place)
    points = points * self.times
    self.points = self.points + points
    self.best = math.max(self.best, self.points)
    self:show()
    local popup = spawn(self.popup, place, { Label = { text = "+" .. points } })
    tween(popup.transform, { position = place - vec(0, 40) }, 0.8, "quadOut")
end

function Score:onEvent_multiply()
    self.times = math.min(self.times + 1, self.most)
    self:show()
end

function Score:onEvent_ballServed()
    self.times = 1
    self:show()
end

function Score:onEvent_gameStarted()
    self.points = 0
end

function Score:show()
    showText("score", self.points)
    showText("best", self.best)
    showText("times", self.times)
end

return Score
