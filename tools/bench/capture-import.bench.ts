import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import sharp from 'sharp';
import { packCapture } from '../../app/services/add-capture.ts';
import { NODE_FILES } from '../../app/services/file-layer.ts';
import { UNKNOWN_SIZE } from '../../app/services/measure-capture.ts';
import { makeDepthMesh } from '../../export/captures/depth/depth-mesh.ts';
import { pinholeRays } from '../../export/captures/depth/depth-rays.ts';
import { thinDepthMesh } from '../../export/captures/depth/thin-depth-mesh.ts';
import { type Bench, timeMs } from './bench.ts';
import { machineLoad } from './machine-load.ts';

const [WIDTH, HEIGHT] = [640, 480];
const COUNTS = [2, 4, 8];
/** How many photographs are imported in other sizes, and the factors of these sizes: 1.2, 4.9 and 19.7 megapixels. */
const RESIZED_COUNT = 2;
const RESIZED = [2, 4, 8];
/** Factors of the size of depth maps. */
const FACTORS = [0.5, 1, 2];
const SAMPLES = 3;

/**
 * How the time of an import grows with the number and the size of its photographs, whose distortion is removed, and that of a depth mesh with
 * the pixels of its map.
 */
export async function benches(): Promise<readonly Bench[]> {
  const numbers = COUNTS.map((count) => importOf(count, 1));
  const sizes = RESIZED.map((factor) => importOf(RESIZED_COUNT, factor));
  return [...numbers, ...sizes, ...FACTORS.flatMap(depthMeshOf), machineLoad('imports of captures')];
}

function importOf(count: number, factor: number): Bench {
  let base: Promise<string> | undefined;
  let taken = 0;
  return {
    name: `import a capture, ${count} photographs, ${WIDTH * factor} × ${HEIGHT * factor}`,
    unit: 'ms',
    samples: SAMPLES,
    sample: async () => {
      base ??= writeScan(count, factor);
      const folder = await base;
      const root = join(folder, `project-${taken++}`);
      await mkdir(root);
      const known = { known: UNKNOWN_SIZE, up: null, metersPerUnit: 1, depth: { from: 'mesh', unit: null, kind: null } } as const;
      const job = { folder: join(folder, 'scan'), root, sources: resolve('.'), name: 'room', maxSidePx: 1600, ...known };
      return timeMs(() => packCapture({ ...job, files: NODE_FILES, say: () => {}, interrupted: new AbortController().signal }));
    },
    dispose: async () => rm((await base) ?? '', { recursive: true, force: true }),
  };
}

/** Photographs from cameras in a row, of a wavy wall of 5,000 triangles. */
async function writeScan(count: number, factor: number): Promise<string> {
  const base = await mkdtemp(join(tmpdir(), 'scrim-bench-import-'));
  const [width, height] = [WIDTH * factor, HEIGHT * factor];
  await mkdir(join(base, 'scan/images'), { recursive: true });
  for (let i = 0; i < count; i++) {
    // Each is another one, because packed photographs are kept.
    const data = new Uint8Array(4 * width * height);
    for (let at = 0; at < data.length; at++) data[at] = (at * (37 + i)) % 251;
    const raw = { width, height, channels: 4 } as const;
    await sharp(data, { raw })
      .jpeg({ quality: 90 })
      .toFile(join(base, 'scan/images', `${i}.jpg`));
  }
  const images = Array.from({ length: count }, (_, i) => `${i + 1} 1 0 0 0 ${-0.1 * i} 0 0 1 ${i}.jpg\n\n`);
  await writeFile(join(base, 'scan/images.txt'), images.join(''));
  await writeFile(join(base, 'scan/cameras.txt'), `1 SIMPLE_RADIAL ${width} ${height} ${520 * factor} ${width / 2} ${height / 2} -0.05\n`);
  const side = 51;
  const vertices = Array.from({ length: side * side }, (_, i) => {
    const [x, y] = [(i % side) / 10 - 2.5, Math.floor(i / side) / 10 - 2.5];
    return `v ${x} ${y} ${2.5 + 0.3 * Math.sin(3 * x) * Math.cos(2 * y)}\n`;
  });
  const faces = Array.from({ length: side * (side - 1) }, (_, i) => i + 1)
    .filter((i) => i % side !== 0)
    .map((i) => `f ${i} ${i + 1} ${i + side + 1} ${i + side}\n`);
  await writeFile(join(base, 'scan/mesh.obj'), vertices.join('') + faces.join(''));
  return base;
}

/** The time of a depth mesh, and its triangles as a share of those of all pixels. */
function depthMeshOf(factor: number): readonly Bench[] {
  const [widthPx, heightPx, focalPx] = [WIDTH, HEIGHT, 520].map((x) => x * factor) as [number, number, number];
  const rays = pinholeRays({ widthPx, heightPx, fxPx: focalPx, fyPx: focalPx, cxPx: widthPx / 2, cyPx: heightPx / 2 });
  // A ball of half a meter before a corner of walls.
  const values = Float32Array.from({ length: widthPx * heightPx }, (_, i) => {
    const [x, y] = [rays.across[i % widthPx] ?? 0, rays.down[Math.floor(i / widthPx)] ?? 0];
    const a = x * x + y * y + 1;
    const root = 4 - a * (4 - 0.25);
    return root > 0 ? (2 - Math.sqrt(root)) / a : Math.min(5, 2 / Math.abs(x), 1.5 / Math.abs(y));
  });
  const map = { widthPx, heightPx, values };
  const make = () => makeDepthMesh(map, rays, Number.POSITIVE_INFINITY);
  const thin = () => thinDepthMesh(make(), map, rays);
  const of = `depth mesh, ${widthPx} × ${heightPx}`;
  return [
    { name: `${of}, quadtree`, unit: 'ms', samples: SAMPLES, sample: () => timeMs(make) },
    { name: `${of}, quadtree without spare vertices`, unit: 'ms', samples: SAMPLES, sample: () => timeMs(thin) },
    {
      name: `${of}, triangles against all pixels`,
      unit: 'ratio',
      samples: 1,
      sample: () => thin().indices.length / 3 / (2 * (widthPx - 1) * (heightPx - 1)),
    },
  ];
}
