/// <reference types="webxr" />
import { Matrix4, Vector3 } from 'three';
import type { Pixels } from '../../export/emulator/display/composite.ts';
import type { EmulatorOptions } from '../../export/emulator/options.ts';
import type { RoomBox } from '../../export/emulator/rooms/box-room.ts';
import { enter, first, lookAt, type Stage, type Triple } from './emulator-kit.ts';

type XrCamera = { readonly width: number; readonly height: number };
type Probe = EventTarget & { probeSpace: XRSpace };
type LightSession = XRSession & { requestLightProbe(init?: object): Promise<Probe> };
type LightFrame = XRFrame & {
  getLightEstimate(probe: Probe): {
    sphericalHarmonicsCoefficients: Float32Array;
    primaryLightDirection: DOMPointReadOnly;
    primaryLightIntensity: DOMPointReadOnly;
  };
};
type CameraBinding = XRWebGLBinding & { getCameraImage(camera: XrCamera): WebGLTexture };

/** Gray walls all around, and a red, a green and a blue cube in front of the viewer. */
const LANDMARKS: readonly (readonly [Triple, Triple])[] = [
  [
    [-0.9, 1.9, -2.4],
    [0.9, 0, 0],
  ],
  [
    [0.7, 1.2, -2.8],
    [0, 0.9, 0],
  ],
  [
    [0.1, 0.6, -1.7],
    [0, 0, 0.9],
  ],
];
const LANDMARK_ROOM: { readonly boxes: readonly RoomBox[] } = {
  boxes: [
    { label: 'wall', centerWorld: [0, 1, -5.05], sizeM: [20, 20, 0.1] },
    ...LANDMARKS.map(([centerWorld, albedo]) => ({ label: 'other', centerWorld, sizeM: [0.12, 0.12, 0.12] as const, albedo })),
  ],
};

export interface Landmark {
  /** The strongest channel of the camera image, of the picture and of depth's own pixel at the landmark. */
  readonly cameraChannel: number;
  readonly imageChannel: number;
  /** Depth there less the landmark's own distance along the view's axis; its front is half a side nearer. */
  readonly depthErrorM: number;
}

/** What stands at the projected center of each landmark, per view: camera image, composite and depth. */
export async function landmarks(options: EmulatorOptions): Promise<Landmark[]> {
  const stage = await enter(
    { room: LANDMARK_ROOM, extra: ['camera-access'], depth: { usages: ['cpu-optimized'], formats: ['float32'] }, ...options },
    {
      requiredFeatures: ['camera-access', 'depth-sensing'],
      depthSensing: { usagePreference: ['cpu-optimized'], dataFormatPreference: ['float32'] },
    },
  );
  stage.emulator.setPose(lookAt([0.2, 1.5, 0.3], [-0.1, 1.1, -2]));
  const seen = await stage.frame((frame, pose) =>
    pose.views.map((view) => {
      const camera = (view as XRView & { camera: XrCamera }).camera;
      const image = readTexture(stage.gl, (stage.binding as CameraBinding).getCameraImage(camera), camera.width, camera.height);
      const depth = frame.getDepthInformation?.(view);
      const { x = 0 } = stage.layer.getViewport(view) ?? {};
      return LANDMARKS.map(([centerWorld]) => {
        const inView = new Vector3(...centerWorld).applyMatrix4(new Matrix4().fromArray([...view.transform.inverse.matrix]));
        const distanceM = -inView.z;
        const { x: nx, y: ny } = inView.applyMatrix4(new Matrix4().fromArray([...view.projectionMatrix]));
        const [u, v] = [(nx + 1) / 2, (ny + 1) / 2];
        const column = Math.floor(u * camera.width);
        const row = Math.floor(v * camera.height);
        return {
          cameraChannel: strongest(image, (row * camera.width + column) * 4),
          at: [x + column, camera.height - 1 - row] as const,
          depthErrorM: (depth?.getDepthInMeters(u, 1 - v) ?? Number.NaN) - distanceM,
        };
      });
    }),
  );
  const picture = stage.emulator.readComposite();
  await stage.leave();
  return seen.flat().map(({ cameraChannel, at: [column, row], depthErrorM }) => ({
    cameraChannel,
    imageChannel: strongest(picture.rgba, (row * picture.widthPx + column) * 4),
    depthErrorM,
  }));
}

