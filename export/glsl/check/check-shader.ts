import type {
  Declarator,
  FunctionDeclaration,
  FunctionSymbol,
  GlslType,
  Parameter,
  ParsedShader,
  StructSymbol,
  VariableDeclaration,
  VariableSymbol,
} from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { arrayType, checkDimensions, resolveType } from './check-expression.ts';
import { checkDeclarator, checkStatements, inScope } from './check-statement.ts';
import { isConstant } from './constant.ts';
import { isImageType } from './glsl-type.ts';
import { type CheckContext, createScope } from './scope.ts';

/** A shader with resolved names. */
export interface CheckedShader {
  /** In the order of the text. */
  readonly declarations: ParsedShader['declarations'];
  readonly main: FunctionDeclaration;
  readonly structs: ReadonlyMap<GlslType, StructSymbol>;
  /** Images that the text declares but the header does not; they are transparent. */
  readonly strayImages: readonly VariableSymbol[];
}

/**
 * Resolves every name of a parsed shader and its types, changing the tree in place. `given` are the variables that the host declares:
 * inputs, images and automatic uniforms. Other mistakes are left to the driver.
 *
 * @throws GlslError if the shader cannot be linked.
 */
export function checkShader(shader: ParsedShader, given: ReadonlyMap<string, VariableSymbol>): CheckedShader {
  const outermost = createScope(null);
  for (const [name, symbol] of given) outermost.variables.set(name, symbol);
  const context: CheckContext = {
    scope: createScope(outermost),
    functions: new Map(),
    structs: new Map(),
    strayImages: [],
    returnType: '',
  };
  let main: FunctionDeclaration | null = null;
  for (const declaration of shader.declarations) {
    if (declaration.kind === 'variables') {
      checkGlobals(declaration, given, context);
    } else {
      checkFunction(declaration, context);
      if (declaration.name.text === 'main' && declaration.body !== null && declaration.parameters.length === 0) main = declaration;
    }
  }
  if (main === null) throw new GlslError({ line: 1, column: 1 }, 'The shader has no "void main() { … }".');
  return { declarations: shader.declarations, main, structs: context.structs, strayImages: context.strayImages };
}

function checkFunction(declaration: FunctionDeclaration, context: CheckContext): void {
  const returnType = resolveType(declaration.returnType, context);
  for (const parameter of declaration.parameters) checkDimensions(parameter.dimensions, context);
  const parameterTypes = declaration.parameters.map((p) => arrayType(resolveType(p.type, context), p.dimensions));
  const symbol = declareFunction(declaration, returnType, parameterTypes, context);
  declaration.symbol = symbol;
  const { body } = declaration;
  if (body === null) return;
  context.returnType = returnType;
  inScope(context, false, () => {
    declaration.parameters.forEach((parameter, i) => {
      declareParameter(parameter, parameterTypes[i] ?? '', { owner: symbol, index: i }, context);
    });
    inScope(context, true, () => checkStatements(body.statements, context));
  });
  context.returnType = '';
}

/** Declares a function and returns its symbol. A prototype and its body, or two bodies of the same function, share one symbol. */
function declareFunction(
  declaration: FunctionDeclaration,
  returnType: GlslType,
  parameterTypes: readonly GlslType[],
  context: CheckContext,
): FunctionSymbol {
  const name = declaration.name.text;
  const overloads = context.functions.get(name) ?? [];
  const known = overloads.find((other) => other.parameterTypes.join() === parameterTypes.join());
  if (known !== undefined) {
    if (declaration.body !== null) known.declaration = declaration;
    return known;
  }
  const parameterOut = declaration.parameters.map((p) => p.qualifiers.some((q) => q.text === 'out' || q.text === 'inout'));
  const symbol: FunctionSymbol = { kind: 'function', name, returnType, parameterTypes, parameterOut, declaration };
  context.functions.set(name, [...overloads, symbol]);
  return symbol;
}

