/**
 * Code that remembers which state it has set in a context, and sets it only when it changes, as three.js does. Other code changes the state
 * too; without the methods here, the owner would have to set all state again before each of its draws.
 */
export interface StateOwner {
  /**
   * Restores the state that the owner left, except the program.
   *
   * @returns Whether another program is selected than the owner left.
   */
  enter(): boolean;
  /** From now on, changes are those of other code, and `enter` reverts them. */
  leave(): void;
  /** Restores the methods of the context after the last owner. */
  release(): void;
}

type Call = (...args: unknown[]) => unknown;
type Values = [unknown, unknown, unknown, unknown];

/** A part of the state, such as the viewport. Each call that sets it replaces all of its values; `undefined` means unknown. */
interface Part {
  readonly apply: Call;
  /** What was set last. */
  readonly wanted: Values;
  /** What WebGL has. */
  readonly actual: Values;
  isPending: boolean;
  /** A capability without which draws do not depend on the part; absent if they always do. */
  needs?: Part;
}

/** What an owner left in a part. */
interface Left {
  readonly part: Part;
  readonly values: Values;
  /** Whether other code has changed the part since. */
  isChanged: boolean;
}

/** What an owner left, by part, and the changed parts among them: the first `count` of `changed`. */
interface Leftovers {
  readonly all: Map<Part, Left>;
  readonly changed: Left[];
  count: number;
}

/** Methods that set one part of the state each. */
export const PLAIN = [
  'bindVertexArray',
  'blendColor',
  'clearColor',
  'clearDepth',
  'clearStencil',
  'colorMask',
  'cullFace',
  'depthFunc',
  'depthMask',
  'depthRange',
  'frontFace',
  'lineWidth',
  'polygonOffset',
  'sampleCoverage',
  'scissor',
  'stencilFunc',
  'stencilMask',
  'stencilOp',
  'viewport',
] as const;

/** Methods that set one part per first argument. */
const KEYED = ['bindSampler', 'pixelStorei'] as const;

/** Methods that draw, which do not depend on the active texture unit. All have at most five arguments. */
const DRAWS = ['clear', 'clearBufferfv', 'drawArrays', 'drawArraysInstanced', 'drawElements', 'drawElementsInstanced'] as const;

/** Methods that do not depend on this state. */
const INDEPENDENT = /^(attach|compile|create|get(Active|Attrib|Error|Ext|Program|Shader|Uniform)|isContext|link|make|shader|uniform)/;

type AddOwner = () => StateOwner;

const interceptions = new WeakMap<WebGL2RenderingContext, AddOwner>();

/**
 * Adds an owner to a context. While a context has owners, its methods skip calls that change nothing: state that calls set reaches WebGL
 * before the next draw or other call that depends on it. State set past these methods, by those of the prototype, is not noticed; WebXR
 * and other parts of the browser do not change the state of a context.
 */
export function shareState(gl: WebGL2RenderingContext): StateOwner {
  const add = interceptions.get(gl) ?? intercept(gl);
  interceptions.set(gl, add);
  return add();
}

