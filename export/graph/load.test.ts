import { describe, expect, jest, test } from '@jest/globals';
import { loadProject } from './load.ts';
import { saveProject } from './save.ts';

const CANONICAL = `{
  "format": "scrim-project",
  "version": 1,
  "title": "Living \\"room\\"",
  "page": {
    "description": "A fox behind the sofa"
  },
  "graphs": {
    "main": {
      "nodes": {
        "fox-m3ab": {
          "type": "source/model",
          "version": 1,
          "params": {
            "model": "fox-aaaa",
            "speed": { "port": 2 }
          }
        },
        "look-x1aa": {
          "type": "graph/look",
          "version": 1,
          "muted": true
        },
        "scene-k7q2": {
          "type": "layer/scene",
          "version": 1
        }
      },
      "wires": [
        "scene-k7q2.layer -> look-x1aa.picture",
        "zebra-k7q2.objects -> scene-k7q2.objects",
        "fox-m3ab.objects -> scene-k7q2.objects"
      ]
    },
    "look": {
      "nodes": {
        "sepia-k7q2": {
          "type": "filter/sepia",
          "version": 1,
          "params": {
            "amount": {
              "track": {
                "keys": [
                  { "timeS": 0, "value": 0 },
                  { "timeS": 1.5, "value": 1, "easing": "ease-in-out" },
                  { "timeS": 2, "value": 0.5, "easing": [0.34, 1.56, 0.64, 1] }
                ],
                "repeat": "loop"
              }
            },
            "shade": {
              "expression": "sin(time)"
            },
            "tint": [1, 0.5, 0.25, 1]
          }
        }
      },
      "wires": [],
      "exposed": {
        "inputs": [
          { "name": "picture", "node": "sepia-k7q2", "port": "inputImage" }
        ],
        "outputs": [
          { "name": "layer", "node": "sepia-k7q2", "port": "layer" }
        ]
      }
    }
  },
  "assets": {
    "fox-aaaa": {
      "path": "assets/fox.glb",
      "kind": "model",
      "credit": "PixelMannen",
      "licence": "CC0"
    }
  }
}
`;

const LAYOUT = `{
  "format": "scrim-layout",
  "version": 1,
  "graphs": {
    "main": {
      "nodes": {
        "fox-m3ab": { "x": 0, "y": -40 },
        "scene-k7q2": { "x": 300, "y": 12.5, "collapsed": true }
      },
      "frames": {
        "frame-aaaa": { "x": 0, "y": 0, "width": 400, "height": 200, "title": "Fox", "color": "#ff8800" }
      },
      "notes": {
        "note-aaaa": { "x": 0, "y": 220, "width": 100, "height": 50, "text": "Two\\nlines" }
      }
    },
    "look": {
      "borders": {
        "inputs": { "x": -240, "y": 16 }
      }
    }
  }
}
`;

const SOURCES = { 'edge.fs': '/*{}*/\nvoid main() {}\n' };

function load(project: string, layout: string | null = null, sources: Record<string, string> = {}) {
  return loadProject({ project, layout, sources });
}

/** A small valid document with some keys replaced. */
function document(change: Record<string, unknown> = {}): string {
  return JSON.stringify({ format: 'scrim-project', version: 1, title: 'T', graphs: { main: { nodes: {}, wires: [] } }, ...change });
}

describe('a project in canonical form', () => {
  test('comes back byte for byte', () => {
    const { output, diagnostics } = load(CANONICAL, LAYOUT, SOURCES);
    expect(diagnostics).toEqual([]);
    if (output === null) throw new Error('not loaded');
    expect(saveProject(output)).toEqual({ project: CANONICAL, layout: LAYOUT, sources: SOURCES });
  });

  test('holds what the files say', () => {
    const project = load(CANONICAL, LAYOUT).output;
    expect(project?.graphs.main?.nodes['fox-m3ab']?.params).toEqual({ model: { value: 'fox-aaaa' }, speed: { port: 2 } });
    expect(project?.graphs.look?.nodes['sepia-k7q2']?.params.shade).toEqual({ expression: 'sin(time)' });
    expect(project?.graphs.main?.nodes['look-x1aa']?.muted).toBe(true);
    expect(project?.page).toEqual({ description: 'A fox behind the sofa', language: 'en' });
    expect(project?.layout.main?.nodes['scene-k7q2']).toEqual({ x: 300, y: 12.5, collapsed: true });
  });

  test('has its order whatever the order in the file, but for wires of one port', () => {
    const shuffled = JSON.parse(CANONICAL) as { graphs: { main: { nodes: object; wires: string[] } } };
    shuffled.graphs.main.nodes = Object.fromEntries(Object.entries(shuffled.graphs.main.nodes).reverse());
    const [toLook, first, second] = shuffled.graphs.main.wires;
    shuffled.graphs.main.wires = [first ?? '', toLook ?? '', second ?? ''];
    const { output } = load(JSON.stringify(shuffled), LAYOUT, SOURCES);
    expect(output && saveProject(output).project).toBe(CANONICAL);
  });

  test('is read with a byte order mark and Windows line ends', () => {
    const { output, diagnostics } = load(`\uFEFF${CANONICAL.replaceAll('\n', '\r\n')}`, LAYOUT);
    expect(diagnostics).toEqual([]);
    expect(output && saveProject(output).project).toBe(CANONICAL);
  });
});

