import { expect, test } from '@jest/globals';
import { createRandom } from '../random.ts';
import { PLAIN, type StateOwner, shareState } from './gl-state.ts';

type Context = WebGL2RenderingContext;
type Call = readonly [name: string, ...args: unknown[]];

const [SCISSOR_TEST, BLEND, FRONT_AND_BACK, FRAMEBUFFER, READ_FRAMEBUFFER, DRAW_FRAMEBUFFER, TEXTURE0, TEXTURE_2D, CUBE] = [
  1, 2, 3, 4, 5, 6, 100, 200, 201,
];
/** Those that set both faces of the stencil are defined apart. */
const PLAIN_METHODS = PLAIN.filter((name) => !name.startsWith('stencil'));
const NAMES = { SCISSOR_TEST, BLEND, FRONT_AND_BACK, FRAMEBUFFER, READ_FRAMEBUFFER, DRAW_FRAMEBUFFER, TEXTURE0, TEXTURE_2D };

/** A context that only remembers its state, and the state at each draw. */
function createContext(): { readonly gl: Context; readonly draws: string[]; readonly calls: Call[] } {
  const state: Record<string, unknown> = {};
  const draws: string[] = [];
  const calls: Call[] = [];
  let unit: unknown = TEXTURE0;
  const methods: Record<string, (...args: unknown[]) => void> = {};
  const define = (name: string, call: (...args: unknown[]) => void): void => {
    methods[name] = (...args) => {
      calls.push([name, ...args.filter((arg) => arg !== undefined)]);
      call(...args);
    };
  };
  const draw = (): void => {
    // The rectangle has an effect only with the scissor test.
    const { scissor, ...rest } = state;
    draws.push(JSON.stringify(state[`is on ${SCISSOR_TEST}`] ? { scissor, ...rest } : rest, Object.keys(state).sort()));
  };
  for (const name of PLAIN_METHODS) {
    define(name, (...args) => {
      state[name] = text(args);
    });
  }
  for (const name of ['stencilMask', 'stencilFunc', 'stencilOp']) {
    define(name, (...args) => {
      state[`${name} front`] = state[`${name} back`] = text(args);
    });
    define(`${name}Separate`, (face, ...args) => {
      for (const side of face === FRONT_AND_BACK ? ['front', 'back'] : [String(face)]) state[`${name} ${side}`] = text(args);
    });
  }
  define('blendEquation', (mode) => {
    state.equation = text([mode, mode]);
  });
  define('blendEquationSeparate', (...modes) => {
    state.equation = text(modes);
  });
  define('blendFunc', (source, target) => {
    state.factors = text([source, target, source, target]);
  });
  define('blendFuncSeparate', (...factors) => {
    state.factors = text(factors);
  });
  define('enable', (capability) => {
    state[`is on ${capability}`] = true;
  });
  define('disable', (capability) => {
    state[`is on ${capability}`] = false;
  });
  for (const name of ['pixelStorei', 'bindSampler']) {
    define(name, (key, value) => {
      state[`${name} ${key}`] = text([value]);
    });
  }
  define('activeTexture', (active) => {
    unit = active;
  });
  define('bindTexture', (target, texture) => {
    state[`texture ${unit} ${target}`] = text([texture]);
  });
  define('bindFramebuffer', (target, framebuffer) => {
    if (target !== READ_FRAMEBUFFER) state.drawn = text([framebuffer]);
    if (target !== DRAW_FRAMEBUFFER) state.read = text([framebuffer]);
  });
  define('useProgram', (program) => {
    state.program = text([program]);
  });
  for (const name of ['deleteTexture', 'deleteFramebuffer', 'deleteSampler', 'deleteVertexArray']) {
    define(name, (object) => {
      for (const [key, value] of Object.entries(state)) if (key !== 'program' && value === text([object])) state[key] = text([null]);
    });
  }
  for (const name of ['clear', 'clearBufferfv', 'drawArrays', 'drawArraysInstanced', 'drawElements', 'drawElementsInstanced']) {
    define(name, draw);
  }
  define('texParameteri', (target) => {
    draws.push(`parameter of ${state[`texture ${unit} ${target}`]}`);
  });
  define('uniform1i', () => {});
  return { gl: { ...NAMES, ...methods } as unknown as Context, draws, calls };
}

