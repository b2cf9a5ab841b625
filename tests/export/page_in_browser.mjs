// Checks the page of an exported platformer in Chromium: what a player does with it, and what a browser does to it.
//   node page_in_browser.mjs FOLDER PLAYER PROJECT PICTURES [CHECK...]
// Needs puppeteer-core, see browser.mjs. What needs no game is checked by page_alone.mjs.
import fs from 'node:fs';
import path from 'node:path';
import { execFileSync, spawnSync } from 'node:child_process';
import { allowClipboard, browser, expect, isCovered, line, open as openAt, press, run as runChecks, seconds, serve } from './browser.mjs';

const [root, player, project, pictures, ...wanted] = process.argv.slice(2);
const site = await serve((name) => {
    const file = path.join(root, name);
    return fs.existsSync(file) ? fs.readFileSync(file) : undefined;
});
await allowClipboard(site);

const open = (hash = '', viewport = undefined, prepare = undefined) => openAt(site + hash, viewport, prepare);
const start = async (page, touch = false) => {
    const [button] = await page.$$('#choices button');
    await (touch ? button.tap() : button.click());
    await seconds(1.5);
};
const logged = async (page, pattern, from = 0) => {
    for (let tries = 0; tries < 200 && !page.lines.slice(from).some((text) => pattern.test(text)); ++tries) await seconds(0.1);
};
const startLevel = async (page) => {
    await start(page);
    await press(page, 'Enter');
    await logged(page, /player grounded: true/);
};
// Opens the menu of the pause and chooses the row that is one step away: "save" is below the first one, "quit" above it, as the
// last one. Each key is held until the game has seen it.
const choosePaused = async (page, step) => {
    for (const key of ['Escape', step, 'Enter']) {
        const from = page.lines.length;
        await page.keyboard.down(key);
        await logged(page, /^\[Input\] .* pressed/, from);
        await page.keyboard.up(key);
        await seconds(0.5);
    }
};
const covered = (page) => page.waitForFunction('!document.getElementById("cover").hidden', { timeout: 20000 });
const linkOf = (page) => page.evaluate('UTF8ToString(Module._plumbLink(0))');
const picture = (page, name) => page.screenshot({ path: path.join(pictures, name + '.png') });

// Plays a link here, which ends with an error unless the state is that of the page.
function here(link) {
    const run = spawnSync(player, [project, '--headless', '--link', link, '--hash', '--record', path.join(pictures, 'run.replay')], { encoding: 'utf8' });
    return { ok: run.status === 0 && link.length > 20, hash: (/hash: (\w+)/.exec(run.stdout) || [])[1], input: fs.readFileSync(path.join(pictures, 'run.replay'), 'utf8'), text: run.stdout + run.stderr };
}
const ticksOf = (run) => Number(/^end (\d+)$/m.exec(run.input)[1]);

