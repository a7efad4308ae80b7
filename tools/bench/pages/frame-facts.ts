import type { Drawn } from './frame-ms.ts';

/** What a frame draws, counted where it reaches WebGL. */
export interface FrameFacts {
  /** Draw calls. In a page without objects, these are the full-screen passes. */
  readonly draws: number;
  /** Framebuffers that are drawn to, without the screen. */
  readonly targets: number;
}

const DRAWS = ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'] as const;

/** Counts draws and targets of one frame. Not for pages whose frames are measured at the same time. */
export function countFrame({ gl, draw }: Drawn): FrameFacts {
  const targets = new Set<WebGLFramebuffer>();
  let draws = 0;
  const context = gl as unknown as Record<string, (...args: unknown[]) => unknown>;
  const own = DRAWS.map((name) => [name, context[name]] as const);
  for (const [name, call] of own) {
    if (call === undefined) continue;
    context[name] = (...args) => {
      const target = gl.getParameter(gl.FRAMEBUFFER_BINDING) as WebGLFramebuffer | null;
      if (target !== null) targets.add(target);
      draws++;
      return call.apply(gl, args);
    };
  }
  draw(1 / 60);
  for (const [name, call] of own) if (call !== undefined) context[name] = call;
  return { draws, targets: targets.size };
}
