import type { FunctionSymbol, GlslType, StructSymbol, VariableSymbol } from '../syntax/ast.ts';

/** Names of one block and, through `parent`, of those around it. */
export interface Scope {
  readonly parent: Scope | null;
  readonly variables: Map<string, VariableSymbol>;
  readonly structs: Map<string, StructSymbol>;
  /**
   * A block that in ES 3.00 shares its names with the parameters or loop variables around it (§4.2.2), while older GLSL lets
   * it declare them anew: such names get a fresh one when printed.
   */
  readonly sharesWithParent: boolean;
}

export function createScope(parent: Scope | null, sharesWithParent = false): Scope {
  return { parent, variables: new Map(), structs: new Map(), sharesWithParent };
}

export function findVariable(scope: Scope | null, name: string): VariableSymbol | null {
  for (let at = scope; at !== null; at = at.parent) {
    const found = at.variables.get(name);
    if (found !== undefined) return found;
  }
  return null;
}

export function findStruct(scope: Scope | null, name: string): StructSymbol | null {
  for (let at = scope; at !== null; at = at.parent) {
    const found = at.structs.get(name);
    if (found !== undefined) return found;
  }
  return null;
}

/** What all parts of the check share. */
export interface CheckContext {
  scope: Scope;
  /** Declared so far: a call sees only what stands above it, as in GLSL. */
  readonly functions: Map<string, FunctionSymbol[]>;
  readonly structs: Map<GlslType, StructSymbol>;
  readonly strayImages: VariableSymbol[];
  /** Type that `return` gives; empty outside of functions. */
  returnType: GlslType;
}
