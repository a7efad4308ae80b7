import type { PassOperation, Program, ResourceId } from '../../program/program.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { Target } from '../targets/target.ts';

/**
 * A pass whose image is only copied to the screen. While the image has the size of the view, the copy would repeat it pixel by pixel, so the
 * pass draws to the screen itself.
 */
export interface DirectDraw {
  /** The pass that draws the image, as it draws to the screen. */
  readonly onScreen: PassOperation;
  /** Whether the pass draws to the screen in this frame. */
  readonly active: boolean;
  /** Decides for a frame, when targets of the image domain have their size. Returns whether it decides otherwise than for the last one. */
  decide(state: PlayState): boolean;
}

/** Finds the passes of a program that can draw to the screen. Both the pass and its copy are keys. */
export function findDirectDraws(program: Program, resources: LiveResources): ReadonlyMap<PassOperation, DirectDraw> {
  const { operations } = program;
  const found = new Map<PassOperation, DirectDraw>();
  // Nodes that draw or compute images may read images in ways of their own.
  if (operations.some(({ kind }) => kind === 'draw' || kind === 'cpu' || kind === 'shadow-maps' || kind === 'readback')) return found;
  const passes = operations.filter((operation) => operation.kind === 'pass');
  const inOrder = [...passes.filter(({ view }) => view === 'once'), ...passes.filter(({ view }) => view === 'each')];
  const viewed = new Set(Object.values(program.taps).map(({ color }) => color));
  for (const copy of passes.filter(({ copies, target }) => copies && target === 'screen')) {
    const [image = ''] = copy.reads;
    const [pass, ...others] = passes.filter(({ writes }) => writes.includes(image));
    const isOnlyCopied = passes.every((one) => one === copy || !one.reads.includes(image));
    if (pass?.view !== 'once' || others.length > 0 || !isOnlyCopied || viewed.has(image)) continue;
    const { target } = liveResource(resources, image, 'target');
    const between = inOrder.slice(inOrder.indexOf(pass) + 1, inOrder.indexOf(copy));
    if (target.resource.lifetime === 'persistent' || overwrites(between, pass.reads, resources)) continue;
    const direct = createDirectDraw({ ...pass, target: 'screen', writes: [], view: 'each', blend: copy.blend }, target);
    found.set(pass, direct).set(copy, direct);
  }
  return found;
}

/** Whether any of the passes draws to a texture that one of the resources has. */
function overwrites(passes: readonly PassOperation[], read: readonly ResourceId[], resources: LiveResources): boolean {
  const kept = new Set(read.map((id) => resources.get(id)));
  return passes.some(({ writes }) => writes.some((id) => kept.has(resources.get(id))));
}

function createDirectDraw(onScreen: PassOperation, target: Target): DirectDraw {
  let active = false;
  return {
    onScreen,
    get active() {
      return active;
    },
    decide: ({ frame, widthPx, heightPx }) => {
      const before = active;
      const image = target.peek(0);
      active = frame.viewCount === 1 && image?.widthPx === widthPx && image.heightPx === heightPx;
      return active !== before;
    },
  };
}
