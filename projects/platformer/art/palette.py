"""The one palette of Wickwood: 32 colours in hue-shifted ramps, darkest first.

Dusk in a wood. Shadows lean to violet, light leans to the lantern's yellow, so every ramp ends in the
same warm family and any two neighbours look right side by side. Each colour has a name and one letter;
the letters are what the ASCII drawings in the other files are made of.
"""

COLORS = {
    # letter: (name, rgb)
    # night to dawn: outlines, far hills, sky
    "k": ("ink", 0x140F23),
    "n": ("night", 0x221A3B),
    "p": ("plum", 0x38285A),
    "u": ("dusk", 0x573A76),
    "m": ("mauve", 0x80508C),
    "q": ("rose", 0xB16C97),
    "h": ("blush", 0xDD919A),
    "f": ("peach", 0xF6BD9A),
    "e": ("cream", 0xFDEEC5),
    # leaves
    "1": ("pine", 0x12343B),
    "2": ("fern", 0x1D5A4E),
    "3": ("moss", 0x3D8A53),
    "4": ("leaf", 0x7BB857),
    "5": ("lime", 0xC2DD6B),
    # earth and wood
    "b": ("root", 0x2C1B2E),
    "B": ("bark", 0x4B2D3A),
    "l": ("clay", 0x754A45),
    "s": ("soil", 0xA26C50),
    "S": ("sand", 0xCB9A66),
    # flame and brass
    "r": ("rust", 0x8C3B2E),
    "a": ("brass", 0xC9772E),
    "g": ("gold", 0xF0A93B),
    "y": ("flame", 0xFFD866),
    "Y": ("glow", 0xFFF5B8),
    # the cloak, and whatever hurts
    "w": ("wine", 0x6B1F3F),
    "c": ("crimson", 0xA92F4A),
    "o": ("coral", 0xE2574F),
    # stone, water, snow
    "A": ("abyss", 0x162340),
    "d": ("slate", 0x2B4468),
    "t": ("steel", 0x4A7392),
    "i": ("ice", 0x82ADB9),
    "z": ("frost", 0xC5E2D8),
}

RGBA = {letter: (rgb << 8 | 0xFF) for letter, (_, rgb) in COLORS.items()}
LETTER_OF = {name: letter for letter, (name, _) in COLORS.items()}
CLEAR = 0


def color(name_or_letter, alpha=255):
    """A colour by name or letter as 0xRRGGBBAA."""
    letter = LETTER_OF.get(name_or_letter, name_or_letter)
    return RGBA[letter] & 0xFFFFFF00 | alpha
