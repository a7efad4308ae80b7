import type { CheckedShader } from '../check/check-shader.ts';
import { classifyImageCall } from '../link/image-call.ts';
import { reachableStatements } from '../link/pass-condition.ts';
import type { Expression, Statement, VariableSymbol } from '../syntax/ast.ts';
import { walkStatement } from '../syntax/walk-tree.ts';

/** Components of a vector that hold alpha. */
const ALPHA = /^[aqw]$/;

/**
 * The image, by the author's name, whose alpha a pass outputs unchanged, as filters of colors do; null if there is none or it is unclear.
 * The pass has to read the image at the current pixel only (`imageReads`).
 *
 * @example
 * keptAlpha(checkIsf(shader).checked, 0); // 'inputImage', for gl_FragColor = vec4(1.0 - color.rgb, color.a);
 */
export function keptAlpha(shader: CheckedShader, passIndex: number): string | null {
  const color = lastColor(shader, passIndex);
  return color === null ? null : imageOfAlpha(color);
}

/**
 * Whether a pass gives each pixel an alpha of 1, as many generators do; false if it is unclear.
 *
 * @example
 * givesOpaque(checkIsf(shader).checked, 0); // true, for gl_FragColor = vec4(isf_FragNormCoord, 0.0, 1.0);
 */
export function givesOpaque(shader: CheckedShader, passIndex: number): boolean {
  const color = lastColor(shader, passIndex);
  if (color?.kind !== 'call' || color.symbol !== null || color.token.text !== 'vec4') return false;
  const alpha = color.args.at(-1);
  return color.args.length > 1 && alpha?.kind === 'literal' && Number(alpha.token.text) === 1;
}

/** The color that the last statement of a pass gives; null if the pass may end before it. */
function lastColor({ main }: CheckedShader, passIndex: number): Expression | null {
  const body = main.symbol?.declaration.body ?? null;
  const statements = body === null ? [] : reachableStatements(body.statements, passIndex);
  const last = statements.at(-1);
  return last === undefined || statements.some(mayEnd) ? null : assignedColor(last);
}

/** Whether the shader may end in a statement before it gives its color. */
function mayEnd(statement: Statement): boolean {
  let ends = false;
  walkStatement(statement, {
    statement: (inner) => {
      ends ||= inner.kind === 'return';
      return undefined;
    },
  });
  return ends;
}

/** The value of a statement `gl_FragColor = value;`, else null. */
function assignedColor(statement: Statement): Expression | null {
  if (statement.kind !== 'expression') return null;
  const { expression } = statement;
  if (expression.kind !== 'binary' || expression.token.text !== '=') return null;
  const { left, right } = expression;
  return left.kind === 'name' && left.symbol?.role === 'builtin' && left.symbol.name === 'gl_FragColor' ? right : null;
}

/** The image whose color at the current pixel has the alpha of this color. */
function imageOfAlpha(color: Expression): string | null {
  if (color.kind === 'group') return imageOfAlpha(color.inner);
  if (color.kind === 'name') return imageOfVariable(color.symbol);
  if (color.kind !== 'call') return null;
  if (color.symbol === null && color.token.text === 'vec4') {
    const alpha = color.args.at(-1);
    const isAlpha = alpha?.kind === 'member' && ALPHA.test(alpha.name.text) && alpha.object.type === 'vec4';
    return isAlpha ? imageOfAlpha(alpha.object) : null;
  }
  const read = classifyImageCall(color);
  const [image] = color.args;
  return read?.use === 'color' && image?.kind === 'name' && image.symbol?.role === 'image' ? image.token.text : null;
}

function imageOfVariable(symbol: VariableSymbol | null): string | null {
  const initializer = symbol?.role === 'local' && !symbol.written ? symbol.declaration?.initializer : null;
  // A color that another variable holds is not followed: declarations may be circular.
  return initializer?.kind === 'call' && initializer.token.text !== 'vec4' ? imageOfAlpha(initializer) : null;
}
