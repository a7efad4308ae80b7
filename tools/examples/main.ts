import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { ToolMain } from '../lib/tool.ts';
import { makeRobot } from './robot.ts';

/** Makes the files in `examples/` that nobody drew by hand. */
export const main: ToolMain = async (_args, { root }) => {
  const path = join(root, 'examples', 'first-light', 'assets', 'robot.glb');
  const bytes = await makeRobot();
  await mkdir(dirname(path), { recursive: true });
  await writeFile(path, bytes);
  console.log(`${path}: ${bytes.length} bytes`);
  return 0;
};
