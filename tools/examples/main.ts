import { mkdir, writeFile } from 'node:fs/promises';
import { dirname, join } from 'node:path';
import type { ToolMain } from '../lib/tool.ts';
import { makeRobot } from './robot.ts';

/** Projects are whole folders, so each has the model for itself. */
const ROBOT_PATHS = ['examples/first-light/assets/robot.glb', 'examples/templates/occlusion/assets/robot.glb'];

/** Makes the files in `examples/` that nobody drew by hand. */
export const main: ToolMain = async (_args, { root }) => {
  const bytes = await makeRobot();
  for (const path of ROBOT_PATHS) {
    await mkdir(dirname(join(root, path)), { recursive: true });
    await writeFile(join(root, path), bytes);
    console.log(`${path}: ${bytes.length} bytes`);
  }
  return 0;
};
