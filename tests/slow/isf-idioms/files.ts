/** A whole file as people write them, and the colour that it draws at the pixel (3, 3) of 8 by 8. */
export interface FileIdiom {
  readonly name: string;
  /** What stands before the code: the comment with the header, and whatever is around it. */
  readonly header: string;
  readonly code: string;
  readonly vertex?: string;
  readonly wanted: readonly [r: number, g: number, b: number, a: number];
  readonly frames?: number;
}

const WHITE = [255, 255, 255, 255] as const;
const GREEN = [0, 255, 0, 255] as const;

/** White where the condition holds, else red. */
function check(condition: string): string {
  return `void main() { gl_FragColor = (${condition}) ? vec4(1.0) : vec4(1.0, 0.0, 0.0, 1.0); }`;
}

function file(name: string, header: string, condition: string, more: Partial<FileIdiom> = {}): FileIdiom {
  return { name, header, code: check(condition), wanted: WHITE, ...more };
}

function inputs(name: string, list: string, condition: string): FileIdiom {
  return file(name, `/*{ "ISFVSN": "2", "INPUTS": [${list}] }*/`, condition);
}

/** Ways in which headers are laid out. */
const LAYOUTS: readonly FileIdiom[] = [
  file('no key at all', '/*{}*/', 'true'),
  file('a byte order mark', '\uFEFF/*{ "ISFVSN": "2" }*/', 'true'),
  file('line breaks of Windows', '/*{\r\n  "ISFVSN": "2",\r\n  "INPUTS": [\r\n  ]\r\n}*/\r\n', 'true'),
  file('line breaks of old Macs', '/*{\r"ISFVSN": "2"\r}*/\r', 'true'),
  file('empty lines before it', '\n\n\n/*\n{ "ISFVSN": "2" }\n*/\n', 'true'),
  file('a licence before it', '/* Copyright (c) somebody */\n// and more\n/*{ "ISFVSN": "2" }*/', 'true'),
  file('letters beyond ASCII', '/*{ "CREDIT": "Zoë Müller — 東京", "DESCRIPTION": "½ ✓" }*/', 'true'),
  file('a trailing comma everywhere', '/*{ "INPUTS": [ { "NAME": "a", "TYPE": "float", "DEFAULT": 0.5, }, ], }*/', 'a == 0.5'),
  file(
    'no comma between inputs',
    '/*{ "INPUTS": [ { "NAME": "a", "TYPE": "float" } { "NAME": "b", "TYPE": "bool", "DEFAULT": 1 } ] }*/',
    'a == 0.0 && b',
  ),
  file('comments in it', '/*{ // what it is\n "INPUTS": [ // none\n ] }*/', 'true'),
  file('tabs and line breaks in a text', '/*{ "DESCRIPTION": "one\n\ttwo", "INPUTS": [] }*/', 'true'),
  file('an escape that is none', '/*{ "CREDIT": "C:\\path\\to" }*/', 'true'),
  file('single quotes', "/*{ 'INPUTS': [ { 'NAME': 'a', 'TYPE': 'float', 'DEFAULT': 1 } ] }*/", 'a == 1.0'),
  file('keys without quotes', '/*{ INPUTS: [ { NAME: "a", TYPE: "float", DEFAULT: 1. } ] }*/', 'a == 1.0'),
  file('a key twice', '/*{ "DESCRIPTION": "a", "DESCRIPTION": "b", "INPUTS": [] }*/', 'true'),
  file('null for lists', '/*{ "INPUTS": null, "PASSES": null, "IMPORTED": null, "CATEGORIES": null }*/', 'true'),
  file('empty lists', '/*{ "INPUTS": [], "PASSES": [], "IMPORTED": [], "PERSISTENT_BUFFERS": [] }*/', 'true'),
  file('an object without pictures', '/*{ "IMPORTED": {} }*/', 'true'),
  file('unknown keys', '/*{ "TAGS": ["a"], "VSN": 1, "ISFVSN": 2.0, "MADE_WITH": { "x": [1, { "y": null }] } }*/', 'true'),
  file('a star in a text', '/*{ "DESCRIPTION": "2 * 3 ** / 4" }*/', 'true'),
];

