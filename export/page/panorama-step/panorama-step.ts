import { setPanoramaPose } from '../../../nodes/kit/panorama/shot.ts';
import { type StitchedPanorama, stitch } from '../../../nodes/kit/panorama/stitch.ts';
import type { Session, SessionFrame } from '../../../nodes/kit/session.ts';
import type { TakenPanorama } from '../../../nodes/kit/taken-panorama.ts';
import { createGlObjects } from '../../runtime/gl/gl-objects.ts';
import { createPassDrawer } from '../../runtime/gl/pass-drawer.ts';
import { createProgramCache } from '../../runtime/gl/program-cache.ts';
import { createPanoramaCapture, type PanoramaCapture } from '../../runtime/panorama/capture.ts';
import { createMarkerDrawer, type MarkerDrawer } from '../../runtime/panorama/marker-drawer.ts';
import { createPhotoReader, type PhotoReader } from '../../runtime/panorama/photo-reader.ts';
import { type Stitching, stitchInWorker } from '../../runtime/panorama/stitch-in-worker.ts';
import type { Notices } from '../notices.ts';
import { createLocator, type Locator, turnShots } from './locate.ts';
import type { PanoramaStorage, StoredPanorama } from './panorama-storage.ts';
import type { StepBar } from './step-bar.ts';
import { barText, NOTICES, type StepPhase } from './step-texts.ts';

/** The step before the program: takes a panorama of the room, or finds how the panorama of an earlier visit is rotated in this session. */
export interface PanoramaStep {
  /** Whether the step draws instead of the program. */
  readonly covers: boolean;
  /** Called when a session begins in which the camera may be used. */
  begin(session: Pick<Session, 'capabilities' | 'world' | 'kind'>): Promise<void>;
  /** Called once per frame: before the program draws, or instead of it. */
  frame(frame: SessionFrame): void;
  /** Sets whether the session tracks the motion of the device. */
  setTracked(tracked: boolean): void;
  /** Called when the session ends. Photos are kept until the page is closed. */
  end(): void;
  /** Uses another panorama, such as one from a file. */
  use(panorama: StoredPanorama): Promise<void>;
  forget(): Promise<void>;
  /** Drops the GPU objects, which are lost with the context; the next frame creates them again. */
  contextLost(): void;
}

export interface PanoramaStepOptions {
  readonly gl: WebGL2RenderingContext;
  readonly bar: StepBar;
  readonly notices: Notices;
  readonly storage: PanoramaStorage;
  /** The script of the worker of `source/panorama-capture`. */
  readonly worker: string;
  /** Width of the panorama, pixels. */
  readonly widthPx: number;
  /** Whether the project has a panorama file, which is used if no panorama is taken. */
  readonly hasFile: boolean;
  readonly setPanorama: (panorama: TakenPanorama | null) => void;
}

export type CreatePanoramaStep = (options: PanoramaStepOptions) => PanoramaStep;

/** How long the camera must be held still for a photo, seconds: as long as the pause in a deep breath. */
const HOLD_S = 0.4;
/** Time between two images that are compared with a panorama, seconds. */
const LOOK_EVERY_S = 0.5;
/** Time without a certain heading after which the visitor is asked to point at a lamp, seconds. */
const ASK_AFTER_S = 10;
const LOOK_WIDTH_PX = 160;
/**
 * Width of the panorama that is stitched from the photos of an earlier session, to find where they belong. Stitching at this size takes a
 * tenth of a second.
 */
const SMALL_WIDTH_PX = 256;
/** Fraction of the panorama above which its holes are mentioned to the visitor. */
const MENTIONED_HOLES = 0.03;

interface Means {
  readonly reader: PhotoReader;
  readonly markers: MarkerDrawer;
}

