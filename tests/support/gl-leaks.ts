/**
 * Page code that counts living GL objects with the stacks that created them, to find leaks. Install it before the tested code gets
 * the context.
 */
export interface GlLeaks {
  /** Number of living objects by kind (`Texture`, `Framebuffer`, …). Kinds without objects are absent. */
  alive(): Readonly<Record<string, number>>;
  /** One text per place that created living objects: their number and kind, and the stack. */
  report(): readonly string[];
  /** Restores the functions of the context. */
  stop(): void;
}

const KINDS = [
  'Buffer',
  'Framebuffer',
  'Program',
  'Query',
  'Renderbuffer',
  'Sampler',
  'Shader',
  'Texture',
  'TransformFeedback',
  'VertexArray',
] as const;

type Functions = Record<string, (...args: unknown[]) => unknown>;

export function trackGl(gl: WebGL2RenderingContext): GlLeaks {
  const made = new Map<unknown, { readonly kind: string; readonly stack: string }>();
  const own = gl as unknown as Functions;
  const replaced: string[] = [];

  function replace(name: string, wrapper: (original: (...args: unknown[]) => unknown) => (...args: unknown[]) => unknown): void {
    const original = own[name];
    if (!original) throw new Error(`WebGL2RenderingContext has no ${name}.`);
    // An own property shadows the method of the prototype; deleting it restores the method.
    own[name] = wrapper(original.bind(gl));
    replaced.push(name);
  }

  function track(kind: string, create: string, remove: string): void {
    replace(create, (original) => (...args) => {
      const object = original(...args);
      if (object !== null) made.set(object, { kind, stack: callers() });
      return object;
    });
    replace(remove, (original) => (...args) => {
      made.delete(args[0]);
      return original(...args);
    });
  }

  for (const kind of KINDS) track(kind, `create${kind}`, `delete${kind}`);
  track('Sync', 'fenceSync', 'deleteSync');

  return {
    alive: () => count([...made.values()].map(({ kind }) => kind)),
    report: () =>
      Object.entries(count([...made.values()].map(({ kind, stack }) => `${kind} made at\n${stack}`))).map(
        ([place, times]) => `${times} × ${place}`,
      ),
    stop: () => {
      for (const name of replaced) delete own[name];
    },
  };
}

/** The stack without the error name and the frames of this file. */
function callers(): string {
  return (new Error().stack ?? '').split('\n').slice(3).join('\n');
}

function count(words: readonly string[]): Record<string, number> {
  const counts: Record<string, number> = {};
  for (const word of words) counts[word] = (counts[word] ?? 0) + 1;
  return counts;
}
