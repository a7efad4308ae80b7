import { execFileSync } from 'node:child_process';
import { mkdir, rm, symlink, truncate, utimes, writeFile } from 'node:fs/promises';
import { createServer } from 'node:net';
import { dirname, join } from 'node:path';
import process from 'node:process';
import { OWNER, ownerOf } from '../../app/services/owner.ts';
import { projectText } from '../support/project-kit.ts';

/** A project made to do harm. `make` gets the project's folder, which holds a fine project, and a folder outside of it. */
export interface HostileProject {
  readonly name: string;
  make(root: string, outside: string): Promise<void>;
}

const PROJECT = 'project.scrim.json';

/** Files that are read when a project is opened, checked, saved or exported; and folders that are listed. */
const FILES = [
  PROJECT,
  'project.layout.json',
  'assets/hostile.png',
  'shaders/hostile.fs',
  'shaders/chunks/hostile.glsl',
  'sessions/hostile/session.json',
  '.scrim/lock',
  '.scrim/save.json',
  '.scrim/.gitignore',
  `.scrim/unsaved-${OWNER.replace(/-\d+-/, '-999999999-')}-${'a'.repeat(32)}.json`,
  '.scrim/cache',
] as const;
const FOLDERS = ['assets', 'shaders', 'shaders/chunks', 'sessions', '.scrim'] as const;

/** What can stand where a file or a folder is looked for. */
const KINDS: Readonly<Record<string, (path: string, outside: string) => Promise<unknown>>> = {
  'a named pipe': async (path) => execFileSync('mkfifo', [path]),
  'a socket': (path) => bindSocket(path),
  'a link to a file outside': (path, outside) => symlink(join(outside, 'secret.txt'), path),
  'a link to a folder outside': (path, outside) => symlink(outside, path),
  'a link to a device': (path) => symlink('/dev/zero', path),
  'a link to itself': (path) => symlink(path, path),
  'a folder': (path) => mkdir(path),
  'a huge file': async (path) => {
    await writeFile(path, '');
    await truncate(path, 2 ** 40);
  },
  'bytes of no text': (path) =>
    writeFile(
      path,
      Uint8Array.from({ length: 4096 }, (_, i) => (i * 7919) % 256),
    ),
};

export function hostileProjects(): readonly HostileProject[] {
  return [...replacedFiles(), ...replacedFolders(), ...texts(), ...nesting(), ...names(), ...locks(), ...journals(), ...devices()];
}

function replacedFiles(): HostileProject[] {
  return FILES.flatMap((path) => Object.entries(KINDS).map(([kind, make]) => replaced(path, kind, make)));
}

function replacedFolders(): HostileProject[] {
  return FOLDERS.flatMap((path) =>
    Object.entries(KINDS).flatMap(([kind, make]) => (kind === 'a folder' ? [] : [replaced(path, kind, make)])),
  );
}

function replaced(path: string, kind: string, make: (path: string, outside: string) => Promise<unknown>): HostileProject {
  return {
    name: `${path.replace(/unsaved-.*/, 'unsaved work')} is ${kind}`,
    make: async (root, outside) => {
      const target = join(root, path);
      await mkdir(dirname(target), { recursive: true });
      await rm(target, { recursive: true, force: true });
      await make(target, outside);
    },
  };
}

/** Only root can make a device; as somebody else, the links above stand for it. */
function devices(): HostileProject[] {
  if (process.getuid?.() !== 0) return [];
  return FILES.map((path) => replaced(path, 'a device', async (target) => execFileSync('mknod', [target, 'c', '1', '5'])));
}

function texts(): HostileProject[] {
  const fine = projectText({ title: 'Hostile', nodes: {}, wires: [] });
  const cut = [0, 0.1, 0.3, 0.5, 0.7, 0.9].map((part) => [`cut off at ${part * 100} %`, fine.slice(0, fine.length * part)] as const);
  const others = [
    ['null', 'null'],
    ['a number', '1e999'],
    ['a string', '"project"'],
    ['a list', '[[]]'],
    ['an empty object', '{}'],
    ['lists in lists without end', '['.repeat(200_000)],
    ['objects in objects without end', '{"a":'.repeat(200_000)],
    ['a prototype', '{"__proto__":{"title":"x"},"constructor":{"prototype":{}}}'],
    ['text that is no UTF-8', '\uFFFD\u0000\u202E'],
    ['a title of a megabyte', JSON.stringify({ ...JSON.parse(fine), title: 'x'.repeat(2 ** 20) })],
    ['graphs of another kind', JSON.stringify({ ...JSON.parse(fine), graphs: [] })],
    ['no graphs', JSON.stringify({ ...JSON.parse(fine), graphs: {} })],
    ['a version of the future', JSON.stringify({ ...JSON.parse(fine), version: 1e9, format: 'scrim/999' })],
  ] as const;
  return [PROJECT, 'project.layout.json'].flatMap((path) =>
    [...cut, ...others].map(([kind, text]) => ({ name: `${path} is ${kind}`, make: (root: string) => writeFile(join(root, path), text) })),
  );
}

