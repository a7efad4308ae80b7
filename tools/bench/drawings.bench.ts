import { LIBRARY } from '../../app/services/compile-project.ts';
import type { ToolContext } from '../lib/tool.ts';
import type { Bench } from './bench.ts';
import { benchesInCopies } from './in-copies.ts';
import { machineLoad } from './machine-load.ts';

/** Filters that draw or paint an image in strokes, dots or lines, besides those named `…-drawing`. */
const DRAWINGS: ReadonlySet<string> = new Set(
  [
    'watercolor',
    'oil-painting',
    'stipple',
    'engraving',
    'pointillism',
    'difference-of-gaussians',
    'halftone',
    'anisotropic-kuwahara',
    'kuwahara',
    'sobel-edges',
  ].map((name) => `filter/${name}`),
);

/** Measures the drawing filters alone in plain copies, as `filters.bench.ts` does for all filters in many times as long. */
export async function benches({ root }: ToolContext): Promise<readonly Bench[]> {
  const types = [...LIBRARY.types()].filter((type) => DRAWINGS.has(type) || /^filter\/(?!room-).+-drawing$/.test(type));
  return [...benchesInCopies(root, types.sort()), machineLoad('drawing filters')];
}
