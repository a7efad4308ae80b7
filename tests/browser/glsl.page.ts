import type { NamedSize } from '../../export/glsl/isf/isf-shader.ts';
import type { LinkedPass, LinkedSampler, LinkedUniform } from '../../export/glsl/link/linked-pass.ts';
import {
  GATE_SAMPLER,
  GATE_UNIFORM,
  LOOP_BUDGET_UNIFORM,
  PROBE_ATTACHMENT,
  PROBE_SIDE_PX,
  readProbe,
} from '../../export/program/loop-budget.ts';
import type { LinkedShader } from '../../export/program/program.ts';
import { TABLE_WIDTH_PX } from '../../export/program/texture-sizes.ts';
import { sampleCurve } from '../../nodes/kit/curve.ts';
import { sampleGradient } from '../../nodes/kit/gradient.ts';
import { playSize, SIZE_STACK_BOTTOM } from '../../nodes/kit/play-size.ts';
import type { TableType } from '../../nodes/kit/wire-types.ts';

/**
 * Plays linked passes as `export/program/program.ts` says, in a few lines of plain WebGL 2 and without the runtime: what the
 * tests find wrong is then the linker's or the shader's.
 */
export interface Picture {
  readonly width: number;
  readonly height: number;
  /** RGBA8, premultiplied, bottom row first, base64. */
  readonly rgba: string;
  /** Column-major 3×3; the identity where it is left out. */
  readonly uvFromViewUv?: readonly number[];
}

export interface DepthImage {
  readonly width: number;
  readonly height: number;
  /** Bottom row first: meters, or what a depth buffer holds. */
  readonly values: readonly number[];
  readonly decode?: readonly [number, number, number, number];
}

export interface DrawJob {
  readonly width: number;
  readonly height: number;
  readonly passes: readonly LinkedPass[];
  readonly pictures?: Readonly<Record<string, Picture>>;
  /** Layer depth by the layer's input, room depth by its own. */
  readonly depths?: Readonly<Record<string, DepthImage>>;
  /** Imported cubes by name: a color per side. */
  readonly cubes?: Readonly<Record<string, readonly (readonly number[])[]>>;
  /** Events too: 1 where they happen. */
  readonly params?: Readonly<Record<string, number | readonly number[]>>;
  /** Matrices of the view, column-major 4×4; identities where they are left out. */
  readonly clipFromView?: readonly number[];
  readonly worldFromView?: readonly number[];
  /** How often to draw; buffers that persist keep their picture in between. */
  readonly frames?: number;
}

export interface Drawing {
  /** As `Picture.rgba`; empty for a float output. */
  readonly rgba: string;
  /** Of float outputs, RGBA. */
  readonly floats: readonly number[];
  readonly glError: number;
  readonly logs: readonly string[];
}

const IDENTITY = [1, 0, 0, 0, 1, 0, 0, 0, 1];
const IDENTITY_4 = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
const FRAME_S = 1 / 60;

const gl = createContext();

function createContext(): WebGL2RenderingContext {
  const context = document.createElement('canvas').getContext('webgl2', { antialias: false });
  if (context === null) throw new Error('This browser has no WebGL 2.');
  context.getExtension('EXT_color_buffer_float');
  context.getExtension('OES_texture_float_linear');
  context.getExtension('EXT_color_buffer_half_float');
  return context;
}

/** The driver's log for each shader; empty where it compiles and links. */
export function compile(shaders: readonly LinkedShader[]): string[] {
  return shaders.map((shader) => {
    const { program, log } = link(shader);
    gl.deleteProgram(program);
    return log;
  });
}

/** One for all shaders: a browser takes the oldest context away when there are more than sixteen. */
let elsewhere: WebGLRenderingContext | null = null;

/** The log of WebGL 1 for a fragment shader's text: what hosts that never heard of Scrim would make of it. */
export function compileElsewhere(fragment: string): string {
  elsewhere ??= document.createElement('canvas').getContext('webgl');
  const other = elsewhere;
  const shader = other?.createShader(other.FRAGMENT_SHADER);
  if (!other || !shader) throw new Error('This browser has no WebGL.');
  other.shaderSource(shader, fragment);
  other.compileShader(shader);
  return other.getShaderParameter(shader, other.COMPILE_STATUS) ? '' : (other.getShaderInfoLog(shader) ?? 'failed without a word');
}

/** A unit where there is nothing: the first may still hold what is drawn into. */
const NO_TEXTURE = 15;

