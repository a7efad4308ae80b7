import { existsSync } from 'node:fs';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { packager } from '@electron/packager';
import { runCommand } from '../lib/run-command.ts';
import type { ToolMain } from '../lib/tool.ts';
import { setFuses } from './fuses.ts';
import { addDesktopFiles } from './linux.ts';
import { printNotices, readNotices } from './notices.ts';
import { packagerOptions } from './packager-options.ts';
import { fillStagingFolder } from './staging-folder.ts';
import { readTarget, type Target, USAGE } from './target.ts';
import { zipFolder } from './zip.ts';

/** File beside the program and Electron’s own license files. */
const NOTICES_FILE = 'THIRD-PARTY-NOTICES.txt';

/** `npm run package`: packages the app as a self-contained folder. */
export const main: ToolMain = async (args, { root }) => {
  let target: Target;
  try {
    target = readTarget(args);
  } catch (error) {
    console.error(`${error instanceof Error ? error.message : String(error)}\n\n${USAGE}`);
    return 2;
  }
  const built = await runCommand(process.execPath, [join(root, 'tools', 'build.mjs')], { cwd: root });
  if (built !== 0) return built;
  const work = await mkdtemp(join(tmpdir(), 'scrim-package-'));
  try {
    console.log(`${await packageApp(root, work, { ...target, out: resolve(root, target.out) })}`);
    return 0;
  } finally {
    await rm(work, { recursive: true, force: true });
  }
};

/** Packages the app for a target. Returns the folder of the app. */
async function packageApp(root: string, work: string, target: Target): Promise<string> {
  const staged = join(work, 'app');
  await fillStagingFolder(root, staged, target);
  const electronVersion = await versionOf(root, target.electron);
  const zips = target.electron === null ? null : join(work, 'electron');
  if (target.electron !== null && zips !== null) {
    await mkdir(zips);
    const zip = join(zips, `electron-v${electronVersion}-${target.platform}-${target.arch}.zip`);
    // Excludes the default app of the unpacked Electron.
    await zipFolder(target.electron, zip, (path) => /^resources\/(?:app\/|default_app\.asar$)/.test(path));
  }
  const { version } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8')) as { version: string };
  const [app] = await packager(packagerOptions({ target, root, staged, electronVersion, zips, version }));
  if (app === undefined || !existsSync(app)) throw new Error('The packager made nothing.');
  await writeFile(join(app, NOTICES_FILE), printNotices(await readNotices(root)));
  if (target.platform === 'linux') await addDesktopFiles(app, root);
  await setFuses(app, target);
  return app;
}

/** Version of an unpacked Electron, from its file `version`. */
async function versionOf(root: string, electron: string | null): Promise<string> {
  if (electron !== null) return (await readFile(join(electron, 'version'), 'utf8')).trim().replace(/^v/, '');
  const manifest = JSON.parse(await readFile(join(root, 'node_modules', 'electron', 'package.json'), 'utf8')) as { version: string };
  return manifest.version;
}
