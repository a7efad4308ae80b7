import { join, resolve } from 'node:path';
import { app } from 'electron';
import manifest from '../../package.json';
import { installationAt } from '../services/installation.ts';
import { startApp } from './start-app.ts';

// Entry of Electron’s main process, bundled to dist/electron/main.cjs. In a packaged app it lies in an archive. The files that
// esbuild reads lie beside the archive, because it is another process (tools/package/staging-folder.ts).
const home = resolve(__dirname, '..', '..');
const root = app.isPackaged ? join(home.replace(/\.asar$/, '.asar.unpacked'), 'sources') : home;
startApp(app, installationAt(root, manifest.version, home));