export function draw(job: DrawJob): Drawing {
  const programs = job.passes.map((pass) => linked(pass.shader));
  const logs = programs.map(({ log }) => log);
  if (logs.some((log) => log !== '')) return { rgba: '', floats: [], glError: 0, logs };
  const textures = new Map<string, WebGLTexture>();
  for (const [name, picture] of Object.entries(job.pictures ?? {})) textures.set(name, upload(picture));
  for (const [name, depth] of Object.entries(job.depths ?? {})) textures.set(`${name}:depth`, uploadDepth(depth));
  const buffers = new Map<string, Buffer>();
  let output: Buffer | null = null;
  for (let frame = 0; frame < (job.frames ?? 1); frame += 1) {
    job.passes.forEach((pass, i) => {
      const program = programs[i]?.program;
      if (program === undefined) return;
      const target = targetOf(pass, job, buffers);
      gl.useProgram(program);
      setUniforms(program, pass.uniforms, pass, target, job, frame);
      setSamplers(program, pass.samplers, textures, buffers, job);
      gl.uniform1i(gl.getUniformLocation(program, GATE_SAMPLER), NO_TEXTURE);
      gl.bindFramebuffer(gl.FRAMEBUFFER, target.framebuffers[1 - target.front] ?? null);
      gl.viewport(0, 0, target.width, target.height);
      if (pass.shader.geometry === 'moved-quad') gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
      gl.drawArrays(gl.TRIANGLES, 0, pass.shader.geometry === undefined ? 3 : 6);
      target.front = 1 - target.front;
      if (pass.target.kind === 'output') output = target;
    });
  }
  const drawing = { ...read(output, job.passes.at(-1)), glError: gl.getError(), logs };
  for (const texture of [...textures.values(), ...[...buffers.values()].flatMap((buffer) => buffer.textures)]) gl.deleteTexture(texture);
  for (const framebuffer of [...buffers.values()].flatMap((buffer) => buffer.framebuffers)) gl.deleteFramebuffer(framebuffer);
  return drawing;
}

/** The author's line that a probe of the loop budget finds, as `export/program/loop-budget.ts` describes it, or null. */
export function endlessLine(job: DrawJob, budget: number): number | null {
  const [pass] = job.passes;
  if (pass === undefined) throw new Error('Nothing to draw.');
  const { program, log } = link(pass.shader);
  if (log !== '') throw new Error(log);
  const texture = createTexture(gl.RG8, PROBE_SIDE_PX, PROBE_SIDE_PX, gl.NEAREST);
  gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + PROBE_ATTACHMENT, gl.TEXTURE_2D, texture, 0);
  gl.drawBuffers([gl.NONE, gl.COLOR_ATTACHMENT1]);
  gl.viewport(0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX);
  gl.useProgram(program);
  gl.uniform1i(gl.getUniformLocation(program, LOOP_BUDGET_UNIFORM), budget);
  gl.uniform1i(gl.getUniformLocation(program, GATE_SAMPLER), NO_TEXTURE);
  setUniforms(program, pass.uniforms, pass, { width: PROBE_SIDE_PX, height: PROBE_SIDE_PX }, job, 0);
  gl.drawArrays(gl.TRIANGLES, 0, 3);
  const found = new Uint8Array(PROBE_SIDE_PX ** 2 * 4);
  gl.readBuffer(gl.COLOR_ATTACHMENT1);
  gl.readPixels(0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, found);
  const glError = gl.getError();
  if (glError !== 0) throw new Error(`GL error ${glError}`);
  return readProbe(found);
}

/** Whether anything is drawn, by the value of the gate: with a probe that is all zero, and with one of a single line. */
export function drawBehindGate(job: DrawJob): Record<'free' | 'unlessExceeded' | 'ifExceeded', readonly boolean[]> {
  const [pass] = job.passes;
  if (pass === undefined) throw new Error('Nothing to draw.');
  const { program } = link(pass.shader);
  const target = createTexture(gl.RGBA8, 8, 8);
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
  gl.viewport(0, 0, 8, 8);
  gl.useProgram(program);
  const drawn = (gate: number) =>
    [0, 300].map((line) => {
      createTexture(gl.RG8, PROBE_SIDE_PX, PROBE_SIDE_PX, gl.NEAREST);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 3, 14, 1, 1, gl.RG, gl.UNSIGNED_BYTE, Uint8Array.of(line & 255, line >> 8));
      gl.uniform1i(gl.getUniformLocation(program, GATE_UNIFORM), gate);
      gl.uniform1i(gl.getUniformLocation(program, GATE_SAMPLER), 0);
      gl.clearBufferfv(gl.COLOR, 0, [0, 0, 0, 0]);
      gl.drawArrays(gl.TRIANGLES, 0, 3);
      const found = new Uint8Array(4);
      gl.readPixels(4, 4, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, found);
      return (found[3] ?? 0) > 0;
    });
  return { free: drawn(0), unlessExceeded: drawn(1), ifExceeded: drawn(2) };
}

