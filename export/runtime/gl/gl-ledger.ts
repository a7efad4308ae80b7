import type { NodeRuntime } from '../../../nodes/kit/runtime.ts';
import type { GlObjects } from './gl-objects.ts';
import type { OwnedMemory, OwnedObjects } from './owned-objects.ts';
import { createTexelBytes, mipTexels } from './texel-bytes.ts';

/** Lists the GPU objects of nodes that draw themselves and of their assets, with what they take. */
export interface GlLedger extends OwnedObjects {
  /** Owners that have objects, in the order in which they got the first one. */
  owners(): readonly OwnedMemory[];
  /** Restores the functions of the context. */
  dispose(): void;
}

interface Owner {
  readonly kind: OwnedMemory['kind'];
  readonly name: string;
  isEnded: boolean;
}

interface Living {
  readonly owner: Owner;
  bytes: number;
}

type Functions = Record<string, (...args: unknown[]) => unknown>;

const KINDS = ['Buffer', 'Framebuffer', 'Program', 'Renderbuffer', 'Sampler', 'Texture', 'TransformFeedback', 'VertexArray'] as const;
const CALLS = ['update', 'draw', 'prepare', 'remember', 'reset', 'settle', 'dispose'] as const;

/**
 * Wraps the functions of a context that create, delete and allocate. Nodes that draw themselves use the context as it is, so they cannot
 * forget to report an object.
 */
export function createGlLedger(gl: WebGL2RenderingContext): GlLedger {
  const texelBytes = createTexelBytes(gl);
  const living = new Map<unknown, Living>();
  const functions = gl as unknown as Functions;
  const replaced: string[] = [];
  let owner: Owner | null = null;

  const within = <T>(next: Owner, work: () => T): T => {
    const before = owner;
    owner = next;
    try {
      return work();
    } finally {
      owner = before;
    }
  };
  const replace = (name: string, hear: (args: readonly unknown[], result: unknown) => void): void => {
    const original = functions[name]?.bind(gl);
    if (!original) throw new Error(`The context has no ${name}.`);
    // An own property shadows the method of the prototype.
    functions[name] = (...args) => {
      const result = original(...args);
      hear(args, result);
      return result;
    };
    replaced.push(name);
  };
  /** Sets the bytes of the object that is bound, if it has an owner. */
  const setBytes = (binding: GLenum, bytes: () => number): void => {
    const entry = living.size > 0 ? living.get(gl.getParameter(binding)) : undefined;
    if (entry) entry.bytes = bytes();
  };
  const textureBinding = (target: unknown): GLenum =>
    target === gl.TEXTURE_2D_ARRAY ? gl.TEXTURE_BINDING_2D_ARRAY : gl.TEXTURE_BINDING_2D;
  for (const kind of KINDS) {
    replace(`create${kind}`, (_, object) => {
      if (owner !== null && object !== null) living.set(object, { owner, bytes: 0 });
    });
    replace(`delete${kind}`, ([object]) => void living.delete(object));
  }
  replace('texStorage2D', (args) => {
    const [target, levels = 0, format = 0, widthPx = 0, heightPx = 0] = args as number[];
    setBytes(textureBinding(target), () => mipTexels(levels, widthPx, heightPx) * texelBytes(format));
  });
  replace('texStorage3D', (args) => {
    const [target, levels = 0, format = 0, widthPx = 0, heightPx = 0, layers = 0] = args as number[];
    setBytes(textureBinding(target), () => mipTexels(levels, widthPx, heightPx) * layers * texelBytes(format));
  });
  replace('texImage2D', (args) => {
    // The shorter form has an image.
    if (args.length < 9) return;
    const [target, , format = 0, widthPx = 0, heightPx = 0] = args as number[];
    setBytes(textureBinding(target), () => widthPx * heightPx * texelBytes(format));
  });
  replace('bufferData', ([target, data]) => {
    const binding = target === gl.ELEMENT_ARRAY_BUFFER ? gl.ELEMENT_ARRAY_BUFFER_BINDING : gl.ARRAY_BUFFER_BINDING;
    setBytes(binding, () => (typeof data === 'number' ? data : ((data as ArrayBufferView | null)?.byteLength ?? 0)));
  });
  return {
    followNode: (name, create) => {
      const mine: Owner = { kind: 'node', name, isEnded: false };
      const node = within(mine, create);
      // Its getters, such as `version`, stay.
      const followed = Object.create(node) as Record<string, unknown>;
      for (const call of CALLS) {
        const work = node[call]?.bind(node) as ((argument?: unknown) => unknown) | undefined;
        if (work) followed[call] = (argument?: unknown) => within(mine, () => work(argument));
      }
      followed.dispose = () => {
        within(mine, () => node.dispose());
        mine.isEnded = true;
      };
      return followed as unknown as NodeRuntime;
    },
    followAsset: (name, objects) => {
      const mine: Owner = { kind: 'asset', name, isEnded: false };
      const entries = Object.entries(objects).map(([key, value]: [string, unknown]) => {
        if (!key.startsWith('create')) return [key, value];
        return [key, (...args: unknown[]) => within(mine, () => (value as (...all: unknown[]) => unknown)(...args))];
      });
      return {
        objects: Object.fromEntries(entries) as unknown as GlObjects,
        end: () => {
          mine.isEnded = true;
        },
      };
    },
    owners: () => {
      const sums = new Map<Owner, { objects: number; bytes: number }>();
      for (const entry of living.values()) {
        const sum = sums.get(entry.owner) ?? { objects: 0, bytes: 0 };
        sum.objects++;
        sum.bytes += entry.bytes;
        sums.set(entry.owner, sum);
      }
      return [...sums].map(([{ kind, name, isEnded }, sum]) => ({ kind, name, ...sum, isLeft: isEnded }));
    },
    dispose: () => {
      for (const name of replaced) Reflect.deleteProperty(gl, name);
      living.clear();
    },
  };
}
