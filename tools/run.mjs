import { createHash } from 'node:crypto';
import { mkdir, rename, rm, writeFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { pathToFileURL } from 'node:url';
import { build } from 'esbuild';

const root = resolve(import.meta.dirname, '..');
const cache = join(root, 'node_modules', '.cache', 'scrim', 'tools');

/**
 * `node tools/run.mjs ENTRY [ARGUMENT…]` starts a tool written in TypeScript, which Node 20 cannot run. It bundles the entry (about 20 ms)
 * into `node_modules/.cache`, where imports of npm packages resolve, and calls its `main(args, { root, version })`. The version is a
 * hash of the code of the tool, for caches of its output.
 *
 * @param {string} entry Path relative to this folder.
 * @param {readonly string[]} args
 */
async function runTool(entry, args) {
  process.setSourceMapsEnabled(true);
  if (process.env.npm_lifecycle_event !== undefined) endWithParent();
  endWithReader();
  const { main, version } = await loadTool(entry);
  process.exitCode = await main(args, { root, version });
}

/**
 * npm passes a signal on to the shell that runs a script. A shell that waits for its last command does not pass it on, so the tool
 * ends when the shell has gone.
 */
function endWithParent() {
  const parent = process.ppid;
  const watch = setInterval(() => {
    if (process.ppid === parent) return;
    clearInterval(watch);
    process.kill(process.pid, 'SIGTERM');
  }, 500);
  watch.unref();
}

/** Ends the tool when the reader of its output closes the pipe, as in `npm run bench | head`; `console` ignores that. */
function endWithReader() {
  for (const stream of [process.stdout, process.stderr]) {
    stream.on('error', (error) => {
      if (error.code !== 'EPIPE') throw error;
      process.kill(process.pid, 'SIGTERM');
    });
  }
}

async function loadTool(entry) {
  const result = await build({
    entryPoints: [join(import.meta.dirname, entry)],
    absWorkingDir: root,
    bundle: true,
    write: false,
    platform: 'node',
    format: 'esm',
    target: 'node20',
    packages: 'external',
    loader: { '.fs': 'text', '.vs': 'text', '.glsl': 'text' },
    sourcemap: 'inline',
  });
  const [file] = result.outputFiles;
  const version = createHash('sha256').update(file.contents).digest('hex').slice(0, 16);
  const path = join(cache, `${entry.replaceAll('/', '-')}.${version}.mjs`);
  await mkdir(cache, { recursive: true });
  // Through a rename, because two runs may write the same file at once.
  const temporary = `${path}.${process.pid}`;
  await writeFile(temporary, file.contents);
  await rename(temporary, path);
  try {
    return { main: (await import(pathToFileURL(path).href)).main, version };
  } finally {
    await rm(path, { force: true });
  }
}

const [entry, ...args] = process.argv.slice(2);
await runTool(entry, args);
