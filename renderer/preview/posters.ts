import type { Player } from '../../export/runtime/player.ts';
import { createPosterCamera, type PosterCamera, type PosterSize } from '../../export/runtime/scenes/poster-camera.ts';
import { type PosterFraming, type ViewCrop, WHOLE_VIEW } from '../../nodes/kit/poster-framing.ts';
import type { FromPreview } from '../preview-protocol.ts';
import type { OpenSession } from './open-session.ts';

export interface PosterRequest extends PosterSize {
  /** Counter that the answer repeats. */
  readonly request: number;
  readonly framing: PosterFraming | null;
  readonly nodes: readonly string[];
}

/** The canvas that posters, screenshots and probes read. */
export interface CaptureSource {
  readonly canvas: HTMLCanvasElement;
  /** Number of views side by side. The poster shows the first. */
  readonly views: 1 | 2;
  /** When the canvas shows the frame. An emulated device composites the room after the frame, and keeps the image. */
  readonly shows: 'in the frame' | 'after it';
  /** Resizes from the next frame on; null restores the size. */
  resize(size: PosterSize | null): void;
}

/** Takes posters: images of the preview for link previews of the exported page. */
export interface Posters {
  /** Draws the next frame in the size that the camera asks for and sends the part that the camera keeps. Replaces a pending request. */
  request(asked: PosterRequest, place: CaptureSource, player: Pick<Player, 'inspect'>, setHead: OpenSession['setHead']): void;
  /** Answers that there is no image. */
  refuse(asked: PosterRequest): void;
  /** Whether a frame is being drawn for a poster. */
  readonly busy: boolean;
  beforeFrame(): void;
  afterFrame(): void;
}

interface PendingPoster {
  readonly asked: PosterRequest;
  readonly place: CaptureSource;
  readonly camera: PosterCamera;
  state: 'new' | 'sized' | 'drawn';
  /** The part of the drawn frame that the poster shows. */
  crop: ViewCrop;
}

/** JPEG quality. The file is an eighth of the PNG, without visible loss. */
const QUALITY = 0.82;
/** Background of exported pages, shown where the image is transparent. */
const GROUND = '#14161a';

/**
 * Creates the posters of the preview.
 *
 * @param wake Requests another frame, also while the preview is paused.
 */
export function createPosters(send: (message: FromPreview, transfer?: Transferable[]) => void, wake: () => void): Posters {
  let pending: PendingPoster | null = null;
  const answer = ({ request }: PosterRequest, bytes: Uint8Array<ArrayBuffer> | null) =>
    send({ kind: 'poster', request, bytes }, bytes ? [bytes.buffer] : []);
  const take = ({ asked, place, crop }: PendingPoster) => {
    const image = cover(place, asked, crop);
    void image.convertToBlob({ type: 'image/jpeg', quality: QUALITY }).then(
      async (blob) => answer(asked, new Uint8Array(await blob.arrayBuffer())),
      () => answer(asked, null),
    );
  };
  const drop = () => {
    if (pending && pending.state !== 'new') {
      pending.place.resize(null);
      pending.camera.release();
    }
    pending = null;
  };
  return {
    request: (asked, place, player, setHead) => {
      drop();
      const { framing, nodes } = asked;
      const camera = createPosterCamera({ inspect: () => player.inspect(null), setHead, framing, nodes, size: asked });
      pending = { asked, place, camera, state: 'new', crop: WHOLE_VIEW };
      wake();
    },
    refuse: (asked) => {
      drop();
      answer(asked, null);
    },
    get busy() {
      return pending !== null && pending.state !== 'new';
    },
    beforeFrame: () => {
      if (pending?.state === 'drawn') {
        if (pending.place.shows === 'after it') take(pending);
        drop();
      }
      if (pending?.state !== 'new') return;
      pending.place.resize(pending.camera.aim());
      pending.state = 'sized';
    },
    afterFrame: () => {
      if (pending?.state !== 'sized') return;
      pending.crop = pending.camera.crop();
      if (pending.place.shows === 'in the frame') take(pending);
      pending.state = 'drawn';
      wake();
    },
  };
}

/** Scales a part of the first view to cover the size, and crops the longer sides. */
function cover({ canvas, views }: CaptureSource, { widthPx, heightPx }: PosterSize, crop: ViewCrop): OffscreenCanvas {
  const image = new OffscreenCanvas(widthPx, heightPx);
  const context = image.getContext('2d');
  if (!context) return image;
  const [partWidthPx, partHeightPx] = [(canvas.width / views) * crop.width, canvas.height * crop.height];
  const [leftPx, topPx] = [(canvas.width / views) * crop.x, canvas.height * crop.y];
  const scale = Math.max(widthPx / partWidthPx, heightPx / partHeightPx);
  const [width, height] = [widthPx / scale, heightPx / scale];
  context.fillStyle = GROUND;
  context.fillRect(0, 0, widthPx, heightPx);
  const [x, y] = [leftPx + (partWidthPx - width) / 2, topPx + (partHeightPx - height) / 2];
  context.drawImage(canvas, x, y, width, height, 0, 0, widthPx, heightPx);
  return image;
}

/** The canvas of the page as a source, for sources other than emulated devices. */
export function sourceOnCanvas(canvas: HTMLCanvasElement): CaptureSource {
  const { width: widthPx, height: heightPx } = canvas;
  return {
    canvas,
    views: 1,
    shows: 'in the frame',
    resize: (size) => {
      const to = size ?? { widthPx, heightPx };
      canvas.width = to.widthPx;
      canvas.height = to.heightPx;
    },
  };
}
