import type { CheckedShader } from '../check/check-shader.ts';
import { isImageType } from '../check/glsl-type.ts';
import { imageProperty } from '../isf/given-symbols.ts';
import type { CallExpression, Expression, FunctionSymbol, VariableSymbol } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { type Walk, walkExpression, walkStatement } from '../syntax/walk-tree.ts';
import { classifyImageCall, type ImageCall, isTableRead, usesOf } from './image-call.ts';
import type { Image, ImageUse } from './images.ts';
import type { Names } from './names.ts';
import { decideBranch, evaluate, reachableStatements } from './pass-condition.ts';
import { type ImageBinding, imageOf, needImage } from './pass-images.ts';

/**
 * A printed version of a function. Functions with image parameters are printed once for each combination of images that they are called
 * with.
 */
export interface Instance {
  readonly symbol: FunctionSymbol;
  readonly name: string;
  readonly binding: ImageBinding;
}

/** Everything of the author's text and of the host that one pass uses. */
export interface Reach {
  /** In order of first use. */
  readonly instances: ReadonlyMap<FunctionSymbol, readonly Instance[]>;
  readonly globals: ReadonlySet<VariableSymbol>;
  readonly params: ReadonlySet<string>;
  readonly builtins: ReadonlySet<string>;
  readonly images: ReadonlyMap<Image, ReadonlySet<ImageUse>>;
  readonly hasLoops: boolean;
  /** The version of a function that a call refers to. `binding` is that of the version that contains the call. */
  instanceFor(call: CallExpression, symbol: FunctionSymbol, binding: ImageBinding): Instance;
}

const NO_IMAGES: ImageBinding = new Map();

/** Maximum number of versions, because combinations of images grow exponentially. */
const MAX_VERSIONS = 64;

export interface ReachOptions {
  readonly passIndex: number;
  readonly images: ReadonlyMap<string, Image>;
  readonly names: Names;
  /** Symbols to print in addition to what `main` uses. */
  readonly also: readonly (FunctionSymbol | VariableSymbol)[];
}

/** Walks from `main` along calls, through the branches that `PASSINDEX` allows. */
export function findReach(shader: CheckedShader, options: ReachOptions): Reach {
  const { passIndex, images, names } = options;
  const instances = new Map<FunctionSymbol, Instance[]>();
  const pending: Instance[] = [];
  const pendingGlobals: VariableSymbol[] = [];
  const globals = new Set<VariableSymbol>();
  const params = new Set<string>();
  const builtins = new Set<string>();
  const used = new Map<Image, Set<ImageUse>>();
  let hasLoops = false;

  function instanceOf(symbol: FunctionSymbol, binding: ImageBinding): Instance {
    const versions = instances.get(symbol) ?? [];
    const known = versions.find((version) => sameBinding(version.binding, binding));
    if (known !== undefined) return known;
    if (versions.length >= MAX_VERSIONS) {
      throw new GlslError(symbol.declaration.name, `"${symbol.name}" is called with more than ${MAX_VERSIONS} sets of images.`, 'SCR043');
    }
    const instance = { symbol, binding, name: binding.size === 0 ? names.of(symbol) : names.fresh(symbol.name) };
    instances.set(symbol, [...versions, instance]);
    pending.push(instance);
    return instance;
  }

  function instanceFor(call: CallExpression, symbol: FunctionSymbol, binding: ImageBinding): Instance {
    const bound = new Map<VariableSymbol, Image>();
    symbol.declaration.parameters.forEach((parameter, i) => {
      if (parameter.symbol !== null && isImageType(parameter.symbol.type))
        bound.set(parameter.symbol, needImage(call.args[i], call, images, binding));
    });
    return instanceOf(symbol, bound);
  }

  function visitName(symbol: VariableSymbol): void {
    if (symbol.role === 'input') params.add(symbol.name);
    if (symbol.role === 'builtin') visitBuiltin(symbol.name);
    if ((symbol.role !== 'global' && symbol.role !== 'varying') || globals.has(symbol)) return;
    globals.add(symbol);
    pendingGlobals.push(symbol);
  }

  /** Visits initializers of variables, which may use other variables. */
  function visitGlobals(): void {
    for (let symbol = pendingGlobals.pop(); symbol !== undefined; symbol = pendingGlobals.pop()) {
      const { dimensions = [], initializer = null } = symbol.declaration ?? {};
      for (const part of [...dimensions, initializer]) if (part !== null) walkExpression(part, walkIn(NO_IMAGES));
    }
  }

  function visitBuiltin(name: string): void {
    builtins.add(name);
    const asked = imageProperty(name);
    const image = asked?.property === 'imgSize' ? images.get(asked.image) : undefined;
    if (image !== undefined) used.set(image, new Set([...(used.get(image) ?? []), 'size' as const]));
  }

  function visitCall(call: CallExpression, binding: ImageBinding): void {
    if (call.symbol?.kind === 'function') instanceFor(call, call.symbol, binding);
    const read = classifyImageCall(call);
    if (read === null) return;
    const image = needImage(call.args[0], call, images, binding);
    checkKind(call, read, image);
    const uses = used.get(image) ?? new Set();
    for (const use of usesOf(read)) uses.add(use);
    used.set(image, uses);
    if (read.use === 'color' && read.position === 'here') builtins.add('isf_FragNormCoord');
  }

  function walkIn(binding: ImageBinding): Walk {
    return {
      expression: (expression) => {
        if (expression.kind === 'name' && expression.symbol !== null) visitName(expression.symbol);
        if (expression.kind === 'call') visitCall(expression, binding);
        return takenParts(expression, passIndex, images, binding);
      },
      statement: (statement) => {
        if (statement.kind === 'for' || statement.kind === 'while' || statement.kind === 'do') hasLoops = true;
        if (statement.kind === 'block') return reachableStatements(statement.statements, passIndex);
        if (statement.kind !== 'if') return undefined;
        const branch = decideBranch(statement, passIndex);
        if (branch === undefined) return undefined;
        return branch === null ? [] : [branch];
      },
    };
  }

  if (shader.main.symbol !== null) instanceOf(shader.main.symbol, NO_IMAGES);
  for (const symbol of options.also) {
    if (symbol.kind === 'function') instanceOf(symbol, NO_IMAGES);
    else visitName(symbol);
  }
  visitGlobals();
  for (let instance = pending.pop(); instance !== undefined; instance = pending.pop()) {
    const walk = walkIn(instance.binding);
    for (const parameter of instance.symbol.declaration.parameters) {
      for (const dimension of [...parameter.dimensions, ...parameter.type.dimensions])
        if (dimension !== null) walkExpression(dimension, walk);
    }
    const { body } = instance.symbol.declaration;
    if (body !== null) walkStatement(body, walk);
    visitGlobals();
  }
  for (const declaration of shader.declarations) {
    if (declaration.kind !== 'variables') continue;
    const needed = declaration.declarators.some((declarator) => declarator.symbol !== null && globals.has(declarator.symbol));
    const members = declaration.type.struct?.members ?? [];
    const sizes = [
      ...(needed ? declaration.type.dimensions : []),
      ...members.flatMap((member) => [...member.type.dimensions, ...member.dimensions]),
    ];
    for (const size of sizes) if (size !== null) walkExpression(size, walkIn(NO_IMAGES));
    visitGlobals();
  }
  return { instances, globals, params, builtins, images: used, hasLoops, instanceFor };
}

