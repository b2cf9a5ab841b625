-- An enemy: walks to and fro, and runs after the hero while it sees it.
local Chaser = script {
    doc = "Walks to and fro, runs after the hero, and catches it by a touch.",
    way = vector { vec(48, 0), unit = "px", doc = "From its place to the other end of its walk." },
    speed = number { 26, min = 0, max = 400, unit = "px/s", doc = "Walking speed." },
    chase = number { 58, min = 0, max = 400, unit = "px/s", doc = "Speed of running after the hero." },
    sight = number { 56, min = 0, max = 1000, unit = "px", doc = "How far it sees." },
}

function Chaser:onCreate()
    self.ends = { self.transform.position, self.transform.position + self.way }
    self.goal = 2
    self.hero = findEntity("hero")
end

function Chaser:onTick()
    local sees = self:seesHero()
    local goal = sees and self.hero.transform.position or self.ends[self.goal]
    local rest = goal - self.transform.position
    if not sees and rest:length() < 2 then self.goal = 3 - self.goal end
    self.rigidBody.velocity = rest:normalized() * (sees and self.chase or self.speed)
end

-- True if the hero is near and nothing stands between.
function Chaser:seesHero()
    local here = self.transform.position
    local way = self.hero.transform.position - here
    if way:length() > self.sight then return false end
    local hit = castRay(here, way, self.entity)
    return hit ~= nil and hit.entity == self.hero
end

function Chaser:onCollisionEnter(other)
    if other:has("Hero") then other:emit("caught") end
end

-- Blocked by a wall, or by another one: turns around.
function Chaser:onCollisionStay(other)
    if not other:has("Hero") then self.goal = 3 - self.goal end
end

return Chaser
