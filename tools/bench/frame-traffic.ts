import { BYTES_PER_PIXEL, type ReferenceSize, targetSize, targetsOf, totalBytes } from '../../export/compiler/target-bytes.ts';
import type { DrawOperation, PassOperation, Program, ResourceId } from '../../export/program/program.ts';

/** What the passes and the draws of objects of a program cost per view and frame, whatever the device. */
export interface FrameTraffic {
  readonly passes: number;
  /** Render targets that have a texture of their own. */
  readonly targets: number;
  readonly targetBytes: number;
  /** Bytes of the layers and depths that passes read, each pixel once, as a texture cache makes it. Files and cameras do not count. */
  readonly readBytes: number;
  /** Bytes that passes write to targets and to the screen. */
  readonly writtenBytes: number;
  /** Layers of objects that are drawn. Shadow maps, and what glass reads behind it, do not count. */
  readonly draws: number;
  /**
   * Bytes that draws of objects write: each sample of color and depth of their target once, whatever the objects cover, and the texture that
   * the samples are resolved to. All draws to the screen share its samples.
   */
  readonly drawnBytes: number;
  /** Bytes of samples that are read to resolve them. */
  readonly resolvedBytes: number;
}

/** What objects are drawn into. */
interface DrawnInto {
  readonly pixels: number;
  readonly colorBytes: number;
  readonly hasDepth: boolean;
  readonly isDepthRead: boolean;
  readonly samples: number;
}

/** Bytes of a pixel of the screen. */
const SCREEN_BYTES = BYTES_PER_PIXEL.rgba8;
const DEPTH_BYTES = 4;
/** Samples of a multisampled framebuffer of the session. */
const SCREEN_SAMPLES = 4;

/**
 * Computes the traffic of passes and draws of objects from a program. A layer whose size depends on a file counts as one of the size of the view.
 *
 * @example
 * frameTraffic(program, { widthPx: 1280, heightPx: 720 }).passes;
 */
export function frameTraffic(program: Program, reference: ReferenceSize): FrameTraffic {
  const targets = new Map(targetsOf(program).map((target) => [target.id, target]));
  const passes = program.operations.filter((operation): operation is PassOperation => operation.kind === 'pass');

  const draws = program.operations.filter((operation): operation is DrawOperation => operation.kind === 'draw');
  const screenPixels = reference.widthPx * reference.heightPx;

  function pixelsOf(id: ResourceId): number {
    const target = targets.get(id);
    if (target === undefined) return 0;
    const { widthPx, heightPx } = targetSize(target, program, reference) ?? reference;
    return widthPx * heightPx;
  }

  function layerBytes(id: ResourceId): number {
    const target = targets.get(id);
    return target === undefined ? 0 : pixelsOf(id) * BYTES_PER_PIXEL[target.format];
  }

  function drawnInto(): DrawnInto[] {
    const { antialias, screenDepth } = program.presentation;
    const screen = { pixels: screenPixels, colorBytes: SCREEN_BYTES, isDepthRead: false };
    const layers = draws.flatMap(({ target }): DrawnInto[] => {
      const layer = target === 'screen' ? undefined : targets.get(target);
      if (layer === undefined) return [];
      const { id, format, depth, depthRead, samples } = layer;
      const hasDepth = depth !== 'none';
      return [{ pixels: pixelsOf(id), colorBytes: BYTES_PER_PIXEL[format], hasDepth, isDepthRead: depthRead === true, samples }];
    });
    const onScreen = draws.some(({ target }) => target === 'screen');
    return onScreen ? [...layers, { ...screen, hasDepth: screenDepth !== 'none', samples: antialias ? SCREEN_SAMPLES : 1 }] : layers;
  }

  const own = [...targets.values()].filter(({ shares }) => shares === undefined);
  const colors = ({ samplers }: PassOperation) =>
    new Set(samplers.flatMap(({ source }) => (source.kind === 'color' ? [source.resource] : [])));
  const depths = ({ samplers }: PassOperation) =>
    new Set(samplers.flatMap(({ source }) => (source.kind === 'depth' ? [source.depth.resource] : [])));
  const resolved = ({ colorBytes, isDepthRead }: DrawnInto) => colorBytes + (isDepthRead ? DEPTH_BYTES : 0);
  const drawn = drawnInto();
  const multisampled = drawn.filter(({ samples }) => samples > 1);
  return {
    passes: passes.length,
    targets: own.length,
    targetBytes: totalBytes(program, reference),
    readBytes: sum(passes, (pass) => sum([...colors(pass)], layerBytes) + sum([...depths(pass)], (id) => pixelsOf(id) * DEPTH_BYTES)),
    writtenBytes: sum(passes, ({ target }) => (target === 'screen' ? screenPixels * SCREEN_BYTES : layerBytes(target))),
    draws: draws.length,
    drawnBytes:
      sum(drawn, ({ pixels, colorBytes, hasDepth, samples }) => pixels * samples * (colorBytes + (hasDepth ? DEPTH_BYTES : 0))) +
      sum(multisampled, (into) => into.pixels * resolved(into)),
    resolvedBytes: sum(multisampled, (into) => into.pixels * into.samples * resolved(into)),
  };
}

function sum<T>(items: readonly T[], of: (item: T) => number): number {
  return items.reduce((total, item) => total + of(item), 0);
}
