"""Which cells make which movement, and when one movement becomes another: the *.anim.json files."""

import json


def frames(row, columns, seconds, events=None):
    result = []
    for k, column in enumerate(columns):
        frame = {"cell": [column, row], "seconds": seconds[k] if isinstance(seconds, list) else seconds}
        if events and k in events:
            frame["event"] = events[k]
        result.append(frame)
    return result


def clip(name, row, columns, seconds, loop="loop", events=None):
    return {"name": name, "loop": loop, "frames": frames(row, columns, seconds, events)}


def when(*conditions):
    return [{"parameter": parameter, "is": comparison, "value": value} for parameter, comparison, value in conditions]


def go(source, target, *conditions, after_end=False):
    step = {"from": source, "to": target, "when": when(*conditions)}
    return {**step, "afterEnd": True} if after_end else step


def states(*names):
    return [{"name": name, "clip": name} for name in names]


GROUNDED, IN_AIR = ("grounded", "==", 1), ("grounded", "==", 0)
PLAYER = {
    "image": "assets/player.png", "frameSize": [24, 24],
    "clips": [
        clip("idle", 0, [0, 1, 2, 2, 1, 0, 1, 2, 3, 1], [0.3, 0.14, 0.3, 0.1, 0.14, 0.3, 0.14, 0.3, 0.12, 0.14]),
        clip("run", 1, range(8), 0.065, events={0: "step", 4: "step"}),
        clip("jump", 2, [0, 1], [0.08, 0.2], "once"),
        clip("apex", 2, [2], 0.1),
        clip("fall", 2, [3, 4], 0.09),
        clip("land", 2, [5, 6], [0.05, 0.07], "once"),
        clip("hurt", 3, [1, 0], [0.06, 0.3], "once"),
        clip("vanish", 3, [1, 0, 2, 3, 4], [0.05, 0.1, 0.1, 0.1, 0.1], "once"),
        clip("appear", 3, [4, 5, 6, 7, 1], [0.06, 0.07, 0.07, 0.08, 0.05], "once"),
    ],
    "parameters": [{"name": "speed", "kind": "float", "default": 0}, {"name": "vy", "kind": "float", "default": 0},
                   {"name": "grounded", "kind": "bool", "default": 1}, {"name": "dead", "kind": "bool", "default": 0},
                   {"name": "hurt", "kind": "bool", "default": 0}],
    "states": states("idle", "run", "jump", "apex", "fall", "land", "vanish", "appear"),
    "transitions": [
        go("*", "vanish", ("dead", "==", 1)),
        go("vanish", "appear", ("dead", "==", 0)),
        go("appear", "idle", after_end=True),
        go("idle", "run", GROUNDED, ("speed", ">", 12)),
        go("run", "idle", GROUNDED, ("speed", "<", 12)),
        *[go(source, "jump", IN_AIR, ("vy", "<", -60)) for source in ("idle", "run", "land", "apex", "fall")],
        *[go(source, "apex", IN_AIR, ("vy", ">", -60), ("vy", "<", 60)) for source in ("idle", "run", "jump", "land")],
        *[go(source, "fall", IN_AIR, ("vy", ">", 60)) for source in ("idle", "run", "jump", "apex", "land")],
        *[go(source, "land", GROUNDED) for source in ("jump", "apex", "fall")],
        go("land", "run", GROUNDED, ("speed", ">", 60)),
        go("land", "idle", GROUNDED, after_end=True),
    ],
}
SIMPLE = {
    "bob": {"image": "assets/bob.png", "frameSize": [16, 16], "clips": [clip("spin", 0, range(8), 0.09)]},
    "spring": {
        "image": "assets/spring.png", "frameSize": [16, 16],
        "clips": [clip("rest", 0, [0], 0.2), clip("throw", 0, [1, 2, 3, 2, 3], [0.03, 0.12, 0.05, 0.05, 0.05], "once")],
        "parameters": [{"name": "pressed", "kind": "trigger", "default": 0}], "states": states("rest", "throw"),
        "transitions": [go("rest", "throw", ("pressed", "==", 1)), go("throw", "rest", after_end=True)]},
    "lamp": {
        "image": "assets/lamp.png", "frameSize": [16, 32],
        "clips": [clip("dark", 0, [0], 0.2), clip("kindle", 0, [1, 2], 0.1, "once"), clip("burn", 0, [3, 4, 5, 6], 0.14)],
        "parameters": [{"name": "active", "kind": "bool", "default": 0}], "states": states("dark", "kindle", "burn"),
        "transitions": [go("dark", "kindle", ("active", "==", 1)), go("kindle", "burn", after_end=True),
                        go("burn", "dark", ("active", "==", 0))]},
    "lamp_lit": {"image": "assets/lamp.png", "frameSize": [16, 32], "clips": [clip("burn", 0, [3, 4, 5, 6], 0.14)]},
    "gate": {
        "image": "assets/gate.png", "frameSize": [32, 48],
        "clips": [clip("glow", 0, range(6), 0.12), clip("open", 0, range(6), 0.05)],
        "parameters": [{"name": "active", "kind": "bool", "default": 0}], "states": states("glow", "open"),
        "transitions": [go("glow", "open", ("active", "==", 1))]},
    "gloomcap": {
        "image": "assets/gloomcap.png", "frameSize": [16, 16],
        "clips": [clip("walk", 0, range(4), 0.13), clip("flat", 0, [4, 5], [0.08, 0.4], "once")],
        "parameters": [{"name": "stomped", "kind": "bool", "default": 0}], "states": states("walk", "flat"),
        "transitions": [go("walk", "flat", ("stomped", "==", 1))]},
    "owlet": {
        "image": "assets/owlet.png", "frameSize": [24, 16],
        "clips": [clip("flap", 0, [0, 1, 2, 3], 0.1), clip("struck", 0, [4], 0.4, "once")],
        "parameters": [{"name": "stomped", "kind": "bool", "default": 0}], "states": states("flap", "struck"),
        "transitions": [go("flap", "struck", ("stomped", "==", 1))]},
}


def text_of(value, indent=0):
    """JSON with one short thing a line."""
    flat = json.dumps(value)
    if len(flat) + indent < 108 or not isinstance(value, (dict, list)):
        return flat
    pad = " " * (indent + 2)
    if isinstance(value, dict):
        inner = [f"{pad}{json.dumps(k)}: {text_of(v, indent + 2)}" for k, v in value.items()]
        return "{\n" + ",\n".join(inner) + "\n" + " " * indent + "}"
    return "[\n" + ",\n".join(pad + text_of(v, indent + 2) for v in value) + "\n" + " " * indent + "]"


def build():
    return {f"{name}.anim.json": (text_of({"format": 1, **what}) + "\n").encode()
            for name, what in {"player": PLAYER, **SIMPLE}.items()}
