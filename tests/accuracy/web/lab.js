// The page of the accuracy lab: draws recorded runs, shows their errors and times, and the diagram of what was measured.
(() => {
    'use strict';

    const element = (id) => document.getElementById(id);
    const kMeasured = 0.3;  // s of steps that a measured time needs
    const kStep = 1 / 60;   // s

    // ---- the engine, in a worker

    const worker = new Worker('worker.js');
    const waiting = new Map();  // id: functions of a promise
    let calls = 0;
    worker.onmessage = ({ data }) => {
        const { done, refuse } = waiting.get(data.id);
        waiting.delete(data.id);
        data.error ? refuse(new Error(data.error)) : done(data.result);
    };
    worker.onerror = (event) => { element('state').textContent = `The engine cannot be loaded: ${event.message || 'is this page on a server?'}`; };
    function call(name, ...parameters) {
        return new Promise((done, refuse) => {
            waiting.set(++calls, { done, refuse });
            worker.postMessage({ id: calls, call: name, arguments: parameters });
        });
    }

    // Results by method, so that each is computed once.
    const known = new Map();
    function once(name, method, ...more) {
        const key = JSON.stringify([name, method]);
        if (!known.has(key)) known.set(key, call(name, method, ...more));
        return known.get(key);
    }

    // ---- what is chosen

    let scenes = [], scene = null;

    function chosenMethod() {
        const substeps = element('automatic').checked ? 0 : 1 << Number(element('substeps').value);
        return methodWith(substeps);
    }
    function methodWith(substeps) {
        const integrator = scene.smooth ? Number(element('integrator').value) : 1;
        return [scene.name, substeps, integrator, !scene.joints || element('trees').checked ? 1 : 0];
    }

    // ---- figures

    // Three significant digits.
    function figureText(value) {
        if (value === null) return '∞';
        const size = Math.abs(value);
        return size !== 0 && (size < 1e-3 || size >= 1e5) ? value.toExponential(1) : String(Number(value.toPrecision(3)));
    }

    function cell(content, kind) {
        const made = document.createElement('td');
        made.textContent = content;
        made.className = kind || '';
        return made;
    }

    function showRows(rows) {
        element('figures').replaceChildren(...rows.map((row) => {
            const line = document.createElement('tr');
            const goal = row.target === null ? '' : `${figureText(row.target)} ${row.unit}`;
            const verdict = { yes: 'met', no: 'missed' }[row.met] || '';
            line.append(cell(row.figure || 'error'), cell(`${figureText(row.error)} ${row.unit}`, 'n'), cell(goal, 'n'), cell(verdict, row.met));
            return line;
        }));
        const micros = rows.length ? rows[0].usPerStep : 0;
        const share = 100 * micros * 1e-6 / kStep;
        element('cost').textContent = rows.length ? `${figureText(micros)} µs for a step of 1/60 s on this machine: ${figureText(share)} % of it.` : '';
    }

    // ---- picture

    const canvas = element('picture');
    let shown = null, ghost = null, begun = 0;

    // The rectangle in which all moving bodies are, as far as they stay near where they began.
    function viewOf(recording) {
        const view = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
        const sizes = recording.moving.map(() => 0);
        for (const shape of recording.shapes) {
            for (let i = 0; i < shape.points.length; i += 2)
                sizes[shape.body] = Math.max(sizes[shape.body], Math.hypot(shape.points[i], shape.points[i + 1]) + shape.radius);
        }
        const addMoment = (moment, isNear) => recording.moving.forEach((moves, body) => {
            const [x, y] = poseAt(recording, moment, body), size = sizes[body];
            if (!moves || !isNear(x, y)) return;
            view.left = Math.min(view.left, x - size);
            view.right = Math.max(view.right, x + size);
            view.bottom = Math.min(view.bottom, y - size);
            view.top = Math.max(view.top, y + size);
        });
        addMoment(0, () => true);
        // A ball that is thrown is seen all the way; stones that have fallen off are not.
        const isCrowd = recording.moving.filter(Boolean).length > 3;
        const start = { ...view }, wide = start.right - start.left, high = start.top - start.bottom;
        const [beside, above] = isCrowd ? [Math.max(wide, high / 4), Math.max(high, wide / 4)] : [200, 200];  // m
        const isNear = (x, y) => x > start.left - beside && x < start.right + beside && y > start.bottom - above && y < start.top + above;
        const kept = Math.max(1, Math.floor(recording.moments / 200));  // of so many moments one
        for (let moment = 0; moment < recording.moments; moment += kept) addMoment(moment, isNear);
        return view;
    }

    function poseAt(recording, moment, body) {
        const at = 3 * (moment * recording.moving.length + body);
        return recording.poses.subarray(at, at + 3);
    }

    function place(pose, x, y) {
        const cos = Math.cos(pose[2]), sin = Math.sin(pose[2]);
        return [pose[0] + cos * x - sin * y, pose[1] + sin * x + cos * y];
    }

    // Draws all shapes at a moment. `look` is called with the number of a shape's body and sets the colors.
    function drawShapes(context, recording, moment, scale, look) {
        for (const shape of recording.shapes) {
            const pose = poseAt(recording, moment, shape.body);
            if (Number.isNaN(pose[0])) continue;
            context.beginPath();
            const points = shape.points;
            if (points.length === 2) {
                const [x, y] = place(pose, points[0], points[1]);
                context.arc(x, y, shape.radius, 0, 2 * Math.PI);
                context.moveTo(x, y);
                context.lineTo(...place(pose, points[0] + shape.radius, points[1]));
            } else {
                for (let i = 0; i < points.length; i += 2) {
                    const [x, y] = place(pose, points[i], points[i + 1]);
                    i === 0 ? context.moveTo(x, y) : context.lineTo(x, y);
                }
                context.closePath();
            }
            look(shape.body, points.length > 2 ? shape.radius : 0);
        }
        context.lineWidth = 1.5 / scale;
        for (const joint of recording.joints) {
            const a = poseAt(recording, moment, joint.a), b = poseAt(recording, moment, joint.b);
            const [x, y] = place(a, joint.anchors[0], joint.anchors[1]), [u, v] = place(b, joint.anchors[2], joint.anchors[3]);
            context.beginPath();
            context.moveTo(x, y);
            context.lineTo(u, v);
            context.stroke();
            context.beginPath();
            context.arc(x, y, 2 / scale, 0, 2 * Math.PI);
            context.stroke();
        }
    }

    function draw() {
        requestAnimationFrame(draw);
        const wide = canvas.clientWidth * devicePixelRatio, high = canvas.clientHeight * devicePixelRatio;
        if (canvas.width !== Math.round(wide) || canvas.height !== Math.round(high)) [canvas.width, canvas.height] = [Math.round(wide), Math.round(high)];
        const context = canvas.getContext('2d');
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, canvas.width, canvas.height);
        if (!shown) return;
        const view = shown.view;
        const moment = Math.min(Math.floor((performance.now() - begun) / 1000 / kStep), shown.moments - 1);
        element('time').textContent = `${(moment * kStep).toFixed(1)} of ${((shown.moments - 1) * kStep).toFixed(1)} s`;
        const scale = 0.9 * Math.min(canvas.width / (view.right - view.left), canvas.height / (view.top - view.bottom), 400 * devicePixelRatio);
        context.translate(canvas.width / 2, canvas.height / 2);
        context.scale(scale, -scale);
        context.translate(-(view.left + view.right) / 2, -(view.bottom + view.top) / 2);
        context.lineJoin = context.lineCap = 'round';
        const style = getComputedStyle(document.documentElement);
        const color = (name) => style.getPropertyValue(name);
        const [body, edge, ground, outline] = ['--body', '--edge', '--ground', '--ghost'].map(color);
        context.strokeStyle = edge;
        drawShapes(context, shown, moment, scale, (of, radius) => {
            context.fillStyle = shown.moving[of] ? body : ground;
            context.strokeStyle = shown.moving[of] ? edge : ground;
            context.lineWidth = 2 * radius + 1.2 * devicePixelRatio / scale;
            context.stroke();
            context.fill();
            context.strokeStyle = edge;
        });
        if (!ghost || !element('ghost').checked || ghost === shown) return;
        context.strokeStyle = outline;
        drawShapes(context, ghost, Math.min(moment, ghost.moments - 1), scale, (of) => {
            if (!ghost.moving[of]) return;
            context.lineWidth = 1.2 * devicePixelRatio / scale;
            context.stroke();
        });
    }

    // ---- changes

    let change = 0;  // number of the last one: answers to earlier ones are dropped

    async function update() {
        const mine = ++change, method = chosenMethod();
        const automatic = element('automatic').checked;
        element('substeps').disabled = automatic;
        element('amount').textContent = automatic ? 'Substeps for each group of bodies' : `${method[1]} substep${method[1] === 1 ? '' : 's'} in each step`;
        element('state').textContent = 'Simulating…';
        const latest = () => mine === change;
        const recording = await once('record', method);
        if (!latest()) return;
        recording.view = recording.view || viewOf(recording);
        shown = recording;
        begun = performance.now();
        const rows = await once('measure', method, kMeasured);
        if (!latest()) return;
        showRows(rows);
        await showChart();
        if (!latest()) return;
        const finest = await once('record', methodWith(64));
        if (!latest()) return;
        finest.view = finest.view || viewOf(finest);
        ghost = finest;
        shown.view = finest.view;
        element('state').textContent = '';
    }

    async function showChart() {
        const name = scene.name, svg = await call('chart', name);
        if (scene.name === name) element('chart').innerHTML = svg;
    }

    function choose(name) {
        scene = scenes.find((one) => one.name === name);
        shown = ghost = null;
        element('answer').textContent = scene.answer;
        element('shows').textContent = scene.shows;
        element('choose').textContent = scene.choose;
        element('treesLabel').hidden = !scene.joints;
        element('integratorLabel').hidden = !scene.smooth;
        element('chart').innerHTML = '';
        showRows([]);
        history.replaceState(null, '', '#' + name);
        update().catch(fail);
    }

    async function measureAll() {
        const mine = scene;
        element('all').disabled = true;
        for (let substeps = 1; substeps <= 64 && scene === mine; substeps *= 2) {
            element('state').textContent = `Measuring ${substeps} of 64 substeps…`;
            await once('measure', methodWith(substeps), kMeasured);
            if (scene === mine) await showChart();
        }
        element('state').textContent = '';
        element('all').disabled = false;
    }

    function fail(error) {
        element('all').disabled = false;
        element('state').textContent = `The engine has stopped: ${error.message}`;
    }

    for (const id of ['automatic', 'trees', 'integrator', 'substeps']) element(id).addEventListener('input', () => update().catch(fail));
    element('scene').addEventListener('change', (event) => choose(event.target.value));
    element('again').addEventListener('click', () => { begun = performance.now(); });
    element('all').addEventListener('click', () => measureAll().catch(fail));

    call('scenes').then((list) => {
        scenes = list;
        element('scene').replaceChildren(...list.map(({ name, title }) => new Option(title || name, name)));
        const wanted = location.hash.slice(1);
        element('scene').value = list.some(({ name }) => name === wanted) ? wanted : 'stack20';
        choose(element('scene').value);
        draw();
    }).catch(fail);
})();
