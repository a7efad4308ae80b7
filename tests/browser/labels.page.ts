import type { Program } from '../../export/program/program.ts';
import { createScenes } from '../../export/runtime/scenes/create-scenes.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { ParamValue } from '../../nodes/kit/definition.ts';
import type { DetectedMesh, DetectedPlane } from '../../nodes/kit/session.ts';
import { createGl, frame, HEIGHT, pixel, type Stand, stand, view, WIDTH } from './runtime-kit.ts';

/** What is seen of the labels after a frame. */
export interface Seen {
  /** Text of the labels that the page shows, with their opacity. */
  readonly texts: readonly string[];
  readonly opacities: readonly string[];
  /** Writes to the page, and textures painted, since the last call. */
  readonly writes: number;
  readonly paints: number;
  readonly center: readonly number[];
  readonly codes: readonly string[];
  readonly error: number;
}

const overlay = document.createElement('div');
Object.assign(overlay.style, { position: 'fixed', left: '0', top: '0', width: `${WIDTH}px`, height: `${HEIGHT}px` });
document.body.append(overlay);

let paints = 0;
const { prototype } = OffscreenCanvasRenderingContext2D;
const { roundRect } = prototype;
prototype.roundRect = function count(...args: Parameters<typeof roundRect>): void {
  paints++;
  roundRect.apply(this, args);
};

let playing: Stand | null = null;
let index = 0;
const observer = new MutationObserver(() => {});

/** A vertical surface 1 m before the viewer. */
const WALL: DetectedPlane = {
  id: 'wall',
  version: 1,
  label: 'wall',
  orientation: 'vertical',
  // Its normal, y, is towards the viewer.
  worldFromSurface: Float32Array.of(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, -1, 1),
  outlineXZ: Float32Array.of(-2, -2, 2, -2, 2, 2, -2, 2),
};

const FAR_WALL: DetectedPlane = {
  ...WALL,
  id: 'far wall',
  worldFromSurface: Float32Array.of(1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, -3, 1),
};

/** The front of a box, 1 m before the viewer, as a mesh. */
const BOX: DetectedMesh = {
  id: 'box',
  version: 1,
  label: 'box',
  worldFromSurface: Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -1, 1),
  positions: Float32Array.of(-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0),
  indices: Uint32Array.of(0, 1, 2, 0, 2, 3),
};

const PLANES: Readonly<Record<string, DetectedPlane>> = { wall: WALL, 'far wall': FAR_WALL };

export async function open(program: Program): Promise<void> {
  playing?.player.dispose();
  playing = await stand(program, { gl: createGl({ depth: true }), modules: RUNTIMES, createScenes, overlay });
  playing.player.setSession({ world: 'device', blend: 'alpha' });
}

export function setParam(name: string, value: ParamValue): boolean {
  return playing?.player.setParam('label-x1', name, value) ?? false;
}

export function setPosition(position: number[]): boolean {
  return playing?.player.setParam('pose-x1', 'positionM', position) ?? false;
}

export function hidePage(hidesPage: boolean): void {
  playing?.player.setSession({ world: 'device', blend: 'alpha', hidesPage });
}

/** @param names Of the surfaces that are detected. */
export function draw(names: readonly string[] = []): Seen {
  if (!playing) throw new Error('Nothing plays.');
  paints = 0;
  observer.takeRecords();
  playing.player.draw(
    frame(index++, [view(0, 0, WIDTH, HEIGHT)], {
      surfaces: { planes: names.flatMap((name) => PLANES[name] ?? []), meshes: names.includes('box') ? [BOX] : [] },
    }),
  );
  const writes = observer.takeRecords().length;
  observer.disconnect();
  const roots = [...overlay.children].flatMap((host) => host.shadowRoot ?? []);
  for (const root of roots) observer.observe(root, { attributes: true, childList: true, subtree: true, characterData: true });
  const shown = roots.flatMap((root) => [...root.querySelectorAll('p')]).filter((label) => label.style.visibility === 'visible');
  return {
    texts: shown.map((label) => label.textContent ?? ''),
    opacities: shown.map((label) => label.style.opacity || '1'),
    writes,
    paints,
    center: pixel(playing.gl, WIDTH / 2, HEIGHT / 2),
    codes: playing.diagnostics().map(({ code }) => code),
    error: playing.gl.getError(),
  };
}

export function close(): number {
  playing?.player.dispose();
  playing = null;
  return overlay.childElementCount;
}
