import type { GlslType, StructSymbol } from '../syntax/ast.ts';
import type { Image } from './images.ts';
import type { LineWriter } from './line-writer.ts';
import type { Names } from './names.ts';
import type { ImageBinding } from './pass-images.ts';
import type { Reach } from './reach.ts';

/** What the printing functions of one pass share. */
export interface PrintContext {
  readonly writer: LineWriter;
  readonly names: Names;
  readonly reach: Reach;
  readonly passIndex: number;
  readonly images: ReadonlyMap<string, Image>;
  readonly structs: ReadonlyMap<GlslType, StructSymbol>;
  readonly loopBudget: boolean;
  readonly stage: 'vertex' | 'fragment';
  /** Names of the varyings that the vertex shader hands on to the fragment shader; any other is a variable that nobody sets. */
  readonly varyings: ReadonlySet<string>;
  /** What the place of this pixel, from (0, 0) to (1, 1), is called here. */
  readonly normCoord: string;
  /** Of the function that is being printed. */
  binding: ImageBinding;
  returnType: GlslType;
  /** Found while printing. */
  readonly found: { discards: boolean; projects: boolean; returns: boolean };
}
