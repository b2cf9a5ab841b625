"""The tunes: sixteen bars each for three voices and a drum, that end where they begin. 8 bits, 22050 Hz."""

from sounds import RATE, Hiss, shape, wav

NAMES = {"c": 0, "d": 2, "e": 4, "f": 5, "g": 7, "a": 9, "b": 11}
# A tune is lines of bars; a note is its name, '#' or '-' (flat), the octave and how many eighths it takes.
# 'r' rests. Chords are played as broken triads by the second voice.
WOOD = {
    "beat": 0.222, "lead": "pulse", "chords": "Am F C G  Am F Dm E  F G Em Am  F G E Am",
    "melody": """
        a4:3 b4 c5:2 e5:2 | d5:3 c5 a4:4 | g4:3 a4 c5:2 g5:2 | e5:3 d5 b4:4 |
        a4:3 b4 c5:2 e5:2 | f5:3 e5 c5:4 | d5:2 f5:2 a5:2 f5:2 | e5:3 d5 b4:2 g#4:2 |
        a5:3 g5 f5:2 e5:2 | d5:3 e5 g5:4 | e5:3 d5 b4:2 g4:2 | a4:2 c5:2 e5:4 |
        f5:3 e5 d5:2 c5:2 | b4:3 c5 d5:2 g5:2 | e5:2 g#4:2 b4:2 d5:2 | c5:2 b4:2 a4:4""",
    "drums": "k.h.s.hhk.hks.h.",
}
CAVE = {
    "beat": 0.226, "lead": "triangle", "chords": "Dm Dm Bb A  Dm Gm Bb A  Gm Dm Bb F  Gm Bb A Dm",
    "melody": """
        d5:4 r:2 a4:2 | f4:4 e4:2 d4:2 | d5:3 e5 f5:4 | e5:6 r:2 |
        a5:4 r:2 f5:2 | g5:3 f5 d5:4 | f5:2 d5:2 b-4:4 | a4:6 c#5:2 |
        d5:2 g5:2 b-5:4 | a5:3 g5 f5:4 | d5:2 f5:2 b-5:4 | a5:4 c5:4 |
        b-4:2 d5:2 g5:4 | f5:3 d5 b-4:4 | c#5:2 e5:2 a5:4 | d5:8""",
    "drums": "k...h...k..ks...",
}
CHORDS = {"Am": "a c e", "F": "f a c", "C": "c e g", "G": "g b d", "Dm": "d f a", "E": "e g# b", "Em": "e g b",
          "Bb": "b- d f", "A": "a c# e", "Gm": "g b- d"}


def semitone(name):
    return NAMES[name[0]] + name.count("#") - name.count("-")


def pitch(name, octave):
    return 440.0 * 2 ** ((semitone(name) - 9) / 12 + octave - 4)


def notes_of(melody):
    """(pitch or 0, eighths) of each note."""
    for word in melody.replace("|", " ").split():
        name, _, length = word.partition(":")
        yield (0.0 if name == "r" else pitch(name[:-1], int(name[-1]))), int(length or 1)


def play(track, start, seconds, kind, hertz, volume, fade):
    """Adds a note to the track; it goes round at the end, so that the loop has no seam."""
    phase, first = 0.0, int(start * RATE)
    count = int(seconds * RATE)
    for n in range(count):
        phase += hertz / RATE
        loud = volume * min(1.0, n / 60, (count - n) / 200) * (1 - fade * n / count)
        track[(first + n) % len(track)] += loud * shape(kind, phase)


def drum(track, start, kind):
    hiss, first = Hiss(), int(start * RATE)
    length, volume = {"k": (0.11, 0.34), "s": (0.12, 0.15), "h": (0.035, 0.07)}[kind]
    count, phase = int(length * RATE), 0.0
    for n in range(count):
        t = n / count
        phase += (150 * (1 - t) ** 2 + 45) / RATE
        value = shape("triangle", phase) if kind == "k" else hiss.next(9000 if kind == "h" else 5200)
        track[(first + n) % len(track)] += volume * (1 - t) ** 2 * value


def tune(piece):
    beat = piece["beat"]
    chords = piece["chords"].split()
    track = [0.0] * int(len(chords) * 8 * beat * RATE)
    at = 0
    for hertz, eighths in notes_of(piece["melody"]):
        if hertz:
            play(track, at * beat, eighths * beat * 0.94, piece["lead"], hertz, 0.2, 0.6)
            play(track, (at + 1.5) * beat, eighths * beat * 0.9, piece["lead"], hertz * 1.003, 0.055, 0.8)
        at += eighths
    for bar, chord in enumerate(chords):
        triad = CHORDS[chord].split()
        for k in range(8):
            name = triad[(0, 1, 2, 1, 0, 2, 1, 2)[k]]
            play(track, (bar * 8 + k) * beat, beat * 0.8, "thin", pitch(name, 3 + (k > 3)), 0.07, 0.8)
        root = triad[0]
        for k, (start, length) in enumerate(((0, 3), (3, 1), (4, 3), (7, 1))):
            hertz = pitch(root if k != 3 else triad[2], 2)
            play(track, (bar * 8 + start) * beat, length * beat * 0.9, "triangle", hertz, 0.26, 0.3)
        for k, kind in enumerate(piece["drums"]):
            if kind != ".":
                drum(track, (bar * 8 + k / 2) * beat, kind)
    loudest = max(abs(s) for s in track)
    return [s / loudest * 0.92 for s in track]


def build():
    return {"music_wood.wav": wav(tune(WOOD), wide=False), "music_cave.wav": wav(tune(CAVE), wide=False)}
