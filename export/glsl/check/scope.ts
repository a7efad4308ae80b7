import type { FunctionSymbol, GlslType, StructSymbol, VariableSymbol } from '../syntax/ast.ts';

/** The names of a block. `parent` is the enclosing scope. */
export interface Scope {
  readonly parent: Scope | null;
  readonly variables: Map<string, VariableSymbol>;
  readonly structs: Map<string, StructSymbol>;
  /**
   * Whether the block shares its names with the parameters or loop variables around it in ES 3.00 (§4.2.2). Older GLSL allows the block to
   * redeclare those names; the printer then renames them.
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

/** State shared by all parts of the check. */
export interface CheckContext {
  scope: Scope;
  /** Functions declared so far, because a call only sees functions above it. */
  readonly functions: Map<string, FunctionSymbol[]>;
  readonly structs: Map<GlslType, StructSymbol>;
  readonly strayImages: VariableSymbol[];
  /** Return type of the current function; empty outside of functions. */
  returnType: GlslType;
}
