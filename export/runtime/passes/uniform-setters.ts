import type { BuiltinUniform, PassOperation, PassUniform, ResourceId } from '../../program/program.ts';
import type { FrameClock } from '../clock.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import { type LiveResources, liveResource } from '../resources/resources.ts';
import type { Slots } from '../values/slots.ts';

/** Sets one uniform of the current program. `widthPx` and `heightPx` are the size of the pass. */
export type SetUniform = (state: PlayState, widthPx: number, heightPx: number) => void;

/** The value of `DATE`, valid within one call. */
const scratchDate = new Float64Array(4);

/** Creates a setter for each uniform of the operation that the linked program uses. */
export function createUniformSetters(
  gl: WebGL2RenderingContext,
  program: GlProgram,
  operation: PassOperation,
  slots: Slots,
  clock: FrameClock,
  resources: LiveResources,
): SetUniform[] {
  const setters: SetUniform[] = [];
  for (const uniform of operation.uniforms) {
    const location = program.uniform(uniform.name);
    if (!location) continue;
    const { source, type } = uniform;
    if ('slot' in source) setters.push(fromSlot(gl, location, type, slots, source.slot));
    else if ('pulses' in source) setters.push(fromPulses(gl, location, source.pulses, resources));
    else setters.push(fromBuiltin(gl, location, source.builtin, operation.passIndex, clock));
  }
  return setters;
}

/**
 * Sets a uniform from a slot. Floats are passed in an array, because JavaScript engines allocate a heap object for each fraction that is
 * passed to the browser.
 */
function fromSlot(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  type: PassUniform['type'],
  slots: Slots,
  slot: number,
): SetUniform {
  const { numbers } = slots;
  const at = slots.offset(slot);
  if (type === 'int') return () => gl.uniform1i(location, (numbers[at] ?? 0) | 0);
  if (type === 'bool') return () => gl.uniform1i(location, numbers[at] === 0 ? 0 : 1);
  const size = COMPONENTS[type];
  const values = new Float32Array(size);
  const send = sender(gl, location, values);
  return () => {
    for (let i = 0; i < size; i++) values[i] = numbers[at + i] ?? 0;
    send();
  };
}

const COMPONENTS = { float: 1, vec2: 2, vec3: 3, vec4: 4, mat4: 16 } as const;

/** The matrices of a frame without views. */
const IDENTITY = Float32Array.of(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);

function sender(gl: WebGL2RenderingContext, location: WebGLUniformLocation, values: Float32Array): () => void {
  switch (values.length) {
    case 1:
      return () => gl.uniform1fv(location, values);
    case 2:
      return () => gl.uniform2fv(location, values);
    case 3:
      return () => gl.uniform3fv(location, values);
    default:
      return () => gl.uniform4fv(location, values);
  }
}

/** Sets a boolean uniform that is true in frames with a pulse. */
function fromPulses(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  pulses: readonly ResourceId[],
  resources: LiveResources,
): SetUniform {
  const queues = pulses.map((id) => liveResource(resources, id, 'pulses').queue);
  return () => {
    let happened = 0;
    for (let i = 0; i < queues.length; i++) if ((queues[i]?.count ?? 0) > 0) happened = 1;
    gl.uniform1i(location, happened);
  };
}

function fromBuiltin(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  builtin: BuiltinUniform,
  passIndex: number,
  clock: FrameClock,
): SetUniform {
  const values = new Float32Array(BUILTIN_COMPONENTS[builtin]);
  const send = sender(gl, location, values);
  switch (builtin) {
    case 'TIME':
      return (state) => {
        values[0] = state.frame.timeS;
        send();
      };
    case 'TIMEDELTA':
      return (state) => {
        values[0] = state.frame.deltaS;
        send();
      };
    case 'DATE':
      return () => {
        clock.readDate(scratchDate);
        values.set(scratchDate);
        send();
      };
    case 'RENDERSIZE':
      return (_state, widthPx, heightPx) => {
        values[0] = widthPx;
        values[1] = heightPx;
        send();
      };
    case 'FRAMEINDEX':
      return (state) => gl.uniform1i(location, state.frame.index);
    case 'PASSINDEX':
      return () => gl.uniform1i(location, passIndex);
    case 'SCRIM_CLIP_FROM_VIEW':
      return ({ view }) => gl.uniformMatrix4fv(location, false, view?.clipFromView ?? IDENTITY);
    case 'SCRIM_WORLD_FROM_VIEW':
      return ({ view }) => gl.uniformMatrix4fv(location, false, view?.worldFromView ?? IDENTITY);
  }
}

const BUILTIN_COMPONENTS: Readonly<Record<BuiltinUniform, number>> = {
  TIME: 1,
  TIMEDELTA: 1,
  FRAMEINDEX: 1,
  DATE: 4,
  RENDERSIZE: 2,
  PASSINDEX: 1,
  SCRIM_CLIP_FROM_VIEW: 16,
  SCRIM_WORLD_FROM_VIEW: 16,
};
