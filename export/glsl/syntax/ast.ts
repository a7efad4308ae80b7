import type { Token } from './token.ts';

/**
 * A parsed shader. Nodes keep the tokens for errors and printing; `check/` sets `type` and `symbol`. Brackets are `group` nodes, so that
 * printing needs no precedence rules.
 */
export interface ParsedShader {
  readonly declarations: readonly (FunctionDeclaration | VariableDeclaration)[];
}

/** Name of a GLSL type (`vec3`, `Ray#1` for a struct, `float[]` for an array), or empty if unknown. */
export type GlslType = string;

export interface FunctionDeclaration {
  readonly kind: 'function';
  readonly returnType: TypeSpecifier;
  readonly name: Token;
  readonly parameters: readonly Parameter[];
  /** Null for a prototype. */
  readonly body: Block | null;
  symbol: FunctionSymbol | null;
}

export interface Parameter {
  /** `const`, `in`, `out`, `inout`; precision is dropped. */
  readonly qualifiers: readonly Token[];
  readonly type: TypeSpecifier;
  /** Null without a name. */
  readonly name: Token | null;
  readonly dimensions: readonly Dimension[];
  symbol: VariableSymbol | null;
}

/** Size of an array; null for `[]`. */
export type Dimension = Expression | null;

export interface TypeSpecifier {
  readonly name: Token;
  readonly dimensions: readonly Dimension[];
  /** Set if the struct is declared here: `struct Ray { … }`. */
  readonly struct: StructDeclaration | null;
  type: GlslType;
  symbol: StructSymbol | null;
}

export interface StructDeclaration {
  readonly start: Token;
  readonly name: Token | null;
  readonly members: readonly StructMember[];
  symbol: StructSymbol | null;
}

export interface StructMember {
  readonly type: TypeSpecifier;
  readonly name: Token;
  readonly dimensions: readonly Dimension[];
}

export interface VariableDeclaration {
  readonly kind: 'variables';
  readonly start: Token;
  /** `const`, `uniform`, `in`, `varying` …; precision, `invariant` and `layout` are dropped. */
  readonly qualifiers: readonly Token[];
  readonly type: TypeSpecifier;
  readonly declarators: readonly Declarator[];
}

export interface Declarator {
  readonly name: Token;
  readonly dimensions: readonly Dimension[];
  /** The `=` token, if any. */
  readonly equals: Token | null;
  readonly initializer: Expression | null;
  symbol: VariableSymbol | null;
}

export type Statement =
  | Block
  | VariableDeclaration
  | { readonly kind: 'expression'; readonly expression: Expression }
  | { readonly kind: 'empty'; readonly start: Token }
  | IfStatement
  | ForStatement
  | { readonly kind: 'while'; readonly start: Token; readonly condition: Expression | VariableDeclaration; readonly body: Statement }
  | { readonly kind: 'do'; readonly start: Token; readonly body: Statement; readonly end: Token; readonly condition: Expression }
  | { readonly kind: 'switch'; readonly start: Token; readonly value: Expression; readonly body: Block }
  /** `case value:`; `default:` has null. */
  | { readonly kind: 'case'; readonly start: Token; readonly value: Expression | null }
  | ReturnStatement
  | { readonly kind: 'jump'; readonly start: Token; readonly word: 'break' | 'continue' | 'discard' };

export interface Block {
  readonly kind: 'block';
  readonly start: Token;
  readonly statements: readonly Statement[];
  readonly end: Token;
}

export interface IfStatement {
  readonly kind: 'if';
  readonly start: Token;
  readonly condition: Expression;
  readonly then: Statement;
  readonly otherwise: { readonly start: Token; readonly statement: Statement } | null;
}

export interface ForStatement {
  readonly kind: 'for';
  readonly start: Token;
  readonly initial: VariableDeclaration | Expression | null;
  readonly condition: Expression | VariableDeclaration | null;
  readonly step: Expression | null;
  readonly body: Statement;
}

export interface ReturnStatement {
  readonly kind: 'return';
  readonly start: Token;
  readonly value: Expression | null;
}

interface ExpressionBase {
  /** The token at which errors are reported: the expression's first token or its operator. */
  readonly token: Token;
  type: GlslType;
  /** Type to which the printer converts the value; empty for none. */
  convertTo: GlslType;
  /** Height of the expression's tree, which the parser limits to protect recursive walks. */
  readonly depth: number;
}

export interface NameExpression extends ExpressionBase {
  readonly kind: 'name';
  symbol: VariableSymbol | null;
}

export interface CallExpression extends ExpressionBase {
  readonly kind: 'call';
  readonly args: readonly Expression[];
  /** The author's function or struct; null for a built-in or unknown name. */
  symbol: FunctionSymbol | StructSymbol | null;
}

export type Expression =
  | NameExpression
  | CallExpression
  | (ExpressionBase & { readonly kind: 'literal' })
  | (ExpressionBase & { readonly kind: 'group'; readonly inner: Expression; readonly close: Token })
  | (ExpressionBase & { readonly kind: 'prefix'; readonly operand: Expression })
  | (ExpressionBase & { readonly kind: 'postfix'; readonly operand: Expression })
  /** Assignments and the comma too. */
  | (ExpressionBase & { readonly kind: 'binary'; readonly left: Expression; readonly right: Expression })
  | (ExpressionBase & {
      readonly kind: 'conditional';
      readonly condition: Expression;
      readonly then: Expression;
      readonly otherwise: Expression;
    })
  | (ExpressionBase & { readonly kind: 'member'; readonly object: Expression; readonly name: Token })
  | (ExpressionBase & { readonly kind: 'index'; readonly object: Expression; readonly index: Expression })
  /** `float[3](…)`. */
  | (ExpressionBase & { readonly kind: 'array'; readonly of: TypeSpecifier; readonly args: readonly Expression[] })
  /** `values.length()`. */
  | (ExpressionBase & { readonly kind: 'length'; readonly object: Expression });

export type GlslSymbol = VariableSymbol | FunctionSymbol | StructSymbol;

export interface VariableSymbol {
  readonly kind: 'variable';
  readonly name: string;
  readonly type: GlslType;
  /** `varying`: passed from the vertex shader to the fragment shader. */
  readonly role: 'global' | 'varying' | 'local' | 'parameter' | 'input' | 'image' | 'builtin';
  readonly token: Token | null;
  /** Whether the value is known at compile time, as GLSL ES 3.00 §4.3.3 requires for `const` and global initializers. */
  constant: boolean;
  /** Whether another variable of this name is in the same scope in ES 3.00, though not in older GLSL: it is printed under a new name. */
  rename: boolean;
  /** Whether the variable is written after its declaration. */
  written: boolean;
  readonly declaration: Declarator | null;
  /** The function and index of a parameter; null for others. */
  readonly parameterOf: { readonly owner: FunctionSymbol; readonly index: number } | null;
}

export interface FunctionSymbol {
  readonly kind: 'function';
  readonly name: string;
  readonly returnType: GlslType;
  readonly parameterTypes: readonly GlslType[];
  /** Whether an argument must be a variable of exactly this type: `out` and `inout`. */
  readonly parameterOut: readonly boolean[];
  declaration: FunctionDeclaration;
}

export interface StructSymbol {
  readonly kind: 'struct';
  readonly name: string;
  readonly type: GlslType;
  readonly members: ReadonlyMap<string, GlslType>;
  readonly global: boolean;
  /** Whether a `? :` selects between two values of the struct. */
  chosen: boolean;
}
