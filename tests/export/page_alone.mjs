// Checks the scripts of a game's page (player/targets/web) in Chromium, with a stub in place of the game.
//   node page_alone.mjs [CHECK...]
// Needs puppeteer-core, see browser.mjs.
import fs from 'node:fs';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { allowClipboard, browser, expect, isCovered, line, open as openAt, press, run, seconds, serve } from './browser.mjs';

const here = path.dirname(fileURLToPath(import.meta.url)), web = path.join(here, '../../player/targets/web');
const read = (...names) => fs.readFileSync(path.join(...names), 'utf8');

// Each folder of the site is a game of this name.
const site = await serve((name) => {
    const [game, file] = name.split('/').slice(-2);
    if (file === 'index.html') return read(web, file).replaceAll('{{NAME}}', game).replaceAll('{{ICON}}', 'data:,');
    if (file === 'player.js') return read(here, 'stub_player.js');
    if (['player.wasm', 'game.pack'].includes(file)) return 'x';
    return fs.existsSync(path.join(web, file)) ? read(web, file) : undefined;
});
await allowClipboard(site);

let games = 0;
const newGame = () => `game${++games}`;  // without stored files
const open = (game, prepare, viewport) => openAt(`${site}${game}/`, viewport, prepare);
const choose = (page, label) => page.evaluate((text) => [...document.querySelectorAll('#choices button')].find((b) => b.textContent === text).click(), label);
async function started(game, prepare, viewport) {
    const page = await open(game, prepare, viewport);
    await page.bringToFront();
    await page.click('#choices button');
    return page;
}
const save = (page, name, content) => page.evaluate((n, c) => stub.save(n, c), name, content);
const before = (script) => (page) => page.evaluateOnNewDocument(script);

// The content of stored files as a new page reads them, e.g. "one two none".
async function storedIn(game, ...names) {
    await seconds(0.3);
    const page = await open(game);
    const contents = await page.evaluate((all) => all.map((name) => stub.content(name)).join(' '), names);
    await page.close();
    return contents;
}
const closeAll = async () => { for (const page of (await browser.pages()).slice(1)) await page.close(); };

