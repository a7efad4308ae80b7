import type { Player } from '../../export/runtime/player.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { ToPreview } from '../preview-protocol.ts';
import type { LayerGate } from './layer-gate.ts';
import type { Thumbnails } from './thumbnails.ts';
import type { TransportClock } from './transport-clock.ts';

interface FrameDrawingParts {
  readonly clock: Pick<TransportClock, 'asked' | 'idle'>;
  readonly gate: Pick<LayerGate, 'show'>;
  readonly thumbnails: Pick<Thumbnails, 'beforeFrame' | 'invalidate' | 'outdated' | 'skip'>;
}

type DrawFrame = (
  player: Pick<Player, 'draw' | 'drawChanges'>,
  frame: SessionFrame,
  viewer: Extract<ToPreview, { kind: 'viewer' }>,
  needed: boolean,
) => boolean;

/**
 * Creates what draws the frames of the preview. A frame is drawn if it is `needed`, if someone has asked for it, or if it shows a layer besides
 * the screen output; other frames only if they differ from the last one. Returns whether a frame was drawn.
 */
export function createFrameDrawing({ clock, gate, thumbnails }: FrameDrawingParts): DrawFrame {
  /** Whether the last frame that was not needed had something new. */
  let changes = true;
  return (player, frame, viewer, needed) => {
    const layers = thumbnails.beforeFrame(frame);
    gate.show(viewer, layers);
    const hasThumbnail = layers.length > 0 && (thumbnails.outdated || !clock.idle);
    const hasViewer = viewer.left !== null || viewer.right !== null || viewer.probed !== null;
    if (needed || hasThumbnail || hasViewer || clock.asked) {
      player.draw(frame);
      return true;
    }
    const drawn = player.drawChanges(frame);
    if (!drawn) thumbnails.skip();
    // Something has loaded late.
    else if (!changes) thumbnails.invalidate();
    changes = drawn;
    return drawn;
  };
}
