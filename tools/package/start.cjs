// The entry of the packaged app. esbuild is a program of its own: the system cannot start it from inside the archive, and it
// reads nothing there. So it lies outside, with the sources that pages are bundled from; its package asks for the place when it
// is loaded.
const { join } = require('node:path');
const process = require('node:process');

const outside = join(__dirname.replace(/\.asar$/, '.asar.unpacked'), 'sources');
const program = process.platform === 'win32' ? ['esbuild.exe'] : ['bin', 'esbuild'];
process.env.ESBUILD_BINARY_PATH = join(outside, 'node_modules', '@esbuild', `${process.platform}-${process.arch}`, ...program);
require('./dist/electron/main.cjs');