function intercept(gl: WebGL2RenderingContext): AddOwner {
  const methods = gl as unknown as Record<string, Call>;
  const replaced = new Map<string, { readonly before: PropertyDescriptor | undefined; readonly wrapper: Call }>();
  const owners: Leftovers[] = [];
  const parts: Part[] = [];
  /** The first `pendingCount` parts differ from WebGL. The array keeps its length, because an array that grows again allocates. */
  const pending: Part[] = [];
  let pendingCount = 0;
  let current: Leftovers | null = null;
  let program: unknown;

  const nativeOf = (name: string): Call => (methods[name] as Call).bind(gl);
  const replace = (name: string, wrapper: Call): void => {
    replaced.set(name, { before: Object.getOwnPropertyDescriptor(gl, name), wrapper });
    Object.defineProperty(gl, name, { configurable: true, writable: true, value: wrapper });
  };
  const createPart = (apply: Call): Part => {
    const part: Part = { apply, wanted: unknown(), actual: unknown(), isPending: false };
    parts.push(part);
    return part;
  };
  /** Returns the part of a key, such as a capability; creates it at its first use. */
  const createParts = (applyOf: (key: unknown) => Call): ((key: unknown) => Part) => {
    const known = new Map<unknown, Part>();
    // A function of its own, because a closure would allocate in each call.
    const add = (key: unknown): Part => {
      const part = createPart(applyOf(key));
      known.set(key, part);
      return part;
    };
    return (key) => known.get(key) ?? add(key);
  };
  // Draws do not depend on the active texture unit, so it is never among the pending parts.
  const unit = createPart(nativeOf('activeTexture'));
  unit.isPending = true;
  /** Remembers what the owners left in a part that other code changes now. */
  const keep = (part: Part): void => {
    for (let i = 0; i < owners.length; i++) {
      const owner = owners[i];
      if (!owner || owner === current) continue;
      const left = owner.all.get(part) ?? { part, values: unknown(), isChanged: false };
      if (left.isChanged) continue;
      owner.all.set(part, left);
      copy(part.wanted, left.values);
      left.isChanged = true;
      owner.changed[owner.count++] = left;
    }
  };
  const want = (part: Part): void => {
    if (part.isPending) return;
    part.isPending = true;
    pending[pendingCount++] = part;
  };
  const set = (part: Part, a: unknown, b?: unknown, c?: unknown, d?: unknown): void => {
    const { wanted } = part;
    if (wanted[0] === a && wanted[1] === b && wanted[2] === c && wanted[3] === d) return;
    keep(part);
    wanted[0] = a;
    wanted[1] = b;
    wanted[2] = c;
    wanted[3] = d;
    want(part);
  };
  const apply = (part: Part): void => {
    const { wanted, actual } = part;
    if (wanted[0] === undefined || isEqual(wanted, actual)) return;
    copy(wanted, actual);
    part.apply(wanted[0], wanted[1], wanted[2], wanted[3]);
  };
  /** Sets the pending parts in WebGL: all, or those that draws depend on now. */
  const flush = (all: boolean): void => {
    let count = 0;
    for (let i = 0; i < pendingCount; i++) {
      const part = pending[i] as Part;
      if (!all && part.needs?.wanted[0] === false) {
        pending[count++] = part;
        continue;
      }
      part.isPending = false;
      apply(part);
    }
    pendingCount = count;
    if (all) apply(unit);
  };
  const [enable, disable] = [nativeOf('enable'), nativeOf('disable')];
  const capabilityOf = createParts((capability) => (isOn) => (isOn ? enable(capability) : disable(capability)));
  replace('enable', (capability) => set(capabilityOf(capability), true));
  replace('disable', (capability) => set(capabilityOf(capability), false));
  for (const name of PLAIN) {
    const part = createPart(nativeOf(name));
    if (name === 'scissor') part.needs = capabilityOf(gl.SCISSOR_TEST);
    replace(name, (a, b, c, d) => set(part, a, b, c, d));
    const separate = `${name}Separate`;
    if (!(separate in gl)) continue;
    const setSeparately = nativeOf(separate);
    replace(separate, (face, a, b, c) => {
      if (face === gl.FRONT_AND_BACK) return set(part, a, b, c);
      // The two faces may differ now.
      keep(part);
      apply(part);
      setSeparately(face, a, b, c);
      part.wanted.fill(undefined);
      part.actual.fill(undefined);
    });
  }
  for (const name of KEYED) {
    const native = nativeOf(name);
    const partOf = createParts((key) => (value) => native(key, value));
    replace(name, (key, value) => set(partOf(key), value));
  }
  const equation = createPart(nativeOf('blendEquationSeparate'));
  replace('blendEquation', (mode) => set(equation, mode, mode));
  replace('blendEquationSeparate', (color, alpha) => set(equation, color, alpha));
  const factors = createPart(nativeOf('blendFuncSeparate'));
  replace('blendFunc', (source, target) => set(factors, source, target, source, target));
  replace('blendFuncSeparate', (source, target, sourceAlpha, targetAlpha) => set(factors, source, target, sourceAlpha, targetAlpha));

  replace('activeTexture', (active) => set(unit, active));
  const bindTexture = nativeOf('bindTexture');
  const textures = new Map<unknown, (active: unknown) => Part>();
  const addTarget = (target: unknown): ((active: unknown) => Part) => {
    const partOf = createParts((active) => (texture) => {
      if (unit.actual[0] !== active) unit.apply(active);
      unit.actual[0] = active;
      bindTexture(target, texture);
    });
    textures.set(target, partOf);
    return partOf;
  };
  replace('bindTexture', (target, texture) => {
    const partOf = textures.get(target) ?? addTarget(target);
    set(partOf(unit.wanted[0] ?? gl.getParameter(gl.ACTIVE_TEXTURE)), texture);
  });

  // Framebuffers are bound at once, because methods of extensions depend on it.
  const bindFramebuffer = nativeOf('bindFramebuffer');
  const framebuffers = createPart((drawn, read) => {
    if (drawn === read) return bindFramebuffer(gl.FRAMEBUFFER, drawn);
    bindFramebuffer(gl.DRAW_FRAMEBUFFER, drawn);
    return bindFramebuffer(gl.READ_FRAMEBUFFER, read);
  });
  replace('bindFramebuffer', (target, framebuffer) => {
    const drawn = framebuffers.wanted[0];
    const read = framebuffers.wanted[1];
    if (drawn === undefined && target !== gl.FRAMEBUFFER) {
      bindFramebuffer(target, framebuffer);
      return;
    }
    set(framebuffers, target === gl.READ_FRAMEBUFFER ? drawn : framebuffer, target === gl.DRAW_FRAMEBUFFER ? read : framebuffer);
    apply(framebuffers);
  });
  const select = nativeOf('useProgram');
  replace('useProgram', (next) => {
    // Nothing can be drawn without a program, so to select none changes nothing.
    if (next === null || next === program) return;
    program = next;
    select(next);
  });

  for (const name of ['deleteFramebuffer', 'deleteSampler', 'deleteTexture', 'deleteVertexArray']) {
    const native = nativeOf(name);
    replace(name, (object) => {
      native(object);
      if (object === null || object === undefined) return;
      // WebGL unbinds what is deleted.
      for (const { wanted, actual } of parts) for (const values of [wanted, actual]) unbind(values, object);
      for (const owner of owners) for (const { values } of owner.all.values()) unbind(values, object);
    });
  }
  for (const name of DRAWS) {
    const native = nativeOf(name);
    replace(name, (a, b, c, d, e) => {
      flush(false);
      native(a, b, c, d, e);
    });
  }
  for (const name in gl) {
    if (replaced.has(name) || INDEPENDENT.test(name) || typeof methods[name] !== 'function') continue;
    const native = methods[name] as Call;
    replace(name, (...args) => {
      flush(true);
      return native.apply(gl, args);
    });
  }

  const restore = (): void => {
    flush(true);
    interceptions.delete(gl);
    for (const [name, { before, wrapper }] of replaced) {
      // Wrappers that others have put around these stay, and these with them.
      if (methods[name] !== wrapper) continue;
      if (before) Object.defineProperty(gl, name, before);
      else Reflect.deleteProperty(gl, name);
    }
  };
  return () => {
    const owner: Leftovers = { all: new Map(), changed: [], count: 0 };
    owners.push(owner);
    let outer: Leftovers | null = null;
    let leftProgram: unknown;
    return {
      enter: () => {
        outer = current;
        current = owner;
        const { changed } = owner;
        for (let i = 0; i < owner.count; i++) {
          const left = changed[i] as Left;
          const { part, values } = left;
          left.isChanged = false;
          if (values[0] !== undefined) set(part, values[0], values[1], values[2], values[3]);
        }
        owner.count = 0;
        return program !== leftProgram;
      },
      leave: () => {
        current = outer;
        leftProgram = program;
      },
      release: () => {
        owners.splice(owners.indexOf(owner), 1);
        if (owners.length === 0) restore();
      },
    };
  };
}

function unknown(): Values {
  return [undefined, undefined, undefined, undefined];
}

function copy(from: Values, to: Values): void {
  for (let i = 0; i < 4; i++) to[i] = from[i];
}

function isEqual(one: Values, other: Values): boolean {
  return one[0] === other[0] && one[1] === other[1] && one[2] === other[2] && one[3] === other[3];
}

function unbind(values: Values, object: unknown): void {
  for (let i = 0; i < 4; i++) if (values[i] === object) values[i] = null;
}
