import { execFile } from 'node:child_process';
import { cp, mkdtemp, rm, symlink } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import process from 'node:process';
import { promisify } from 'node:util';

const REPOSITORY = resolve(import.meta.dirname, '../..');

export interface RepositoryCopy {
  /** Absolute path. */
  readonly root: string;
  /** Runs a script in the copy and returns its output. A failure fails the test with the output. */
  node(...args: string[]): Promise<string>;
  dispose(): Promise<void>;
}

/** Copies some folders and files of the repository and links its packages, so that a test may write without changing the original. */
export async function copyRepository(paths: readonly string[]): Promise<RepositoryCopy> {
  const root = await mkdtemp(join(tmpdir(), 'scrim-copy-'));
  for (const path of paths) await cp(join(REPOSITORY, path), join(root, path), { recursive: true });
  await symlink(join(REPOSITORY, 'node_modules'), join(root, 'node_modules'));
  const env = { ...process.env, NODE_OPTIONS: '--experimental-vm-modules --disable-warning=ExperimentalWarning' };
  return {
    root,
    node: async (...args) => {
      try {
        const { stdout, stderr } = await promisify(execFile)(process.execPath, args, { cwd: root, env });
        return stdout + stderr;
      } catch (error) {
        const { stdout, stderr } = error as { stdout: string; stderr: string };
        throw new Error(`${args.join(' ')}:\n${stdout}${stderr}`);
      }
    },
    dispose: () => rm(root, { recursive: true }),
  };
}
