import type { Place, Token } from '../syntax/token.ts';
import type { NameKind, NameSignature, ShaderName } from './shader-name.ts';

/** A name while a text is analyzed: its declarations, uses and scope are still being collected. */
export interface Draft extends ShaderName {
  readonly declarations: Token[];
  readonly uses: Token[];
  readonly signatures: NameSignature[];
  readonly members: Map<string, Draft>;
  scope: { from: Place; to: Place } | null;
}

export interface Frame {
  readonly kind: 'file' | 'block' | 'function' | 'for' | 'struct' | 'macro';
  readonly parent: Frame | null;
  readonly names: Map<string, Draft>;
  readonly owned: Draft[];
  /** The struct whose members are declared here. */
  readonly owner: Draft | null;
  /** Whether the head of a `for` or function is closed, so that its body may begin. */
  headClosed: boolean;
}

export function frameOf(kind: Frame['kind'], parent: Frame | null, owner: Draft | null = null): Frame {
  return { kind, parent, names: new Map(), owned: [], owner, headClosed: false };
}

export function draftOf(kind: NameKind, { text }: Token, type: string, doc: string): Draft {
  return { kind, name: text, type, file: null, doc, declarations: [], uses: [], signatures: [], members: new Map(), scope: null };
}

/** Copies a name that comes from elsewhere, such as the header or a chunk, without its uses. */
export function adopted(name: ShaderName): Draft {
  const members = new Map([...name.members].map(([key, member]) => [key, adopted(member)]));
  return { ...name, declarations: [...name.declarations], uses: [], signatures: [...name.signatures], members, scope: null };
}

export function scopeFrom(token: Token): { from: Place; to: Place } {
  return { from: behind(token), to: { line: Number.POSITIVE_INFINITY, column: 1 } };
}

export function behind({ line, column, text }: Token): Place {
  return { line, column: column + text.length };
}

export function byPlace(a: Token, b: Token): number {
  return a.line - b.line || a.column - b.column;
}