/** The camera image against the room as the device shows it: differing bytes, and the image's rows must be turned over. */
export async function cameraAgainstRoom(): Promise<number> {
  const stage = await enter({ room: 'studio', device: 'phone' }, { requiredFeatures: ['camera-access'] });
  stage.emulator.setPose(lookAt([1.2, 1.4, 1.9], [-0.5, 0.7, -1]));
  const image = await stage.frame((_, pose) => {
    const { camera } = first(pose.views) as XRView & { camera: XrCamera };
    return readTexture(stage.gl, (stage.binding as CameraBinding).getCameraImage(camera), camera.width, camera.height);
  });
  const room = stage.emulator.readRoom();
  await stage.leave();
  let differing = 0;
  const rowBytes = room.widthPx * 4;
  for (let i = 0; i < image.length; i++) {
    const row = room.heightPx - 1 - Math.floor(i / rowBytes);
    if (image[i] !== room.rgba[row * rowBytes + (i % rowBytes)]) differing++;
  }
  return differing;
}

/** What a page's half-transparent red makes of the room, in the middle of it and beside it. */
export async function blending(options: EmulatorOptions) {
  const stage = await enter({ room: LANDMARK_ROOM, sizePx: [64, 32], ...options });
  stage.emulator.setPose({ position: [0, 1, 0] });
  await stage.frame(() => fill(stage, [0.5, 0, 0, 0.5], 0, 0, 32, 32));
  const { emulator } = stage;
  const [layer, room, composite] = [emulator.readLayer(), emulator.readRoom(), emulator.readComposite()];
  const shown = shownPixel(stage, 8, 8);
  await stage.leave();
  return {
    layer: pixel(layer, 8, 8),
    room: pixel(room, 8, 8),
    composite: pixel(composite, 8, 8),
    beside: pixel(composite, 60, 8),
    shown,
    bareRoom: pixel(room, 60, 8),
  };
}

/** Draws into the canvas instead of the layer: on a device that shows nothing. */
export async function drawnIntoTheCanvas() {
  const stage = await enter({ room: null, sizePx: [32, 32] });
  await stage.frame(() => {
    stage.gl.bindFramebuffer(stage.gl.FRAMEBUFFER, null);
    stage.gl.clearColor(1, 1, 1, 1);
    stage.gl.clear(stage.gl.COLOR_BUFFER_BIT);
  });
  const layer = pixel(stage.emulator.readLayer(), 16, 16);
  await stage.leave();
  return layer;
}

/** A frame begins transparent whatever the page left on, and the page's own state is as it left it. */
export async function stateOfThePage() {
  const stage = await enter({ room: LANDMARK_ROOM, sizePx: [32, 32] }, { requiredFeatures: ['camera-access'] });
  const { gl } = stage;
  const own = { texture: gl.createTexture(), framebuffer: gl.createFramebuffer(), buffer: gl.createBuffer() };
  const settings = () => [
    gl.getParameter(gl.SCISSOR_TEST),
    [...(gl.getParameter(gl.COLOR_WRITEMASK) as boolean[])],
    gl.getParameter(gl.DEPTH_WRITEMASK),
    gl.getParameter(gl.UNPACK_FLIP_Y_WEBGL),
    gl.getParameter(gl.UNPACK_ALIGNMENT),
    gl.getParameter(gl.TEXTURE_BINDING_2D) === own.texture,
    gl.getParameter(gl.FRAMEBUFFER_BINDING) === own.framebuffer,
    gl.getParameter(gl.PIXEL_UNPACK_BUFFER_BINDING) === own.buffer,
    [...(gl.getParameter(gl.COLOR_CLEAR_VALUE) as Float32Array)],
  ];
  await stage.frame(() => {
    fill(stage, [0, 1, 0, 1], 0, 0, 32, 32);
    gl.bindTexture(gl.TEXTURE_2D, own.texture);
    gl.bindFramebuffer(gl.FRAMEBUFFER, own.framebuffer);
    gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, own.buffer);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(0, 0, 4, 4);
    gl.colorMask(true, false, true, false);
    gl.depthMask(false);
    gl.pixelStorei(gl.UNPACK_FLIP_Y_WEBGL, true);
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 2);
    gl.clearColor(0.25, 0.5, 0.75, 1);
  });
  const before = settings();
  const after = await stage.frame((_, pose) => {
    (stage.binding as CameraBinding).getCameraImage((first(pose.views) as XRView & { camera: XrCamera }).camera);
    return settings();
  });
  const begun = pixel(stage.emulator.readLayer(), 16, 16);
  const error = gl.getError();
  await stage.leave();
  return { before, after, begun, error };
}

