import { GATE_SAMPLER, LOOP_BUDGET_UNIFORM, PROBE_SIDE_PX, readProbe } from '../../../export/program/loop-budget.ts';
import type { BuiltinUniform, LinkedShader, PassUniform } from '../../../export/program/program.ts';
import { createBrowserClock } from '../../../export/runtime/clock.ts';
import { allocateTexture } from '../../../export/runtime/gl/allocate-texture.ts';
import { createGlObjects, type GlObjects } from '../../../export/runtime/gl/gl-objects.ts';
import { createLoopProbe, type LoopProbe } from '../../../export/runtime/gl/loop-probe.ts';
import { createPassDrawer, type PassDrawer } from '../../../export/runtime/gl/pass-drawer.ts';
import { createProgramCache, type GlProgram, type ShaderError } from '../../../export/runtime/gl/program-cache.ts';

const SIDE_PX = 64;

/** A linked shader and its inputs. */
export interface ShaderJob {
  readonly shader: LinkedShader;
  readonly passIndex: number;
  readonly uniforms: readonly {
    readonly name: string;
    readonly type: PassUniform['type'];
    readonly value: readonly number[] | BuiltinUniform;
  }[];
  /** Samplers by content. `number` is depth, sound or a curve, in the red channel. */
  readonly samplers: readonly { readonly name: string; readonly holds: 'color' | 'number' | 'cube' }[];
}

export interface ShaderVerdict {
  /** Errors of the driver. */
  readonly logs: readonly Pick<ShaderError, 'stage' | 'log'>[];
  /** Source line of a loop that does not end in time; null if all loops end. */
  readonly endlessLine: number | null;
}

interface Bench {
  readonly gl: WebGL2RenderingContext;
  readonly objects: GlObjects;
  readonly drawer: PassDrawer;
  readonly probe: LoopProbe;
  readonly color: WebGLTexture;
  readonly depth: WebGLTexture;
}

let bench: Bench | null = null;

/** Compiles all shaders at once, in the threads of the driver, and draws those with loops. */
export async function judge(jobs: readonly ShaderJob[]): Promise<readonly ShaderVerdict[]> {
  bench ??= createBench();
  const at = bench;
  const { gl, objects } = at;
  const programs = createProgramCache(objects);
  const clock = createBrowserClock();
  const entries = jobs.map((job) => ({ job, program: programs.acquire(job.shader) }));
  while (entries.some(({ program }) => program.state === 'linking')) {
    programs.poll();
    if (gl.isContextLost()) throw new Error('The graphics driver gave up.');
    await clock.delay(0.002);
  }
  const verdicts = entries.map(({ job, program }) => verdictOf(at, job, program));
  programs.dispose();
  return verdicts;
}

function verdictOf(of: Bench, job: ShaderJob, program: GlProgram): ShaderVerdict {
  const logs = program.errors.map(({ stage, log }) => ({ stage, log }));
  const isBounded = program.state === 'linked' && program.uniform(LOOP_BUDGET_UNIFORM) !== null;
  return { logs, endlessLine: isBounded ? probeLoops(of, job, program) : null };
}

