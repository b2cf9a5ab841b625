-- The rules: a game has some balls, and a lost ball comes back until there are none left.
local Pinball = script {
    doc = "Brings lost balls back, and starts again after the last one.",
    ball = entity { doc = "The ball. It comes back to where the scene has it." },
    balls = integer { 3, min = 1, max = 9, doc = "Number of balls in a game." },
    least = integer { 500, min = 0, doc = "A ball that made fewer points comes back once more." },
    pause = number { 1, min = 0, max = 10, unit = "s", doc = "Time until a lost ball comes back." },
}

function Pinball:onCreate()
    self.start = self.ball.transform.position
    self:play()
end

-- A saved game does not contain functions that wait: after loading, a new game begins.
function Pinball:onLoad()
    self:play()
end

-- Runs as long as the scene: handlers may wait, so a whole game is written from top to bottom.
function Pinball:play()
    while true do
        emit("gameStarted")
        local number = 1
        while number <= self.balls do
            showText("ball", number .. " of " .. self.balls)
            showText("message", "")
            self:serve(self.start)
            local before = self.score.points -- of the script Score, which the same entity has
            waitFor("ballLost")
            if self.score.points < before + self.least then
                showText("message", "Once more")
            else
                number = number + 1
            end
            wait(self.pause)
        end
        showText("message", "Game over\nSpace starts again")
        waitUntil(function() return input:isPressed("Jump") end)
    end
end

function Pinball:serve(place)
    emit("ballServed")
    teleport(self.ball, place)
    self.ball.rigidBody.velocity = vec(0, 0)
end

return Pinball