describe('broken files', () => {
  test.each([
    ['a comma too much', '{\n  "format": "scrim-project",\n}', 'SCR001', 3, 1],
    ['a missing brace', '{"a": 1', 'SCR001', 1, 8],
    ['nothing', '', 'SCR001', 1, 1],
    ['a comment', '{\n  // no\n}', 'SCR001', 2, 3],
    ['NaN', document().replace('"T"', 'NaN'), 'SCR006', 1, 47],
    ['minus infinity', '{"a": -Infinity}', 'SCR006', 1, 7],
    ['a key twice', '{\n  "format": "x",\n  "format": "scrim-project"\n}', 'SCR002', 3, 3],
  ])('%s is told with its place', (_, text, code, line, column) => {
    const { output, diagnostics } = load(text);
    expect(output).toBeNull();
    expect(diagnostics).toHaveLength(1);
    expect(diagnostics[0]).toMatchObject({ code, severity: 'error', file: 'project.scrim.json', line, column });
  });

  test('an empty one is called empty, and a way out is told', () => {
    for (const text of ['', ' \n', '\uFEFF']) {
      const [found] = load(text).diagnostics;
      expect(found).toMatchObject({ message: 'project.scrim.json is empty.', fix: expect.stringContaining('backup') });
    }
  });

  test.each([
    ['a list', '[]', 'is not an object'],
    ['another format', '{"format": "x"}', '"format" must be "scrim-project"'],
    ['no version', '{"format": "scrim-project"}', 'whole number'],
    ['no main graph', document({ graphs: {} }), '“main”|"main" is missing'],
    ['an unknown key', document({ graph: {} }), 'key is unknown'],
    ['a title that is a number', document({ title: 3 }), 'must be a text'],
    ['a node id without a suffix', document({ graphs: { main: { nodes: { sepia: { type: 'a/b', version: 1 } } } } }), 'node id'],
    ['a node type without a category', document({ graphs: { main: { nodes: { 'a-b': { type: 'b', version: 1 } } } } }), 'node type'],
    ['a wire without an arrow', document({ graphs: { main: { wires: ['a-b.c d-e.f'] } } }), 'wire must be written'],
    ['a null', document({ graphs: { main: { nodes: null } } }), 'it is null'],
    [
      'two bindings',
      document({ graphs: { main: { nodes: { 'a-b': { type: 'a/b', version: 1, params: { x: { port: 1, expression: '1' } } } } } } }),
      'bound to exactly one',
    ],
  ])('%s is refused with a reason', (_, text, reason) => {
    const { output, diagnostics } = load(text);
    expect(output).toBeNull();
    expect(diagnostics[0]).toMatchObject({ code: 'SCR002', severity: 'error' });
    expect(diagnostics[0]?.message).toMatch(new RegExp(reason));
  });

  test('the place of a wrong value is that of the value, of an unknown key that of the key', () => {
    const { diagnostics } = load(
      '{\n  "format": "scrim-project", "version": 1, "titel": "x",\n  "title": 4,\n  "graphs": { "main": {} }\n}',
    );
    expect(diagnostics.map(({ line, column, message }) => [line, column, message.split(':')[0]])).toEqual([
      [2, 44, 'titel'],
      [3, 12, 'title'],
    ]);
  });

  test('a newer version is not touched', () => {
    expect(load(document({ version: 2 })).diagnostics).toMatchObject([{ code: 'SCR003', severity: 'error' }]);
  });

  test('a number beyond what JSON can hold is not finite', () => {
    const text = document({ graphs: { main: { nodes: { 'a-b': { type: 'a/b', version: 1, params: { x: [1, 0] } } } } } }).replace(
      '[1,0]',
      '[1,1e999]',
    );
    const { output, diagnostics } = load(text);
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR006', line: 1 }]);
    expect(diagnostics[0]?.message).toContain('graphs.main.nodes.a-b.params.x[1]');
  });

  test('a number beyond 32 bits would be infinite in a shader', () => {
    expect(
      load(document({ graphs: { main: { nodes: { 'a-b': { type: 'a/b', version: 1, params: { x: 1e39 } } } } } })).diagnostics,
    ).toMatchObject([{ code: 'SCR006' }]);
  });

  test('200 MB are refused without being read, with the limit', () => {
    const parse = jest.spyOn(JSON, 'parse');
    const text = ' '.repeat(200 * 2 ** 20);
    expect(load(text).diagnostics).toMatchObject([{ code: 'SCR005', severity: 'error', message: expect.stringContaining('up to 64 MiB') }]);
    expect(parse).not.toHaveBeenCalled();
    parse.mockRestore();
  });

  test('brackets nested a million deep do not overflow the stack', () => {
    const deep = '['.repeat(1e6) + ']'.repeat(1e6);
    expect(load(document().replace('"T"', deep)).diagnostics).toMatchObject([{ code: 'SCR002' }]);
    expect(load(deep.slice(0, -1)).diagnostics).toMatchObject([{ code: 'SCR001' }]);
  });

  test.each(['en', 'de-CH', 'zh-Hant-TW', 'sr-Latn'])('the page may be in the language %s', (language) => {
    expect(load(document({ page: { language } })).diagnostics).toEqual([]);
  });

  test.each(['', 'en_US', 'e', 'en" onload="alert(1)', '-en', 'en--US', 'Deutsch (Schweiz)'])(
    'the page cannot be in the language %j',
    (language) => {
      expect(load(document({ page: { language } })).diagnostics).toMatchObject([
        { code: 'SCR002', message: expect.stringContaining(`${JSON.stringify(language)} is not a language tag. Use a BCP 47 tag`) },
      ]);
    },
  );

  test.each(['__proto__', 'constructor', 'toString'])('the name %s reaches no prototype', (name) => {
    const text = document().replace('"nodes":{}', `"nodes":{"${name}":{"type":"a/b","version":1}}`);
    expect(load(text).diagnostics).toMatchObject([{ code: 'SCR002' }]);
    const asParam = document({ graphs: { main: { nodes: { 'a-b': { type: 'a/b', version: 1, params: {} } } } } }).replace(
      '"params":{}',
      `"params":{"${name}":1}`,
    );
    const { output } = load(asParam);
    expect(({} as { type?: unknown }).type).toBeUndefined();
    if (name === '__proto__') expect(output).toBeNull();
    else expect(Object.keys(output?.graphs.main?.nodes['a-b']?.params ?? {})).toEqual([name]);
  });

  test('fifty problems are enough', () => {
    const nodes = Object.fromEntries(Array.from({ length: 200 }, (_, i) => [`a-${i}`, {}]));
    expect(load(document({ graphs: { main: { nodes } } })).diagnostics).toHaveLength(50);
  });
});

