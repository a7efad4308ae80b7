// `npm run lock`: completes package-lock.json after `npm install`.
//
// npm leaves out the optional packages of other platforms when the registry it asks does not offer them (mirrors often carry
// one platform), and then refuses its own file: `npm ci` ends with "Missing: … from lock file", and elsewhere the binary for
// that platform would not be installed. What an entry says of its platform follows from its parent and its name; where its
// archive is, and the checksum that `npm ci` compares it with, the registry is asked for. One that does not carry the package knows
// neither: the entry stays without, and the tool says so and fails, because it would be installed unseen.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { resolve } from 'node:path';

const SYSTEMS = ['aix', 'android', 'darwin', 'freebsd', 'linux', 'netbsd', 'openbsd', 'openharmony', 'sunos', 'win32'];
const PROCESSORS = { arm: /^arm/, riscv64: /^riscv64/ };

const file = resolve(import.meta.dirname, '..', 'package-lock.json');
const lock = JSON.parse(readFileSync(file, 'utf8'));
let added = 0;
for (const [parentPath, parent] of Object.entries(lock.packages)) {
  for (const [name, version] of Object.entries(parent.optionalDependencies ?? {})) {
    if (isThere(parentPath, name)) continue;
    lock.packages[`node_modules/${name}`] = entry(name, version, parent);
    added++;
  }
}
const isUnchecked = ([path, { link, integrity }]) => path !== '' && !link && integrity === undefined;
const asked = Object.entries(lock.packages).filter(isUnchecked);
for (const [path, { version, ...rest }] of asked) lock.packages[path] = { version, ...archiveOf(nameOf(path), version), ...rest };
if (added + asked.length > 0) {
  lock.packages = Object.fromEntries(Object.entries(lock.packages).sort(([a], [b]) => a.localeCompare(b, 'en')));
  writeFileSync(file, `${JSON.stringify(lock, null, 2)}\n`);
}
const unchecked = Object.entries(lock.packages).filter(isUnchecked);
if (added + asked.length === 0) console.log('The lock file is complete.');
else console.log(`Added ${added} packages of other platforms to the lock file, and ${asked.length - unchecked.length} checksums.`);
if (unchecked.length > 0) {
  console.error(`${unchecked.length} packages have no checksum; ask a registry that carries every platform (npm run lock --registry=URL):`);
  for (const [path, { version }] of unchecked) console.error(`  ${nameOf(path)}@${version}`);
  process.exitCode = 1;
}

function nameOf(path) {
  return path.slice(path.lastIndexOf('node_modules/') + 'node_modules/'.length);
}

/** URL and checksum of a package from npm’s client; undefined if the registry does not offer it. */
function archiveOf(name, version) {
  let text = '';
  try {
    text = execFileSync('npm', ['view', `${name}@${version}`, 'dist', '--json'], {
      encoding: 'utf8',
      shell: process.platform === 'win32',
      stdio: ['ignore', 'pipe', 'ignore'],
    });
  } catch {
    return {};
  }
  const { tarball, integrity } = text.trim() === '' ? {} : JSON.parse(text);
  return typeof integrity === 'string' ? { resolved: tarball, integrity } : {};
}

/** Whether a package is installed where Node looks for it: beside the importing package, or in a folder above. */
function isThere(from, name) {
  for (let path = from; ; path = path.slice(0, Math.max(0, path.lastIndexOf('node_modules/') - 1))) {
    if (lock.packages[`${path === '' ? '' : `${path}/`}node_modules/${name}`]) return true;
    if (path === '') return false;
  }
}

/** `@biomejs/cli-linux-x64-musl` runs on Linux, on x64, with musl. */
function entry(name, version, parent) {
  if (!/^\d/.test(version)) throw new Error(`${name} is wanted as ${version}: only exact versions can be completed.`);
  const words = name.slice(name.lastIndexOf('/') + 1).split('-');
  const system = words.find((word) => SYSTEMS.includes(word));
  if (system === undefined) throw new Error(`${name} does not name its platform.`);
  const word = words[words.indexOf(system) + 1] ?? '';
  const cpu = Object.keys(PROCESSORS).find((key) => PROCESSORS[key].test(word) && word !== 'arm64') ?? word;
  const libc = system !== 'linux' ? undefined : words.some((w) => w.startsWith('musl')) ? 'musl' : 'glibc';
  return {
    version,
    cpu: [cpu],
    ...(parent.dev ? { dev: true } : {}),
    ...(libc === undefined ? {} : { libc: [libc] }),
    optional: true,
    os: [system],
  };
}
