import type { FilmCamera } from '../../../export/emulator/rooms/room-film.ts';
import type { Intrinsics, SessionFile, SessionFileFrame } from '../../../export/runtime/sessions/session-format.ts';
import type { ViewFrame } from '../../../nodes/kit/session.ts';
import type { RecordedFiles } from '../../preview-protocol.ts';

/** A frame without its images. */
export type RecordedFrame = Pick<SessionFileFrame, 'timeS' | 'worldFromCamera' | 'input'>;

/** Makes the images of a recording, of which each kind of preview source has others. */
export interface Film {
  /**
   * Takes what cannot be made later of the frame that was just drawn.
   *
   * @returns Whether there is something to take; frames without are not recorded.
   */
  take(view: ViewFrame, camera: FilmCamera): boolean;
  /** Makes the images of all recorded frames, in their order, and adds them to `files`. */
  make(frames: readonly RecordedFrame[], camera: FilmCamera, files: FileList): Promise<FilmedImages>;
}

export interface FilmedImages {
  /** Paths of the images of each frame. */
  readonly paths: readonly Pick<SessionFileFrame, 'color' | 'depth'>[];
  readonly head: Pick<SessionFile, 'depth' | 'light' | 'surfaces'>;
}

/** Of the longer side of color images; depth has half of it, as on phones. */
const LONG_SIDE_PX = 480;
const JPEG_QUALITY = 0.82;

/** The camera of a recording. Sides are even, so that depth has exactly half of them. */
export function filmCamera(clipFromView: Float32Array, aspect: number): FilmCamera {
  const even = (px: number) => Math.max(2, 2 * Math.round(px / 2));
  const widthPx = even(aspect >= 1 ? LONG_SIDE_PX : LONG_SIDE_PX * aspect);
  const heightPx = even(aspect >= 1 ? LONG_SIDE_PX / aspect : LONG_SIDE_PX);
  return {
    widthPx,
    heightPx,
    depthWidthPx: widthPx / 2,
    depthHeightPx: heightPx / 2,
    clipFromView,
    jpegQuality: JPEG_QUALITY,
    oversampling: 1,
  };
}

/** The pinhole camera of a projection, with y down. */
export function intrinsicsOf({ clipFromView }: FilmCamera, widthPx: number, heightPx: number): Intrinsics {
  const at = (i: number) => clipFromView[i] ?? 0;
  return {
    fxPx: (at(0) * widthPx) / 2,
    fyPx: (at(5) * heightPx) / 2,
    cxPx: ((1 - at(8)) * widthPx) / 2,
    cyPx: ((1 + at(9)) * heightPx) / 2,
  };
}

/** Path of the color image of a frame, as the host expects it. */
export function colorPath(frame: number): string {
  return `color/${String(frame).padStart(6, '0')}.jpg`;
}

export interface FileList {
  add(path: string, bytes: Uint8Array): void;
  /** All files, in one block of bytes. */
  joined(): Pick<RecordedFiles, 'files' | 'content'>;
}

export function createFileList(): FileList {
  const files: { path: string; bytes: number }[] = [];
  const parts: Uint8Array[] = [];
  return {
    add: (path, bytes) => {
      files.push({ path, bytes: bytes.length });
      parts.push(bytes);
    },
    joined: () => {
      const content = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
      let at = 0;
      for (const part of parts) {
        content.set(part, at);
        at += part.length;
      }
      return { files, content };
    },
  };
}
