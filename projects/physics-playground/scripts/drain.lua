-- The drain below the flippers: a trigger that says when a ball is lost.
local Drain = script {
    doc = "Emits the event ballLost when a body falls into its trigger.",
    noise = sound { "assets/blast.wav", doc = "Played when the ball is lost." },
}

function Drain:onTriggerEnter()
    if self.noise then playSound(self.noise, 0.3) end
    emit("ballLost")
end

return Drain
