import { join } from 'node:path';

/** Where this Scrim lies. */
export interface Installation {
  readonly version: string;
  /** Holds the sources and `node_modules` that exported pages are bundled from. */
  readonly root: string;
  /** The built pages of the editor and of its preview. */
  readonly pages: { readonly editor: string; readonly preview: string };
  readonly examplesDir: string;
  /** Projects to begin with. */
  readonly templatesDir: string;
  /** Recorded sessions that come with Scrim. */
  readonly sessionsDir: string;
  /** Captures of emulated rooms. */
  readonly roomsDir: string;
}

/** `home` holds what is built, where that is not in `root`: in a packaged app, the archive. */
export function installationAt(root: string, version: string, home = root): Installation {
  const examplesDir = join(root, 'examples');
  return {
    version,
    root,
    pages: { editor: join(home, 'dist', 'editor'), preview: join(home, 'dist', 'preview') },
    examplesDir,
    templatesDir: join(examplesDir, 'templates'),
    sessionsDir: join(examplesDir, 'sessions'),
    roomsDir: join(root, 'node_modules', '@iwer', 'sem', 'captures'),
  };
}
