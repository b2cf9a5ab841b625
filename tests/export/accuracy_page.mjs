// Checks the page of the accuracy lab: its engine must have the errors of the program here; then it is used in Chromium. The
// simulation has the same bits, but the errors are computed from it with the functions of the C library: some differ in the
// last of 16 digits, and what is left of a difference of two numbers near 1 (%) in the last of 9.
//   node accuracy_page.mjs FOLDER PLUMB-ACCURACY [PICTURES]
// FOLDER: what ./plumb accuracy --web FOLDER has written. Without PICTURES no browser is used; it needs puppeteer-core, see
// browser.mjs.
import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { createRequire } from 'node:module';
import { execFileSync } from 'node:child_process';

const [root, program, pictures] = process.argv.slice(2);
const require = createRequire(import.meta.url);
let failed = 0;
const check = (holds, what) => {
    console.log(`${holds ? 'ok  ' : 'FAIL'} ${what}`);
    if (!holds) failed = 1;
};

// ---- errors

const keyOf = (row) => [row.scene, row.figure, row.solver, row.integrator, row.substeps].join('|');
const work = fs.mkdtempSync(path.join(os.tmpdir(), 'plumb-accuracy-'));
execFileSync(program, ['--quick', '--no-peers', '--out', work], { stdio: 'ignore' });
const here = new Map(JSON.parse(fs.readFileSync(path.join(work, 'results.json'), 'utf8')).map((row) => [keyOf(row), row.error]));
fs.rmSync(work, { recursive: true });

const wasmBinary = fs.readFileSync(path.join(root, 'lab-engine.wasm'));
const lab = await require(path.resolve(root, 'lab-engine.js'))({ wasmBinary });
const types = ['string', 'number', 'number', 'number', 'number'];
const quick = new Set([...here.keys()].map((key) => key.split('|')[0]));
const isLike = (a, b) => a === b || (a !== null && b !== null && Math.abs(a - b) <= 1e-9 * Math.max(Math.abs(a), Math.abs(b), 1e-3));
let compared = 0;
const unlike = [];
for (const scene of JSON.parse(lab.ccall('labScenes', 'string', [], [])).filter(({ name }) => quick.has(name))) {
    for (const substeps of [1, 4, 16]) {
        for (const integrator of scene.smooth ? [0, 1, 2, 3] : [1]) {
            for (const trees of scene.joints ? [1, 0] : [1]) {
                for (const row of JSON.parse(lab.ccall('labMeasure', 'string', types, [scene.name, substeps, integrator, trees, 0]))) {
                    if (!here.has(keyOf(row))) continue;
                    ++compared;
                    if (!isLike(here.get(keyOf(row)), row.error)) unlike.push(`${keyOf(row)}: ${row.error}, here ${here.get(keyOf(row))}`);
                }
            }
        }
    }
}
check(compared > 200 && unlike.length === 0, `${compared} errors are those of the program here${unlike.map((each) => '\n     ' + each).join('')}`);

// ---- the page

if (pictures) {
    const { browser, seconds, serve } = await import('./browser.mjs');
    fs.mkdirSync(pictures, { recursive: true });
    const site = await serve((name) => {
        const file = path.join(root, name);
        return fs.existsSync(file) && fs.statSync(file).isFile() ? fs.readFileSync(file) : undefined;
    });
    const open = async (address, viewport) => {
        const page = await browser.newPage();
        page.on('pageerror', (error) => check(false, error.message));
        await page.setViewport(viewport);
        await page.goto(address);
        return page;
    };
    const measured = async (page) => {
        for (let i = 0; i < 240; ++i) {
            if (await page.evaluate("document.getElementById('state').textContent === '' && document.querySelector('#figures tr') !== null")) return;
            await seconds(0.25);
        }
    };
    const errorOn = (page) => page.evaluate("parseFloat(document.querySelector('#figures td.n').textContent)");
    const page = await open(site + 'index.html', { width: 1280, height: 900 });
    await measured(page);
    await page.screenshot({ path: path.join(pictures, 'lab.png') });
    const before = await errorOn(page);
    await page.evaluate("document.getElementById('substeps').value = 5; document.getElementById('substeps').dispatchEvent(new Event('input'))");
    await measured(page);
    const after = await errorOn(page);
    check(after < before / 10, `moving the slider from 4 to 32 substeps changes the error of a stack from ${before} to ${after} mm`);
    await page.click('#all');
    await seconds(1);
    await measured(page);
    const points = await page.evaluate("document.querySelectorAll('#chart svg circle').length");
    check(points >= 7, `the diagram has ${points} points`);
    await page.screenshot({ path: path.join(pictures, 'all.png') });
    for (const scene of ['pendulum90', 'resonance', 'stonearch']) {
        await page.select('#scene', scene);
        await measured(page);
        await seconds(1);
        await page.screenshot({ path: path.join(pictures, scene + '.png') });
    }
    const small = await open(site + 'index.html#bounces', { width: 390, height: 844 });
    await measured(small);
    check(await small.evaluate('document.documentElement.scrollWidth <= innerWidth'), 'nothing is wider than a phone');
    await small.screenshot({ path: path.join(pictures, 'phone.png'), fullPage: true });
    await browser.close();
}
process.exit(failed);