function nesting(): HostileProject[] {
  return ['assets', 'shaders/chunks'].flatMap((folder) => [
    {
      name: `${folder} nests a thousand deep`,
      make: async (root: string) => {
        await mkdir(join(root, folder, ...Array.from({ length: 1000 }, () => 'd')), { recursive: true });
      },
    },
    {
      name: `${folder} holds five hundred files`,
      make: async (root: string) => {
        await mkdir(join(root, folder), { recursive: true });
        for (let i = 0; i < 500; i++) await writeFile(join(root, folder, `f${i}.glsl`), '');
      },
    },
  ]);
}

function names(): HostileProject[] {
  const assetPaths = ['../outside/secret.txt', '/etc/passwd', 'assets/../../outside/secret.txt', 'assets/%2e%2e/secret.txt', 'C:\\secret'];
  const inDocument = assetPaths.map((path) => ({
    name: `an asset is called ${path}`,
    make: async (root: string) => {
      const project = JSON.parse(projectText({ title: 'Hostile', nodes: {}, wires: [] })) as object;
      await writeFile(join(root, PROJECT), JSON.stringify({ ...project, assets: { image: { kind: 'image', path } } }));
    },
  }));
  const onDisk = ['a\\b', 'a:b', '%2e%2e', '\u202Egnp.exe', '\n', '-rf', 'x'.repeat(250)].map((name) => ({
    name: `a file is called ${JSON.stringify(name.slice(0, 12))}`,
    make: async (root: string) => {
      for (const folder of ['assets', 'shaders', 'shaders/chunks', 'sessions']) {
        await mkdir(join(root, folder, name), { recursive: true });
        await writeFile(join(root, folder, `${name}.fs`), 'void main() {}\n');
      }
    },
  }));
  return [...inDocument, ...onDisk];
}

function locks(): HostileProject[] {
  const owners = {
    'another machine': OWNER.replace(/^[0-9a-f]{8}/, '00000000'),
    'a process that runs': ownerOf(process.ppid),
    'a process that ended': OWNER.replace(/-\d+-/, '-999999999-'),
    nobody: '',
    'a path': '../../outside/secret.txt',
    'a number without end': `00000000-${'9'.repeat(300)}-1`,
  };
  return Object.entries(owners).flatMap(([who, text]) =>
    [-120_000, 3_600_000].map((ageMs) => ({
      name: `the lock is of ${who}, ${ageMs < 0 ? 'two minutes old' : 'dated an hour ahead'}`,
      make: async (root: string) => {
        await mkdir(join(root, '.scrim'), { recursive: true });
        const lock = join(root, '.scrim', 'lock');
        await writeFile(lock, text);
        const date = new Date(Date.now() + ageMs);
        await utimes(lock, date, date);
      },
    })),
  );
}

function journals(): HostileProject[] {
  const staging = '.scrim/save-0123456789ab';
  const change = (path: string, action = 'remove') => ({ direction: 'forward', staging, changes: [{ path, action, had: true }] });
  const all = {
    'removes a file outside': change('../outside/secret.txt'),
    'removes an absolute path': change('/etc/passwd'),
    'writes outside': change('../outside/secret.txt', 'write'),
    'stages outside': { ...change('x'), staging: '../outside' },
    'has no changes': { direction: 'forward', staging },
    'goes sideways': { ...change('x'), direction: 'sideways' },
    'is a number': 7,
    'names the folder itself': change('.'),
  };
  return Object.entries(all).map(([what, journal]) => ({
    name: `the journal ${what}`,
    make: async (root: string) => {
      await mkdir(join(root, staging), { recursive: true });
      await writeFile(join(root, '.scrim', 'save.json'), JSON.stringify(journal));
    },
  }));
}

/** The name of a socket goes when its server closes: it is given another one first, and stays by that. */
async function bindSocket(path: string): Promise<void> {
  const short = join('/tmp', `scrim-socket-${process.pid}-${Math.floor(performance.now() * 1000)}`);
  const server = createServer();
  await new Promise<void>((resolve) => server.listen(short, resolve));
  execFileSync('mv', [short, path]);
  await new Promise((resolve) => server.close(resolve));
}