describe('what is beside the document', () => {
  test.each([
    ['broken JSON', '{', 'SCR001'],
    ['another shape', '{"format":"scrim-layout","version":1,"graphs":{"main":{"nodes":{"a-b":{"x":"left","y":0}}}}}', 'SCR002'],
    ['a newer version', '{"format":"scrim-layout","version":9}', 'SCR003'],
  ])('a layout with %s is a warning, and the graph is whole', (_, layout, code) => {
    const { output, diagnostics } = load(CANONICAL, layout);
    expect(diagnostics).toMatchObject([{ code, severity: 'warning', file: 'project.layout.json' }]);
    expect(output?.layout).toEqual({});
    expect(output && saveProject(output).project).toBe(CANONICAL);
  });

  test.each([
    '../edge.fs',
    'a/b.fs',
    'edge.txt',
    '__proto__',
    '.fs',
    'edge.fs ',
    'chunks/../a.glsl',
    'chunks/a.fs',
    'chunks//a.glsl',
    'a/chunks/b.glsl',
  ])('a shader file cannot be called %j', (name) => {
    const { output, diagnostics } = load(document(), null, JSON.parse(`{${JSON.stringify(name)}: ""}`));
    expect(output).toBeNull();
    expect(diagnostics).toMatchObject([{ code: 'SCR002', severity: 'error' }]);
  });

  test.each(['edge.fs', 'CMYK Halftone (v2).fs', '3d Rotate.vs', 'Größe.fs', 'chunks/a.glsl', 'chunks/noise/simplex-3d.glsl'])(
    'a shader file can be called %j',
    (name) => {
      expect(load(document(), null, { [name]: 'x' }).output?.sources).toEqual({ [name]: 'x' });
    },
  );
});