function text(values: readonly unknown[]): string {
  return values
    .filter((value) => value !== undefined)
    .map((value) => (value !== null && typeof value === 'object' ? (value as { name: string }).name : String(value)))
    .join(' ');
}

/** Calls that set each part of the state to one of a few values. */
function settings(next: () => number, objects: readonly object[]): Call[] {
  const number = (): number => Math.floor(next() * 3);
  const object = (): object | null => objects[Math.floor(next() * (objects.length + 1))] ?? null;
  return [
    ...PLAIN_METHODS.map((name): Call => (name === 'bindVertexArray' ? [name, object()] : [name, number(), number(), number(), number()])),
    ['stencilMask', number()],
    ['stencilFunc', number(), 0, 1],
    ['stencilOp', number(), 0, 0],
    ['blendEquation', number()],
    ['blendFuncSeparate', number(), number(), number(), number()],
    ...[SCISSOR_TEST, BLEND].map((capability): Call => [next() < 0.5 ? 'enable' : 'disable', capability]),
    ...[7, 8].map((name): Call => ['pixelStorei', name, number()]),
    ...[0, 1, 2].map((unit): Call => ['bindSampler', unit, object()]),
    ...[0, 1, 2].flatMap((unit): Call[] => [
      ['activeTexture', TEXTURE0 + unit],
      ['bindTexture', TEXTURE_2D, object()],
      ['bindTexture', CUBE, object()],
    ]),
    ['bindFramebuffer', FRAMEBUFFER, object()],
    ['useProgram', objects[0]],
  ];
}

const call = (gl: Context, [name, ...args]: Call): void => (gl as unknown as Record<string, (...all: unknown[]) => void>)[name]?.(...args);

const objectsOf = (owner: string): object[] => [0, 1].map((i) => ({ name: `${owner}${i}` }));

test('draws have the state that all calls set, in code that remembers its state and in code that does not', () => {
  const { next } = createRandom(7, 'state');
  const plain = createContext();
  const shared = createContext();
  const mine = objectsOf('mine');
  const others = objectsOf('other');
  const owner = shareState(shared.gl);
  /** What the owner remembers. A texture belongs to the active unit. */
  const remembered = new Map<string, Call>();
  let textures = 0;
  const both = (made: Call): void => {
    call(plain.gl, made);
    call(shared.gl, made);
  };
  const drawAsOwner = (changes: readonly Call[]): void => {
    if (owner.enter()) remembered.delete('useProgram');
    let unit: unknown = TEXTURE0;
    for (const made of changes) {
      const [name, first] = made;
      if (name === 'activeTexture') unit = first;
      const key = KEYED.test(name) ? `${name} ${name === 'bindTexture' ? unit : ''} ${first}`.replace(/^(en|dis)/, '') : name;
      const isKnown = text(remembered.get(key) ?? []) === text(made);
      // As three.js does: the unit is selected only for a texture that changes.
      if (name === 'activeTexture' || isKnown) continue;
      if (name === 'bindTexture') call(shared.gl, ['activeTexture', unit]);
      call(shared.gl, made);
      remembered.set(key, made);
    }
    for (const made of changes) call(plain.gl, made);
    both(['drawElements', 4, 3, 5, 0]);
    owner.leave();
  };
  let own = settings(next, mine);
  drawAsOwner(own);
  for (let round = 0; round < 1500; round++) {
    const action = next();
    if (action < 0.4) {
      if (next() < 0.5) own = settings(next, mine);
      drawAsOwner(own);
    } else if (action < 0.8) {
      const all = settings(next, others);
      const first = Math.floor(next() * all.length);
      // Other code sets some of the state, its textures at units that it selects.
      for (const made of all.slice(first, first + 6)) if (made[0] !== 'bindTexture') both(made);
      both(['activeTexture', TEXTURE0 + Math.floor(next() * 3)]);
      both(['bindTexture', TEXTURE_2D, others[0]]);
      if (next() < 0.3) both(['texParameteri', TEXTURE_2D]);
      if (next() < 0.3) both(['stencilMaskSeparate', 'front', round]);
      if (next() < 0.3) both(['bindFramebuffer', READ_FRAMEBUFFER, others[1]]);
      if (next() < 0.3) both(['bindFramebuffer', DRAW_FRAMEBUFFER, others[0]]);
      if (next() < 0.5) both(['drawArrays', 4, 0, 3]);
    } else {
      both(['deleteTexture', others[0]]);
      others[0] = { name: `other${textures++}, made later` };
    }
  }
  expect(shared.draws.length).toBeGreaterThan(600);
  expect(shared.draws).toEqual(plain.draws);
  expect(shared.calls.length).toBeLessThan(plain.calls.length * 0.6);
});

