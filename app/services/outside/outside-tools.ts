import { constants } from 'node:fs';
import { access, stat } from 'node:fs/promises';
import { basename, delimiter, isAbsolute, join, resolve } from 'node:path';
import process from 'node:process';
import { refusal } from '../file-errors.ts';

/** A program of others that Scrim runs where it is installed. */
export interface OutsideTool {
  readonly title: string;
  /** Names of its executable file. */
  readonly commands: readonly string[];
  /** Environment variable with the path of its executable file. */
  readonly setting: string;
  /** Where to get it. */
  readonly url: string;
}

export const COLMAP: OutsideTool = {
  title: 'COLMAP',
  commands: ['colmap'],
  setting: 'SCRIM_COLMAP',
  url: 'https://colmap.github.io/install.html',
};

export const BLENDER: OutsideTool = {
  title: 'Blender',
  commands: ['blender'],
  setting: 'SCRIM_BLENDER',
  url: 'https://www.blender.org/download/',
};

export const INSTANT_MESHES: OutsideTool = {
  title: 'Instant Meshes',
  commands: ['Instant Meshes', 'InstantMeshes', 'instant-meshes'],
  setting: 'SCRIM_INSTANT_MESHES',
  url: 'https://github.com/wjakob/instant-meshes',
};

/**
 * Finds a tool: at the path of an option, else at that of its setting, else in the folders of PATH.
 *
 * @param given The path of an option; null if there is none.
 * @returns An absolute path.
 * @throws SCR078 with the place to get it if it is nowhere, or not at the path that was named
 */
export async function findTool({ title, commands, setting, url }: OutsideTool, given: string | null): Promise<string> {
  const named = given ?? (process.env[setting] || null);
  if (named !== null) {
    const path = resolve(named);
    if (await isExecutable(path)) return path;
    throw refusal(
      'SCR078',
      `${title} cannot be run: ${path} is no executable file.`,
      `Name the executable file of ${title}, or install it: ${url}`,
    );
  }
  const endings = process.platform === 'win32' ? ['.exe', '.bat'] : [''];
  for (const folder of (process.env.PATH ?? '').split(delimiter)) {
    // A relative folder would find files of whatever folder this process was started in.
    if (!isAbsolute(folder)) continue;
    for (const name of commands.flatMap((command) => endings.map((ending) => command + ending))) {
      const path = join(folder, name);
      if (await isExecutable(path)) return path;
    }
  }
  throw refusal('SCR078', `${title} is not installed: it is in no folder of PATH.`, `Get it from ${url}, or set ${setting} to its path.`);
}

/**
 * Finds a tool for a page, which may not name other programs.
 *
 * @param typed The path that was typed; null if there is none.
 * @throws SCR078
 */
export async function findTypedTool(tool: OutsideTool, typed: string | null): Promise<string> {
  const { title, commands, url } = tool;
  if (typed !== null && !commands.some((command) => plain(basename(typed.replaceAll('\\', '/'))).startsWith(plain(command)))) {
    throw refusal(
      'SCR078',
      `${typed} is not ${title}: the name of its executable file begins with “${commands[0]}”.`,
      `Get ${title} from ${url}`,
    );
  }
  return findTool(tool, typed);
}

function plain(name: string): string {
  return name.toLowerCase().replace(/[ _-]/g, '');
}

async function isExecutable(path: string): Promise<boolean> {
  try {
    await access(path, constants.X_OK);
    return (await stat(path)).isFile();
  } catch {
    return false;
  }
}
