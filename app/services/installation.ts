import { homedir } from 'node:os';
import { join } from 'node:path';
import process from 'node:process';

/** Folders of this installation of Scrim. */
export interface Installation {
  readonly version: string;
  /** Folder with the sources and `node_modules`, from which exported pages are bundled. */
  readonly root: string;
  /** Folders of the built pages of the editor and the preview. */
  readonly pages: { readonly editor: string; readonly preview: string };
  readonly examplesDir: string;
  /** Folder with the template projects. */
  readonly templatesDir: string;
  /** Folder with the recorded sessions that come with Scrim. */
  readonly sessionsDir: string;
  /** Folder with the captures of emulated rooms. */
  readonly roomsDir: string;
  /** Folder for the projects of the user. */
  readonly projectsDir: string;
}

/**
 * The folders of the installation at `root`. The environment variable `SCRIM_PROJECTS` replaces the default projects folder, `~/Scrim`.
 *
 * @param home Folder with the built files, if it is not `root`: the archive of a packaged app.
 */
export function installationAt(root: string, version: string, home = root): Installation {
  const examplesDir = join(root, 'examples');
  return {
    version,
    root,
    pages: { editor: join(home, 'dist', 'editor'), preview: join(home, 'dist', 'preview') },
    examplesDir,
    templatesDir: join(examplesDir, 'templates'),
    sessionsDir: join(examplesDir, 'sessions'),
    projectsDir: process.env.SCRIM_PROJECTS || join(homedir(), 'Scrim'),
    roomsDir: join(root, 'node_modules', '@iwer', 'sem', 'captures'),
  };
}
