import type { FromPreview } from '../preview-protocol.ts';

export interface PosterSize {
  readonly widthPx: number;
  readonly heightPx: number;
}

export interface PosterRequest extends PosterSize {
  /** Comes with the answer. */
  readonly request: number;
}

/** What a poster is taken from. */
export interface PosterPlace {
  readonly canvas: HTMLCanvasElement;
  /** Side by side in it; the first is taken. */
  readonly views: 1 | 2;
  /** An emulated device lays the room under what was drawn when the frame is over, and keeps the picture. */
  readonly shows: 'in the frame' | 'after it';
  /** From the next frame on; null: as it was. */
  resize(size: PosterSize | null): void;
}

/** Pictures of what plays, for those who link to the page that it becomes. */
export interface Posters {
  /** Takes the next frame, which is drawn in that size; a wish that is not fulfilled yet gives way. */
  want(asked: PosterRequest, place: PosterPlace): void;
  /** There is none to be had. */
  refuse(asked: PosterRequest): void;
  /** Whether a frame is being drawn for a poster. */
  readonly busy: boolean;
  beforeFrame(): void;
  afterFrame(): void;
}

interface Wish {
  readonly asked: PosterRequest;
  readonly place: PosterPlace;
  state: 'new' | 'sized' | 'drawn';
}

/** An eighth of what the same picture takes as PNG, and nobody sees it. */
const QUALITY = 0.82;
/** The page's own, where the picture is transparent. */
const GROUND = '#14161a';

/** `wake` asks for another frame, also of a preview that is held. */
export function createPosters(send: (message: FromPreview, transfer?: Transferable[]) => void, wake: () => void): Posters {
  let wish: Wish | null = null;
  const answer = ({ request }: PosterRequest, bytes: Uint8Array<ArrayBuffer> | null) =>
    send({ kind: 'poster', request, bytes }, bytes ? [bytes.buffer] : []);
  const take = ({ asked, place }: Wish) => {
    const picture = cover(place, asked);
    void picture.convertToBlob({ type: 'image/jpeg', quality: QUALITY }).then(
      async (blob) => answer(asked, new Uint8Array(await blob.arrayBuffer())),
      () => answer(asked, null),
    );
  };
  const drop = () => {
    if (wish && wish.state !== 'new') wish.place.resize(null);
    wish = null;
  };
  return {
    want: (asked, place) => {
      drop();
      wish = { asked, place, state: 'new' };
      wake();
    },
    refuse: (asked) => {
      drop();
      answer(asked, null);
    },
    get busy() {
      return wish !== null && wish.state !== 'new';
    },
    beforeFrame: () => {
      if (wish?.state === 'drawn') {
        if (wish.place.shows === 'after it') take(wish);
        drop();
      }
      if (wish?.state !== 'new') return;
      wish.place.resize(wish.asked);
      wish.state = 'sized';
    },
    afterFrame: () => {
      if (wish?.state !== 'sized') return;
      if (wish.place.shows === 'in the frame') take(wish);
      wish.state = 'drawn';
      wake();
    },
  };
}

/** As large as fills the size, cut at the sides that are too long. */
function cover({ canvas, views }: PosterPlace, { widthPx, heightPx }: PosterSize): OffscreenCanvas {
  const picture = new OffscreenCanvas(widthPx, heightPx);
  const context = picture.getContext('2d');
  if (!context) return picture;
  const viewWidthPx = canvas.width / views;
  const scale = Math.max(widthPx / viewWidthPx, heightPx / canvas.height);
  const [width, height] = [widthPx / scale, heightPx / scale];
  context.fillStyle = GROUND;
  context.fillRect(0, 0, widthPx, heightPx);
  context.drawImage(canvas, (viewWidthPx - width) / 2, (canvas.height - height) / 2, width, height, 0, 0, widthPx, heightPx);
  return picture;
}