/** Ways in which inputs are written. */
const INPUTS: readonly FileIdiom[] = [
  inputs('a bool by 1', '{ "NAME": "a", "TYPE": "bool", "DEFAULT": 1 }', 'a'),
  inputs('a bool by "0"', '{ "NAME": "a", "TYPE": "bool", "DEFAULT": "0" }', '!a'),
  inputs('a bool by 1.0', '{ "NAME": "a", "TYPE": "bool", "DEFAULT": 1.0 }', 'a == true'),
  inputs(
    'types in other capitals',
    '{ "NAME": "a", "TYPE": "Float", "DEFAULT": 1 }, { "NAME": "b", "TYPE": "POINT2D" }',
    'a == 1.0 && b.x == 0.0',
  ),
  inputs('a bool without a first value', '{ "NAME": "a", "TYPE": "bool" }', '!a'),
  inputs('a bool with a range', '{ "NAME": "a", "TYPE": "bool", "MIN": false, "MAX": true, "DEFAULT": true, "IDENTITY": 0 }', 'a'),
  inputs('a float by a text', '{ "NAME": "a", "TYPE": "float", "DEFAULT": "0.25" }', 'a == 0.25'),
  inputs('a float by a whole number', '{ "NAME": "a", "TYPE": "float", "DEFAULT": 2, "MIN": 0, "MAX": 4 }', 'a / 4 == 0.5'),
  inputs('a float with a list', '{ "NAME": "a", "TYPE": "float", "DEFAULT": [0.25] }', 'a == 0.25 || a == 0.0'),
  inputs('a float with a range the wrong way', '{ "NAME": "a", "TYPE": "float", "DEFAULT": 0.5, "MIN": 1, "MAX": 0 }', 'a == 0.5'),
  inputs('a float with an identity', '{ "NAME": "a", "TYPE": "float", "DEFAULT": 0.5, "IDENTITY": 0.0 }', 'a == 0.5'),
  inputs('a float whose first value is outside', '{ "NAME": "a", "TYPE": "float", "DEFAULT": 5, "MIN": 0, "MAX": 1 }', 'a == 1.0'),
  inputs('a colour of three numbers', '{ "NAME": "a", "TYPE": "color", "DEFAULT": [0, 1, 0] }', 'a.g == 1.0'),
  inputs('a colour of whole numbers', '{ "NAME": "a", "TYPE": "color", "DEFAULT": [0, 1, 0, 1] }', 'a == vec4(0, 1, 0, 1)'),
  inputs('a colour without a first value', '{ "NAME": "a", "TYPE": "color" }', 'a.a == 1.0'),
  inputs(
    'a colour with a range',
    '{ "NAME": "a", "TYPE": "color", "MIN": [0,0,0,0], "MAX": [1,1,1,1], "DEFAULT": [1,1,1,0.5] }',
    'a.a == 0.5',
  ),
  inputs('a point without a range', '{ "NAME": "a", "TYPE": "point2D", "DEFAULT": [0.25, 0.5] }', 'a == vec2(0.25, 0.5)'),
  inputs('a point without a first value', '{ "NAME": "a", "TYPE": "point2D", "MIN": [0, 0], "MAX": [1, 1] }', 'a == vec2(0)'),
  inputs(
    'a point with numbers for its range',
    '{ "NAME": "a", "TYPE": "point2D", "MIN": 0, "MAX": 1, "DEFAULT": [0.5, 0.5] }',
    'a.x == 0.5',
  ),
  inputs('a long', '{ "NAME": "a", "TYPE": "long", "VALUES": [0, 1, 2], "LABELS": ["x", "y", "z"], "DEFAULT": 2 }', 'a == 2'),
  inputs('a long with fewer labels', '{ "NAME": "a", "TYPE": "long", "VALUES": [3, 1, 2], "LABELS": ["x"], "DEFAULT": 2 }', 'a == 2'),
  inputs('a long with labels alone', '{ "NAME": "a", "TYPE": "long", "LABELS": ["x", "y"], "DEFAULT": 1 }', 'a == 1'),
  inputs('a long with a range', '{ "NAME": "a", "TYPE": "long", "MIN": 0, "MAX": 9, "DEFAULT": 5 }', 'a == 5'),
  inputs('a long whose first value is none of them', '{ "NAME": "a", "TYPE": "long", "VALUES": [4, 8], "DEFAULT": 0 }', 'a == 4'),
  inputs('a long by texts', '{ "NAME": "a", "TYPE": "long", "VALUES": ["0", "1"], "LABELS": ["x", "y"], "DEFAULT": "1" }', 'a == 1'),
  inputs('a long compared with a float', '{ "NAME": "a", "TYPE": "long", "VALUES": [0, 1], "DEFAULT": 1 }', 'a == 1.0 && a * 0.5 == 0.5'),
  inputs('a long in a switch', '{ "NAME": "a", "TYPE": "long", "VALUES": [0, 1], "DEFAULT": 1 }', 'mat2(1.0)[a][a] == 1.0'),
  inputs('an event', '{ "NAME": "a", "TYPE": "event" }', '!a'),
  inputs('an event with a first value', '{ "NAME": "a", "TYPE": "event", "DEFAULT": 0 }', 'a == false'),
  inputs(
    'an input called as a reserved word',
    '{ "NAME": "sample", "TYPE": "float", "DEFAULT": 1 }, { "NAME": "filter", "TYPE": "float" }',
    'sample > filter',
  ),
  inputs(
    'an input called as a built-in function',
    '{ "NAME": "mix", "TYPE": "float", "DEFAULT": 1 }, { "NAME": "scale", "TYPE": "float" }',
    'mix == 1.0',
  ),
  inputs(
    'an input called as a word of this host',
    '{ "NAME": "uv", "TYPE": "point2D", "DEFAULT": [1, 0] }, { "NAME": "color", "TYPE": "float" }',
    'uv.x == 1.0',
  ),
  inputs('an input that the code declares, too', '{ "NAME": "a", "TYPE": "float", "DEFAULT": 1 }', 'a == 1.0'),
  inputs('an input that is a parameter’s name, too', '{ "NAME": "a", "TYPE": "float", "DEFAULT": 1 }', 'twice(0.5) == 1.0 && a == 1.0'),
  inputs(
    'a sound that is not there',
    '{ "NAME": "a", "TYPE": "audio", "MAX": 16 }, { "NAME": "b", "TYPE": "audioFFT" }',
    'IMG_NORM_PIXEL(b, vec2(0.5)).r == 0.0',
  ),
  inputs('an image that is not connected', '{ "NAME": "a", "TYPE": "image" }', 'IMG_THIS_PIXEL(a).a == 0.0 && IMG_SIZE(a).x > 0.0'),
].map((idiom) => {
  const before: Readonly<Record<string, string>> = {
    'an input that the code declares, too': 'uniform float a;\n',
    'an input that is a parameter’s name, too': 'float twice(float a) { return a * 2.0; }\n',
  };
  return { ...idiom, code: (before[idiom.name] ?? '') + idiom.code };
});

