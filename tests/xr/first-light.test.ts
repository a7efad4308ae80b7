import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import { useBrowser } from '../support/browser.ts';
import type { RgbaImage } from '../support/image.ts';
import { type ServedExport, serveProject } from '../support/project-page.ts';
import { openXrPage } from './xr-page.ts';

const EXAMPLE = resolve(import.meta.dirname, '../../examples/first-light');
const chromium = useBrowser();

interface SavedNode {
  readonly type: string;
  muted?: boolean;
  params?: Record<string, unknown>;
}
interface SavedProject {
  readonly graphs: { readonly main: { readonly nodes: Record<string, SavedNode>; readonly wires: readonly string[] } };
}

/** One thing taken out of the example, so that what it does to the image can be seen. */
type Variant = 'whole' | 'no shadow' | 'nothing hidden' | 'no filter';

let base = '';
let saved = '';
/** Each variant is exported once, for all devices. */
const served = new Map<Variant, Promise<ServedExport>>();

function serveVariant(variant: Variant): Promise<ServedExport> {
  const known = served.get(variant) ?? makeVariant(variant).then((folder) => serveProject(folder));
  served.set(variant, known);
  return known;
}

beforeAll(async () => {
  base = await mkdtemp(join(tmpdir(), 'scrim-first-light-'));
  saved = await readFile(join(EXAMPLE, 'project.scrim.json'), 'utf8');
});
afterAll(async () => {
  for (const variant of served.values()) await (await variant).close();
  await rm(base, { recursive: true, force: true });
});

async function makeVariant(variant: Variant): Promise<string> {
  const folder = join(base, variant);
  await cp(EXAMPLE, folder, { recursive: true });
  const project = JSON.parse(saved) as SavedProject;
  const { nodes, wires } = project.graphs.main;
  const idsOf = (type: string) => Object.keys(nodes).filter((id) => nodes[id]?.type === type);
  const change = (id: string | undefined, more: Partial<SavedNode>) => {
    if (id === undefined) throw new Error(`The example has nothing to change for ${variant}.`);
    Object.assign(nodes[id] as SavedNode, more);
  };
  if (variant === 'no shadow') for (const id of idsOf('layer/shadow')) change(id, { params: { strength: 0 } });
  if (variant === 'nothing hidden') {
    const scene = idsOf('layer/scene')[0];
    change(wires.find((wire) => wire.startsWith(`${scene}.layer -> `))?.match(/-> (\S+)\.layer$/)?.[1], { muted: true });
  }
  if (variant === 'no filter')
    change(wires.find((wire) => wire.includes(`-> ${idsOf('output/screen')[0]}.layer`))?.split('.')[0], { muted: true });
  await writeFile(join(folder, 'project.scrim.json'), JSON.stringify(project));
  return folder;
}

/** What a visitor in the studio sees, and the room without the page. */
async function see(variant: Variant, options: EmulatorOptions): Promise<{ readonly seen: RgbaImage; readonly room: RgbaImage }> {
  const { url } = await serveVariant(variant);
  const xr = await openXrPage(chromium.browser, url, { room: 'studio', display: false, ...options }, { width: 320, height: 240 });
  await xr.enter();
  // Down to the table: a turn of -0.34 rad about x.
  await xr.setPose({ position: [0.2, 1.5, 1.6], quaternion: [-0.17, 0, 0, 0.985] });
  await xr.step(2);
  const pictures = { seen: await xr.readComposite(), room: await xr.readRoom() };
  expect(xr.errors).toEqual([]);
  await xr.close();
  return pictures;
}

/** Pixels that differ by more than a few steps, with how much lighter `a` is than `b` there, over all channels. */
function differences(a: RgbaImage, b: RgbaImage): number[] {
  const found: number[] = [];
  for (let i = 0; i < a.data.length; i += 4) {
    const deltas = [0, 1, 2].map((c) => (a.data[i + c] ?? 0) - (b.data[i + c] ?? 0));
    if (deltas.some((delta) => Math.abs(delta) > 6)) found.push(deltas.reduce((sum, delta) => sum + delta, 0));
  }
  return found;
}

/** Mean red over mean blue of the upper third, where only the room is. */
function warmth({ data, width, height }: RgbaImage): number {
  let red = 0;
  let blue = 0;
  for (let i = 0; i < width * Math.floor(height / 3) * 4; i += 4) {
    red += data[i] ?? 0;
    blue += data[i + 2] ?? 0;
  }
  return red / blue;
}

describe('the example, exported, in AR', () => {
  test.each([
    ['one view', { device: 'phone' }],
    ['two views', { device: 'headset', extra: ['camera-access'] }],
  ] as const)('hides the robot behind the table, shadows the floor and warms the picture: %s', async (_name, options) => {
    const whole = await see('whole', options as EmulatorOptions);
    const halves = options.device === 'headset' ? 2 : 1;
    const pixels = (whole.seen.width * whole.seen.height) / halves;

    const plain = await see('no filter', options as EmulatorOptions);
    expect(warmth(whole.seen) / warmth(plain.seen)).toBeGreaterThan(1.05);
    expect(Math.abs(warmth(plain.seen) / warmth(plain.room) - 1)).toBeLessThan(0.02);

    const shadowless = differences(whole.seen, (await see('no shadow', options as EmulatorOptions)).seen);
    expect(shadowless.length).toBeGreaterThan(pixels * 0.002);
    expect(shadowless.filter((lighter) => lighter > 0)).toEqual([]);

    const unhidden = differences(whole.seen, (await see('nothing hidden', options as EmulatorOptions)).seen);
    expect(unhidden.length).toBeGreaterThan(pixels * 0.002);
    // What is hidden is no more than a part: the robot is still there.
    const bare = differences(whole.seen, whole.room);
    expect(bare.length).toBeGreaterThan(unhidden.length * 2);
  });
});
