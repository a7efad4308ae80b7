import { existsSync } from 'node:fs';
import { readdir, readFile } from 'node:fs/promises';
import { join } from 'node:path';

/** Names of license files. */
const LICENSE_FILE = /^(?:licen[cs]e|copying|notice|third[-_ ]?party)/i;

/** Notice of a package that is part of the app. */
export interface Notice {
  readonly name: string;
  readonly version: string;
  /** SPDX expression of the manifest. */
  readonly license: string;
  /** Address of the sources. */
  readonly source: string | null;
  readonly texts: readonly string[];
}

/**
 * Reads the notices of all packages that the app contains: the `dependencies` of package.json and their dependencies, because the pages of
 * the editor are bundled from them. Packages for tests and builds alone are omitted. Throws if a package states no license.
 */
export async function readNotices(root: string): Promise<readonly Notice[]> {
  const found = new Map<string, Notice>();
  const add = async (name: string) => {
    const folder = join(root, 'node_modules', name);
    if (found.has(name) || !existsSync(folder)) return;
    const manifest = JSON.parse(await readFile(join(folder, 'package.json'), 'utf8')) as Manifest;
    const { version, dependencies = {}, optionalDependencies = {} } = manifest;
    const license = licenseOf(manifest);
    const texts = await licenseTexts(folder);
    if (license === null && texts.length === 0) throw new Error(`${name} ${version} says nothing of its license.`);
    found.set(name, { name, version, license: license ?? 'see below', source: sourceOf(manifest), texts });
    for (const next of Object.keys({ ...dependencies, ...optionalDependencies })) await add(next);
  };
  const { dependencies = {} } = JSON.parse(await readFile(join(root, 'package.json'), 'utf8')) as Manifest;
  for (const name of Object.keys(dependencies)) await add(name);
  return [...found.values()].sort((a, b) => (a.name < b.name ? -1 : 1));
}

/** Text of the notices file. Electron contains the licenses of Electron and Chromium. */
export function printNotices(notices: readonly Notice[]): string {
  const line = '-'.repeat(80);
  const parts = notices.map(({ name, version, license, source, texts }) =>
    [line, `${name} ${version}`, `License: ${license}`, ...(source === null ? [] : [`Source: ${source}`]), '', ...texts].join('\n'),
  );
  return `Scrim is made with the packages below, each under its own license. Electron and Chromium, which it runs in, come with
LICENSE.electron.txt (LICENSE in some systems' folders) and LICENSES.chromium.html beside this file.

Packages under the EPL, the MPL and the LGPL are used unchanged; their sources are at the addresses given.

${notices.map(({ name, version, license }) => `${name} ${version} (${license})`).join('\n')}

${parts.join('\n\n')}
`;
}

interface Manifest {
  readonly version: string;
  readonly license?: string | { readonly type?: string };
  readonly licenses?: readonly { readonly type?: string }[];
  readonly repository?: string | { readonly url?: string };
  readonly homepage?: string;
  readonly dependencies?: Readonly<Record<string, string>>;
  readonly optionalDependencies?: Readonly<Record<string, string>>;
}

function licenseOf({ license, licenses }: Manifest): string | null {
  if (typeof license === 'string') return license;
  return license?.type ?? licenses?.map(({ type }) => type).join(' OR ') ?? null;
}

function sourceOf({ repository, homepage }: Manifest): string | null {
  const url = typeof repository === 'string' ? repository : repository?.url;
  return url?.replace(/^git\+/, '') ?? homepage ?? null;
}

async function licenseTexts(folder: string): Promise<readonly string[]> {
  const entries = await readdir(folder, { withFileTypes: true });
  const names = entries.filter((entry) => entry.isFile() && LICENSE_FILE.test(entry.name)).map(({ name }) => name);
  return Promise.all(names.sort().map(async (name) => (await readFile(join(folder, name), 'utf8')).trim()));
}
