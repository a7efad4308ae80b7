import { join, resolve } from 'node:path';
import { app } from 'electron';
import manifest from '../../package.json';
import { installationAt } from '../services/installation.ts';
import { startApp } from './start-app.ts';

// The entry of Electron's main process, bundled to dist/electron/main.cjs. Packaged, it lies in an archive; what esbuild, a
// program of its own, has to read lies beside that (tools/package/staging-folder.ts).
const home = resolve(__dirname, '..', '..');
const root = app.isPackaged ? join(home.replace(/\.asar$/, '.asar.unpacked'), 'sources') : home;
startApp(app, installationAt(root, manifest.version, home));
