import { readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';

interface LockEntry {
  readonly version: string;
  readonly integrity?: string;
  readonly optional?: boolean;
  readonly cpu?: readonly string[];
  readonly os?: readonly string[];
  readonly optionalDependencies?: Readonly<Record<string, string>>;
}

const { packages } = JSON.parse(readFileSync('package-lock.json', 'utf8')) as { packages: Readonly<Record<string, LockEntry>> };

/** Without them `npm ci` refuses the file; `npm run lock` adds what `npm install` left out. */
test('the lock file holds the binaries of every platform', () => {
  const names = new Set(Object.keys(packages).map((path) => path.slice(path.lastIndexOf('node_modules/') + 'node_modules/'.length)));
  const wanted = Object.values(packages).flatMap((entry) => Object.keys(entry.optionalDependencies ?? {}));
  expect(wanted.filter((name) => !names.has(name))).toEqual([]);
  expect(packages['node_modules/@biomejs/cli-win32-x64']?.os).toEqual(['win32']);
});

/**
 * `npm ci` installs what has no checksum unseen. Registries that carry one platform know none of the others' binaries: those alone may
 * be without, until `npm run lock` has asked a registry that knows them.
 */
test('the lock file has the checksum of every package, but of other platforms’ binaries', () => {
  const unchecked = Object.entries(packages).filter(
    ([path, { integrity }]) => path !== '' && !/^sha512-[\w+/]{86}==$/.test(integrity ?? ''),
  );
  const others = unchecked.filter(([, { optional, os, cpu }]) => optional === true && os !== undefined && cpu !== undefined);
  expect(unchecked.filter((entry) => !others.includes(entry))).toEqual([]);
  // Fewer is better.
  expect(others.length).toBeLessThanOrEqual(40);
});
