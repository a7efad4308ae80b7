import { resolve } from 'node:path';
import { app } from 'electron';
import manifest from '../../package.json';
import { installationAt } from '../services/installation.ts';
import { startApp } from './start-app.ts';

// The entry of Electron's main process, bundled to dist/electron/main.cjs.
startApp(app, installationAt(resolve(__dirname, '..', '..'), manifest.version));