export const createPanoramaStep: CreatePanoramaStep = ({ gl, bar, notices, storage, worker, widthPx, hasFile, setPanorama }) => {
  let phase: StepPhase = 'idle';
  let means: Means | null = null;
  let session: Pick<Session, 'capabilities' | 'world' | 'kind'> | null = null;
  /** Number of sessions. Results that were requested in an earlier session are dropped. */
  let turn = 0;
  let newest: SessionFrame | null = null;
  let taken: TakenPanorama | null = null;
  let locator: Locator | null = null;
  let lookedS = 0;
  let locatingSinceS = -1;
  let stitching: Stitching | null = null;
  let progress = 0;
  let failure = '';
  /** Photos of a session that ended before the panorama was complete. */
  let before: ReturnType<PanoramaCapture['result']>['shots'] = [];
  const capture = createPanoramaCapture({ read: (view, width, height) => gpu().reader.read(view, width, height), widthPx, holdS: HOLD_S });

  function gpu(): Means {
    if (means) return means;
    const objects = createGlObjects(gl);
    const programs = createProgramCache(objects);
    const drawer = createPassDrawer(objects);
    means = { reader: createPhotoReader(objects, programs, drawer), markers: createMarkerDrawer(objects, programs, drawer) };
    return means;
  }

  function enter(next: StepPhase): void {
    phase = next;
    showBar();
  }

  function showBar(): void {
    const { text, progress: part } = barText(phase, { capture, progress, failure, beforeCount: before.length });
    bar.show(text === '' ? null : { text, progress: part, actions: ACTIONS[phase] });
  }

  function retake(): void {
    stitching?.cancel();
    before = [];
    capture.restart();
    enter('taking');
  }

  function skip(): void {
    stitching?.cancel();
    enter('idle');
  }

  function finish(): void {
    const { shots, at } = capture.result();
    const mine = turn;
    progress = 0;
    stitching = stitchInWorker(worker, shots, widthPx, (part) => {
      progress = part;
      showBar();
    });
    enter('stitching');
    stitching.panorama.then(
      (panorama) => mine === turn && void keep(panorama, at),
      (error: unknown) => {
        if (mine !== turn) return;
        failure = error instanceof Error ? error.message : String(error);
        enter('failed');
      },
    );
  }

  async function keep(panorama: StitchedPanorama, at: readonly number[]): Promise<void> {
    const worldFromPanorama = new Float32Array(16);
    setPanoramaPose(worldFromPanorama, 0, at);
    give({ pixels: panorama, worldFromPanorama, located: true, isNew: true });
    capture.restart();
    before = [];
    enter('ready');
    const holes = Math.round(panorama.holesPart * 100);
    if (panorama.holesPart > MENTIONED_HOLES) notices.show('panorama', { text: NOTICES.holes(holes), tone: 'hint' });
    const { widthPx: width, heightPx, data } = panorama;
    const refused = await storage.save({ widthPx: width, heightPx, data });
    if (refused !== null) notices.show('panorama-storage', { text: refused, tone: 'problem' });
  }

  function give(panorama: TakenPanorama | null): void {
    taken = panorama;
    locator = panorama === null || panorama.located ? null : createLocator(panorama.pixels);
    locatingSinceS = -1;
    setPanorama(panorama);
  }

  function locate(headingRad: number): void {
    const m = newest?.views[0]?.worldFromView;
    if (!taken || !m) return;
    setPanoramaPose(taken.worldFromPanorama, headingRad, [m[12] ?? 0, m[13] ?? 0, m[14] ?? 0]);
    taken.located = true;
    enter('ready');
  }

  function pointed(): void {
    const view = newest?.views[0];
    const heading = view && taken ? (locator ?? createLocator(taken.pixels)).pointedAtLamp(view) : null;
    if (heading === null) notices.show('panorama', { text: NOTICES.noLamp, tone: 'problem' });
    else locate(heading);
  }

  /** Reads a small photo, at most twice a second; null in between and without a camera image. */
  function look(frame: SessionFrame): ReturnType<PhotoReader['read']> | null {
    const view = frame.views[0];
    if (!view?.cameraImage || Math.abs(frame.timeS - lookedS) < LOOK_EVERY_S) return null;
    lookedS = frame.timeS;
    const { widthPx: width, heightPx } = view.viewport;
    return gpu().reader.read(view, LOOK_WIDTH_PX, Math.max(16, Math.round((LOOK_WIDTH_PX * heightPx) / width)));
  }

  function lookForPlace(frame: SessionFrame): void {
    if (!taken || !locator) return;
    // The node has found it by its anchor.
    if (taken.located) {
      enter('ready');
      return;
    }
    if (locatingSinceS < 0) locatingSinceS = frame.timeS;
    const photo = look(frame);
    const heading = photo === null ? null : locator.look(photo);
    if (heading !== null) locate(heading);
    else if (phase === 'locating' && frame.timeS - locatingSinceS > ASK_AFTER_S) enter('asking');
  }

  /** Finds how photos of an earlier session are rotated in this one, and then continues to take photos with them. */
  function lookForPhotos(frame: SessionFrame): void {
    locator ??= createLocator(runWhole(stitch(before, SMALL_WIDTH_PX)));
    const photo = look(frame);
    const heading = photo === null ? null : locator.look(photo);
    if (heading === null) return;
    locator = null;
    capture.adopt(turnShots(before, heading), heading);
    before = [];
    enter('taking');
  }

  function takePhotos(frame: SessionFrame): void {
    capture.update(frame);
    if (capture.state === 'blind') {
      notices.show('panorama', { text: hasFile ? NOTICES.noImage : NOTICES.noImageNoFile, tone: 'hint' });
      enter('idle');
      return;
    }
    gpu().markers.draw(frame, session?.world ?? 'none', capture);
    if (capture.state === 'complete') finish();
    else showBar();
  }

  const ACTIONS = {
    idle: [],
    resuming: [
      { label: 'Continue', run: () => enter('aligning') },
      { label: 'Start again', run: retake },
      { label: 'Skip', run: skip },
    ],
    aligning: [
      { label: 'Start again', run: retake },
      { label: 'Skip', run: skip },
    ],
    taking: [
      { label: 'Use these photos', run: () => (capture.shots.length > 0 ? finish() : skip()) },
      { label: 'Start again', run: retake },
      { label: 'Skip', run: skip },
    ],
    stitching: [{ label: 'Skip', run: skip }],
    failed: [
      { label: 'Start again', run: retake },
      { label: 'Skip', run: skip },
    ],
    locating: [{ label: 'Take it again', run: retake }],
    asking: [
      { label: 'Use this direction', run: pointed },
      { label: 'Take it again', run: retake },
    ],
    ready: [{ label: 'Take the panorama again', run: retake }],
  } as const;

  return {
    get covers() {
      return phase === 'taking' || phase === 'stitching' || phase === 'resuming' || phase === 'aligning' || phase === 'failed';
    },
    begin: async (begun) => {
      const mine = ++turn;
      session = begun;
      newest = null;
      lookedS = 0;
      if (taken) {
        taken.isNew = false;
        taken.located = false;
        give(taken);
      } else {
        const stored = await storage.load();
        if (mine !== turn) return;
        if (stored) give(takenOf(stored));
      }
      if (!begun.capabilities.has('camera-image')) {
        if (!taken) notices.show('panorama', { text: hasFile ? NOTICES.noCamera : NOTICES.noCameraNoFile, tone: 'hint' });
        return enter('idle');
      }
      if (before.length > 0) enter('resuming');
      else if (taken) enter('locating');
      else retake();
    },
    frame: (frame) => {
      newest = frame;
      switch (phase) {
        case 'taking':
          return takePhotos(frame);
        case 'aligning':
          gpu().markers.draw(frame, session?.world ?? 'none', capture);
          return lookForPhotos(frame);
        case 'resuming':
        case 'stitching':
        case 'failed':
          return gpu().markers.draw(frame, session?.world ?? 'none', capture);
        case 'locating':
        case 'asking':
          return lookForPlace(frame);
        case 'idle':
        case 'ready':
          return;
        default:
          phase satisfies never;
      }
    },
    setTracked: (tracked) => {
      if (tracked || session?.kind !== 'camera' || phase !== 'taking' || capture.shots.length > 0) return;
      notices.show('panorama', { text: hasFile ? NOTICES.noMotion : NOTICES.noMotionNoFile, tone: 'hint' });
      enter('idle');
    },
    end: () => {
      turn++;
      stitching?.cancel();
      if (capture.shots.length > 0) before = [...before, ...capture.result().shots];
      capture.restart();
      locator = null;
      session = null;
      newest = null;
      notices.clear('panorama');
      enter('idle');
    },
    use: async (panorama) => {
      give(takenOf(panorama));
      const refused = await storage.save(panorama);
      if (refused !== null) notices.show('panorama-storage', { text: refused, tone: 'problem' });
    },
    forget: async () => {
      give(null);
      before = [];
      await storage.forget();
    },
    contextLost: () => {
      means = null;
    },
  };
};

function takenOf({ widthPx, heightPx, data }: StoredPanorama): TakenPanorama {
  const worldFromPanorama = new Float32Array(16);
  setPanoramaPose(worldFromPanorama, 0, [0, 1.6, 0]);
  return { pixels: { widthPx, heightPx, channels: 4, data }, worldFromPanorama, located: false, isNew: false };
}

function runWhole<T>(slices: Generator<undefined, T>): T {
  for (;;) {
    const { done, value } = slices.next();
    if (done) return value;
  }
}
