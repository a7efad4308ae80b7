import { existsSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import process from 'node:process';
import { DEFINITIONS, SHADERS } from '../../nodes/generated/definitions.gen.ts';
import type { NodeLibrary } from '../../nodes/kit/definition.ts';
import { writeIfChanged } from '../lib/files.ts';
import { runCommand } from '../lib/run-command.ts';
import type { ToolContext } from '../lib/tool.ts';
import { chooseTemplate, refuseType, scaffold, TEMPLATE_NAMES } from './scaffold.ts';

const byType = new Map(DEFINITIONS.map((definition) => [definition.type, definition]));
const LIBRARY: NodeLibrary = {
  definition: (type) => byType.get(type),
  shader: (name) => SHADERS[name],
  types: () => byType.keys(),
};

const USAGE = `Usage: npm run new-node CATEGORY/NAME [TEMPLATE]. Templates: ${TEMPLATE_NAMES.join(', ')}.`;

/** `npm run new-node CATEGORY/NAME [TEMPLATE]` creates a node folder that passes every check, to be edited. */
export async function main([type, named]: readonly string[], { root }: ToolContext): Promise<number> {
  const refusal = type === undefined ? USAGE : refuseType(type, LIBRARY);
  if (type === undefined || refusal !== null) {
    console.error(refusal);
    return 1;
  }
  const template = chooseTemplate(type, named);
  if (template === null) {
    const missing = named === undefined ? `No template belongs to the category of ${type}.` : `The template “${named}” does not exist.`;
    console.error(`${missing} Name one of these after the type: ${TEMPLATE_NAMES.join(', ')}.`);
    return 1;
  }
  const folder = `nodes/${type}`;
  if (existsSync(join(root, folder))) {
    console.error(`${folder} exists already. Choose another name, or delete the folder.`);
    return 1;
  }
  const files = scaffold(type, template, LIBRARY);
  for (const [path, text] of Object.entries(files)) await writeIfChanged(join(root, path), text);
  const biome = createRequire(join(root, 'package.json')).resolve('@biomejs/biome/bin/biome');
  const formatted = await runCommand(process.execPath, [biome, 'format', '--write', '--log-level=error', folder], { cwd: root });
  console.log(
    `Created ${Object.keys(files).join(', ')}.\nNext: edit them, then run \`npm run docs\` and \`npm run test:one unit ${folder}\`.`,
  );
  return formatted;
}
