import { BYTES_PER_PIXEL, type ReferenceSize, targetSize, targetsOf, totalBytes } from '../../export/compiler/target-bytes.ts';
import type { PassOperation, Program, ResourceId } from '../../export/program/program.ts';

/** What the passes of a program cost per view and frame, whatever the device. */
export interface FrameTraffic {
  readonly passes: number;
  /** Render targets that have a texture of their own. */
  readonly targets: number;
  readonly targetBytes: number;
  /** Bytes of the layers that passes read, each pixel once, as a texture cache makes it. Files and cameras do not count. */
  readonly readBytes: number;
  /** Bytes that passes write to targets and to the screen. */
  readonly writtenBytes: number;
}

/** Bytes of a pixel of the screen. */
const SCREEN_BYTES = BYTES_PER_PIXEL.rgba8;

/**
 * Computes the traffic of passes from a program. A layer whose size depends on a file counts as one of the size of the view.
 *
 * @example
 * frameTraffic(program, { widthPx: 1280, heightPx: 720 }).passes;
 */
export function frameTraffic(program: Program, reference: ReferenceSize): FrameTraffic {
  const targets = new Map(targetsOf(program).map((target) => [target.id, target]));
  const passes = program.operations.filter((operation): operation is PassOperation => operation.kind === 'pass');

  function layerBytes(id: ResourceId): number {
    const target = targets.get(id);
    if (target === undefined) return 0;
    const { widthPx, heightPx } = targetSize(target, program, reference) ?? reference;
    return widthPx * heightPx * BYTES_PER_PIXEL[target.format];
  }

  const own = [...targets.values()].filter(({ shares }) => shares === undefined);
  const read = ({ samplers }: PassOperation) =>
    new Set(samplers.flatMap(({ source }) => (source.kind === 'color' ? [source.resource] : [])));
  return {
    passes: passes.length,
    targets: own.length,
    targetBytes: totalBytes(program, reference),
    readBytes: sum(passes, (pass) => sum([...read(pass)], layerBytes)),
    writtenBytes: sum(passes, ({ target }) =>
      target === 'screen' ? reference.widthPx * reference.heightPx * SCREEN_BYTES : layerBytes(target),
    ),
  };
}

function sum<T>(items: readonly T[], of: (item: T) => number): number {
  return items.reduce((total, item) => total + of(item), 0);
}
