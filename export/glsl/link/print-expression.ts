import { imageProperty } from '../isf/given-symbols.ts';
import type { CallExpression, Expression, TypeSpecifier } from '../syntax/ast.ts';
import { GlslError } from '../syntax/token.ts';
import { classifyImageCall, type ImageCall, isTableRead, positionCount } from './image-call.ts';
import { colorFunction, depthFunction, sizeUniform, tableFunction } from './images.ts';
import { evaluate } from './pass-condition.ts';
import { imageOf, needImage } from './pass-images.ts';
import type { PrintContext } from './print-context.ts';

/** Names of the host's variables in the printed text, as `prelude.ts` declares them. */
const BUILTIN_NAMES: Readonly<Record<string, string>> = {
  isf_FragCoord: 'scrim_fragCoord.xy',
  vv_FragCoord: 'scrim_fragCoord.xy',
  gl_FragCoord: 'scrim_fragCoord',
  gl_FragColor: 'scrim_fragColor',
  isf_FragColor: 'scrim_fragColor',
};

export function printExpression(expression: Expression, context: PrintContext): void {
  const { writer } = context;
  if (expression.convertTo === '') {
    printPlain(expression, context);
  } else if (expression.kind === 'literal') {
    writer.write(convertedLiteral(expression.token.text, expression.convertTo), expression.token);
  } else {
    writer.write(`${expression.convertTo}(`);
    printPlain(expression, context);
    writer.write(')');
  }
}

function printList(expressions: readonly Expression[], context: PrintContext): void {
  expressions.forEach((expression, i) => {
    if (i > 0) context.writer.write(', ');
    printExpression(expression, context);
  });
}

/** Prints `vec3`, `a_Ray` or `float[4]`; `print-declaration.ts` prints a struct that is declared there. */
export function printTypeName(type: TypeSpecifier, context: PrintContext, length: number | null = null): void {
  const name = type.symbol === null ? type.name.text : context.names.of(type.symbol);
  context.writer.write(name, type.name);
  printDimensions(type.dimensions, context, length);
}

/** Prints the sizes of an array in brackets. `length` is printed if the initializer determines the size of the array. */
export function printDimensions(dimensions: TypeSpecifier['dimensions'], context: PrintContext, length: number | null = null): void {
  for (const dimension of dimensions) {
    context.writer.write('[');
    if (dimension !== null) printExpression(dimension, context);
    else if (length !== null) context.writer.write(String(length));
    context.writer.write(']');
  }
}

function printPlain(expression: Expression, context: PrintContext): void {
  const { writer } = context;
  switch (expression.kind) {
    case 'literal':
      writer.write(expression.type === 'float' ? floatLiteral(expression.token.text) : expression.token.text, expression.token);
      return;
    case 'name':
      printName(expression, context);
      return;
    case 'group':
      writer.write('(', expression.token);
      printExpression(expression.inner, context);
      writer.write(')', expression.close);
      return;
    case 'prefix':
      printPrefix(expression, context);
      return;
    case 'postfix':
      printExpression(expression.operand, context);
      writer.write(expression.token.text, expression.token);
      return;
    case 'binary':
      printBinary(expression, context);
      return;
    case 'conditional':
      printConditional(expression, context);
      return;
    case 'member':
      printExpression(expression.object, context);
      writer.write('.');
      writer.write(context.names.member(expression.name.text), expression.name);
      return;
    case 'length':
      printExpression(expression.object, context);
      writer.write('.length()', expression.token);
      return;
    case 'index':
      printIndex(expression, context);
      return;
    case 'array':
      printTypeName(expression.of, context);
      writer.write('(');
      printList(expression.args, context);
      writer.write(')');
      return;
    case 'call':
      printCall(expression, context);
      return;
    default:
      expression satisfies never;
  }
}

const NORM_COORDS: ReadonlySet<string> = new Set(['isf_FragNormCoord', 'vv_FragNormCoord']);

function printName(expression: Extract<Expression, { kind: 'name' }>, context: PrintContext): void {
  const { symbol, token } = expression;
  if (imageOf(expression, context.images, context.binding) !== null) {
    throw new GlslError(
      token,
      `The image "${token.text}" can only be handed to IMG_… functions, to texture functions and to functions that take a sampler2D.`,
    );
  }
  if (symbol === null) context.writer.write(token.text, token);
  else if (NORM_COORDS.has(symbol.name) && symbol.role === 'builtin') context.writer.write(context.normCoord, token);
  else if (symbol.role === 'builtin') context.writer.write(builtinText(symbol.name, context), token);
  else context.writer.write(context.names.of(symbol), token);
}

function builtinText(name: string, { images }: PrintContext): string {
  const asked = imageProperty(name);
  if (asked === null) return BUILTIN_NAMES[name] ?? name;
  if (asked.property === 'flip') return 'false';
  const image = images.get(asked.image);
  return asked.property === 'imgRect' || image === undefined ? 'vec4(0.0, 0.0, 1.0, 1.0)' : sizeUniform(image);
}

/** Prints a prefix operator and its operand. A space separates two equal signs, so that `- -a` does not become `--a`. */
function printPrefix(expression: Extract<Expression, { kind: 'prefix' }>, context: PrintContext): void {
  const { operand, token } = expression;
  const apart = operand.kind === 'prefix' && operand.convertTo === '' && operand.token.text.startsWith(token.text);
  context.writer.write(apart ? `${token.text} ` : token.text, token);
  printExpression(operand, context);
}

