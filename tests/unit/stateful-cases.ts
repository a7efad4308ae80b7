import type { ParamValue } from '../../nodes/kit/definition.ts';
import { subsetGlyphs } from '../../nodes/kit/glyphs.ts';
import { LIBRARY } from '../support/library.ts';

/** Nodes that `stateful-nodes.test.ts` plays otherwise than most. */

/** What one node alone does not show: on the GPU, or in the nodes that it acts on. */
export const SHOWN_ELSEWHERE: Readonly<Record<string, string>> = {
  'world/depth': 'Only its steadier keeps a picture, on the GPU, and only where smoothing is on: tests/browser/room-depth.test.ts.',
  'layer/measure-mask': 'It measures pixels that come from the GPU: nodes/layer/measure-mask/measure-mask.test.ts.',
  'physics/grab': 'It holds bodies of other nodes: nodes/physics/grab/grab.test.ts.',
  'physics/room': 'It sends depth to the world: nodes/physics/room/room.test.ts.',
  'physics/world': 'It moves the bodies of other nodes: nodes/physics/world/steps.test.ts.',
};

/** What draws its text on a canvas of the browser. It keeps nothing but what it has drawn. */
export const IN_BROWSERS = ['objects/label'];

/** Params that keep a node off the GPU, or are as the compiler gives them. */
export const FIXED: Readonly<Record<string, Readonly<Record<string, ParamValue>>>> = {
  'world/depth': { source: 'device', filter: 'nearest', fillHoles: false, smoothingS: 0 },
  'source/camera-video': { withoutImage: 'transparent' },
  'objects/text-3d': { characters: subsetGlyphs(LIBRARY.shader('fonts/inter') ?? '', 'abcdefghijklmnopqrstuvwxyz 0123456789.') },
};

/** Values, kept in all frames, at which what a node keeps is seen. */
export const SHOWING: Readonly<Record<string, Readonly<Record<string, ParamValue>>>> = {
  'pulse/every': { periodS: 0.25 },
  'pulse/on-start': { delayS: 0.05 },
  'pulse/on-change': { least: 1 },
  'pose/follow': { timeConstantS: 1 },
  'pose/inside-box': { sizeM: [1, 1, 1], marginM: 1 },
  'world/measure': { moveM: 10 },
  'world/surface-filter': { choose: 'nearest', leastSideM: 0, minHeightM: -10, maxHeightM: 10 },
};
