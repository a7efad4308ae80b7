import type { GlslType, StructSymbol } from '../syntax/ast.ts';
import type { Image } from './images.ts';
import type { LineWriter } from './line-writer.ts';
import type { Names } from './names.ts';
import type { ImageBinding } from './pass-images.ts';
import type { Reach } from './reach.ts';

/** State shared by the printing functions of one pass. */
export interface PrintContext {
  readonly writer: LineWriter;
  readonly names: Names;
  readonly reach: Reach;
  readonly passIndex: number;
  readonly images: ReadonlyMap<string, Image>;
  readonly structs: ReadonlyMap<GlslType, StructSymbol>;
  readonly loopBudget: boolean;
  readonly stage: 'vertex' | 'fragment';
  /** Varyings that the vertex shader passes to the fragment shader; others are variables that nothing sets. */
  readonly varyings: ReadonlySet<string>;
  /** Name of the position of this pixel, from (0, 0) to (1, 1). */
  readonly normCoord: string;
  /** Binding of the function that is being printed. */
  binding: ImageBinding;
  returnType: GlslType;
  /** Set while printing. */
  readonly found: { discards: boolean; projects: boolean; returns: boolean };
}