const checks = {
    async play() {
        const page = await open();
        await picture(page, 'cover');
        await start(page);
        await press(page, 'Enter');
        await seconds(1.5);
        await press(page, 'ArrowRight', 1);
        await press(page, 'Space', 0.3);
        await picture(page, 'play');
        const run = here(await linkOf(page));
        expect(run.ok && /\+Right/.test(run.input) && /\+Space/.test(run.input), `keys reach the game; its link plays here to the same state (${ticksOf(run)} ticks)`);
        await page.mouse.move(600, 300);
        await page.mouse.move(610, 310);
        await seconds(0.3);
        await picture(page, 'tools');
        await page.click('#copy');
        await seconds(0.5);
        const copied = await page.evaluate('navigator.clipboard.readText()').catch((error) => String(error));
        await picture(page, 'copied');
        expect(copied.startsWith(site + '#r=') && here(copied).ok, `the button copies an address that plays here to the same state (${copied.length} characters)`);
        await press(page, 'ArrowLeft', 0.4);
        expect(/-Left/.test(here(await linkOf(page)).input), 'keys reach the game after the button');
        await page.mouse.move(620, 320);
        await page.click('#full');
        await seconds(1);
        expect(await page.evaluate('!!document.fullscreenElement'), 'the button makes it fullscreen');
        await page.close();
    },
    async replay() {
        const recorded = execFileSync(player, [project, '--headless', '--replay', path.join(import.meta.dirname || path.dirname(process.argv[1]), '../replay/platformer.replay'), '--frames', '300', '--print-link'], { encoding: 'utf8' });
        const link = /link: (\S+)/.exec(recorded)[1];
        const page = await open(link);
        await picture(page, 'replay-cover');
        await start(page);
        await picture(page, 'replay');
        expect(/press any key/.test(await line(page)), `the page says that it is a replay: "${await line(page)}"`);
        await page.waitForFunction('/ended/.test(document.getElementById("line").textContent)', { timeout: 20000 });
        await picture(page, 'replay-ended');
        expect(/the state is the recorded one/.test(await line(page)), `at its end: "${await line(page)}"`);
        await press(page, 'ArrowLeft', 0.4);
        const run = here(await linkOf(page));
        expect(run.ok && ticksOf(run) > 310, `it goes on live; the link of all of it plays here (${ticksOf(run)} ticks)`);
        await page.close();
        const second = await open(link);
        await start(second);
        await press(second, 'ArrowLeft', 0.4);
        expect(/You play/.test(await line(second)), `a key takes over: "${await line(second)}"`);
        expect(here(await linkOf(second)).ok, 'the link after that plays here');
        await second.close();
        const damaged = await open('#r=hello');
        await start(damaged);
        const text = await damaged.$eval('#text', (e) => e.textContent);
        await picture(damaged, 'damaged');
        expect(/damaged or incomplete/.test(text) && await isCovered(damaged), `a damaged link: "${text}"`);
        await damaged.close();
    },
    async hidden() {
        const page = await open();
        await start(page);
        const other = await browser.newPage();
        await other.bringToFront();
        await seconds(0.5);
        const state = await page.evaluate('document.visibilityState');
        const before = here(await linkOf(page)), sound = await page.evaluate('Module.SDL2 && Module.SDL2.audioContext && Module.SDL2.audioContext.state');
        await seconds(2);
        const after = here(await linkOf(page));
        expect(state === 'hidden' && ticksOf(after) - ticksOf(before) <= 2, `while hidden the game stands still (${ticksOf(after) - ticksOf(before)} ticks in 2 s, ${state}, sound ${sound})`);
        await page.bringToFront();
        await seconds(1);
        const again = here(await linkOf(page));
        expect(ticksOf(again) > ticksOf(after) + 20 && ticksOf(again) < ticksOf(after) + 100, `then it goes on (${ticksOf(again) - ticksOf(after)} ticks in 1 s)`);
        await other.close();
        for (const [width, height] of [[800, 600], [400, 800], [1600, 500]]) {
            await page.setViewport({ width, height });
            await seconds(0.7);
            const size = await page.evaluate('[document.getElementById("canvas").width, document.getElementById("canvas").height].join("x")');
            await picture(page, `size-${width}x${height}`);
            expect(size === `${width}x${height}`, `the picture follows the size of the window: ${size}`);
        }
        await page.close();
    },
    async touch() {
        for (const [width, height] of [[844, 390], [390, 844]]) {
            const page = await open('', { width, height, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
            await picture(page, `phone-${width}-cover`);
            await start(page, true);
            await seconds(1);
            await picture(page, `phone-${width}-title`);
            const confirm = await page.$('#touch button:not([hidden])');
            await confirm.tap();
            await seconds(2);
            const pad = await (await page.$('#touch .pad:not([hidden])')).boundingBox();
            const jump = await (await page.$('#touch button:not([hidden]):not(.menu)')).boundingBox();
            const first = { x: pad.x + pad.width * 0.9, y: pad.y + pad.height / 2, id: 1 };
            const second = { x: jump.x + jump.width / 2, y: jump.y + jump.height / 2, id: 2 };
            const fingers = await page.createCDPSession();
            const touch = (type, ...touchPoints) => fingers.send('Input.dispatchTouchEvent', { type, touchPoints });
            await touch('touchStart', first);
            await seconds(0.8);
            await picture(page, `phone-${width}-play`);
            await touch('touchStart', first, second);
            await seconds(0.3);
            await picture(page, `phone-${width}-jump`);
            await touch('touchEnd', first);
            await seconds(0.3);
            await touch('touchEnd');
            await seconds(0.5);
            const run = here(await linkOf(page));
            expect(run.ok && /\+Right/.test(run.input) && /-Right/.test(run.input), 'the pad presses and releases keys');
            expect(/\+Right[^]*\+Space[^]*-Space/.test(run.input), 'a second finger presses a button');
            await page.close();
        }
        const desktop = await open();
        await start(desktop);
        expect(await desktop.$eval('#touch', (e) => e.hidden), 'without touches there are no buttons');
        await desktop.close();
    },
    async pad() {
        const page = await open('', undefined, (p) => p.evaluateOnNewDocument(() => {
            const button = () => ({ pressed: false, touched: false, value: 0 });
            const pad = { id: 'Xbox 360 Controller (STANDARD GAMEPAD Vendor: 045e Product: 028e)', index: 0, connected: true, mapping: 'standard',
                timestamp: 1, axes: [0, 0, 0, 0], buttons: Array.from({ length: 17 }, button) };
            window.testPad = pad;
            navigator.getGamepads = () => [pad, null, null, null];
        }));
        await start(page);
        await page.evaluate(() => {
            const event = new Event('gamepadconnected');
            event.gamepad = window.testPad;
            window.dispatchEvent(event);
        });
        await seconds(0.5);
        const set = (code) => page.evaluate(code + '; testPad.timestamp += 1');
        await set('testPad.buttons[0] = {pressed: true, touched: true, value: 1}');
        await seconds(0.3);
        await set('testPad.buttons[0] = {pressed: false, touched: false, value: 0}');
        await seconds(2);
        for (const axis of [0.3, 0.6, 0.8]) await set(`testPad.axes[0] = ${axis}`), await seconds(0.2);  // SDL takes the first one as the centre
        await set('testPad.axes[0] = 0');
        await seconds(0.3);
        const run = here(await linkOf(page));
        expect(run.ok && /\+Gamepad1.A/.test(run.input) && /Gamepad1.LeftX=2/.test(run.input), 'buttons and sticks of a gamepad reach the game');
        await page.close();
    },
    async context() {
        const page = await open();
        await start(page);
        await press(page, 'Enter');
        await seconds(3);
        await picture(page, 'context-before');
        await page.evaluate(() => {
            window.lose = document.getElementById('canvas').getContext('webgl2').getExtension('WEBGL_lose_context');
            window.lose.loseContext();
        });
        await seconds(1);
        await picture(page, 'context-lost');
        const lost = here(await linkOf(page));
        await page.evaluate('lose.restoreContext()');
        await seconds(1.5);
        await picture(page, 'context-after');
        const sizes = ['before', 'lost', 'after'].map((name) => fs.statSync(path.join(pictures, `context-${name}.png`)).size);
        expect(sizes[2] > 0.7 * sizes[0] && sizes[1] < 0.5 * sizes[0], `the picture comes back after the context was lost (PNG of ${sizes.join(', ')} bytes)`);
        expect(ticksOf(here(await linkOf(page))) > ticksOf(lost), 'the game goes on');
        expect(!page.lines.some((text) => /error|stopped/i.test(text) && !/pread|favicon/.test(text)), 'without errors');
        await page.close();
    },
    async saves() {
        const other = await open();  // in another tab, without saves
        await start(other);
        // The page looks for changes at intervals: without them, only what the engine says makes it store a file.
        const page = await open('', undefined, (p) => p.evaluateOnNewDocument('window.setInterval = () => 0'));
        await page.bringToFront();
        await startLevel(page);
        await choosePaused(page, 'ArrowDown');
        for (const key of ['F10', 'ArrowDown', 'ArrowDown', 'ArrowDown', 'ArrowRight', 'F10']) await press(page, key, 0.3);  // another limit of frames
        await picture(page, 'saves');
        const third = await open();
        const files = await third.evaluate('["/saves/1.save", "/settings.json"].filter((name) => FS.analyzePath("/libsdl/Wickwood" + name).exists).join(" ")');
        expect(files === '/saves/1.save /settings.json', `a saved game and settings are stored at once: ${files}`);
        await page.evaluate("FS.writeFile('/libsdl/Wickwood/kept.txt', 'kept')");
        await page.bringToFront();
        await page.reload();
        await page.waitForFunction('window.readyAt', { timeout: 60000 });
        expect(await page.evaluate("FS.readFile('/libsdl/Wickwood/kept.txt', {encoding: 'utf8'})") === 'kept', 'files in the folder for saves are there after a reload');
        for (const tab of [page, other, third]) await tab.close();
    },
    async end() {
        const page = await open();
        await startLevel(page);
        const sound = () => page.evaluate('Module.SDL2.audioContext.state'), before = await sound();
        await choosePaused(page, 'ArrowUp');
        await covered(page);
        await picture(page, 'end');
        const text = await page.$eval('#text', (e) => e.textContent);
        expect(await isCovered(page) && before === 'running' && await sound() === 'suspended', `"${text}", the sound was ${before} and is ${await sound()}`);
        await page.evaluate('window.isOld = true');
        await press(page, 'Enter');
        await page.waitForFunction('!window.isOld && window.readyAt', { timeout: 60000 }).catch(() => {});
        expect(!(await page.evaluate('window.isOld')), 'Enter loads it again');
        await page.close();
    },
    async clipboard() {
        const page = await open('', undefined, (p) => p.evaluateOnNewDocument('Object.defineProperty(navigator, "clipboard", { value: undefined })'));
        await startLevel(page);
        await page.keyboard.down('ArrowRight');
        await seconds(0.5);
        await page.mouse.move(600, 300);
        await page.click('#copy');
        await covered(page);
        await picture(page, 'clipboard');
        const selected = (await page.evaluate('getSelection().toString()')).trim();
        expect(selected.startsWith(site + '#r=') && here(selected).ok, 'without a clipboard the link is shown, and plays here');
        const before = here(await linkOf(page));
        await page.keyboard.up('ArrowRight');
        await seconds(1);
        expect(ticksOf(here(await linkOf(page))) === ticksOf(before), 'meanwhile the game stands still');
        await page.keyboard.press('Enter');
        await seconds(1);
        const after = here(await linkOf(page));
        expect(after.ok && ticksOf(after) > ticksOf(before) + 20 && /-Right/.test(after.input), 'then it goes on, without the key that was held');
        await page.close();
    },
    async broken() {
        const dialogs = [];
        const page = await open('', undefined, async (p) => {
            p.on('dialog', (dialog) => { dialogs.push(dialog.message()); dialog.dismiss(); });
            await p.evaluateOnNewDocument(() => {
                const load = window.fetch;
                window.fetch = (url) => (url === 'game.pack' ? Promise.resolve(new Response('no pack')) : load(url));
            });
        });
        await start(page);
        const text = await page.$eval('#text', (e) => e.textContent);
        expect(await isCovered(page) && /game\.pack/.test(text) && dialogs.length === 0, `a damaged pack: "${text}", ${dialogs.length} dialogs`);
        await page.close();
    },
    async crash() {
        const page = await open();
        await start(page);
        await press(page, 'Enter');
        await seconds(1);
        await page.evaluate("setTimeout(() => abort('a test'), 0)");
        await seconds(1);
        await picture(page, 'crash');
        const text = await page.$eval('#text', (e) => e.textContent);
        expect(/has stopped.*a test/.test(text), `a crash says: "${text.split('\n')[0]}"`);
        const [button] = await page.$$('#choices button');
        await button.click();
        await seconds(0.5);
        const copied = await page.evaluate('navigator.clipboard.readText()').catch((error) => String(error));
        const run = here(copied);
        expect(run.ok && /\+Enter/.test(run.input), `and copies a link of the run (${copied.length} characters, ${ticksOf(run)} ticks)`);
        await page.close();
    },
    async memory() {
        const page = await open();
        await start(page);
        await press(page, 'Enter');
        const heap = () => page.evaluate('HEAP8.length / 1048576');
        const js = async () => { await page.evaluate('window.gc && gc()'); return (await page.metrics()).JSHeapUsedSize / 1048576; };
        const rows = [];
        for (let i = 0; i <= 6; ++i) {
            rows.push([await heap(), Number((await js()).toFixed(1))]);
            for (let n = 0; n < 40 && i < 6; ++n) {
                await press(page, ['ArrowRight', 'Space', 'ArrowLeft', 'Space'][n % 4], 0.3);
                await page.mouse.move(300 + 7 * n, 200 + 3 * n);
            }
        }
        const link = await linkOf(page);
        const run = here(link);
        expect(run.ok && rows.at(-1)[0] <= rows[1][0], `memory over ${(ticksOf(run) / 3600).toFixed(1)} min (wasm MB, JS MB): ${rows.map((r) => r.join('/')).join(' ')}; link ${link.length} characters`);
        await page.close();
    },
};

await runChecks(checks, wanted.length ? wanted : Object.keys(checks).filter((name) => name !== 'memory'));
