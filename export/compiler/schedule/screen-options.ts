import type { Presentation } from '../../program/program-presentation.ts';
import type { FlatNode } from '../flat-graph.ts';
import { startValue } from './slot-allocator.ts';

export interface ScreenOptions {
  readonly antialias: boolean;
  readonly background: Presentation['background'];
  /** Absent if it has the default value. */
  readonly around?: NonNullable<Presentation['around']>;
}

const AROUND = ['aroundHeightM', 'aroundAheadM', 'aroundDistanceM'] as const;

/** Reads the params of the output node. They are fixed before a session starts, so the program contains their values. */
export function readScreen(screen: FlatNode): ScreenOptions {
  const read = (name: string) => {
    const param = Object.hasOwn(screen.definition.params, name) ? screen.definition.params[name] : undefined;
    return param && startValue(screen, name, param);
  };
  const color = read('color');
  const [r = 0, g = 0, b = 0, a = 1] = typeof color === 'object' ? color : [];
  const [heightM = 0, aheadM = 0, distanceM = 0] = AROUND.map((name) => Number(read(name) ?? 0));
  const said = AROUND.some((name) => read(name) !== screen.definition.params[name]?.default);
  return {
    antialias: read('antialias') !== false,
    background: read('background') === 'color' ? [r, g, b, a] : 'world',
    ...(said && { around: { targetWorld: [0, heightM, 0 - aheadM], distanceM } }),
  };
}
