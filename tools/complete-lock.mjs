// `npm run lock`: completes package-lock.json after `npm install`.
//
// npm leaves out the optional packages of other platforms when the registry it asks does not offer them (mirrors often carry
// one platform), and then refuses its own file: `npm ci` ends with "Missing: … from lock file", and elsewhere the binary for
// that platform would not be installed. The entries need no more than what their parent and their name say. They have no
// checksum, because nobody here has seen the package.
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
if (added > 0) {
  lock.packages = Object.fromEntries(Object.entries(lock.packages).sort(([a], [b]) => a.localeCompare(b, 'en')));
  writeFileSync(file, `${JSON.stringify(lock, null, 2)}\n`);
}
console.log(added === 0 ? 'The lock file is complete.' : `Added ${added} packages of other platforms to the lock file.`);

/** As Node looks a package up: beside the one that asks, then in each folder above. */
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
