import type { Drawn } from './frame-ms.ts';

/** Calls that reach WebGL in one frame. */
export interface GlCalls {
  /** Draws, of shadow maps too. */
  readonly draws: number;
  /** Calls that bind something, or change how pixels are drawn, apart from programs and uniforms. */
  readonly stateChanges: number;
  /** Calls that select another program than the last one; to select none is no switch. */
  readonly programSwitches: number;
}

const DRAWS = /^draw(Arrays|Elements|RangeElements)/;
const STATES =
  /^(active|bind|blend(?!Color)|clear(Color|Depth|Stencil)$|colorMask|cullFace|depth|disable|enable|frontFace|lineWidth|polygonOffset|scissor|stencil|viewport)/;

const counts = { draws: 0, stateChanges: 0, programSwitches: 0 };

/**
 * Starts to count calls that reach WebGL, in contexts that are created later: a player intercepts the methods of its context to skip calls
 * that change nothing. Counting costs time, so pages whose frames are measured do not count.
 */
export function startCounting(): void {
  const { prototype } = WebGL2RenderingContext;
  const methods = prototype as unknown as Record<string, (...args: unknown[]) => unknown>;
  let program: unknown = null;
  const count = (name: string, [first]: readonly unknown[]): void => {
    if (DRAWS.test(name)) counts.draws++;
    else if (STATES.test(name)) counts.stateChanges++;
    else if (name === 'useProgram' && first !== null && first !== program) {
      program = first;
      counts.programSwitches++;
    }
  };
  for (const name of Object.getOwnPropertyNames(prototype)) {
    if (!(DRAWS.test(name) || STATES.test(name) || name === 'useProgram')) continue;
    const own = methods[name];
    methods[name] = function (...args) {
      count(name, args);
      return own?.apply(this, args);
    };
  }
}

/** Counts the calls of one frame, after `startCounting`. */
export function countCalls({ draw }: Drawn): GlCalls {
  // A change of state may reach WebGL in the next frame, so the counted frame follows another.
  draw(1 / 60);
  Object.assign(counts, { draws: 0, stateChanges: 0, programSwitches: 0 });
  draw(1 / 60);
  return { ...counts };
}
