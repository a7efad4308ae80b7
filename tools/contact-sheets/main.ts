import { execFile } from 'node:child_process';
import { copyFile, mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { basename, join, resolve } from 'node:path';
import process from 'node:process';
import sharp from 'sharp';
import { LIBRARY } from '../../app/services/compile-project.ts';
import { listFiles } from '../lib/files.ts';
import type { ToolContext } from '../lib/tool.ts';
import { measureModel } from './measure-model.ts';
import { LIGHTS, type Style, sheetProject, sheetSession } from './sheet-project.ts';

/** Models of the examples: one without edges, one with soft edges, and three of thin or flat parts. */
const MODELS = [
  'examples/pen-strokes/assets/elephant.glb',
  'examples/first-light/assets/robot.glb',
  'nodes/source/model/example/assets/pinwheel.glb',
  'examples/marble-run/assets/chutes.glb',
  'examples/tin-cans/assets/can.glb',
] as const;

/** Filters that make a drawing or a painting of an image. `filter/room-drawing` needs a room and is not among them. */
const FILTERS = [
  'charcoal-drawing',
  'pencil-drawing',
  'hatched-drawing',
  'watercolor',
  'oil-painting',
  'comic-drawing',
  'stipple',
  'engraving',
  'pointillism',
  'difference-of-gaussians',
  'halftone',
  'anisotropic-kuwahara',
  'sobel-edges',
] as const;

/** Techniques that are no style: glass needs a layer behind it, and custom is a start for one's own. */
const NO_STYLE: ReadonlySet<string> = new Set(['custom', 'glass']);

/**
 * `npm run contact-sheets -- OUT [MODEL.glb…] [--style NAME]` renders a sheet for each technique and each drawing filter to the folder OUT:
 * a column for each model, by default five of the examples, and a row for each light.
 */
export async function main(args: readonly string[], { root }: ToolContext): Promise<number> {
  const only = args.includes('--style') ? args[args.indexOf('--style') + 1] : undefined;
  const [out, ...paths] = args.filter((arg) => arg !== '--style' && arg !== only);
  if (out === undefined) {
    console.error('Usage: npm run contact-sheets -- OUT [MODEL.glb…] [--style NAME]');
    return 2;
  }
  const files = paths.length > 0 ? paths.map((path) => resolve(path)) : MODELS.map((path) => join(root, path));
  const models = await Promise.all(files.map(measureModel));
  const all = await allStyles(root);
  const styles = all.filter(({ name }) => only === undefined || name === only);
  if (styles.length === 0) {
    console.error(`No style is named “${only}”. Styles: ${all.map(({ name }) => name).join(', ')}.`);
    return 2;
  }
  const { session, widthPx, heightPx } = sheetSession(models.length);
  const folder = await mkdtemp(join(tmpdir(), 'scrim-sheets-'));
  let problems = 0;
  try {
    await mkdir(join(folder, 'assets'));
    await mkdir(resolve(out), { recursive: true });
    for (const [i, file] of files.entries()) await copyFile(file, join(folder, 'assets', `${i}.glb`));
    await mkdir(join(folder, 'wall'));
    await writeFile(join(folder, 'wall', 'session.json'), JSON.stringify(session));
    await writeFile(join(folder, 'wall', 'wall.png'), await drawWall(widthPx, heightPx));
    console.log(`Columns: ${files.map((file) => basename(file, '.glb')).join(', ')}. Rows: ${LIGHTS.map(({ name }) => name).join(', ')}.`);
    for (const style of styles) {
      const project = sheetProject(models, style, (type) => LIBRARY.definition(type)?.version ?? 1);
      await writeFile(join(folder, 'project.scrim.json'), JSON.stringify(project));
      const png = join(folder, 'sheet.png');
      const said = await render(root, [folder, '--session', join(folder, 'wall'), '--size', `${widthPx}x${heightPx}`, '--out', png]);
      const lines = said.split('\n').filter((line) => line.trim() !== '' && !/^(Wrote|Building|npm warn)/.test(line));
      if (lines.length > 0) {
        problems++;
        console.log(`${style.name}: ${lines.join('\n')}`);
      }
      const drawn = await readFile(png).catch(() => null);
      if (drawn === null) continue;
      const file = join(resolve(out), `${style.name}.jpg`);
      await sharp(drawn).flatten({ background: '#fff' }).jpeg({ quality: 86 }).toFile(file);
      await rm(png);
      console.log(file);
    }
  } finally {
    await rm(folder, { recursive: true, force: true });
  }
  return problems === 0 ? 0 : 1;
}

async function allStyles(root: string): Promise<readonly Style[]> {
  const techniques = (await listFiles(join(root, 'shader-library', 'techniques'))).map((file) => file.replace('.glsl', ''));
  return [
    ...techniques.filter((name) => !NO_STYLE.has(name)).map((name) => ({ name: `technique-${name}`, type: `technique/${name}` })),
    ...FILTERS.map((name) => ({ name: `filter-${name}`, type: `filter/${name}` })),
  ];
}

/** A gray wall that gets brighter to the top, so that filters have something to draw behind the models. */
async function drawWall(width: number, height: number): Promise<Uint8Array> {
  const data = Buffer.alloc(width * height * 3);
  for (let y = 0; y < height; y++) data.fill(Math.round(205 - (60 * y) / height), y * width * 3, (y + 1) * width * 3);
  return sharp(data, { raw: { width, height, channels: 3 } })
    .png()
    .toBuffer();
}

function render(root: string, args: readonly string[]): Promise<string> {
  return new Promise((done) => {
    execFile(process.execPath, [join(root, 'bin', 'scrim.mjs'), 'render', ...args], (_, stdout, stderr) => done(`${stdout}${stderr}`));
  });
}