const TABLE_READS = { curve: 'CURVE(curve, x)', gradient: 'GRADIENT(gradient, x)' } as const;

function checkKind(call: CallExpression, read: ImageCall, image: Image): void {
  const table = image.kind === 'curve' || image.kind === 'gradient' ? image.kind : null;
  if (isTableRead(read) ? table !== read.use : table !== null) {
    const [what, instead] = table === null ? [`no ${read.use}`, 'IMG_NORM_PIXEL'] : [`a ${table}`, TABLE_READS[table]];
    throw new GlslError(call.token, `"${image.name}" is ${what}: "${call.token.text}" does not read that. Use ${instead}.`, 'SCR043');
  }
  const takesDirection = read.use === 'color' && (read.position === 'direction' || read.position === 'norm');
  if (image.isCube ? !takesDirection : read.use === 'color' && read.position === 'direction') {
    const [what, instead] = image.isCube ? ['a cube', 'textureCube and a direction'] : ['no cube', 'IMG_NORM_PIXEL or IMG_PIXEL'];
    throw new GlslError(call.token, `"${image.name}" is ${what}: "${call.token.text}" does not read that. Use ${instead}.`, 'SCR043');
  }
  if (image.isRoom === (read.use === 'depth' && read.room)) return;
  const instead = image.isRoom ? 'ROOM_DEPTH' : read.use === 'depth' ? 'LAYER_DEPTH' : 'an image';
  throw new GlslError(
    call.token,
    `"${image.name}" is ${image.isRoom ? 'room depth' : 'an image'}: "${call.token.text}" does not read that. Use ${instead}.`,
  );
}

/** Parts of an expression that a pass evaluates, without images that are passed as arguments. */
function takenParts(
  expression: Expression,
  passIndex: number,
  images: ReadonlyMap<string, Image>,
  binding: ImageBinding,
): readonly Expression[] | undefined {
  if (expression.kind === 'call') return expression.args.filter((arg) => imageOf(arg, images, binding) === null);
  if (expression.kind !== 'conditional') return undefined;
  const value = evaluate(expression.condition, passIndex);
  if (value === null) return undefined;
  return [value === 0 ? expression.otherwise : expression.then];
}

function sameBinding(a: ImageBinding, b: ImageBinding): boolean {
  return a.size === b.size && [...a].every(([parameter, image]) => b.get(parameter) === image);
}