const checks = {
    async tabs() {
        const game = newGame(), kFiles = ['saves/1.save', 'saves/2.save', 'settings.json'];
        const first = await started(game), second = await open(game);
        await save(first, kFiles[0], 'one');
        await second.click('#choices button');
        await seconds(2.5);
        expect(await storedIn(game, ...kFiles) === 'one none none', 'a game that starts in another tab leaves what this one has saved');
        await save(second, kFiles[2], 'loud');
        await save(second, kFiles[1], 'two');
        await second.evaluate('FS.unlink(stub.folder + "/settings.json"); Module.onGame("saved", "")');
        expect(await storedIn(game, ...kFiles) === 'one two none', 'a page removes what it has removed, and nothing else');
        const third = await started(game);
        await save(third, kFiles[0], 'newer');
        await save(first, kFiles[2], 'quiet');
        expect(await storedIn(game, ...kFiles) === 'newer two quiet', 'a page stores only what it has changed');
        expect(await storedIn(newGame(), kFiles[0]) === 'none', 'another game of the site has other files');
    },
    async close() {
        const game = newGame();
        const first = await started(game);
        await save(first, 'saves/1.save', 'one');
        await first.close();
        expect(await storedIn(game, 'saves/1.save') === 'one', 'what is saved just before the tab is closed is kept');
        const second = await started(game);
        await second.evaluate('stub.write("saves/1.save", "two"); location.href = "about:blank"');
        expect(await storedIn(game, 'saves/1.save') === 'two', 'so is what the game has written, if the page is left');
        const third = await started(game);
        await third.evaluate('stub.save("saves/1.save", "same"); stub.save("saves/1.save", "time")');
        expect(await storedIn(game, 'saves/1.save') === 'time', 'of two files of one size in one millisecond, the second one');
    },
    async failures() {
        const game = newGame(), page = await started(game);
        await page.evaluate('window.commit = IDBTransaction.prototype.commit; IDBTransaction.prototype.commit = function () { this.abort(); }');
        await save(page, 'saves/1.save', 'one');
        await seconds(0.3);
        expect(/^Not kept: /.test(await line(page)), `a transaction that ends early: "${await line(page)}"`);
        await page.evaluate('IDBTransaction.prototype.commit = commit');
        await seconds(2.5);
        expect(await line(page) === '' && await storedIn(game, 'saves/1.save') === 'one', 'it is done again, and the line goes');
        await page.evaluate((name) => new Promise((done) => { indexedDB.deleteDatabase(name).onsuccess = done; }), `plumb ${game}`);
        await save(page, 'saves/2.save', 'two');
        expect(await storedIn(game, 'saves/2.save') === 'two', 'a database that was closed is opened again');
        const without = await started(newGame(), before('Object.defineProperty(window, "indexedDB", { value: undefined })'));
        await save(without, 'saves/1.save', 'one');
        await seconds(0.3);
        expect(/^Not kept: /.test(await line(without)), `without a database the game plays: "${await line(without)}"`);
    },
    async unread() {
        const game = newGame(), first = await started(game);
        await save(first, 'saves/1.save', 'old');
        await first.close();
        const page = await started(game, before('IDBObjectStore.prototype.getAll = () => { throw new Error("a test"); }'));
        expect(/^Not read: .*a test/.test(await line(page)), `files that cannot be read: "${await line(page)}"`);
        await save(page, 'saves/2.save', 'two');
        await seconds(0.3);
        await save(page, 'saves/2.save', 'newer');
        await save(page, 'saves/1.save', 'new');
        await seconds(2.5);
        expect(/^Not kept: .*could not be read/.test(await line(page)), `they are not replaced: "${await line(page)}"`);
        await page.evaluate('FS.unlink(stub.folder + "/saves/1.save"); Module.onGame("saved", "")');
        expect(await storedIn(game, 'saves/1.save', 'saves/2.save') === 'old newer', 'nor removed; new files are kept');
    },
    async fullscreen() {
        const page = await started(newGame(), before('Object.defineProperty(document, "fullscreenEnabled", { value: undefined })'));
        await page.mouse.move(600, 300);
        expect(await page.$eval('#full', (e) => e.hidden) && !(await page.$eval('#copy', (e) => e.hidden)), 'without fullscreen there is no button for it');
    },
    async errors() {
        const page = await started(newGame());
        await page.addScriptTag({ content: 'setTimeout(() => { throw new Error("of another script"); }, 0)' });
        await seconds(0.3);
        expect(page.lines.includes('error: of another script') && !(await isCovered(page)), 'an error of another script does not stop the game');
        await page.addScriptTag({ content: 'setTimeout(() => { throw new WebAssembly.RuntimeError("unreachable"); }, 0)' });
        await seconds(0.3);
        const text = await page.$eval('#text', (e) => e.textContent);
        expect(/has stopped.*unreachable/.test(text), `one of the player does: "${text.split('\n')[0]}"`);
        const other = await started(newGame());
        await other.evaluate('setTimeout(() => Module.onGame("an unknown topic", ""), 0)');
        await seconds(0.3);
        expect(await isCovered(other), 'so does one of the page');
    },
    async keys() {
        const page = await started(newGame());
        await page.evaluate(() => {
            const send = (kind, key, code, ctrlKey) => window.dispatchEvent(new KeyboardEvent(kind, { key, code, ctrlKey }));
            send('keydown', 'r', 'KeyR', false);
            send('keydown', 'Control', 'ControlLeft', true);
            send('keyup', 'r', 'KeyR', true);
            send('keyup', 'Control', 'ControlLeft', false);
            send('keydown', 'o', 'KeyR', true);  // in a layout that has other letters there
            send('keydown', 'R', 'KeyO', true);
            send('keydown', 'F5', 'F5', false);
        });
        const keys = (await page.evaluate('stub.keys')).join(' ');
        expect(keys === '+KeyR +ControlLeft -KeyR -ControlLeft +KeyR', `keys that reach the game: ${keys}`);
    },
    async end() {
        const page = await started(newGame());
        const audio = () => page.evaluate('Module.SDL2.audioContext.state');
        await seconds(0.5);
        const playing = await audio();
        await page.evaluate('stub.keys.length = 0; Module.onGame("ended", "")');
        await seconds(0.3);
        await page.mouse.click(20, 700);
        await seconds(0.3);
        expect(playing === 'running' && await audio() === 'suspended', `the sound of a game that has ended is ${await audio()}, before it was ${playing}`);
        await page.bringToFront();
        await seconds(0.2);
        expect(await audio() === 'suspended', 'also if the page is shown again');
        await press(page, 'Tab');
        await page.focus('#choices button');
        await page.evaluate('window.isOld = true');
        await press(page, 'Enter');
        await page.waitForFunction('window.isOld === undefined && window.readyAt', { timeout: 5000 }).catch(() => {});
        expect(!(await page.evaluate('window.isOld')), 'Enter plays it again');
        const filled = await started(newGame());
        await filled.evaluate('document.getElementById("canvas").requestFullscreen()');
        await seconds(0.5);
        const before = await filled.evaluate('!!document.fullscreenElement');
        await filled.evaluate('Module.onGame("ended", "")');
        await seconds(0.5);
        expect(before && !(await filled.evaluate('!!document.fullscreenElement')), 'a canvas that fills the screen does not hide the buttons');
        const held = await started(newGame());
        await held.keyboard.down('Enter');
        await held.evaluate('window.isOld = true; Module.onGame("ended", "")');
        await held.keyboard.down('Enter');  // repeated, because it is held
        await seconds(0.5);
        expect(await held.evaluate('window.isOld'), 'but not the key that was held at the end');
    },
    async touch() {
        const viewport = { width: 844, height: 390, hasTouch: true, isMobile: true };
        const page = await open(newGame(), undefined, viewport);
        await (await page.$('#choices button')).tap();
        const tapJump = async (usage, key) => {
            const pad = usage === 44 ? [80, 79] : [4, 7];
            const axis = { name: 'Horizontal', negative: { key: 'Left', usage: pad[0] }, positive: { key: 'Right', usage: pad[1] } };
            await page.evaluate((list) => Module.onGame('controls', list), JSON.stringify({ axes: [axis], actions: [{ name: 'Jump', key, usage }] }));
            await (await page.$('#touch button:not([hidden])')).tap();
            const box = await (await page.$('#touch .pad:not([hidden])')).boundingBox();
            await page.touchscreen.tap(box.x + 0.9 * box.width, box.y + box.height / 2);
        };
        await tapJump(44, 'Space');
        await tapJump(13, 'J');
        const usages = (await page.evaluate('stub.usages')).join(' ');
        expect(usages === '44 -44 79 -79 13 -13 7 -7', `buttons press the keys that are bound at the moment: ${usages}`);
    },
    async link() {
        const page = await started(newGame(), before(() => {
            Object.defineProperty(navigator, 'clipboard', { value: undefined });
            window.prompt = () => { throw new Error('prompts are refused'); };
        }));
        const selected = () => page.evaluate('getSelection().toString().trim()');
        await page.mouse.move(600, 300);
        await page.click('#copy');
        await seconds(0.3);
        expect(await isCovered(page) && (await selected()).endsWith('#r=run'), `without a clipboard the link is selected: ${await selected()}`);
        expect(await page.evaluate('stub.paused && Module.SDL2.audioContext.state === "suspended"'), 'meanwhile the game stands still');
        await choose(page, 'Go on');
        await seconds(0.3);
        expect(!(await isCovered(page)) && await page.evaluate('!stub.paused && Module.SDL2.audioContext.state === "running"'), 'then it goes on');
        await page.evaluate('setTimeout(() => Module.onAbort("a test"), 0)');
        await seconds(0.3);
        await choose(page, 'Copy a link to this run');
        await seconds(0.3);
        const text = await page.$eval('#text', (e) => e.textContent);
        expect((await selected()).endsWith('#r=run') && /a test/.test(text), 'after a crash it stands below the error');
    },
};

for (const [name, check] of Object.entries(checks)) checks[name] = async () => { await check(); await closeAll(); };
const wanted = process.argv.slice(2);
await run(checks, wanted.length ? wanted : Object.keys(checks));