function printBinary(expression: Extract<Expression, { kind: 'binary' }>, context: PrintContext): void {
  const operator = expression.token.text;
  printExpression(expression.left, context);
  context.writer.write(operator === ',' ? ', ' : ` ${operator} `, expression.token);
  printExpression(expression.right, context);
}

/**
 * Function that replaces `? :` of structs, one per struct: WebGL 2.0 does not allow it for structs with arrays (“Disallowed variants of
 * GLSL ES 3.00 operators”), and ANGLE does not allow it for any struct.
 */
export const CHOOSE = 'scrim_choose';

function printConditional(expression: Extract<Expression, { kind: 'conditional' }>, context: PrintContext): void {
  const value = evaluate(expression.condition, context.passIndex);
  if (value !== null) {
    context.writer.write('(');
    printExpression(value === 0 ? expression.otherwise : expression.then, context);
    context.writer.write(')');
    return;
  }
  if (context.structs.get(expression.type)?.global === true) {
    context.writer.write(`${CHOOSE}(`, expression.token);
    printList([expression.condition, expression.then, expression.otherwise], context);
    context.writer.write(')');
    return;
  }
  printExpression(expression.condition, context);
  context.writer.write(' ? ', expression.token);
  printExpression(expression.then, context);
  context.writer.write(' : ');
  printExpression(expression.otherwise, context);
}

/**
 * Prints an access by index. `gl_FragData[0]` is printed as the color of the output; other indices are rejected, because a pass has one
 * output.
 */
function printIndex(expression: Extract<Expression, { kind: 'index' }>, context: PrintContext): void {
  const { object, index } = expression;
  if (object.kind === 'name' && object.symbol?.role === 'builtin' && object.symbol.name === 'gl_FragData') {
    if (index.kind !== 'literal' || Number(index.token.text) !== 0)
      throw new GlslError(index.token, 'A pass has one output: gl_FragData[0].', 'SCR043');
    context.writer.write('scrim_fragColor', object.token);
    return;
  }
  printExpression(object, context);
  context.writer.write('[', expression.token);
  printExpression(index, context);
  context.writer.write(']');
}

function printCall(call: CallExpression, context: PrintContext): void {
  const { writer, images, binding } = context;
  const read = classifyImageCall(call);
  if (read !== null) {
    printImageCall(call, read, context);
    return;
  }
  let name = call.token.text;
  if (call.symbol?.kind === 'struct') name = context.names.of(call.symbol);
  if (call.symbol?.kind === 'function') name = context.reach.instanceFor(call, call.symbol, binding).name;
  writer.write(`${name}(`, call.token);
  printList(
    call.args.filter((arg) => call.symbol?.kind !== 'function' || imageOf(arg, images, binding) === null),
    context,
  );
  writer.write(')');
}

function printImageCall(call: CallExpression, read: ImageCall, context: PrintContext): void {
  const { writer } = context;
  const image = needImage(call.args[0], call, context.images, context.binding);
  const [, position, third] = call.args;
  if (positionCount(read) === 1 && position === undefined)
    throw new GlslError(call.token, `"${call.token.text}" needs the ${isTableRead(read) ? read.use : 'image'} and a position on it.`);
  if (read.use === 'size') {
    const isTexture = read.isStored && image.kind !== 'absent';
    const size = isTexture ? `vec2(textureSize(${image.sampler}, 0))` : sizeUniform(image);
    writer.write(read.whole ? `ivec2(${size})` : size, call.token);
    return;
  }
  const functionOf = { color: colorFunction, depth: depthFunction, curve: tableFunction, gradient: tableFunction }[read.use];
  writer.write(`${functionOf(image)}(`, call.token);
  if (position === undefined || (read.use === 'color' && read.position === 'here')) {
    writer.write(`${context.normCoord})`);
    return;
  }
  switch (read.use === 'color' ? read.position : 'norm') {
    case 'pixel':
      printWrapped('(', position, `) / ${sizeUniform(image)}`, context);
      break;
    case 'texel':
      printWrapped('(vec2(', position, `) + 0.5) / ${sizeUniform(image)}`, context);
      break;
    case 'projected':
      context.found.projects = true;
      printWrapped('scrim_project(', position, ')', context);
      break;
    case 'offset': {
      const offset = call.token.text === 'textureLodOffset' ? call.args[3] : third;
      if (offset === undefined) throw new GlslError(call.token, `"${call.token.text}" needs an offset in pixels.`);
      printWrapped('(', position, ') + vec2(', context);
      printWrapped('', offset, `) / ${sizeUniform(image)}`, context);
      break;
    }
    default:
      printExpression(position, context);
  }
  writer.write(')');
}

function printWrapped(before: string, expression: Expression, after: string, context: PrintContext): void {
  context.writer.write(before);
  printExpression(expression, context);
  context.writer.write(after);
}

/** Prints a float literal without a suffix and with a decimal point, because ES 3.00 does not allow `1f` and `1.0lf`. */
function floatLiteral(text: string): string {
  const digits = text.replace(/(?:lf|LF|[fF])$/, '');
  return /[.eE]/.test(digits) ? digits : `${digits}.0`;
}

function convertedLiteral(text: string, to: string): string {
  const isDecimal = /^(?:0|[1-9][0-9]*)$/.test(text);
  if (to === 'float') return isDecimal ? `${text}.0` : `float(${text})`;
  return to === 'uint' && isDecimal ? `${text}u` : `${to}(${text})`;
}
