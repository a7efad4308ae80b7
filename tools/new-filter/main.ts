import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { DEFINITIONS } from '../../nodes/generated/definitions.gen.ts';
import { writeIfChanged } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { filterFiles, refuseName } from './filter-template.ts';

/** `npm run new-filter NAME` creates a working filter and a test of its formula, both to be edited. */
export async function main([name]: readonly string[], { root }: ToolContext): Promise<number> {
  const refusal = name === undefined ? 'Usage: npm run new-filter NAME' : refuseName(name, new Set(DEFINITIONS.map(({ type }) => type)));
  const files = name === undefined || refusal !== null ? {} : filterFiles(name);
  const taken = Object.keys(files).find((path) => existsSync(join(root, path)));
  if (refusal !== null || taken !== undefined) {
    console.error(refusal ?? `${taken} exists already. Choose another name.`);
    return 1;
  }
  for (const [path, text] of Object.entries(files)) await writeIfChanged(join(root, path), text);
  console.log(
    `Created ${Object.keys(files).join(' and ')}.\nNext: edit both, then run \`npm run docs\` and \`npm run test:one browser ${name}\`. Restart Scrim to see the filter among the nodes.`,
  );
  return 0;
}
