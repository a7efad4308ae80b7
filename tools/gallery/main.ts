import { mkdir, writeFile } from 'node:fs/promises';
import { basename, join, relative, resolve } from 'node:path';
import { findExamples } from '../../app/services/find-examples.ts';
import type { ToolMain } from '../lib/tool.ts';
import { drawExample } from './draw-example.ts';
import { makeSheet, type SheetCell } from './make-sheet.ts';

const OWN_SHEET = 'docs/gallery.jpg';

/**
 * Makes a contact sheet of all examples over the studio, `docs/gallery.jpg`. With folders of recorded sessions named, and a folder to
 * write to before them, makes one sheet for each session there instead: `npm run gallery -- /tmp/sheets recordings/desk`.
 */
export const main: ToolMain = async ([out, ...sessions], { root }) => {
  const examples = await findExamples(join(root, 'examples'));
  const sheets =
    out === undefined
      ? [{ session: null, file: join(root, OWN_SHEET) }]
      : sessions.map((session) => ({ session, file: join(resolve(out), `${basename(resolve(session))}.jpg`) }));
  let problems = 0;
  for (const { session, file } of sheets) {
    const cells: SheetCell[] = [];
    for (const { path, title } of examples) {
      const { png, said } = await drawExample(root, path, session);
      if (said !== '') console.log(`${relative(root, path)}: ${said}`);
      if (png === null || said !== '') problems++;
      if (png) cells.push({ title, png });
    }
    const sheet = await makeSheet(cells);
    await mkdir(join(file, '..'), { recursive: true });
    await writeFile(file, sheet);
    console.log(`${file}: ${cells.length} examples, ${sheet.length} bytes`);
  }
  return problems === 0 ? 0 : 1;
};