/** Programs that drew, by their text. Tests draw many pictures by the same shader, and most of their time would go into compiling it. */
const programsByText = new Map<string, ReturnType<typeof link>>();

function linked(shader: LinkedShader): ReturnType<typeof link> {
  const text = `${shader.vertex}\n${shader.fragment}`;
  const known = programsByText.get(text) ?? link(shader);
  programsByText.set(text, known);
  return known;
}

function link(shader: LinkedShader): { program: WebGLProgram; log: string } {
  const program = gl.createProgram();
  let log = '';
  for (const [type, text] of [
    [gl.VERTEX_SHADER, shader.vertex],
    [gl.FRAGMENT_SHADER, shader.fragment],
  ] as const) {
    const stage = gl.createShader(type);
    if (stage === null) throw new Error('The context is lost.');
    gl.shaderSource(stage, text);
    gl.compileShader(stage);
    if (!gl.getShaderParameter(stage, gl.COMPILE_STATUS)) log += gl.getShaderInfoLog(stage) ?? 'failed without a word';
    gl.attachShader(program, stage);
  }
  if (log === '') {
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) log = gl.getProgramInfoLog(program) ?? 'failed without a word';
  }
  return { program, log };
}

interface Buffer {
  readonly width: number;
  readonly height: number;
  readonly textures: readonly [WebGLTexture, WebGLTexture];
  readonly framebuffers: readonly [WebGLFramebuffer, WebGLFramebuffer];
  front: number;
}

function targetOf(pass: LinkedPass, job: DrawJob, buffers: Map<string, Buffer>): Buffer {
  const { target } = pass;
  const name = target.kind === 'output' ? 'the output' : target.name;
  const known = buffers.get(name);
  if (known !== undefined) return known;
  const width = target.kind === 'output' ? job.width : evaluateSize(target.width, job.width, job);
  const height = target.kind === 'output' ? job.height : evaluateSize(target.height, job.height, job);
  const internal = { rgba8: gl.RGBA8, scene16f: gl.RGBA16F, rgba16f: gl.RGBA16F, rgba32f: gl.RGBA32F, r32f: gl.R32F }[target.format];
  const textures = [createTexture(internal, width, height), createTexture(internal, width, height)] as const;
  const buffer: Buffer = { width, height, textures, framebuffers: [frame(textures[0]), frame(textures[1])], front: 0 };
  buffers.set(name, buffer);
  return buffer;
}

function frame(texture: WebGLTexture): WebGLFramebuffer {
  const framebuffer = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, framebuffer);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.clear(gl.COLOR_BUFFER_BIT);
  return framebuffer;
}

function createTexture(internal: number, width: number, height: number, filter: number = gl.LINEAR): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, internal, width, height);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
  return texture;
}

function upload(picture: Picture): WebGLTexture {
  const texture = createTexture(gl.RGBA8, picture.width, picture.height);
  const bytes = Uint8Array.from(atob(picture.rgba), (c) => c.charCodeAt(0));
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, picture.width, picture.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  return texture;
}

/** Sides of one pixel each, in the order +x, -x, +y, -y, +z, -z. */
function uploadCube(sides: readonly (readonly number[])[]): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_CUBE_MAP, texture);
  sides.forEach((color, i) => {
    gl.texImage2D(gl.TEXTURE_CUBE_MAP_POSITIVE_X + i, 0, gl.RGBA8, 1, 1, 0, gl.RGBA, gl.UNSIGNED_BYTE, Uint8Array.from(color));
  });
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_CUBE_MAP, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

function uploadDepth(depth: DepthImage): WebGLTexture {
  const texture = createTexture(gl.R32F, depth.width, depth.height, gl.NEAREST);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, depth.width, depth.height, gl.RED, gl.FLOAT, new Float32Array(depth.values));
  return texture;
}

function uploadTable(of: TableType, value: number | readonly number[] | undefined): WebGLTexture {
  if (typeof value !== 'object') throw new Error(`The test gives no ${of}.`);
  const isCurve = of === 'curve';
  const row = new Float32Array(TABLE_WIDTH_PX * (isCurve ? 1 : 4));
  if (isCurve) sampleCurve(value, row);
  else sampleGradient(value, row);
  const texture = createTexture(isCurve ? gl.R16F : gl.RGBA16F, TABLE_WIDTH_PX, 1);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, TABLE_WIDTH_PX, 1, isCurve ? gl.RED : gl.RGBA, gl.FLOAT, row);
  return texture;
}

