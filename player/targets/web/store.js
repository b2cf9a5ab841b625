// Keeps the files of a folder of the player in a database of the browser, one for each game. Other tabs may play the same game
// and use its database too: this page writes only files that have changed here, and removes only files that were here.
window.FileStore = class {
    // files: of the player, emscripten's FS. game: its name. report(problem): '' as soon as all files are kept again.
    constructor(files, folder, game, report) {
        Object.assign(this, { files, folder, report });
        this.name = `plumb ${game}`;
        this.database = null;   // the open one
        this.opening = null;    // the promise of it
        this.kept = new Map();  // path: mark of the file that was read or handed to the browser; '' if it was not kept
        this.own = new Set();   // paths that this page has stored
        this.hasRead = false;   // else the database may have files that this page does not know
        this.problem = '';
    }

    // Writes the files of the database to the folder.
    async read() {
        this.files.mkdirTree(this.folder);
        try {
            const stored = (await this.open()).transaction('files').objectStore('files');
            const requests = [stored.getAllKeys(), stored.getAll()];
            const [paths, entries] = await Promise.all(requests.map((request) => this.resultOf(request)));
            paths.forEach((path, index) => this.restore(path, entries[index]));
            this.kept = this.present();
            this.hasRead = true;
        } catch (error) {
            this.say(`Not read: what was saved before (${this.reasonOf(error)})`);
        }
    }

    // The browser has all changes when this returns, so that the page may close, unless the database must be opened first.
    store() {
        const present = this.present();
        const changes = [...present].filter(([path, mark]) => this.kept.get(path) !== mark);
        for (const path of this.kept.keys()) if (!present.has(path)) changes.push([path, null]);
        if (changes.length === 0) return;
        if (this.database) changes.forEach(([path, mark]) => this.change(path, mark));
        else this.open().then(() => this.store(), (error) => this.fail(error));
    }

    // ---- for the functions above

    // The files in the folder: {path: mark}. A file that is written gets another mark.
    present() {
        const found = new Map();
        const look = (path) => {
            const { mode, ino, mtime, size } = this.files.stat(path);
            if (this.files.isFile(mode)) found.set(path, `${ino} ${Number(mtime)} ${size}`);
            if (!this.files.isDir(mode)) return;
            for (const name of this.files.readdir(path)) if (name !== '.' && name !== '..') look(`${path}/${name}`);
        };
        look(this.folder);
        return found;
    }

    restore(path, { contents, time }) {
        this.files.mkdirTree(path.slice(0, path.lastIndexOf('/')));
        this.files.writeFile(path, contents);
        this.files.utime(path, time, time);
    }

    // Stores a file, or removes it if mark is null. Each has a transaction of its own: one that is too large stops no other.
    change(path, mark) {
        const transaction = this.begin();
        if (!transaction) return;
        const stored = transaction.objectStore('files');
        const isKnown = this.hasRead || this.own.has(path);
        if (mark === null) {
            this.kept.delete(path);
            if (isKnown) stored.delete(path);
        } else {
            this.kept.set(path, mark);
            const entry = { contents: this.files.readFile(path), time: Number(this.files.stat(path).mtime) };
            isKnown ? stored.put(entry, path) : stored.add(entry, path);  // add() fails rather than replace a file
        }
        transaction.oncomplete = () => {
            this.own.add(path);
            if (![...this.kept.values()].includes('')) this.say('');
        };
        transaction.onabort = () => {
            this.kept.set(path, '');
            this.fail(transaction.error);
        };
        transaction.commit();
    }

    begin() {
        try {
            return this.database && this.database.transaction('files', 'readwrite');
        } catch (error) {  // the connection has been closed
            this.database = null;
            this.fail(error);
            return null;
        }
    }

    open() {
        this.opening = this.opening || this.connect().finally(() => { this.opening = null; });
        return this.opening;
    }

    async connect() {
        const request = indexedDB.open(this.name, 1);
        request.onupgradeneeded = () => request.result.createObjectStore('files');
        const database = await this.resultOf(request);
        const forget = () => { if (this.database === database) this.database = null; };
        database.onclose = forget;  // by the browser
        database.onversionchange = () => { database.close(); forget(); };  // it is being deleted
        this.database = database;
        return database;
    }

    resultOf(request) {
        return new Promise((done, refuse) => {
            request.onsuccess = () => done(request.result);
            request.onerror = () => refuse(request.error);
        });
    }

    reasonOf(error) {
        if (error && error.name === 'ConstraintError') return 'what was saved before could not be read; load the page again';
        return (error && (error.message || error.name)) || 'the browser gives no reason';
    }

    fail(error) {
        this.say(`Not kept: ${this.reasonOf(error)}`);
    }

    say(problem) {
        if (problem === this.problem) return;
        this.problem = problem;
        if (problem) console.warn(problem);
        this.report(problem);
    }
};
