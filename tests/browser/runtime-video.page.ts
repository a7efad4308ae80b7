import { type LoadedVideo, loadVideo } from '../../export/runtime/assets/video/load-video.ts';
import { createBrowserClock } from '../../export/runtime/clock.ts';
import { createGlObjects, type GlObjects } from '../../export/runtime/gl/gl-objects.ts';
import type { ImageAsset, VideoAsset, VideoPlayback } from '../../nodes/kit/assets.ts';
import { encodeFilm, type FilmImage } from '../../tools/examples/encode-film.ts';
import { createGl } from './runtime-kit.ts';

const SIDE_PX = 32;
const PER_S = 10;
const COUNT = 20;

/** Gray number `i` of the film, display-referred. */
const grayOf = (i: number): number => 20 + i * 11;

const plane = (value: number, length = SIDE_PX * SIDE_PX): Uint8Array => new Uint8Array(length).fill(value);

/** BT.601 video range. */
function gray(value: number, alpha?: Uint8Array): FilmImage {
  const neutral = plane(128, (SIDE_PX * SIDE_PX) / 4);
  return { y: plane(Math.round(16 + (219 * value) / 255)), u: neutral, v: neutral, ...(alpha ? { alpha } : {}) };
}

interface FilmOptions {
  readonly timed?: boolean;
  readonly alpha?: Uint8Array;
}

/** Two seconds of ten grays each, a key frame every half second. */
function grays({ timed = true, alpha }: FilmOptions = {}): Promise<Uint8Array<ArrayBuffer>> {
  const pictures = Array.from({ length: COUNT }, (_, i) => gray(alpha ? 200 : grayOf(i), alpha));
  return encodeFilm({ widthPx: SIDE_PX, heightPx: SIDE_PX, framesPerS: PER_S, keyEvery: 5, bitrate: 2_000_000, images: pictures, timed });
}

/** A transparent video: left half clear, right half half opaque, an opaque strip at the bottom. */
function halves(): Uint8Array {
  const alpha = plane(0);
  for (let i = 0; i < alpha.length; i++) {
    if (i % SIDE_PX >= SIDE_PX / 2) alpha[i] = 128;
    if (i >= SIDE_PX * 24) alpha[i] = 255;
  }
  return alpha;
}

function createStand() {
  const gl = createGl();
  const objects = createGlObjects(gl);
  const framebuffer = gl.createFramebuffer();
  /** RGBA of a pixel of the picture, origin bottom left. */
  const read = (picture: ImageAsset | null, x = SIDE_PX / 2, y = SIDE_PX / 2): number[] | null => {
    if (picture === null) return null;
    gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, picture.texture, 0);
    const out = new Uint8Array(4);
    gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, out);
    return [...out];
  };
  return { gl, objects, read };
}

const ignore = (): void => {};

const load = (objects: GlObjects, film: Uint8Array<ArrayBuffer>): Promise<LoadedVideo> =>
  loadVideo(objects, film.buffer, createBrowserClock().delay);

/** Only the player keeps a video that waits for its image; a test has no player. */
const kept = new Set<VideoPlayback>();

function open(video: VideoAsset, onProblem: Parameters<VideoAsset['open']>[0] = ignore): VideoPlayback {
  const playback = video.open(onProblem);
  kept.add(playback);
  return playback;
}

/** Which gray is shown at each time, sought in this order. */
async function seek(playback: VideoPlayback, times: readonly number[], read: (picture: ImageAsset | null) => number[] | null) {
  const shown: number[] = [];
  for (const timeS of times) {
    playback.follow(timeS, 0, true);
    await playback.settle();
    const [red = -99] = read(playback.image) ?? [];
    shown.push((red - grayOf(0)) / 11);
  }
  return shown.map((index) => (Math.abs(index - Math.round(index)) < 0.35 ? Math.round(index) : index));
}

