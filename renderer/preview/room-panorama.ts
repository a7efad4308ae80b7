import { createGlObjects } from '../../export/runtime/gl/gl-objects.ts';
import { createPassDrawer } from '../../export/runtime/gl/pass-drawer.ts';
import { createProgramCache } from '../../export/runtime/gl/program-cache.ts';
import { createPanoramaCapture, type PanoramaCapture } from '../../export/runtime/panorama/capture.ts';
import { createPhotoReader, type PhotoReader } from '../../export/runtime/panorama/photo-reader.ts';
import { type Stitching, stitchInWorker } from '../../export/runtime/panorama/stitch-in-worker.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import { uprightPose } from '../../nodes/kit/panorama/capture-targets.ts';
import { setPanoramaPose } from '../../nodes/kit/panorama/shot.ts';
import type { SessionFrame } from '../../nodes/kit/session.ts';
import type { TakenPanorama } from '../../nodes/kit/taken-panorama.ts';
import type { FromPreview, PreviewSource } from '../preview-protocol.ts';
import type { OpenSession } from './open-session.ts';
import type { PlayerHost } from './player-host.ts';

/** Takes the panorama of an emulated room: the head turns to each target by itself. */
export interface RoomPanorama {
  /**
   * Starts a capture with the next frame.
   *
   * @param host Null while nothing is shown.
   * @param setHead Turns the head of the device; null gives it back to the keys and the pointer. Null for other sources than rooms.
   */
  take(host: Pick<PlayerHost, 'gl' | 'player'> | null, setHead: OpenSession['setHead'], widthPx: number): void;
  /** Called with each frame, before the program draws it. */
  beforeDraw(frame: SessionFrame): void;
  /** Called when a session begins. Returns the panorama that was taken in the same room; null if there is none. */
  enter(source: PreviewSource): TakenPanorama | null;
  /** Stops the capture, because the context or the session ends. A finished panorama is kept. */
  stop(): void;
}

interface PanoramaPlace {
  readonly player: PlayerHost['player'];
  readonly widthPx: number;
  readonly setHead: NonNullable<OpenSession['setHead']>;
}

const TYPE = 'source/panorama-capture';
/** Number of frames without a camera image after which the capture fails. */
const PATIENT_FRAMES = 30;

export function createRoomPanorama(send: (message: FromPreview) => void, wake: () => void): RoomPanorama {
  let taken: TakenPanorama | null = null;
  let place: PanoramaPlace | null = null;
  let capture: PanoramaCapture | null = null;
  let reader: { readonly of: WebGL2RenderingContext; readonly photos: PhotoReader } | null = null;
  let stitching: Stitching | null = null;
  let frames = 0;
  /** Key of the room in which `taken` was taken. */
  let room = '';

  function stop(): void {
    stitching?.cancel();
    stitching = null;
    if (capture) place?.setHead(null);
    capture = null;
  }

  function refuse(text: string): void {
    stop();
    send({ kind: 'panorama', state: 'failed', text });
  }

  function photosOf(gl: WebGL2RenderingContext): PhotoReader {
    if (reader?.of !== gl) {
      const objects = createGlObjects(gl);
      reader = { of: gl, photos: createPhotoReader(objects, createProgramCache(objects), createPassDrawer(objects)) };
    }
    return reader.photos;
  }

  function finish(complete: PanoramaCapture, { widthPx, setHead, player }: PanoramaPlace): void {
    const { shots, at } = complete.result();
    capture = null;
    setHead(null);
    const module = RUNTIMES[TYPE];
    if (!module || !('worker' in module) || module.worker === undefined) throw new Error(`The node type ${TYPE} has no worker.`);
    stitching = stitchInWorker(module.worker, shots, widthPx);
    stitching.panorama.then(
      (panorama) => {
        const worldFromPanorama = new Float32Array(16);
        setPanoramaPose(worldFromPanorama, 0, at);
        taken = { pixels: panorama, worldFromPanorama, located: true, isNew: true };
        player.setPanorama(taken);
        wake();
        send({ kind: 'panorama', state: 'taken', text: `The panorama of the room is made of ${shots.length} photos.` });
      },
      (error: unknown) =>
        refuse(`The panorama could not be made: ${(error instanceof Error ? error.message : String(error)).replace(/\.$/, '')}.`),
    );
  }

  return {
    take: (host, setHead, widthPx) => {
      stop();
      if (!host || !setHead) return refuse('Choose an emulated room as the source of the preview first.');
      place = { player: host.player, widthPx, setHead };
      frames = 0;
      capture = createPanoramaCapture({ read: photosOf(host.gl).read, widthPx, holdS: 0 });
      wake();
    },
    beforeDraw: (frame) => {
      const view = frame.views[0];
      if (!capture || !place || !view) return;
      if (!view.cameraImage && ++frames > PATIENT_FRAMES) {
        return refuse('The emulated device gives no camera image. Choose a phone with “Camera image” as the device of the preview.');
      }
      capture.update(frame);
      if (capture.state === 'complete') finish(capture, place);
      else if (capture.next) {
        const pose = uprightPose(capture.next.direction);
        for (let i = 12; i < 15; i++) pose[i] = view.worldFromView[i] ?? 0;
        place.setHead(pose);
      }
      wake();
    },
    enter: (source) => {
      const entered = source.kind === 'room' ? `room ${source.captureUrl}` : source.kind;
      stop();
      if (entered !== room) taken = null;
      room = entered;
      return taken;
    },
    stop,
  };
}
