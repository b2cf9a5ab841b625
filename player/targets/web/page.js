// The page of an exported game: loads the player and the game's pack, starts them at the first click, keeps what the game
// stores in the browser, and shows errors.
// A function, because the script of the player has global names of its own.
(() => {
    'use strict';

    const element = (id) => document.getElementById(id);
    const canvas = element('canvas'), cover = element('cover'), text = element('text'), start = element('start');
    const query = new URLSearchParams(location.search);
    // Options of the player, e.g. ?args=--headless --frames 600 --hash
    const options = (query.get('args') || '').split(' ').filter(Boolean);

    function show(message) { text.textContent = message; }

    function fail(message) {
        cover.hidden = false;
        start.hidden = true;
        element('bar').hidden = true;
        show(message);
    }

    // ---- files

    // Reports what share of a file has arrived.
    async function download(url, progress) {
        const answer = await fetch(url);
        if (!answer.ok) throw new Error(`${url}: the server answers ${answer.status}`);
        const total = Number(answer.headers.get('Content-Length')) || 0;
        if (!answer.body || total === 0) return new Uint8Array(await answer.arrayBuffer());
        const parts = [];
        let size = 0;
        for (const reader = answer.body.getReader();;) {
            const { done, value } = await reader.read();
            if (done) break;
            parts.push(value);
            size += value.length;
            progress(Math.min(size / total, 1));
        }
        const whole = new Uint8Array(size);
        let at = 0;
        for (const part of parts) whole.set(part, at), at += part.length;
        return whole;
    }

    // ---- what the game stores: SDL's folder for it is kept in the browser's database

    const kStored = '/libsdl';

    function mountStored() {
        FS.mkdirTree(kStored);
        FS.mount(IDBFS, {}, kStored);
        return new Promise((done) => FS.syncfs(true, (error) => {
            if (error) console.warn('what the game stored cannot be read: ' + error);
            done();
        }));
    }

    let storing = false;
    function store() {
        if (storing || typeof FS === 'undefined') return;
        storing = true;
        FS.syncfs(false, (error) => {
            storing = false;
            if (error) console.warn('what the game stores cannot be kept: ' + error);
        });
    }

    // ---- the player

    let failed = false;
    window.Module = {
        canvas,
        arguments: options,
        noInitialRun: true,
        print: (line) => console.log(line),
        printErr: (line) => console.warn(line),
        onAbort: (what) => { failed = true; fail(`The game has stopped: ${what}`); },
        preRun: [],
    };

    function loadScript(url) {
        return new Promise((done, refuse) => {
            const script = document.createElement('script');
            script.src = url;
            script.onload = done;
            script.onerror = () => refuse(new Error(`${url} cannot be loaded`));
            document.body.append(script);
        });
    }

    async function load() {
        const shares = [0, 0];
        const progress = (index) => (share) => {
            shares[index] = share;
            element('bar').firstElementChild.style.width = `${50 * (shares[0] + shares[1])}%`;
        };
        const [wasm, pack] = await Promise.all([download('player.wasm', progress(0)), download('game.pack', progress(1))]);
        Module.wasmBinary = wasm;
        const ready = new Promise((done) => { Module.onRuntimeInitialized = done; });
        await loadScript('player.js');
        await ready;
        FS.writeFile('/game.pack', pack);
        await mountStored();
        window.readyAt = performance.now();
    }

    function run() {
        cover.hidden = true;
        canvas.focus();
        setInterval(store, 2000);
        try {
            Module.callMain(options);
        } catch (error) {
            if (error !== 'unwind') throw error;
        }
    }

    // ---- page

    window.addEventListener('error', (event) => { if (!failed) fail(`The game has stopped: ${event.message}`); });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    // The keys of games must not scroll the page.
    window.addEventListener('keydown', (event) => {
        if (['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Space', 'Tab'].includes(event.code)) event.preventDefault();
    });
    document.addEventListener('visibilitychange', () => { if (document.hidden) store(); });
    window.addEventListener('pagehide', store);
    // The button is there while the mouse moves.
    let hiding = 0;
    window.addEventListener('mousemove', () => {
        element('full').hidden = !cover.hidden;
        clearTimeout(hiding);
        hiding = setTimeout(() => { element('full').hidden = true; }, 2000);
    });
    element('full').addEventListener('click', () => {
        if (document.fullscreenElement) document.exitFullscreen();
        else document.documentElement.requestFullscreen();
        canvas.focus();
    });
    start.addEventListener('click', run, { once: true });

    load().then(() => {
        element('bar').hidden = true;
        if (options.includes('--headless')) return run();
        show('');
        start.hidden = false;
        start.focus();
    }).catch((error) => fail(`The game could not be loaded: ${error.message}`));
})();
