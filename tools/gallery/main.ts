import { mkdir, writeFile } from 'node:fs/promises';
import { basename, dirname, join, relative, resolve } from 'node:path';
import sharp from 'sharp';
import { findExamples, pictureOf } from '../../app/services/find-examples.ts';
import { installationAt } from '../../app/services/installation.ts';
import { findTemplates } from '../../app/services/templates.ts';
import type { ToolMain } from '../lib/tool.ts';
import { CELL, drawExample } from './draw-example.ts';
import { makeSheet, type SheetCell } from './make-sheet.ts';

const WIDTH_PX = 240;

/** JPEG quality of thumbnails. Each has about 9 kB, and all of them are sent to the editor at once. */
const QUALITY = 74;

const OWN_SHEET = 'docs/gallery.jpg';

/**
 * `npm run gallery` renders all examples in the studio to a contact sheet, `docs/gallery.jpg`, and to the thumbnails of examples and templates
 * that the editor shows. `npm run gallery -- OUT SESSION…` writes one contact sheet per recorded session to the folder OUT instead.
 */
export const main: ToolMain = async ([out, ...sessions], { root }) => {
  const { examplesDir, templatesDir } = installationAt(root, '0.0.0');
  const examples = await findExamples(examplesDir);
  const sheets =
    out === undefined
      ? [{ session: null, file: join(root, OWN_SHEET) }]
      : sessions.map((session) => ({ session, file: join(resolve(out), `${basename(resolve(session))}.jpg`) }));
  let problems = 0;
  for (const { session, file } of sheets) {
    const cells: SheetCell[] = [];
    const draw = async (path: string) => {
      const { png, said } = await drawExample(root, path, session);
      if (said !== '') console.log(`${relative(root, path)}: ${said}`);
      if (png === null || said !== '') problems++;
      return png;
    };
    for (const { path, title } of examples) {
      const png = await draw(path);
      if (png) cells.push({ title, png: await sharp(png).resize(CELL.widthPx, CELL.heightPx).png().toBuffer() });
      if (png && session === null) await writeThumbnail(examplesDir, basename(path), png);
    }
    if (session === null) {
      for (const { name } of await findTemplates(templatesDir)) {
        const png = await draw(join(templatesDir, name));
        if (png) await writeThumbnail(examplesDir, `template-${name}`, png);
      }
    }
    const sheet = await makeSheet(cells);
    await mkdir(join(file, '..'), { recursive: true });
    await writeFile(file, sheet);
    console.log(`${file}: ${cells.length} examples, ${sheet.length} bytes`);
  }
  return problems === 0 ? 0 : 1;
};

/** Writes the small image of an example for the editor. */
async function writeThumbnail(examplesDir: string, name: string, png: Uint8Array): Promise<void> {
  const file = pictureOf(examplesDir, name);
  await mkdir(dirname(file), { recursive: true });
  await writeFile(file, await sharp(png).resize({ width: WIDTH_PX }).jpeg({ quality: QUALITY }).toBuffer());
}
