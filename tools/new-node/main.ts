import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import process from 'node:process';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { writeIfChanged } from '../lib/files.ts';
import { runCommand } from '../lib/run-command.ts';
import type { ToolContext } from '../lib/tool.ts';
import { refuseType, scaffold } from './scaffold.ts';

const byType = new Map(DEFINITIONS.map((definition) => [definition.type, definition]));
const LIBRARY: NodeLibrary = {
  definition: (type) => byType.get(type),
  shader: (name) => SHADERS[name],
  types: () => byType.keys(),
};

/** `npm run new-node CATEGORY/NAME`: a node folder that passes every check, to be changed into what it is to be. */
export async function main([type]: readonly string[], { root }: ToolContext): Promise<number> {
  const refusal = type === undefined ? 'Usage: npm run new-node CATEGORY/NAME' : refuseType(type, LIBRARY);
  if (type === undefined || refusal !== null) {
    console.error(refusal);
    return 1;
  }
  const folder = `nodes/${type}`;
  if (existsSync(join(root, folder))) {
    console.error(`${folder} is there already.`);
    return 1;
  }
  const files = scaffold(type, LIBRARY);
  for (const [path, text] of Object.entries(files)) await writeIfChanged(join(root, path), text);
  const biome = createRequire(join(root, 'package.json')).resolve('@biomejs/biome/bin/biome');
  const formatted = await runCommand(process.execPath, [biome, 'format', '--write', '--log-level=error', folder], { cwd: root });
  console.log(`Made ${Object.keys(files).join(', ')}.\nNext: change them, then \`npm run docs\` and \`npm run test:one unit ${folder}\`.`);
  return formatted;
}
