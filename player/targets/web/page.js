// The page of an exported game: loads the player and the game's pack, starts them at the first click, keeps what the game
// stores in the browser, plays the replay in the address, and shows errors.
// A function, because the script of the player has global names of its own.
(() => {
    'use strict';

    const element = (id) => document.getElementById(id);
    const canvas = element('canvas'), cover = element('cover'), text = element('text'), choices = element('choices');
    const query = new URLSearchParams(location.search);
    // Options of the player, e.g. ?args=--headless --frames 600 --hash
    const options = (query.get('args') || '').split(' ').filter(Boolean);
    const replay = location.hash.startsWith('#r=') ? location.hash : '';
    const game = document.title;  // the name; the player changes the title later

    // Shows a message and buttons over the page: {label: function}. Until one is pressed, the game has neither input nor sound.
    function ask(message, answers) {
        element('bar').hidden = true;
        text.textContent = message;
        choices.replaceChildren(...Object.entries(answers).map(([label, answer], index) => {
            const button = document.createElement('button');
            button.textContent = label;
            button.className = index === 0 ? 'first' : '';
            button.addEventListener('click', answer);
            return button;
        }));
        element('tools').hidden = element('touch').hidden = element('line').hidden = true;
        cover.hidden = false;
        const { fullscreenElement } = document;  // the canvas alone, if the player has made it fullscreen: it hides the page
        if (fullscreenElement && fullscreenElement !== document.documentElement) document.exitFullscreen();
        followSound();
        if (choices.firstChild) choices.firstChild.focus();
    }

    // The sound of a game goes on by itself while nothing else does: in a hidden page, and after its end.
    function followSound() {
        const audio = window.Module && Module.SDL2 && Module.SDL2.audioContext;
        if (audio) document.hidden || !cover.hidden ? audio.suspend() : audio.resume();
    }

    const restart = () => location.reload();
    const withoutReplay = () => {
        history.replaceState(null, '', location.pathname + location.search);
        location.reload();
    };

    let hiding = 0;
    // A line at the top of the picture. @param seconds  0: until the next one
    function say(message, seconds) {
        const line = element('line');
        line.textContent = message;
        line.hidden = !message || !cover.hidden;
        clearTimeout(hiding);
        if (seconds) hiding = setTimeout(() => { line.hidden = true; }, 1000 * seconds);
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

    let files = null;

    function readStored() {
        files = new FileStore(FS, '/libsdl', game, (problem) => say(problem, 0));
        return files.read();
    }

    function store() {
        if (files) files.store();
    }

    // ---- links

    // The address of this page with a replay of the run so far; '' if there is none.
    function runLink(afterFailure) {
        try {
            const link = UTF8ToString(Module._plumbLink(afterFailure ? 1 : 0));
            return link && location.href.split('#')[0] + link;
        } catch (error) {
            console.warn('no link of the run: ' + error);
            return '';
        }
    }

    // Browsers refuse the clipboard to pages without https and in frames of other sites.
    async function copy(link) {
        try {
            await navigator.clipboard.writeText(link);
            return true;
        } catch {
            return false;
        }
    }

    // Shows a link below the message, selected, to be copied by hand.
    function showLink(link) {
        const place = document.createElement('p');
        place.textContent = link;
        text.append(place);
        getSelection().selectAllChildren(place);
    }

    async function copyRun() {
        const link = runLink(false);
        if (!link) return say('The run is too long for a link', 5);
        if (await copy(link)) {
            say(`Copied a link that replays this run (${link.length} characters)`, 5);
            canvas.focus();
        } else {
            pause();
            ask('This link replays the run:', { 'Go on': goOn });
            showLink(link);
        }
    }

    // To the player it is as if another window had the keys: it releases those that are held.
    function pause() {
        window.dispatchEvent(new Event('blur'));
        Module.pauseMainLoop();
    }

    function goOn() {
        cover.hidden = true;
        element('touch').hidden = !usesTouch;
        followSound();
        window.dispatchEvent(new Event('focus'));
        Module.resumeMainLoop();
        canvas.focus();
    }

    // ---- the player

    let failed = false;
    const errors = [];  // the last lines

    function stop(message) {
        if (failed) return;
        failed = true;
        store();
        const link = runLink(true);
        const answers = {};
        if (link) answers['Copy a link to this run'] = async ({ target }) => {
            if (await copy(link)) return target.textContent = 'Copied';
            target.hidden = true;
            showLink(link);
        };
        answers['Start again'] = replay ? withoutReplay : restart;
        cover.classList.add('over');
        console.error(`stopped: ${message} ${link}`);
        ask(`The game has stopped: ${message}\n${errors.join('\n')}` +
            (link ? '\n\nThe link replays the run up to this error: send it to the authors of the game.' : ''), answers);
    }

    const touch = new TouchControls(element('touch'), (usage, down) => Module._plumbKey(usage, down ? 1 : 0));

    // What the game tells the page.
    const onGame = {
        replay: () => say(`Replay: ${usesTouch ? 'touch the picture' : 'press any key'} to take over`, 0),
        live: (why) => say(why, 10),
        controls: (list) => touch.show(JSON.parse(list)),
        saved: store,
        ended: () => {
            store();
            if (!options.includes('--headless')) ask('The game has ended.', { 'Play again': restart });
        },
    };

    window.Module = {
        canvas,
        arguments: options,
        noInitialRun: true,
        print: (line) => console.log(line),
        printErr: (line) => {
            console.warn(line);
            errors.push(line);
            if (errors.length > 6) errors.shift();
        },
        onAbort: (what) => stop(what),
        onGame: (topic, message) => onGame[topic](message),
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
        await readStored();
        window.readyAt = performance.now();
    }

    function run(link) {
        cover.hidden = true;
        element('touch').hidden = !usesTouch;
        canvas.focus();
        say(files.problem, 0);
        setInterval(store, 2000);  // for what the code of the game writes; what the engine has saved is stored at once
        // Nothing as soon as there is a loop of frames; otherwise what main() returns.
        const code = Module.callMain(link ? [...options, '--link', link] : options);
        if (code) ask(errors.join('\n'), link ? { 'Play without the replay': withoutReplay } : {});
    }

    // ---- page

    // The buttons are for fingers: those that play have touched the page before.
    let usesTouch = false;
    window.addEventListener('pointerdown', (event) => {
        if (event.pointerType !== 'touch' || usesTouch) return;
        usesTouch = true;
        element('touch').hidden = !cover.hidden;
    }, true);
    // Scripts of others fail too, e.g. those of extensions of the browser: the game goes on.
    const scripts = ['player.js', 'page.js', 'touch.js', 'store.js'].map((name) => new URL(name, document.baseURI).href);
    window.addEventListener('error', ({ message, error, filename }) => {
        if (error instanceof WebAssembly.RuntimeError || scripts.includes(filename)) stop(message);
    });
    window.addEventListener('unhandledrejection', (event) => console.error(event.reason));
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
    // The keys of games must not scroll the page.
    window.addEventListener('keydown', (event) => {
        if (['ArrowUp', 'ArrowDown', 'ArrowLeft', 'ArrowRight', 'Space', 'Tab'].includes(event.code)) event.preventDefault();
    });
    // What browsers do with these keys they go on doing: the player takes all other ones from them. It gets every release,
    // because a key may have been pressed before Ctrl was.
    const isOfBrowser = ({ key, ctrlKey, metaKey }) => ['F5', 'F12'].includes(key) ||
        ((ctrlKey || metaKey) && ['r', 'l', '0', '+', '-', '='].includes(String(key).toLowerCase()));
    window.addEventListener('keydown', (event) => { if (isOfBrowser(event)) event.stopImmediatePropagation(); }, true);
    // Keys press the buttons of the page instead, but not the one that was held when they appeared. The player would start its
    // sound again at a key or a touch.
    for (const kind of ['keydown', 'keypress', 'keyup', 'mousedown', 'touchstart']) window.addEventListener(kind, (event) => {
        if (cover.hidden) return;
        event.stopImmediatePropagation();
        if (event.repeat && event.key === 'Enter') event.preventDefault();
    }, true);
    // A hidden page draws no frames, so that the game stands still.
    document.addEventListener('visibilitychange', () => {
        if (document.hidden) store();
        followSound();
    });
    window.addEventListener('pagehide', store);
    window.addEventListener('hashchange', () => location.reload());  // another replay

    // The tools are there while the mouse moves, or after a touch.
    let toolsHiding = 0;
    for (const kind of ['mousemove', 'pointerdown']) window.addEventListener(kind, () => {
        element('tools').hidden = !cover.hidden;
        clearTimeout(toolsHiding);
        toolsHiding = setTimeout(() => { element('tools').hidden = true; }, 2500);
    });
    for (const tool of element('tools').children) tool.addEventListener('mousedown', (event) => event.preventDefault());
    element('copy').addEventListener('click', copyRun);
    element('full').hidden = !document.fullscreenEnabled;  // iPhones have fullscreen for videos only
    element('full').addEventListener('click', () => {
        if (document.fullscreenElement) document.exitFullscreen();
        else document.documentElement.requestFullscreen();
        canvas.focus();
    });

    load().then(() => {
        if (options.includes('--headless')) return run(replay);
        if (replay) ask('This link holds a replay of the game.', { 'Watch the replay': () => run(replay), 'Play': withoutReplay });
        else ask('', { Play: () => run('') });
    }).catch((error) => ask(`The game could not be loaded: ${error.message}`, { 'Try again': restart }));
})();
