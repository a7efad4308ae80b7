/**
 * Page code: counts the GL objects that are alive, each with the stack that made it, so that a test can say who forgot what.
 * Install it before the code under test gets the context.
 */
export interface GlLeaks {
  /** Objects alive by kind (`Texture`, `Framebuffer` …); kinds of which there are none are left out. */
  alive(): Readonly<Record<string, number>>;
  /** One text per place that made objects still alive: how many of what, and the stack. */
  report(): readonly string[];
  /** Puts the context's own functions back. */
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
    // An own property hides the prototype's function; removing it brings that back.
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

/** Without the first line, which names the error, and the two of this file. */
function callers(): string {
  return (new Error().stack ?? '').split('\n').slice(3).join('\n');
}

function count(words: readonly string[]): Record<string, number> {
  const counts: Record<string, number> = {};
  for (const word of words) counts[word] = (counts[word] ?? 0) + 1;
  return counts;
}