const CARDINAL = [
  { direction: [1, 0, 0], albedo: [0.9, 0, 0] },
  { direction: [-1, 0, 0], albedo: [0, 0.9, 0] },
  { direction: [0, 1, 0], albedo: [0, 0, 0.9] },
  { direction: [0, -1, 0], albedo: [0.9, 0.9, 0] },
  { direction: [0, 0, 1], albedo: [0, 0.9, 0.9] },
  { direction: [0, 0, -1], albedo: [0.9, 0, 0.9] },
] as const;

/**
 * Light in a room whose six walls have six colors: the estimate, and for each direction the color that a page's shader finds
 * in the reflection cube map there (a little off the axes, so that a mirrored face shows).
 */
export async function light() {
  const boxes = CARDINAL.map(({ direction: [x, y, z], albedo }) => ({
    label: 'wall',
    centerWorld: [x * 2, 1.4 + y * 2, z * 2] as const,
    sizeM: [x === 0 ? 3.8 : 0.2, y === 0 ? 3.8 : 0.2, z === 0 ? 3.8 : 0.2] as const,
    albedo,
  }));
  const stage = await enter({ device: 'phone', room: { boxes } }, { requiredFeatures: ['light-estimation'] });
  const session = stage.session as LightSession;
  const binding = stage.binding as XRWebGLBinding & { getReflectionCubeMap(probe: Probe): WebGLTexture };
  const probe = await session.requestLightProbe();
  let changes = 0;
  probe.addEventListener('reflectionchange', () => changes++);
  const estimate = await stage.frame((frame) => (frame as LightFrame).getLightEstimate(probe));
  await stage.frame(() => {});
  const cube = binding.getReflectionCubeMap(probe);
  const corners = CARDINAL.flatMap(({ direction }) => [0.6, -0.6].flatMap((a) => [0.6, -0.6].map((b) => offAxis(direction, a, b))));
  const found = sampleCube(stage.gl, cube, corners);
  const error = stage.gl.getError();
  await stage.leave();
  const { primaryLightDirection: d, primaryLightIntensity: i } = estimate;
  return {
    changes,
    harmonics: [...estimate.sphericalHarmonicsCoefficients],
    direction: [d.x, d.y, d.z, d.w],
    intensity: [i.x, i.y, i.z, i.w],
    channels: found.map((rgb) => rgb.map((value) => value > 40)),
    error,
  };
}

/** On the floor of the studio, to both sides of its table (`furniture.ts`), and as far from it. */
const BESIDE_TABLE: readonly Triple[] = [
  [-0.98, 0, -0.42],
  [0.58, 0, -0.42],
];

export interface MovedLight {
  /** Of `BESIDE_TABLE`, sRGB green in [0, 255]. */
  readonly beside: readonly number[];
  readonly direction: readonly number[];
  /** Red, of what light depends on x. */
  readonly harmonicX: number;
  /** Times that the cube map was announced so far. */
  readonly changes: number;
  readonly pixels: number;
}

/** The studio from above, with its light where each of the directions says. */
export async function movedLight(directions: readonly (Triple | null)[]): Promise<MovedLight[]> {
  const stage = await enter({ device: 'phone', room: 'studio' }, { requiredFeatures: ['light-estimation'] });
  const session = stage.session as LightSession;
  const probe = await session.requestLightProbe();
  let changes = 0;
  probe.addEventListener('reflectionchange', () => changes++);
  stage.emulator.setPose(lookAt([-0.2, 2.3, 0.5], [-0.2, 0, -0.42]));
  const seen: MovedLight[] = [];
  for (const direction of directions) {
    stage.emulator.moveLight(direction);
    const { estimate, places } = await stage.frame((frame, pose) => ({
      estimate: (frame as LightFrame).getLightEstimate(probe),
      places: BESIDE_TABLE.map((place) => placeInView(place, pose.views[0])),
    }));
    await stage.frame(() => {});
    const { rgba, widthPx, heightPx } = stage.emulator.readComposite();
    const { x, y, z } = estimate.primaryLightDirection;
    let pixels = 0;
    for (const value of rgba) pixels = (Math.imul(pixels, 31) + value) | 0;
    seen.push({
      beside: places.map(([u, v]) => rgba[(Math.floor((1 - v) * heightPx) * widthPx + Math.floor(u * widthPx)) * 4 + 1] ?? 0),
      direction: [x, y, z],
      harmonicX: estimate.sphericalHarmonicsCoefficients[9] ?? 0,
      changes,
      pixels,
    });
  }
  await stage.leave();
  return seen;
}