const TWO = 'void main() { if (PASSINDEX == 0) gl_FragColor = vec4(0.0, 1.0, 0.0, 1.0); else gl_FragColor = IMG_THIS_PIXEL(one); }';
const LATER =
  'void main() { vec4 was = IMG_THIS_NORM_PIXEL(one); if (PASSINDEX == 0) gl_FragColor = vec4(0.0, was.g + 0.25, 0.0, 1.0); else gl_FragColor = was; }';

function passes(name: string, list: string, code = TWO, more: Partial<FileIdiom> = {}): FileIdiom {
  return { name, header: `/*{ "ISFVSN": "2", "PASSES": [${list}] }*/`, code, wanted: GREEN, ...more };
}

/** Sizes of 8 by 8: a pass that is `wide` pixels wide. */
function sized(width: string, wide: string): FileIdiom {
  const code = `void main() { if (PASSINDEX == 0) gl_FragColor = abs(RENDERSIZE.x - ${wide}) < 0.01 ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1); else gl_FragColor = IMG_THIS_PIXEL(one); }`;
  const header = `/*{ "INPUTS": [{ "NAME": "half_", "TYPE": "float", "DEFAULT": 0.5 }, { "NAME": "n", "TYPE": "long", "VALUES": [1, 3], "DEFAULT": 3 }, { "NAME": "on", "TYPE": "bool", "DEFAULT": 1 }], "PASSES": [{ "TARGET": "one", "WIDTH": ${JSON.stringify(width)} }, {}] }*/`;
  return { name: `a pass as wide as ${width}`, header, code, wanted: GREEN };
}

