import { join } from 'node:path';
import type { Options } from '@electron/packager';
import { OUTSIDE } from './staging-folder.ts';
import type { Target } from './target.ts';

export interface PackagerInput {
  readonly target: Target;
  readonly root: string;
  /** Staging folder of the app. */
  readonly staged: string;
  readonly electronVersion: string;
  /** Folder with Electron’s ZIP; null to let the packager download it. */
  readonly zips: string | null;
  readonly version: string;
}

/** Document types for macOS, which then shows a folder with the extension `.scrim` as a document. */
const DOCUMENT_TYPES = [
  {
    CFBundleTypeName: 'Scrim Project',
    CFBundleTypeRole: 'Editor',
    CFBundleTypeExtensions: ['scrim'],
    CFBundleTypeIconFile: 'electron.icns',
    LSHandlerRank: 'Owner',
    LSTypeIsPackage: true,
  },
];

/** Options of the packager for a target. */
export function packagerOptions({ target, root, staged, electronVersion, zips, version }: PackagerInput): Options {
  return {
    dir: staged,
    out: target.out,
    name: 'Scrim',
    executableName: 'scrim',
    platform: target.platform,
    arch: target.arch,
    electronVersion,
    ...(zips === null ? {} : { electronZipDir: zips }),
    appVersion: version,
    appCopyright: 'Scrim contributors, MIT license',
    // The packager adds the extension of the system.
    icon: join(root, 'app', 'electron', 'icons', 'scrim'),
    asar: { unpackDir: OUTSIDE },
    // The staging folder contains only required packages.
    prune: false,
    derefSymlinks: false,
    overwrite: true,
    quiet: true,
    appBundleId: 'app.scrim.editor',
    appCategoryType: 'public.app-category.graphics-design',
    extendInfo: { CFBundleDocumentTypes: DOCUMENT_TYPES },
    win32metadata: { CompanyName: 'Scrim contributors', FileDescription: 'Scrim', ProductName: 'Scrim', InternalName: 'scrim' },
  };
}
