/// <reference types="webxr" />
import { Matrix4, Raycaster, Vector3 } from 'three';
import type { DepthOptions, EmulatorOptions } from '../../export/emulator/options.ts';
import type { DepthFormat, DepthUsage } from '../../export/emulator/profiles.ts';
import { createRoom, type RoomSource } from '../../export/emulator/rooms/room-source.ts';
import { enter, first, lookAt, type Stage, type Triple } from './emulator-kit.ts';

export interface DepthTrial {
  readonly options: EmulatorOptions;
  readonly eye: Triple;
  readonly target: Triple;
  readonly usage: DepthUsage;
  readonly format: DepthFormat;
}

export interface DepthErrors {
  /** Of |measured − ray cast|, meters, over the sampled texels of all views. */
  readonly medianM: number;
  readonly maxM: number;
  readonly samples: number;
  /** Texels where one found a surface and the other none. */
  readonly disagreements: number;
  readonly views: number;
  readonly granted: readonly [string, string];
}

/** Every `stride`-th texel against a ray through the same point of the view, cast at the room's triangles. */
export async function compareWithRays(trial: DepthTrial, stride: number): Promise<DepthErrors> {
  const stage = await enter(trial.options, depthInit(trial.usage, trial.format));
  stage.emulator.setPose(lookAt(trial.eye, trial.target));
  const views = await stage.frame((frame, pose) => pose.views.map((view) => readDepth(stage, frame, view)));
  const granted = [stage.session.depthUsage, stage.session.depthDataFormat] as const;
  const cast = createCaster(trial.options.room ?? 'studio');
  const errors: number[] = [];
  let disagreements = 0;
  for (const view of views) {
    for (let row = 1; row < view.height; row += stride) {
      for (let column = 1; column < view.width; column += stride) {
        const measured = view.meters[row * view.width + column] ?? 0;
        const error = errorAt(measured, (dx, dy) => cast(view, (column + 0.5 + dx) / view.width, (row + 0.5 + dy) / view.height));
        if (Number.isFinite(error)) errors.push(error);
        else disagreements++;
      }
    }
  }
  errors.sort((a, b) => a - b);
  await stage.leave();
  return {
    medianM: errors[Math.floor(errors.length / 2)] ?? Number.NaN,
    maxM: errors.at(-1) ?? Number.NaN,
    samples: errors.length,
    disagreements,
    views: views.length,
    granted: [String(granted[0]), String(granted[1])],
  };
}

/** Drivers snap corners to a fraction of a pixel, so an edge may fall on the other side of a texel's center. */
const NUDGES = [
  [-0.1, 0],
  [0.1, 0],
  [0, -0.1],
  [0, 0.1],
] as const;

/** Infinite where one found a surface and the other none. */
function errorAt(measured: number, castAt: (dx: number, dy: number) => number | null): number {
  const error = (dx: number, dy: number): number => {
    const expected = castAt(dx, dy);
    if (expected === null) return measured === 0 ? 0 : Number.POSITIVE_INFINITY;
    return measured === 0 ? Number.POSITIVE_INFINITY : Math.abs(measured - expected);
  };
  const atCenter = error(0, 0);
  return atCenter < 0.002 ? atCenter : Math.min(atCenter, ...NUDGES.map(([dx, dy]) => error(dx, dy)));
}

export function depthInit(usage: DepthUsage, format: DepthFormat): XRSessionInit {
  return { requiredFeatures: ['depth-sensing'], depthSensing: { usagePreference: [usage], dataFormatPreference: [format] } };
}

interface ReadDepth {
  readonly width: number;
  readonly height: number;
  /** Row-major as the buffer or texture has them. */
  readonly meters: Float32Array;
  readonly bufferFromView: Matrix4;
  readonly worldFromView: Matrix4;
  readonly clipFromView: Matrix4;
}

function readDepth({ session, gl, binding }: Stage, frame: XRFrame, view: XRView): ReadDepth {
  const onGpu = session.depthUsage === 'gpu-optimized';
  const info = onGpu ? binding.getDepthInformation(view) : frame.getDepthInformation?.(view);
  if (!info) throw new Error('No depth.');
  const { width, height, rawValueToMeters } = info;
  const raw =
    'texture' in info
      ? readTexture(gl, info, session.depthDataFormat as DepthFormat)
      : toNumbers(info.data, session.depthDataFormat as DepthFormat);
  return {
    width,
    height,
    meters: raw.map((value) => value * rawValueToMeters),
    bufferFromView: new Matrix4().fromArray([...info.normDepthBufferFromNormView.matrix]),
    worldFromView: new Matrix4().fromArray([...view.transform.matrix]),
    clipFromView: new Matrix4().fromArray([...view.projectionMatrix]),
  };
}

function toNumbers(data: ArrayBuffer, format: DepthFormat): Float32Array {
  return Float32Array.from(format === 'float32' ? new Float32Array(data) : new Uint16Array(data));
}