function probeLoops({ gl, drawer, probe, color, depth }: Bench, job: ShaderJob, program: GlProgram): number | null {
  drawer.begin(probe.framebuffer, 0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX, 'replace');
  probe.clear();
  drawer.use(program);
  job.samplers.forEach(({ name, holds }, unit) => {
    const location = program.uniform(name);
    if (location && holds === 'cube') drawer.cube(unit, location, null);
    else if (location) drawer.texture(unit, location, holds === 'number' ? depth : color, holds === 'number' ? 'nearest' : 'linear');
    gl.uniformMatrix3fv(program.uniform(`${name}_uvFromViewUv`), false, [1, 0, 0, 0, 1, 0, 0, 0, 1]);
    gl.uniform2f(program.uniform(`${name}_size`), VIEW_PX[0], VIEW_PX[1]);
    gl.uniform4f(program.uniform(`${name}_decode`), 1, 0, 0, 0);
  });
  for (const { name, type, value } of job.uniforms) {
    setUniform(gl, program.uniform(name), type, typeof value === 'string' ? builtinValue(value, job.passIndex) : value);
  }
  const gate = program.uniform(GATE_SAMPLER);
  if (gate) drawer.texture(job.samplers.length, gate, null, 'nearest');
  drawer.draw();
  // The page draws nothing else, so waiting blocks nothing.
  const bytes = new Uint8Array(PROBE_SIDE_PX ** 2 * 4);
  gl.readPixels(0, 0, PROBE_SIDE_PX, PROBE_SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
  drawer.end();
  return readProbe(bytes);
}

const VIEW_PX = [1280, 720] as const;

/** Value of a built-in uniform in the middle of a session, because some shaders start only after time 0. */
function builtinValue(builtin: BuiltinUniform, passIndex: number): readonly number[] {
  switch (builtin) {
    case 'TIME':
      return [1.5];
    case 'TIMEDELTA':
      return [1 / 60];
    case 'FRAMEINDEX':
      return [90];
    case 'DATE':
      return [2024, 1, 1, 43_200];
    case 'RENDERSIZE':
      return VIEW_PX;
    case 'PASSINDEX':
      return [passIndex];
    case 'SCRIM_CLIP_FROM_VIEW':
      return [1, 0, 0, 0, 0, 16 / 9, 0, 0, 0, 0, -1, -1, 0, 0, -0.1, 0];
    case 'SCRIM_WORLD_FROM_VIEW':
      return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 1.6, 0, 1];
  }
}

function setUniform(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation | null,
  type: PassUniform['type'],
  value: readonly number[],
): void {
  const [x = 0, y = 0, z = 0, w = 0] = value;
  if (type === 'float') gl.uniform1f(location, x);
  else if (type === 'vec2') gl.uniform2f(location, x, y);
  else if (type === 'vec3') gl.uniform3f(location, x, y, z);
  else if (type === 'vec4') gl.uniform4f(location, x, y, z, w);
  else if (type === 'mat4') gl.uniformMatrix4fv(location, false, value);
  else gl.uniform1i(location, x);
}

function createBench(): Bench {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) throw new Error('The browser has no WebGL 2.');
  const objects = createGlObjects(gl);
  const drawer = createPassDrawer(objects);
  return { gl, objects, drawer, probe: createLoopProbe(objects), ...createTestImage(objects) };
}

/** Test textures for layers and depth: all colors, some transparency, 0.5 to 4.5 m. */
function createTestImage(objects: GlObjects): { readonly color: WebGLTexture; readonly depth: WebGLTexture } {
  const { gl } = objects;
  const colors = new Uint8Array(SIDE_PX ** 2 * 4);
  const meters = new Float32Array(SIDE_PX ** 2);
  for (let i = 0; i < meters.length; i++) {
    const x = i % SIDE_PX;
    const y = Math.floor(i / SIDE_PX);
    const alpha = y < SIDE_PX / 8 ? y * 32 : 255;
    colors.set([(x * 4 * alpha) / 255, (y * 4 * alpha) / 255, ((x ^ y) * 4 * alpha) / 255, alpha], i * 4);
    meters[i] = 0.5 + (x + y) / 32;
  }
  const color = allocateTexture(gl, objects.createTexture(), gl.RGBA8, gl.LINEAR, SIDE_PX, SIDE_PX);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, SIDE_PX, SIDE_PX, gl.RGBA, gl.UNSIGNED_BYTE, colors);
  const depth = allocateTexture(gl, objects.createTexture(), gl.R32F, gl.NEAREST, SIDE_PX, SIDE_PX);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, SIDE_PX, SIDE_PX, gl.RED, gl.FLOAT, meters);
  return { color, depth };
}
