import type { IsfShader } from '../isf/isf-shader.ts';
import { findInput } from '../isf/isf-shader.ts';
import type { Expression, ParsedShader, VariableDeclaration } from '../syntax/ast.ts';
import { parseShader } from '../syntax/parse.ts';
import { FROM_IMAGE, isUniform, TO_IMAGE } from './read-transition.ts';

/** Declarations before the text of a transition. */
const BEFORE = `
float ratio = RENDERSIZE.x / RENDERSIZE.y;
vec4 getFromColor(vec2 uv) { return IMG_NORM_PIXEL(${FROM_IMAGE}, uv); }
vec4 getToColor(vec2 uv) { return IMG_NORM_PIXEL(${TO_IMAGE}, uv); }`;

const AFTER = 'void main() { gl_FragColor = transition(isf_FragNormCoord); }';

/** Parses the file as a whole ISF shader. Its text keeps its lines; valid declarations surround it. */
export function parseTransition(shader: IsfShader): ParsedShader {
  const author = parseShader(shader.source).declarations.flatMap((declaration) =>
    declaration.kind === 'variables' && isUniform(declaration) ? bindUniforms(declaration, shader) : [declaration],
  );
  return { declarations: [...parseShader(BEFORE).declarations, ...author, ...parseShader(AFTER).declarations] };
}

/** Uniforms are inputs; one with a type that inputs do not have becomes a variable that is set from the input of its name. */
function bindUniforms(declaration: VariableDeclaration, shader: IsfShader): VariableDeclaration[] {
  return declaration.declarators.flatMap((declarator): VariableDeclaration[] => {
    const input = findInput(shader, declarator.name.text);
    if (input === undefined) return declarator.name.text === 'ratio' ? [] : [{ ...declaration, declarators: [declarator] }];
    const wanted = declaration.type.name.text;
    const given = { color: 'vec4', point2D: 'vec2' }[input.type as string] ?? wanted;
    if (given === wanted) return [];
    const initializer = expressionOf(`${wanted}(${declarator.name.text}${wanted === 'vec3' ? '.rgb' : ''})`);
    return [{ ...declaration, qualifiers: [], declarators: [{ ...declarator, initializer }] }];
  });
}

function expressionOf(text: string): Expression {
  const [declaration] = parseShader(`float x = ${text};`).declarations;
  const initializer = declaration?.kind === 'variables' ? declaration.declarators[0]?.initializer : null;
  if (!initializer) throw new Error(`Not an expression: ${text}`);
  return initializer;
}
