import type { PassOperation, PassUniform } from '../../program/program.ts';
import type { FrameClock } from '../clock.ts';
import type { GlProgram } from '../gl/program-cache.ts';
import type { PlayState } from '../play-state.ts';
import type { Slots } from '../values/slots.ts';

/** Sets one uniform of the program in use. `widthPx` and `heightPx` are what the pass draws into. */
export type SetUniform = (state: PlayState, widthPx: number, heightPx: number) => void;

/** Filled and read within one call. */
const scratchDate = new Float64Array(4);

/** Uniforms that the driver threw out are left out here. */
export function createUniforms(
  gl: WebGL2RenderingContext,
  program: GlProgram,
  operation: PassOperation,
  slots: Slots,
  clock: FrameClock,
): SetUniform[] {
  const setters: SetUniform[] = [];
  for (const uniform of operation.uniforms) {
    const location = program.uniform(uniform.name);
    if (!location) continue;
    setters.push(
      'slot' in uniform.source
        ? fromSlot(gl, location, uniform.type, slots, uniform.source.slot)
        : fromBuiltin(gl, location, uniform.source.builtin, operation.passIndex, clock),
    );
  }
  return setters;
}

function fromSlot(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  type: PassUniform['type'],
  slots: Slots,
  slot: number,
): SetUniform {
  const { numbers } = slots;
  const at = slots.offset(slot);
  switch (type) {
    case 'float':
      return () => gl.uniform1f(location, numbers[at] ?? 0);
    case 'int':
      return () => gl.uniform1i(location, numbers[at] ?? 0);
    case 'bool':
      return () => gl.uniform1i(location, numbers[at] === 0 ? 0 : 1);
    case 'vec2':
      return () => gl.uniform2f(location, numbers[at] ?? 0, numbers[at + 1] ?? 0);
    case 'vec3':
      return () => gl.uniform3f(location, numbers[at] ?? 0, numbers[at + 1] ?? 0, numbers[at + 2] ?? 0);
    case 'vec4':
      return () => gl.uniform4f(location, numbers[at] ?? 0, numbers[at + 1] ?? 0, numbers[at + 2] ?? 0, numbers[at + 3] ?? 0);
  }
}

function fromBuiltin(
  gl: WebGL2RenderingContext,
  location: WebGLUniformLocation,
  builtin: Extract<PassUniform['source'], { builtin: unknown }>['builtin'],
  passIndex: number,
  clock: FrameClock,
): SetUniform {
  switch (builtin) {
    case 'TIME':
      return (state) => gl.uniform1f(location, state.frame.timeS);
    case 'TIMEDELTA':
      return (state) => gl.uniform1f(location, state.frame.deltaS);
    case 'FRAMEINDEX':
      return (state) => gl.uniform1i(location, state.frame.index);
    case 'DATE':
      return () => {
        clock.readDate(scratchDate);
        gl.uniform4f(location, scratchDate[0] ?? 0, scratchDate[1] ?? 0, scratchDate[2] ?? 0, scratchDate[3] ?? 0);
      };
    case 'RENDERSIZE':
      return (_state, widthPx, heightPx) => gl.uniform2f(location, widthPx, heightPx);
    case 'PASSINDEX':
      return () => gl.uniform1i(location, passIndex);
  }
}
