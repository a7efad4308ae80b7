import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { driverDiagnostics, uniqueDiagnostics } from '../../export/glsl/driver/driver-diagnostics.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import { countsAbove, linkAbove } from '../../export/glsl/link/link-above.ts';
import { linkIsf } from '../../export/glsl/link/link-isf.ts';
import { lex } from '../../export/glsl/syntax/lexer.ts';
import type { Token } from '../../export/glsl/syntax/token.ts';
import type { LinkedShader } from '../../export/program/program.ts';
import { createRandom } from '../../export/runtime/random.ts';
import type { Diagnostic } from '../../nodes/kit/diagnostics.ts';
import { PAGE } from '../browser/glsl-kit.ts';
import { openModule, type PageModule, useBrowser } from '../support/browser.ts';

const chromium = useBrowser();
let page: PageModule;
beforeAll(async () => {
  page = await openModule(chromium.browser, PAGE);
});
afterAll(() => page.close());

const HEADER = '/*{ "ISFVSN": "2", "INPUTS": [ { "NAME": "amount", "TYPE": "float" } ] }*/\n';

/** GLSL that is right both below an ISF header and as GLSL ES 3.00. */
const SHADER = `
struct Ray {
  vec3 origin;
  vec3 direction;
};

const int STEPS = 48;
const float FAR = 20.0;
vec3 light = vec3(0.5, 0.8, -0.3);

float hash(vec2 p) {
  return fract(sin(dot(p, vec2(127.1, 311.7))) * 43758.5453);
}

float noise(vec2 p) {
  vec2 cell = floor(p);
  vec2 f = fract(p);
  vec2 u = f * f * (3.0 - 2.0 * f);
  float bottom = mix(hash(cell), hash(cell + vec2(1.0, 0.0)), u.x);
  float top = mix(hash(cell + vec2(0.0, 1.0)), hash(cell + vec2(1.0)), u.x);
  return mix(bottom, top, u.y);
}

mat2 turn(float angle) {
  float c = cos(angle);
  float s = sin(angle);
  return mat2(c, -s, s, c);
}

float scene(vec3 p) {
  p.xz = turn(0.7 * amount) * p.xz;
  float ball = length(p) - 1.0;
  float floorHeight = p.y + 1.0 + 0.1 * noise(p.xz * 4.0);
  return min(ball, floorHeight);
}

vec3 normalAt(vec3 p) {
  vec2 e = vec2(0.001, 0.0);
  return normalize(vec3(
    scene(p + e.xyy) - scene(p - e.xyy),
    scene(p + e.yxy) - scene(p - e.yxy),
    scene(p + e.yyx) - scene(p - e.yyx)
  ));
}

bool march(Ray ray, out float travelled) {
  travelled = 0.0;
  for (int i = 0; i < STEPS; i++) {
    float d = scene(ray.origin + ray.direction * travelled);
    if (d < 0.001) return true;
    travelled += d;
    if (travelled > FAR) {
      break;
    }
  }
  return false;
}

vec4 shade(Ray ray) {
  float t;
  if (!march(ray, t)) {
    return vec4(0.2, 0.3, 0.5, 1.0);
  }
  vec3 p = ray.origin + ray.direction * t;
  vec3 n = normalAt(p);
  float weights[3];
  weights[0] = 0.2;
  weights[1] = max(dot(n, normalize(light)), 0.0);
  weights[2] = pow(weights[1], 16.0);
  float sum = 0.0;
  for (int i = 0; i < 3; i++) sum += weights[i];
  vec3 color = vec3(0.9, 0.5, 0.2) * sum;
  color = t > 10.0 ? mix(color, vec3(0.5), 0.5) : color;
  return vec4(color, 1.0);
}

void main() {
  vec2 uv = isf_FragNormCoord * 2.0 - 1.0;
  uv.x *= RENDERSIZE.x / RENDERSIZE.y;
  Ray ray = Ray(vec3(0.0, 0.0, -3.0), normalize(vec3(uv, 1.5)));
  vec4 color = shade(ray);
  int mode = int(amount * 3.0);
  if (mode == 1) {
    color.rgb = color.bgr;
  } else {
    color.rgb *= 1.0 - 0.2 * dot(uv, uv);
  }
  gl_FragColor = vec4(color.rgb, 1.0);
}
`;

/** One line stands before the text in both: the header, and this. */
const PLAIN_HEAD =
  '#version 300 es\nprecision highp float; uniform vec2 RENDERSIZE; uniform float amount; in vec2 isf_FragNormCoord; out vec4 resultColor;';
const PLAIN_VERTEX = '#version 300 es\nout vec2 isf_FragNormCoord; void main() { isf_FragNormCoord = vec2(0.0); gl_Position = vec4(0.0); }';

type Mutation = (tokens: readonly Token[], at: number, pick: <T>(from: readonly T[]) => T) => string | null;

const PUNCTUATION = [';', ',', '(', ')', '{', '}', '[', ']', '=', '.', '+', '*'];
const TYPES = ['float', 'vec2', 'vec3', 'vec4', 'bool', 'mat2', 'Ray'];

