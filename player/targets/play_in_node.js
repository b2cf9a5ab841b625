// Plays an exported page without a browser: node play_in_node.js FOLDER OPTIONS...
'use strict';
const fs = require('fs'), path = require('path'), vm = require('vm');
const [folder, ...options] = process.argv.slice(2);
const file = (name) => path.join(folder, name);
Object.assign(globalThis, { require, __filename: file('player.js'), __dirname: folder });
globalThis.Module = {
    noInitialRun: true,
    wasmBinary: fs.readFileSync(file('player.wasm')),
    print: (line) => console.log(line),
    printErr: (line) => console.error(line),
    onRuntimeInitialized() {
        FS.writeFile('/game.pack', fs.readFileSync(file('game.pack')));
        process.exitCode = Module.callMain(options);
    },
};
vm.runInThisContext(fs.readFileSync(file('player.js'), 'utf8'), { filename: 'player.js' });
