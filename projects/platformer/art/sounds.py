"""Every sound of the game, made from square waves, triangles and noise. Mono, 22050 Hz."""

import math

from art_files import RATE, late, mix, wav


class Hiss:
    """Noise from a shift register, as the old consoles made it."""

    def __init__(self):
        self.register, self.phase, self.value = 0x7FFF, 0.0, 1.0

    def next(self, frequency):
        self.phase += frequency / RATE
        while self.phase >= 1.0:
            self.phase -= 1.0
            bit = (self.register ^ self.register >> 1) & 1
            self.register = self.register >> 1 | bit << 14
            self.value = 1.0 if self.register & 1 else -1.0
        return self.value


def shape(kind, phase):
    phase -= math.floor(phase)
    if kind == "triangle":
        return 4 * abs(phase - 0.5) - 1
    if kind == "sine":
        return math.sin(2 * math.pi * phase)
    return 1.0 if phase < {"square": 0.5, "pulse": 0.25, "thin": 0.125}[kind] else -1.0


def tone(kind, pitches, seconds, volume=0.5, attack=0.005, decay=3.0, vibrato=0.0):
    """A note that slides through `pitches` (Hz) in equal parts and dies away."""
    count, phase, result, hiss = int(seconds * RATE), 0.0, [], Hiss()
    for n in range(count):
        t = n / count
        place = t * (len(pitches) - 1) if len(pitches) > 1 else 0.0
        low = min(int(place), max(len(pitches) - 2, 0))
        high = min(low + 1, len(pitches) - 1)
        pitch = pitches[low] * (pitches[high] / pitches[low]) ** (place - low)
        pitch *= 1 + vibrato * math.sin(n / RATE * 38)
        phase += pitch / RATE
        loud = min(1.0, n / RATE / attack) * (1 - t) ** (decay / 2)
        result.append(volume * loud * (hiss.next(pitch) if kind == "noise" else shape(kind, phase)))
    return result


def steps(kind, pitches, each, last, volume=0.4, decay=1.0):
    """Notes one after the other, the last one longer."""
    result = []
    for k, pitch in enumerate(pitches):
        result += tone(kind, [pitch], last if k == len(pitches) - 1 else each, volume, decay=3 if k == len(pitches) - 1
                       else decay)
    return result


def softened(samples, amount=0.5):
    """A low pass of one pole, to take the edge off."""
    value, result = 0.0, []
    for s in samples:
        value += (s - value) * amount
        result.append(value)
    return result


def effects():
    return {
        "jump": softened(tone("square", [230, 330, 520], 0.16, 0.35, decay=2)),
        "land": softened(mix(tone("noise", [2400, 500], 0.07, 0.3), tone("triangle", [110, 60], 0.08, 0.5)), 0.4),
        "step": softened(tone("noise", [3200, 1600], 0.03, 0.16), 0.4),
        "coin": mix(steps("pulse", [1046.5, 1568.0], 0.06, 0.32, 0.26), late(0.06, tone("sine", [3136], 0.3, 0.14))),
        "spring": softened(mix(tone("triangle", [140, 420, 300, 760, 620, 1100], 0.36, 0.6, decay=2),
                               tone("square", [70, 210, 380], 0.2, 0.16))),
        "hurt": softened(mix(tone("square", [420, 180, 90], 0.28, 0.34), tone("noise", [5000, 800], 0.2, 0.26))),
        "vanish": softened(mix(tone("triangle", [660, 494, 330, 165, 82], 0.55, 0.55, decay=2, vibrato=0.03),
                               tone("noise", [1200, 6000], 0.5, 0.12, attack=0.2))),
        "checkpoint": mix(steps("triangle", [523.3, 659.3, 784.0, 1046.5], 0.07, 0.5, 0.45),
                          late(0.21, tone("sine", [2093], 0.5, 0.14)), tone("noise", [900, 5200], 0.3, 0.08)),
        "goal": mix(steps("pulse", [523.3, 659.3, 784.0, 1046.5, 784.0, 1046.5, 1318.5], 0.09, 0.8, 0.26),
                    steps("triangle", [261.6, 329.6, 392.0, 523.3, 392.0, 523.3, 659.3], 0.09, 0.8, 0.4)),
        "stomp": softened(mix(tone("noise", [1800, 300], 0.12, 0.36), tone("square", [300, 90], 0.14, 0.3),
                              late(0.05, tone("triangle", [240, 620], 0.14, 0.4)))),
        "select": softened(tone("triangle", [880, 988], 0.05, 0.4, decay=2)),
        "confirm": steps("pulse", [659.3, 987.8, 1318.5], 0.05, 0.25, 0.26),
    }


def build():
    return {f"{name}.wav": wav(samples) for name, samples in effects().items()}