const PASSES: readonly FileIdiom[] = [
  passes('a pass of nothing', '{ "TARGET": "one" }, {}'),
  passes('a TARGET that is empty', '{ "TARGET": "one" }, { "TARGET": "" }'),
  passes('flags as texts', '{ "TARGET": "one", "PERSISTENT": "true", "FLOAT": "1" }, {}'),
  passes('flags as numbers', '{ "TARGET": "one", "PERSISTENT": 1, "FLOAT": 0 }, {}'),
  passes(
    'numbers of 32 bits',
    '{ "TARGET": "one", "FLOAT": true }, {}',
    'void main() { vec4 was = IMG_THIS_PIXEL(one); if (PASSINDEX == 0) gl_FragColor = vec4(100001.0, 2049.0, 0.0, 1.0); else gl_FragColor = was.rg == vec2(100001.0, 2049.0) ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1); }',
  ),
  passes('a TARGET on the last pass', '{ "TARGET": "one" }, { "TARGET": "two" }'),
  passes(
    'the last pass alone, with a TARGET',
    '{ "TARGET": "one", "PERSISTENT": true }',
    'void main() { gl_FragColor = IMG_THIS_PIXEL(one); gl_FragColor += vec4(0.0, 0.25, 0.0, 0.25); }',
    {
      frames: 4,
    },
  ),
  passes('a buffer that remembers', '{ "TARGET": "one", "PERSISTENT": true }, {}', LATER, { frames: 4 }),
  passes(
    'passes told apart by a switch',
    '{ "TARGET": "one" }, {}',
    'void main() { switch (PASSINDEX) { case 0: gl_FragColor = vec4(0, 1, 0, 1); break; default: gl_FragColor = IMG_THIS_PIXEL(one); } }',
  ),
  passes(
    'passes told apart by floats',
    '{ "TARGET": "one" }, {}',
    'void main() { if (PASSINDEX < 0.5) { gl_FragColor = vec4(0, 1, 0, 1); return; } gl_FragColor = IMG_NORM_PIXEL(one, isf_FragNormCoord); }',
  ),
  passes(
    'passes told apart by !=',
    '{ "TARGET": "one" }, {}',
    'void main() { if (PASSINDEX != 0) gl_FragColor = IMG_THIS_PIXEL(one); else gl_FragColor = vec4(0, 1, 0, 1); }',
  ),
  passes(
    'passes told apart in a function',
    '{ "TARGET": "one" }, {}',
    'vec4 draw(int n) { return n == 0 ? vec4(0, 1, 0, 1) : IMG_THIS_PIXEL(one); } void main() { gl_FragColor = draw(PASSINDEX); }',
  ),
  passes(
    'passes told apart by macros',
    '{ "TARGET": "one" }, {}',
    '#define FIRST (PASSINDEX == 0)\nvoid main() { if (FIRST) gl_FragColor = vec4(0, 1, 0, 1); else gl_FragColor = IMG_THIS_PIXEL(one); }',
  ),
  {
    name: 'buffers of version 1',
    header: '/*{ "PERSISTENT_BUFFERS": ["one"], "PASSES": [{ "TARGET": "one" }, {}] }*/',
    code: LATER.replace('isf_', 'vv_'),
    wanted: GREEN,
    frames: 4,
  },
  {
    name: 'buffers of version 1 with settings',
    header:
      '/*{ "PERSISTENT_BUFFERS": { "one": { "WIDTH": "$WIDTH/2.0", "HEIGHT": 4, "FLOAT": true } }, "PASSES": [{ "TARGET": "one" }, {}] }*/',
    code: LATER,
    wanted: GREEN,
    frames: 4,
  },
  ...(
    [
      ['$WIDTH', '8.0'],
      ['$WIDTH/2', '4.0'],
      ['$WIDTH / 2.0', '4.0'],
      ['floor($WIDTH/3.0)', '2.0'],
      ['ceil($WIDTH/3.0)', '3.0'],
      ['max($WIDTH * 0.1, 2.0)', '2.0'],
      ['min($WIDTH, $HEIGHT) - 3', '5.0'],
      ['$WIDTH * $half_', '4.0'],
      ['$n', '3.0'],
      ['$n + $on', '4.0'],
      ['pow(2.0, $n)', '8.0'],
      ['2 ^ 2', '4.0'],
      ['$half_ > 0.25 ? $WIDTH / 4 : $WIDTH', '2.0'],
      ['$on == 1 && $n >= 3 ? 5 : 6', '5.0'],
      ['(($WIDTH)) % 5', '3.0'],
      ['-(-4) + +1', '5.0'],
      ['sqrt($WIDTH * 2)', '4.0'],
      ['abs(-6)', '6.0'],
      ['round(2.6)', '3.0'],
      ['mod($WIDTH, 5.0)', '3.0'],
      ['floor(log2($WIDTH))', '3.0'],
      ['6', '6.0'],
      [' $HEIGHT ', '8.0'],
    ] as const
  ).map(([width, wide]) => sized(width, wide)),
];