/** From the bottom left of the picture, in [0, 1]. */
function placeInView(place: Triple, view: XRView | undefined): readonly [u: number, v: number] {
  if (!view) throw new Error('There is no view.');
  const clipFromWorld = new Matrix4().fromArray([...view.projectionMatrix]);
  clipFromWorld.multiply(new Matrix4().fromArray([...view.transform.inverse.matrix]));
  const { x, y } = new Vector3(...place).applyMatrix4(clipFromWorld);
  return [(x + 1) / 2, (y + 1) / 2];
}

function offAxis([x, y, z]: Triple, a: number, b: number): Triple {
  if (x !== 0) return [x, a, b];
  return y !== 0 ? [a, y, b] : [a, b, z];
}

/** A walk through a room: a number for each frame's composite and depth. */
export async function walk(options: EmulatorOptions): Promise<number[]> {
  const stage = await enter(
    { room: LANDMARK_ROOM, sizePx: [160, 120], ...options },
    {
      requiredFeatures: ['depth-sensing'],
      depthSensing: { usagePreference: ['cpu-optimized'], dataFormatPreference: ['luminance-alpha'] },
    },
  );
  const numbers: number[] = [];
  for (let i = 0; i < 4; i++) {
    stage.emulator.setPose(lookAt([1.2 - i * 0.3, 1.4, 1.6], [-0.4, 0.6, -0.8 + i * 0.1]));
    const depth = await stage.frame((frame, pose, timeMs) => {
      fill(stage, [timeMs / 255, 0, 0, 0.5], i * 20, 10, 40, 40);
      return pose.views.map((view) => digest(new Uint8Array(frame.getDepthInformation?.(view)?.data ?? new ArrayBuffer(0))));
    });
    numbers.push(digest(stage.emulator.readComposite().rgba), ...depth);
  }
  await stage.leave();
  return numbers;
}

function fill(
  { gl, layer }: Stage,
  [r, g, b, a]: readonly [number, number, number, number],
  x: number,
  y: number,
  width: number,
  height: number,
): void {
  gl.bindFramebuffer(gl.FRAMEBUFFER, layer.framebuffer);
  gl.enable(gl.SCISSOR_TEST);
  gl.scissor(x, y, width, height);
  gl.clearColor(r, g, b, a);
  gl.clear(gl.COLOR_BUFFER_BIT);
  gl.disable(gl.SCISSOR_TEST);
}

function readTexture(gl: WebGL2RenderingContext, texture: WebGLTexture, width: number, height: number): Uint8Array {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  const out = new Uint8Array(width * height * 4);
  gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, out);
  gl.deleteFramebuffer(framebuffer);
  return out;
}

function sampleCube(gl: WebGL2RenderingContext, cube: WebGLTexture, directions: readonly Triple[]): number[][] {
  const program = gl.createProgram();
  const sources = [
    [
      gl.VERTEX_SHADER,
      '#version 300 es\nvoid main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0); }',
    ],
    [
      gl.FRAGMENT_SHADER,
      '#version 300 es\nprecision highp float; uniform samplerCube cube; uniform vec3 direction; out vec4 color; void main() { color = texture(cube, direction); }',
    ],
  ] as const;
  for (const [type, source] of sources) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error('No shader.');
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  gl.useProgram(program);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.viewport(0, 0, 1, 1);
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, cube);
  return directions.map((direction) => {
    gl.uniform3f(gl.getUniformLocation(program, 'direction'), ...direction);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    const out = new Uint8Array(4);
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, out);
    return [...out.subarray(0, 3)];
  });
}

/** Of the canvas that the user looks at. */
function shownPixel({ gl }: Stage, x: number, y: number): number[] {
  const canvas = document.querySelector<HTMLCanvasElement>('[data-scrim-emulator] canvas');
  if (!canvas) return [];
  const copy = document.createElement('canvas');
  copy.width = canvas.width;
  copy.height = canvas.height;
  const context = copy.getContext('2d');
  context?.drawImage(canvas, 0, 0);
  gl.flush();
  return [...(context?.getImageData(x, y, 1, 1).data ?? [])];
}

function pixel({ rgba, widthPx }: Pixels, x: number, y: number): number[] {
  return [...rgba.subarray((y * widthPx + x) * 4, (y * widthPx + x) * 4 + 4)];
}

function strongest(rgba: Uint8Array, at: number): number {
  const rgb = [...rgba.subarray(at, at + 3)];
  return rgb.indexOf(Math.max(...rgb));
}

/** FNV-1a. */
function digest(bytes: Uint8Array): number {
  let hash = 0x811c9dc5;
  for (const byte of bytes) hash = Math.imul(hash ^ byte, 0x01000193);
  return hash >>> 0;
}