const KEYED = /^(enable|disable|pixelStorei|bindSampler|bindTexture)$/;

test('calls that change nothing, and changes that are reverted before a draw, do not reach WebGL', () => {
  const { gl, calls } = createContext();
  const owner = shareState(gl);
  const texture = { name: 'a texture' } as unknown as WebGLTexture;
  const set = (): void => {
    gl.enable(SCISSOR_TEST);
    gl.scissor(0, 0, 8, 8);
    gl.activeTexture(TEXTURE0 + 3);
    gl.bindTexture(TEXTURE_2D, texture);
    gl.bindFramebuffer(FRAMEBUFFER, null);
  };
  set();
  gl.drawArrays(4, 0, 3);
  calls.length = 0;
  gl.disable(SCISSOR_TEST);
  gl.bindTexture(TEXTURE_2D, null);
  set();
  gl.uniform1i(null, 3);
  gl.drawArrays(4, 0, 3);
  expect(calls).toEqual([
    ['uniform1i', null, 3],
    ['drawArrays', 4, 0, 3],
  ]);
  owner.release();
});

test('each owner gets back what it left, whatever another did', () => {
  const { gl, draws } = createContext();
  const owners = [shareState(gl), shareState(gl)] as const;
  const drawAs = (owner: StateOwner, change: () => void): string => {
    owner.enter();
    change();
    gl.drawArrays(4, 0, 3);
    owner.leave();
    return draws.at(-1) ?? '';
  };
  const [first, second] = owners.map((owner, i) =>
    drawAs(owner, () => {
      gl.viewport(0, 0, i, i);
      gl.bindSampler(i, null);
      gl.bindSampler(1 - i, { name: `sampler ${i}` } as unknown as WebGLSampler);
    }),
  );
  gl.viewport(0, 0, 9, 9);
  expect(drawAs(owners[1], () => {})).toBe(second);
  expect(drawAs(owners[0], () => {})).toBe(first);
});

test('what an owner never set stays as other code left it', () => {
  const { gl, draws } = createContext();
  const owner = shareState(gl);
  gl.bindSampler(0, { name: 'a sampler' } as unknown as WebGLSampler);
  gl.drawArrays(4, 0, 3);
  gl.bindSampler(0, null);
  owner.enter();
  gl.drawArrays(4, 0, 3);
  owner.leave();
  expect(draws.map((draw) => JSON.parse(draw))).toEqual([{ 'bindSampler 0': 'a sampler' }, { 'bindSampler 0': 'null' }]);
});

test('without owners the context has its own methods and the state that was set last', () => {
  const { gl, calls } = createContext();
  const { viewport } = gl;
  const owners = [shareState(gl), shareState(gl)];
  gl.viewport(0, 0, 4, 4);
  owners[0]?.release();
  expect(gl.viewport).not.toBe(viewport);
  owners[1]?.release();
  expect(gl.viewport).toBe(viewport);
  expect(calls).toEqual([['viewport', 0, 0, 4, 4]]);
});
