import {
  DirectionalLight,
  DoubleSide,
  Mesh,
  type MeshPhysicalMaterialParameters,
  PlaneGeometry,
  Scene,
  SphereGeometry,
  WebGLRenderer,
} from 'three';
import type { Program } from '../../export/program/program.ts';
import { createFetchAssetSource } from '../../export/runtime/assets/asset-source.ts';
import { createScenesWith } from '../../export/runtime/scenes/create-scenes.ts';
import { createGlass } from '../../export/runtime/scenes/glass/glass-scene.ts';
import { ALL_DECODERS } from '../../export/runtime/scenes/models/decoders/all-decoders.ts';
import { RUNTIMES } from '../../nodes/generated/runtimes.gen.ts';
import type { CameraImage, ViewFrame } from '../../nodes/kit/session.ts';
import { FRONT, flat, glass, shoot } from '../browser/glass.page.ts';
import { frame, stand } from '../browser/runtime-kit.ts';
import { createGl, HEIGHT, item, lookingAt, pixel, readPixels, viewOf, WIDTH } from '../browser/scenes-kit.ts';

/** The same scene by three.js and by us: an opaque background of three colors, a sheet with lines, and glass of all kinds. */
export function againstThree(options: MeshPhysicalMaterialParameters, isTwoSided: boolean) {
  const parts = () => {
    const background = new Mesh(new PlaneGeometry(12, 12), flat(0x5577aa));
    background.position.z = -1.5;
    const bars = [-1, -0.5, 0, 0.5, 1].map((x, i) => {
      const bar = new Mesh(new PlaneGeometry(0.2, 4), flat([0xff4040, 0x40ff40, 0xffff40, 0x4040ff, 0xffffff][i] ?? 0));
      bar.position.set(x, 0, -1);
      return bar;
    });
    const side = isTwoSided ? { side: DoubleSide } : {};
    const ball = new Mesh(new SphereGeometry(0.55, 64, 32), glass({ ...options, ...side }));
    return [background, ...bars, ball];
  };
  const ours = shoot(
    parts().map((part) => {
      part.updateMatrix();
      const at = part.matrix.clone();
      part.position.set(0, 0, 0);
      return item(part, { at });
    }),
    { light: true },
  );
  const gl = createGl();
  const three = new WebGLRenderer({ canvas: gl.canvas, context: gl });
  three.setClearColor(0, 0);
  const light = new DirectionalLight(0xffffff, Math.PI);
  light.position.set(0.3, 1, 0.5);
  const scene = new Scene().add(...parts(), light);
  // Its first frame shows nothing through glass on SwiftShader: an incomplete framebuffer.
  for (let i = 0; i < 2; i++) three.render(scene, FRONT);
  gl.getError();
  const theirs = readPixels(gl, WIDTH, HEIGHT);
  three.dispose();
  let sum = 0;
  let far = 0;
  let inside = 0;
  for (let y = 0; y < HEIGHT; y++) {
    for (let x = 0; x < WIDTH; x++) {
      if (Math.hypot(x - WIDTH / 2, y - HEIGHT / 2) > 33) continue;
      const a = pixel(ours, x, y);
      const b = pixel(theirs, x, y);
      const worst = Math.max(...a.map((value, c) => Math.abs(value - (b[c] ?? 0))));
      inside++;
      sum += worst;
      if (worst > 12) far++;
    }
  }
  return { mean: sum / inside, far: far / inside, ours: [...ours], theirs: [...theirs] };
}

const SIDE = 256;

/** A camera image of colored checks of 16 pixels. */
function checks(gl: WebGL2RenderingContext): CameraImage {
  const texture = gl.createTexture();
  const bytes = new Uint8Array(SIDE * SIDE * 4);
  for (let y = 0; y < SIDE; y++) {
    for (let x = 0; x < SIDE; x++) {
      const isLight = ((x >> 4) + (y >> 4)) % 2 === 0;
      bytes.set(isLight ? [235, 225, 205, 255] : [60, 40 + x / 2, 60 + y / 2, 255], (y * SIDE + x) * 4);
    }
  }
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, SIDE, SIDE, 0, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  for (const name of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, name, gl.LINEAR);
  return { texture, widthPx: SIDE, heightPx: SIDE, uvFromViewUv: Float32Array.of(1, 0, 0, 0, 1, 0, 0, 0, 1) };
}

/** What a program shows over a camera image: in one view, in each half of two, and in one view after the context was lost. */
export async function play(
  program: Program,
  baseUrl: string,
  eye: readonly [number, number, number],
  target: readonly [number, number, number],
) {
  const gl = createGl(SIDE * 2, SIDE, { depth: true });
  const fetchFile = (...args: Parameters<typeof fetch>) => fetch(...args);
  const { player, diagnostics } = await stand(program, {
    gl,
    modules: RUNTIMES,
    held: true,
    createScenes: createScenesWith({
      decoders: ALL_DECODERS,
      files: createFetchAssetSource(`${location.href}libs/`, fetchFile).load,
      createGlass,
    }),
    assets: createFetchAssetSource(new URL(baseUrl, location.href).href, fetchFile),
  });
  player.setSession({ world: 'image', blend: 'opaque' });
  const camera = lookingAt(eye, target, 1);
  let image = checks(gl);
  const view = (x: number): ViewFrame => ({ ...viewOf(camera, { x, y: 0, widthPx: SIDE, heightPx: SIDE }), cameraImage: image });
  const sized = { framebufferWidthPx: SIDE * 2, framebufferHeightPx: SIDE };
  const half = (x: number): number[] => {
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    const pixels = new Uint8Array(SIDE * SIDE * 4);
    gl.readPixels(x, 0, SIDE, SIDE, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return [...pixels];
  };
  await player.drawSettled(frame(0, [view(0)], sized));
  await player.drawSettled(frame(1, [view(0)], sized));
  const one = half(0);
  await player.drawSettled(frame(2, [view(0), view(SIDE)], sized));
  const two = [half(0), half(SIDE)].map((pixels) => apart(one, pixels));
  const error = gl.getError();
  const lose = gl.getExtension('WEBGL_lose_context');
  const canvas = gl.canvas as HTMLCanvasElement;
  const event = (name: string): Promise<void> =>
    new Promise((resolve) => {
      canvas.addEventListener(name, (e) => void e.preventDefault(), { once: true });
      canvas.addEventListener(name, () => resolve(), { once: true });
    });
  const lost = event('webglcontextlost');
  lose?.loseContext();
  await lost;
  player.contextLost();
  const restored = event('webglcontextrestored');
  // Not allowed within the event's own task.
  await new Promise((resolve) => setTimeout(resolve, 0));
  lose?.restoreContext();
  await restored;
  await player.restore();
  image = checks(gl);
  await player.drawSettled(frame(3, [view(0)], sized));
  const again = apart(one, half(0));
  const told = diagnostics();
  player.dispose();
  return { one, two, again, error, told };
}

/** Pixels that differ by more than two steps. */
function apart(a: readonly number[], b: readonly number[]): number {
  let count = 0;
  for (let i = 0; i < a.length; i += 4) {
    if ([0, 1, 2, 3].some((c) => Math.abs((a[i + c] ?? 0) - (b[i + c] ?? 0)) > 2)) count++;
  }
  return count;
}