const VERTICES: readonly FileIdiom[] = [
  {
    name: 'a vertex shader of version 1',
    header: '/*{}*/',
    vertex: 'varying vec2 left;\nvoid main() { vv_vertShaderInit(); left = vv_FragNormCoord - vec2(0.0); }',
    code: 'varying vec2 left;\nvoid main() { gl_FragColor = distance(left, vv_FragNormCoord) < 0.001 ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1); }',
    wanted: GREEN,
  },
  {
    name: 'varyings between #if lines',
    header: '/*{}*/',
    vertex:
      '#if __VERSION__ <= 120\nvarying vec2 n[4];\n#else\nout vec2 n[4];\n#endif\nvoid main() { isf_vertShaderInit(); for (int i = 0; i < 4; i++) n[i] = vec2(float(i) * 0.25); }',
    code: '#if __VERSION__ <= 120\nvarying vec2 n[4];\n#else\nin vec2 n[4];\n#endif\nvoid main() { gl_FragColor = vec4(0.0, n[2].x * 2.0, 0.0, 1.0); }',
    wanted: GREEN,
  },
  {
    name: 'pixels beside this one, by RENDERSIZE',
    header: '/*{ "INPUTS": [{ "NAME": "width", "TYPE": "float", "DEFAULT": 1 }] }*/',
    vertex:
      'varying vec2 left_coord; varying vec2 right_coord;\nvoid main() { isf_vertShaderInit(); vec2 d = vec2(width / RENDERSIZE.x, 0); left_coord = clamp(vec2(isf_FragNormCoord.xy - d), 0.0, 1.0); right_coord = clamp(isf_FragNormCoord + d, 0, 1); }',
    code: 'varying vec2 left_coord; varying vec2 right_coord;\nvoid main() { gl_FragColor = vec4(0.0, right_coord.x > left_coord.x ? 1 : 0, 0.0, 1); }',
    wanted: GREEN,
  },
];

export const FILES: readonly FileIdiom[] = [...LAYOUTS, ...INPUTS, ...PASSES, ...VERTICES];
