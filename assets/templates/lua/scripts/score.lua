-- Counts the points. The Label of the entity shows them: its text contains {score}.
local Score = script {
    doc = "Counts the points that coins give.",
    points = integer { 0, min = 0, doc = "Points at the start." },
}

function Score:onCreate()
    self:show()
end

-- Called when a script emits the event "score".
function Score:onEvent_score(points)
    self.points = self.points + points
    self:show()
end

function Score:show()
    showText("score", self.points)
end

return Score