function declareParameter(parameter: Parameter, type: GlslType, parameterOf: VariableSymbol['parameterOf'], context: CheckContext): void {
  if (parameter.name === null) return;
  const symbol: VariableSymbol = {
    kind: 'variable',
    name: parameter.name.text,
    type,
    role: 'parameter',
    token: parameter.name,
    constant: false,
    rename: false,
    written: parameter.qualifiers.some((qualifier) => qualifier.text === 'out' || qualifier.text === 'inout'),
    declaration: null,
    parameterOf,
  };
  context.scope.variables.set(symbol.name, symbol);
  parameter.symbol = symbol;
}

function checkGlobals(declaration: VariableDeclaration, given: ReadonlyMap<string, VariableSymbol>, context: CheckContext): void {
  resolveType(declaration.type, context);
  const words = new Set(declaration.qualifiers.map((qualifier) => qualifier.text));
  for (const declarator of declaration.declarators) {
    const type = checkDeclarator(declarator, declaration.type.type, context);
    const name = declarator.name.text;
    const same = given.get(name);
    if (same !== undefined && ['uniform', 'varying', 'in', 'out'].some((word) => words.has(word))) {
      // Another declaration of a variable of the host, as some hosts require.
      declarator.symbol = same;
    } else if (words.has('out') && given.has('gl_FragColor')) {
      declarator.symbol = outputVariable(declarator, type, given, context);
    } else {
      refuse(declarator, words, type);
      if (isImageType(type)) {
        declareStrayImage(declarator, type, context);
        continue;
      }
      const role = ['varying', 'in', 'out'].some((word) => words.has(word)) ? 'varying' : 'global';
      declarator.symbol = declareGlobal(declarator, type, role, words.has('const'), context);
    }
  }
}

function declareGlobal(
  declarator: Declarator,
  type: GlslType,
  role: 'global' | 'varying' | 'image',
  isConst: boolean,
  context: CheckContext,
): VariableSymbol {
  const symbol: VariableSymbol = {
    kind: 'variable',
    name: declarator.name.text,
    type,
    role,
    token: declarator.name,
    constant: isConst && declarator.initializer !== null && isConstant(declarator.initializer),
    rename: false,
    written: false,
    declaration: declarator,
    parameterOf: null,
  };
  context.scope.variables.set(symbol.name, symbol);
  return symbol;
}

function declareStrayImage(declarator: Declarator, type: GlslType, context: CheckContext): void {
  const symbol = declareGlobal(declarator, type, 'image', false, context);
  declarator.symbol = symbol;
  if (!context.strayImages.some(({ name }) => name === symbol.name)) context.strayImages.push(symbol);
}

/** Makes a declared output, such as `out vec4 color;` of ES 3.00, another name of `gl_FragColor`. */
function outputVariable(
  declarator: Declarator,
  type: GlslType,
  given: ReadonlyMap<string, VariableSymbol>,
  context: CheckContext,
): VariableSymbol {
  const output = given.get('gl_FragColor');
  if (output === undefined || type !== 'vec4') throw new GlslError(declarator.name, 'The output of a shader must be one vec4.', 'SCR043');
  context.scope.variables.set(declarator.name.text, output);
  return output;
}

function refuse(declarator: Declarator, words: ReadonlySet<string>, type: GlslType): void {
  const name = declarator.name.text;
  if (words.has('attribute')) {
    throw new GlslError(
      declarator.name,
      `"${name}" is an attribute, and a full-screen picture has none: isf_FragNormCoord says where the corner is.`,
      'SCR043',
    );
  }
  if (/^[iu]?sampler/.test(type) && !(words.has('uniform') && isImageType(type))) {
    throw new GlslError(
      declarator.name,
      `The image "${name}" is not in the header. Add it to INPUTS as { "NAME": "${name}", "TYPE": "image" }.`,
      'SCR043',
    );
  }
}