export async function held(times: readonly number[], timed: boolean) {
  const { objects, read, gl } = createStand();
  const video = await load(objects, await grays({ timed }));
  const playback = open(video);
  const shown = await seek(playback, times, read);
  const again = playback.settle();
  const second = open(video);
  const other = await seek(second, [1.25], read);
  const stays = await seek(playback, [times.at(-1) ?? 0], read);
  playback.dispose();
  second.dispose();
  video.dispose();
  return {
    durationS: video.durationS,
    size: [video.widthPx, video.heightPx],
    shown,
    again,
    other,
    stays,
    textures: objects.counts().textures,
    error: gl.getError(),
  };
}

/** Asks for many times at once, as a dragged slider does; what is shown in the end is the last. */
export async function dragged() {
  const { objects, read } = createStand();
  const video = await load(objects, await grays());
  const playback = open(video);
  for (let i = 0; i < 15; i++) playback.follow(i / 10, 0, true);
  await playback.settle();
  const shown = await seek(playback, [1.4], read);
  playback.dispose();
  video.dispose();
  return shown;
}

export async function transparency() {
  const { objects, read, gl } = createStand();
  const video = await load(objects, await grays({ alpha: halves() }));
  const playback = open(video);
  playback.follow(0.5, 0, true);
  await playback.settle();
  const { image: picture } = playback;
  const result = { left: read(picture, 6, 24), right: read(picture, 26, 24), bottom: read(picture, 6, 3) };
  playback.dispose();
  video.dispose();
  return { ...result, error: gl.getError() };
}

const nextFrame = (): Promise<number> => new Promise((resolve) => requestAnimationFrame(resolve));

/**
 * Plays in time until it has shown `until` grays, in the order of their coming: no clock is measured, because a busy machine has
 * none to speak of.
 */
export async function running(until: number) {
  const { objects, read } = createStand();
  const video = await load(objects, await grays());
  const problems: string[] = [];
  const playback = open(video, ({ message }) => problems.push(message));
  const start = (await nextFrame()) / 1000;
  const seen: number[] = [];
  while (new Set(seen).size < until) {
    const timeS = ((await nextFrame()) / 1000 - start) % video.durationS;
    playback.follow(timeS, 1, true);
    const [red] = read(playback.image) ?? [];
    if (red === undefined) continue;
    const index = Math.round((red - grayOf(0)) / 11);
    if (seen.at(-1) !== index) seen.push(index);
  }
  // Held again, it is exact again.
  const then = await seek(playback, [0.75], read);
  playback.dispose();
  video.dispose();
  return { seen, then, problems };
}

/** A browser that lets nothing start by itself: pictures come all the same, and a tap lets it run. */
export async function blocked() {
  const { objects, read } = createStand();
  const video = await load(objects, await grays());
  const problems: { message: string; fix: string }[] = [];
  const { play } = HTMLMediaElement.prototype;
  let calls = 0;
  HTMLMediaElement.prototype.play = () => {
    calls++;
    return Promise.reject(new DOMException('not yet', 'NotAllowedError'));
  };
  const playback = open(video, (problem) => problems.push(problem));
  while (problems.length === 0) {
    playback.follow(0.1, 1, true);
    await nextFrame();
  }
  playback.follow(0.55, 1, true);
  await playback.settle();
  const shown = Math.round(((read(playback.image)?.[0] ?? 0) - grayOf(0)) / 11);
  const before = calls;
  playback.follow(0.55, 1, true);
  const silent = calls === before;
  document.dispatchEvent(new Event('pointerdown'));
  playback.follow(0.55, 1, true);
  HTMLMediaElement.prototype.play = play;
  playback.dispose();
  video.dispose();
  return { problems: problems.slice(0, 1), shown, silent, triedAgain: calls > before };
}

export async function refusals() {
  const { objects } = createStand();
  const refusal = (bytes: Uint8Array<ArrayBuffer>): Promise<string> =>
    load(objects, bytes).then(
      () => 'taken',
      (error: Error) => `${error.message} | ${(error as { fix?: string }).fix}`,
    );
  const film = await grays();
  const otherCodec = film.slice();
  // V_VP9 → V_XX9.
  const at = new TextDecoder('latin1').decode(film).indexOf('V_VP9');
  otherCodec.set([88, 88], at + 2);
  return {
    noise: await refusal(new Uint8Array(500).fill(9)),
    otherCodec: await refusal(otherCodec),
    headOnly: await refusal(film.slice(0, 60)),
  };
}
