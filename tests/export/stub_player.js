// Stands in for player.js where the page is checked without a game: files in memory, and what the page calls.
var UTF8ToString = (text) => text;
var FS = (() => {
    const nodes = new Map([['', { mode: 'folder' }]]);
    let made = 0;
    const at = (path) => nodes.get(path.replace(/\/$/, ''));
    return {
        isDir: (mode) => mode === 'folder',
        isFile: (mode) => mode === 'file',
        mkdirTree(path) {
            path.split('/').forEach((name, index, names) => {
                const folder = names.slice(0, index + 1).join('/');
                if (!at(folder)) nodes.set(folder, { mode: 'folder' });
            });
        },
        readdir(path) {
            const inside = [...nodes.keys()].filter((name) => name && name.slice(0, name.lastIndexOf('/')) === path);
            return ['.', '..', ...inside.map((name) => name.slice(path.length + 1))];
        },
        stat: (path) => ({ ...at(path), size: at(path).contents ? at(path).contents.length : 0, mtime: new Date(at(path).time || 0) }),
        readFile: (path) => at(path).contents.slice(),
        // As the engine writes: a new file takes the place of the old one.
        writeFile: (path, contents) => nodes.set(path, { mode: 'file', ino: ++made, contents: Uint8Array.from(contents), time: Date.now() }),
        utime: (path, accessed, time) => { at(path).time = time; },
        unlink: (path) => nodes.delete(path),
    };
})();

var stub = {
    keys: [],  // "+KeyR", "-KeyR"
    usages: [],
    paused: false,
    folder: `/libsdl/${document.title}`,
    write(name, content) {
        FS.mkdirTree(`${this.folder}/saves`);
        FS.writeFile(`${this.folder}/${name}`, new TextEncoder().encode(content));
    },
    save(name, content) {
        this.write(name, content);
        Module.onGame('saved', '');
    },
    content(name) {
        try {
            return new TextDecoder().decode(FS.readFile(`${this.folder}/${name}`));
        } catch {
            return 'none';
        }
    },
};

Object.assign(Module, {
    _plumbLink: () => '#r=run',
    _plumbKey: (usage, down) => stub.usages.push(down ? usage : -usage),
    pauseMainLoop: () => { stub.paused = true; },
    resumeMainLoop: () => { stub.paused = false; },
    callMain() {
        FS.mkdirTree(stub.folder);  // as SDL_GetPrefPath()
        const audio = new AudioContext();
        audio.createConstantSource().connect(audio.destination);
        Module.SDL2 = { audioContext: audio };
        document.addEventListener('mousedown', () => audio.resume());  // as emscripten does
        for (const [kind, sign] of [['keydown', '+'], ['keyup', '-']]) window.addEventListener(kind, (event) => {
            stub.keys.push(sign + event.code);
            event.preventDefault();
        });
    },
});
setTimeout(() => Module.onRuntimeInitialized(), 0);