const MUTATIONS: Readonly<Record<'syntax' | 'semantic', readonly Mutation[]>> = {
  syntax: [
    (_, __) => '',
    (tokens, at) => `${tokens[at]?.text} ${tokens[at]?.text}`,
    (tokens, at, pick) => `${tokens[at]?.text} ${pick(PUNCTUATION)}`,
    (tokens, at, pick) => (tokens[at]?.kind === 'operator' ? pick(PUNCTUATION) : null),
    (_, __, pick) => pick(['for', 'else', 'float', '@', '1.0', 'return']),
  ],
  semantic: [
    (tokens, at) => (tokens[at]?.kind === 'word' ? `${tokens[at]?.text}X` : null),
    (tokens, at, pick) => (TYPES.includes(tokens[at]?.text ?? '') ? pick(TYPES) : null),
    (tokens, at, pick) =>
      /^[xyzwrgb]{1,4}$/.test(tokens[at]?.text ?? '') && tokens[at - 1]?.text === '.' ? pick(['x', 'xy', 'xyz', 'xyzz']) : null,
    (tokens, at) => (tokens[at]?.kind === 'float' ? 'vec2(1.0)' : null),
    (tokens, at, pick) => (tokens[at]?.kind === 'word' ? pick(['color', 'uv', 'ray', 'hash', 'mode', 'FAR', 'weights']) : null),
  ],
};

/** The shader with one token changed; the line of each other stays. */
function mutant(kind: keyof typeof MUTATIONS, random: () => number): string {
  const tokens = lex(SHADER).slice(0, -1);
  const pick = <T>(from: readonly T[]) => from[Math.floor(random() * from.length)] as T;
  for (;;) {
    const at = Math.floor(random() * tokens.length);
    const text = pick(MUTATIONS[kind])(tokens, at, pick);
    const token = tokens[at];
    if (token === undefined || text === null || text === token.text) continue;
    const lines = SHADER.split('\n');
    const line = lines[token.line - 1] ?? '';
    lines[token.line - 1] = line.slice(0, token.column - 1) + text + line.slice(token.column - 1 + token.text.length);
    return lines.join('\n');
  }
}

async function compile(shaders: readonly Pick<LinkedShader, 'vertex' | 'fragment'>[]): Promise<readonly string[]> {
  return page.call<string[]>('compile', shaders);
}

/** First line of the text that the driver refuses as it stands; null where it takes it. */
function plainLine(log: string): number | null {
  const found = /^ERROR: \d+:(\d+):/m.exec(log);
  return found === null ? null : Number(found[1]) - 1;
}

interface Told {
  readonly shaders: readonly LinkedShader[];
  read(logs: readonly string[]): Diagnostic | undefined;
}

function scrim(text: string): Told {
  const source = HEADER.trimEnd() + text;
  const shader = readIsf(source, 'mutant.fs').output;
  if (shader === null) throw new Error('The header cannot be read.');
  const options = { node: 'n', loopBudget: true };
  const { output, diagnostics } = linkIsf(shader, options);
  const above = output === null && diagnostics[0] ? linkAbove(shader, options, diagnostics[0]) : null;
  const shaders = (output ?? above?.output ?? []).map((pass) => pass.shader);
  return {
    shaders,
    read: (logs) => {
      const said = shaders
        .flatMap((one, i) => driverDiagnostics(one, logs[i] ?? '', () => source))
        .filter((one) => above === null || countsAbove(one, above.before));
      return uniqueDiagnostics([...diagnostics, ...(above?.diagnostics ?? []), ...said]).find(({ severity }) => severity === 'error');
    },
  };
}

/** Scrim points behind the last token where one is missing, drivers at the next: the end of a line is the same where only white space lies between. */
function isSame(text: string, { line = 0, column = 0 }: Diagnostic, plain: number): boolean {
  if (line === plain) return true;
  const lines = `${HEADER.trimEnd()}${text}`.split('\n');
  const between = [lines[line - 1]?.slice(column - 1) ?? '', ...lines.slice(line, plain - 1)];
  return line < plain && between.every((part) => part.trim() === '');
}

const WANTED = 120;

test.each(['syntax', 'semantic'] as const)('the first error of %s mutants is on the line where the driver has it', async (kind) => {
  const { next: random } = createRandom(7, kind);
  const misses: string[] = [];
  let counted = 0;
  let taken = 0;
  while (counted < WANTED) {
    const texts = Array.from({ length: 50 }, () => mutant(kind, random));
    const told = texts.map(scrim);
    const plainLogs = await compile(
      texts.map((text) => ({ vertex: PLAIN_VERTEX, fragment: `${PLAIN_HEAD}${text.replaceAll('gl_FragColor', 'resultColor')}` })),
    );
    const logs = await compile(told.flatMap(({ shaders }) => shaders));
    let next = 0;
    texts.forEach((text, i) => {
      const { shaders, read } = told[i] as Told;
      const first = read(logs.slice(next, next + shaders.length));
      next += shaders.length;
      const plain = plainLine(plainLogs[i] ?? '');
      if (plain === null || counted >= WANTED) return;
      // Integers in place of floats and similar faults: older GLSL has them, and Scrim converts them.
      if (first === undefined) {
        taken += 1;
        return;
      }
      counted += 1;
      if (isSame(text, first, plain)) return;
      const at = text.split('\n')[plain - 1];
      misses.push(`${first.line}:${first.column} ${first.message} / ${plain}: ${plainLogs[i]?.split('\n')[0]} / ${at}`);
    });
  }
  if (misses.length > 0) console.log([`${kind}: ${misses.length} of ${counted} elsewhere, ${taken} taken`, ...misses].join('\n'));
  expect(misses.length).toBeLessThanOrEqual(WANTED / 100);
});
