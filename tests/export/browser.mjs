// What the checks in Chromium share: a server on this computer, the browser, and the count of failures.
// Needs puppeteer-core, found by PUPPETEER=FOLDER/node_modules/puppeteer-core/lib/esm/puppeteer/puppeteer-core.js.
import http from 'node:http';
import path from 'node:path';

const { default: puppeteer } = await import(process.env.PUPPETEER || 'puppeteer-core');
const types = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };

export const seconds = (count) => new Promise((done) => setTimeout(done, 1000 * count));

let failures = 0;
export function expect(isTrue, what) {
    console.log(`${isTrue ? 'ok    ' : 'FAILED'} ${what}`);
    if (!isTrue) ++failures;
}

// Serves what contentOf returns for a path, e.g. "/index.html"; undefined: there is no such file. Returns the address.
export async function serve(contentOf) {
    const server = http.createServer((request, response) => {
        const name = decodeURIComponent(new URL(request.url, 'http://x').pathname).replace(/\/$/, '/index.html');
        const content = contentOf(name);
        if (content === undefined) return response.writeHead(404), response.end();
        const type = types[path.extname(name)] || 'application/octet-stream';
        response.writeHead(200, { 'Content-Type': type, 'Content-Length': Buffer.byteLength(content) });
        response.end(content);
    }).listen(0, '127.0.0.1');
    await new Promise((done) => server.once('listening', done));
    server.unref();
    return `http://127.0.0.1:${server.address().port}/`;
}

export const browser = await puppeteer.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium', headless: true, protocolTimeout: 240000,
    args: ['--no-sandbox', '--disable-dev-shm-usage', '--mute-audio', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'] });

export const allowClipboard = (site) => browser.defaultBrowserContext()
    .overridePermissions(site, ['clipboard-read', 'clipboard-write', 'clipboard-sanitized-write']).catch(() => {});

// A page of a game that waits for the click that starts it. prepare(page) is called before it is loaded.
export async function open(address, viewport = { width: 1280, height: 720 }, prepare = () => {}) {
    const page = await browser.newPage();
    page.lines = [];
    page.on('console', (message) => page.lines.push(message.text()));
    page.on('pageerror', (error) => page.lines.push('error: ' + error.message));
    await page.setViewport(viewport);
    await prepare(page);
    await page.goto(address, { waitUntil: 'load', timeout: 120000 });
    await page.waitForFunction('window.readyAt && document.querySelector("#choices button")', { timeout: 120000 });
    return page;
}

export const press = async (page, key, length = 0.15) => {
    await page.keyboard.down(key);
    await seconds(length);
    await page.keyboard.up(key);
    await seconds(0.2);
};

export const line = (page) => page.$eval('#line', (e) => (e.hidden ? '' : e.textContent));
export const isCovered = (page) => page.$eval('#cover', (e) => !e.hidden);

// Runs the checks {name: function}, or those that are named, and ends the program.
export async function run(checks, wanted) {
    for (const name of wanted) {
        try {
            await checks[name]();
        } catch (error) {
            expect(false, `${name}: ${error.stack}`);
        }
    }
    await browser.close();
    process.exit(failures === 0 ? 0 : 1);
}