function setUniforms(
  program: WebGLProgram,
  uniforms: readonly LinkedUniform[],
  pass: LinkedPass,
  target: { readonly width: number; readonly height: number },
  job: DrawJob,
  frameIndex: number,
): void {
  for (const { name, type, source } of uniforms) {
    const location = gl.getUniformLocation(program, name);
    const builtins = {
      TIME: frameIndex * FRAME_S,
      TIMEDELTA: frameIndex === 0 ? 0 : FRAME_S,
      FRAMEINDEX: frameIndex,
      DATE: [2026, 3, 4, 5],
      RENDERSIZE: [target.width, target.height],
      PASSINDEX: pass.passIndex,
      SCRIM_CLIP_FROM_VIEW: job.clipFromView ?? IDENTITY_4,
      SCRIM_WORLD_FROM_VIEW: job.worldFromView ?? IDENTITY_4,
    };
    const given = 'event' in source ? (job.params?.[source.event] ?? 0) : undefined;
    const value = given ?? ('builtin' in source ? builtins[source.builtin] : 'param' in source ? job.params?.[source.param] : undefined);
    if (value === undefined) throw new Error(`The test gives no value for ${name}.`);
    const numbers = typeof value === 'number' ? [value] : [...value];
    if (type === 'int' || type === 'bool') gl.uniform1iv(location, numbers);
    else if (type === 'float') gl.uniform1fv(location, numbers);
    else if (type === 'vec2') gl.uniform2fv(location, numbers);
    else if (type === 'vec3') gl.uniform3fv(location, numbers);
    else if (type === 'mat4') gl.uniformMatrix4fv(location, false, numbers);
    else gl.uniform4fv(location, numbers);
  }
}

function setSamplers(
  program: WebGLProgram,
  samplers: readonly LinkedSampler[],
  textures: ReadonlyMap<string, WebGLTexture>,
  buffers: ReadonlyMap<string, Buffer>,
  job: DrawJob,
): void {
  samplers.forEach(({ name, source }, unit) => {
    const buffer = source.kind === 'buffer' ? buffers.get(source.target) : undefined;
    const image = source.kind === 'import' ? source.import : 'input' in source ? source.input : '';
    const isDepth = source.kind === 'input-depth' || source.kind === 'room-depth';
    const cube = job.cubes?.[image];
    const picture = job.pictures?.[image];
    const depth = job.depths?.[image];
    const texture = buffer === undefined ? textures.get(isDepth ? `${image}:depth` : image) : buffer.textures[buffer.front];
    gl.activeTexture(gl.TEXTURE0 + unit);
    if (cube) gl.bindTexture(gl.TEXTURE_CUBE_MAP, uploadCube(cube));
    else if (source.kind === 'table') gl.bindTexture(gl.TEXTURE_2D, uploadTable(source.of, job.params?.[source.param]));
    else gl.bindTexture(gl.TEXTURE_2D, texture ?? null);
    gl.uniform1i(gl.getUniformLocation(program, name), unit);
    gl.uniformMatrix3fv(gl.getUniformLocation(program, `${name}_uvFromViewUv`), false, picture?.uvFromViewUv ?? IDENTITY);
    const own = buffer ?? (source.kind === 'import' || source.kind === 'sound' ? picture : undefined) ?? job;
    gl.uniform2f(gl.getUniformLocation(program, `${name}_size`), own.width, own.height);
    const [x, y, z, w] = depth?.decode ?? [1, 0, 0, 0];
    gl.uniform4f(gl.getUniformLocation(program, `${name}_decode`), x, y, z, w);
  });
}

function read(output: Buffer | null, last: LinkedPass | undefined): Pick<Drawing, 'rgba' | 'floats'> {
  if (output === null || last === undefined) throw new Error('No pass draws the output.');
  gl.bindFramebuffer(gl.FRAMEBUFFER, output.framebuffers[output.front] ?? null);
  if (last.target.format === 'rgba8') {
    const bytes = new Uint8Array(output.width * output.height * 4);
    gl.readPixels(0, 0, output.width, output.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    let text = '';
    for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192));
    return { rgba: btoa(text), floats: [] };
  }
  const floats = new Float32Array(output.width * output.height * 4);
  gl.readPixels(0, 0, output.width, output.height, gl.RGBA, gl.FLOAT, floats);
  return { rgba: '', floats: [...floats] };
}

function evaluateSize(size: NamedSize | null, whole: number, job: DrawJob): number {
  if (size === null) return whole;
  const stack = new Float64Array(SIZE_STACK_BOTTOM + size.length);
  const put = ({ param }: { readonly param: string }, { params }: DrawJob, into: Float64Array, at: number) => {
    into[at] = Number(params?.[param]);
  };
  playSize(size, job.width, job.height, put, job, stack);
  return Math.max(1, Math.round(stack[SIZE_STACK_BOTTOM] ?? whole));
}
