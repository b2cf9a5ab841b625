// The buttons of a touch screen: a round pad for two axes, and a button for each action. They press the keys that the game
// has bound. The game says which of them are there (engine/app/touch_controls.hpp), and changes them while it runs.
window.TouchControls = class {
    // press(usage, down) presses or releases a key.
    constructor(root, press) {
        this.root = root;
        this.press = press;
        this.holds = new Map();  // usage: number of fingers
        this.parts = new Map();  // name with the keys: element of a control that was shown once
    }

    // controls: {axes: [{name, negative: {key, usage}, positive}], actions: [{name, key, usage}]}
    show(controls) {
        const wanted = new Set();
        const show = (name, make) => {
            if (!this.parts.has(name)) {
                this.parts.set(name, make());
                this.root.append(this.parts.get(name));
            }
            wanted.add(name);
            return this.parts.get(name);
        };
        this.padsOf(controls.axes).forEach((pad, index) => {
            const name = `pad ${JSON.stringify(pad)}`;
            show(name, () => this.makePad(pad)).className = index === 0 ? 'pad first' : 'pad second';
        });
        const twoPads = this.padsOf(controls.axes).length > 1;
        let menus = 0, actions = 0;
        for (const action of controls.actions) {
            const button = show(`action ${action.name} ${action.usage}`, () => this.makeButton(action));
            if (button.classList.contains('menu')) this.placeMenu(button, menus++);
            else this.placeAction(button, actions++, twoPads);
        }
        for (const [name, part] of this.parts) {
            if (!wanted.has(name) && !part.hidden) part.release();
            part.hidden = !wanted.has(name);
        }
    }

    hold(usage, by) {
        const before = this.holds.get(usage) || 0, now = before + by;
        this.holds.set(usage, now);
        if ((before > 0) !== (now > 0)) this.press(usage, now > 0);
    }

    // The first two axes are one pad, the next two a second one. An axis whose keys say nothing of its direction
    // is horizontal, then vertical.
    padsOf(axes) {
        const pads = [];
        for (const { negative, positive } of axes) {
            const known = { Left: 0, A: 0, Up: 1, W: 1 }[negative.key];
            const isFree = (pad, upright) => !(upright ? 'up' in pad : 'left' in pad);
            let pad = pads.find((p) => (known !== 1 && isFree(p, false)) || (known !== 0 && isFree(p, true)));
            if (!pad) pads.push(pad = {});
            const upright = known === undefined ? !isFree(pad, false) : known === 1;
            Object.assign(pad, upright ? { up: negative.usage, down: positive.usage }
                                       : { left: negative.usage, right: positive.usage });
        }
        return pads.slice(0, 2);
    }

    makePad(pad) {
        const part = document.createElement('div');
        for (const side of Object.keys(pad)) {
            const arrow = document.createElement('i');
            arrow.className = side;
            part.append(arrow);
        }
        let held = new Set();
        const hold = (sides) => {
            for (const side of held) if (!sides.has(side)) this.hold(pad[side], -1);
            for (const side of sides) if (!held.has(side)) this.hold(pad[side], 1);
            held = sides;
            for (const arrow of part.children) arrow.classList.toggle('held', held.has(arrow.classList[0]));
        };
        part.release = () => hold(new Set());
        this.follow(part, (event) => {
            const box = part.getBoundingClientRect();
            const x = (event.clientX - box.left) / box.width * 2 - 1, y = (event.clientY - box.top) / box.height * 2 - 1;
            // Eight directions; with one axis only its two.
            const kCentre = 0.2, kDiagonal = 0.41;  // the tangent of 22.5 degrees
            const far = (a, b, other) => Math.abs(a) > kCentre && (!other || Math.abs(a) > kDiagonal * Math.abs(b));
            const sides = new Set();
            if ('left' in pad && far(x, y, 'up' in pad)) sides.add(x < 0 ? 'left' : 'right');
            if ('up' in pad && far(y, x, 'left' in pad)) sides.add(y < 0 ? 'up' : 'down');
            hold(sides);
        });
        return part;
    }

    makeButton(action) {
        const part = document.createElement('button');
        part.textContent = action.name;
        part.tabIndex = -1;
        if (['Escape', 'P', 'Tab'].includes(action.key)) part.classList.add('menu');
        let isHeld = false;
        const hold = (now) => {
            if (now !== isHeld) this.hold(action.usage, now ? 1 : -1);
            isHeld = now;
            part.classList.toggle('held', now);
        };
        part.release = () => hold(false);
        this.follow(part, () => hold(true));
        return part;
    }

    // Calls `at` while a finger is on a part, which gets its events until it is lifted.
    follow(part, at) {
        part.addEventListener('pointerdown', (event) => {
            event.preventDefault();
            part.setPointerCapture(event.pointerId);
            at(event);
        });
        part.addEventListener('pointermove', (event) => { if (part.hasPointerCapture(event.pointerId)) at(event); });
        for (const end of ['pointerup', 'pointercancel', 'lostpointercapture'])
            part.addEventListener(end, () => part.release());
    }

    // Around the thumb: the first at the lower right, the next ones to the left of it and above.
    placeAction(button, index, above) {
        const places = [[0, 0], [84, -26], [22, -84], [106, -110], [44, -168], [128, -194]];
        const [x, y] = places[Math.min(index, places.length - 1)];
        button.style.right = `calc(${26 + x}px + env(safe-area-inset-right))`;
        button.style.bottom = `calc(${(above ? 176 : 40) - y}px + env(safe-area-inset-bottom))`;
    }

    placeMenu(button, index) {
        button.style.left = `calc(${10 + 84 * index}px + env(safe-area-inset-left))`;
        button.style.top = 'calc(10px + env(safe-area-inset-top))';
    }
};