/** Draws the depth texture texel by texel into floats, as a page's shader would read it. */
function readTexture(gl: WebGL2RenderingContext, info: XRWebGLDepthInformation, format: DepthFormat): Float32Array {
  const isArray = info.textureType === 'texture-array';
  const sampler = `${format === 'unsigned-short' ? 'u' : ''}sampler2D${isArray ? 'Array' : ''}`;
  const coordinate = isArray ? `ivec3(ivec2(gl_FragCoord.xy), ${info.imageIndex ?? 0})` : 'ivec2(gl_FragCoord.xy)';
  const value = format === 'luminance-alpha' ? 'dot(texel.ra, vec2(255.0, 65280.0))' : 'float(texel.r)';
  const program = link(
    gl,
    '#version 300 es\nvoid main() { gl_Position = vec4(vec2((gl_VertexID << 1) & 2, gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0); }',
    `#version 300 es
    precision highp float; precision highp int;
    uniform highp ${sampler} depth; out float raw;
    void main() { ${format === 'unsigned-short' ? 'uvec4' : 'vec4'} texel = texelFetch(depth, ${coordinate}, 0); raw = ${value}; }`,
  );
  gl.getExtension('EXT_color_buffer_float');
  const target = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, target);
  gl.texStorage2D(gl.TEXTURE_2D, 1, gl.R32F, info.width, info.height);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  gl.bindTexture(isArray ? gl.TEXTURE_2D_ARRAY : gl.TEXTURE_2D, info.texture);
  gl.useProgram(program);
  gl.viewport(0, 0, info.width, info.height);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const out = new Float32Array(info.width * info.height);
  gl.readPixels(0, 0, info.width, info.height, gl.RED, gl.FLOAT, out);
  return out;
}

function link(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [type, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(type);
    if (!shader) throw new Error('No shader.');
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? 'link');
  return program;
}

type Cast = (view: ReadDepth, u: number, v: number) => number | null;

/** three.js' own intersection of a ray with the room's triangles: nothing in common with drawing them. */
function createCaster(source: RoomSource): Cast {
  const room = createRoom(source);
  room.solids.updateMatrixWorld(true);
  const raycaster = new Raycaster();
  const inView = new Vector3();
  return ({ bufferFromView, worldFromView, clipFromView }, u, v) => {
    // Depth buffer → view, both with the origin at the top left → device coordinates → a ray that advances 1 m along −z.
    inView.set(u, v, 0).applyMatrix4(bufferFromView.clone().invert());
    const [x, y] = [2 * inView.x - 1, 1 - 2 * inView.y];
    const p = clipFromView.elements;
    const direction = new Vector3((x + p[8]) / p[0], (y + p[9]) / p[5], -1);
    const length = direction.length();
    raycaster.set(new Vector3().setFromMatrixPosition(worldFromView), direction.transformDirection(worldFromView));
    const [hit] = raycaster.intersectObject(room.solids, true);
    return hit ? hit.distance / length : null;
  };
}

/** Depth at the middle of the view, right after a move and right after the next one. */
export async function depthAfterMoves(): Promise<number[]> {
  const wall = { label: 'wall', centerWorld: [0, 1, -3.05], sizeM: [8, 8, 0.1] } as const;
  const stage = await enter({ device: 'phone', room: { boxes: [wall] } }, depthInit('cpu-optimized', 'luminance-alpha'));
  const out: number[] = [];
  for (const z of [0, 1, -1]) {
    stage.emulator.setPose({ position: [0, 1, z] });
    out.push(
      await stage.frame((frame, pose) => {
        const info = frame.getDepthInformation?.(first(pose.views));
        return info?.getDepthInMeters(0.5, 0.5) ?? Number.NaN;
      }),
    );
  }
  await stage.leave();
  return out;
}

/** `getDepthInMeters` at places of the view, for a post on the left half and a wall behind, under a transform of the buffer. */
export async function depthAtPlaces(
  transform: NonNullable<DepthOptions['transform']>,
  places: readonly (readonly [number, number])[],
): Promise<number[]> {
  const boxes = [
    { label: 'wall', centerWorld: [0, 1, -4.05], sizeM: [20, 20, 0.1] },
    { label: 'other', centerWorld: [-0.6, 1.4, -2.25], sizeM: [0.8, 0.8, 0.5] },
  ] as const;
  const options: EmulatorOptions = { device: 'phone', room: { boxes }, sizePx: [400, 400], depth: { sizePx: [90, 60], transform } };
  const stage = await enter(options, depthInit('cpu-optimized', 'luminance-alpha'));
  stage.emulator.setPose({ position: [0, 1, 0] });
  const out = await stage.frame((frame, pose) => {
    const info = frame.getDepthInformation?.(first(pose.views));
    return places.map(([x, y]) => info?.getDepthInMeters(x, y) ?? Number.NaN);
  });
  await stage.leave();
  return out;
}
