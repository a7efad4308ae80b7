import { describe, expect, test } from '@jest/globals';
import { describeSeparate } from '../../export/compiler/describe.ts';
import { SEPARATE_REASONS } from '../../export/compiler/schedule/fuse/separate-wire.ts';
import { totalBytes } from '../../export/compiler/target-bytes.ts';
import { chain, EXACT_EFFECTS, passes, type Twins, twins, versionOf } from '../support/fusion-kit.ts';
import { OBJECT_REASONS } from '../support/material-effects-kit.ts';

const INPUTS = '"INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }]';
const COPY = 'gl_FragColor = IMG_THIS_PIXEL(inputImage);';

/** pattern → the filter `own`, of this text → sepia → screen. */
function around(header: string, body: string, more: Readonly<Record<string, string>> = {}, options = {}): Twins {
  const nodes = { 'own-a': { type: 'filter/own', version: 1 }, 'sepia-a': { type: 'filter/sepia', version: 1 } };
  const wires = ['pattern-a.layer -> own-a.inputImage', 'own-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer'];
  return twins(nodes, wires, { 'own.fs': `/*{ "ISFVSN": "2", ${INPUTS}${header} }*/\n${body}`, ...more }, options);
}

function reasonsOf({ wires }: Twins): Record<string, string> {
  return Object.fromEntries(wires.map(({ writer, reader, reason }) => [`${writer} → ${reader}`, reason]));
}

/** Scenes over each other, one by one, and a filter over all. */
function stackOfScenes(count: number): Twins {
  const scenes = Array.from({ length: count }, (_, i) => i);
  const nodes = Object.fromEntries(
    scenes.flatMap((i) => [
      [`s-${i}`, { type: 'layer/scene', version: 1 }],
      [`o-${i}`, { type: 'operator/over', version: 1 }],
    ]),
  );
  const wires = scenes.flatMap((i) =>
    ['box-a.objects -> s-N.objects', 's-N.layer -> o-N.top', `${i === 0 ? 'pattern-a' : `o-${i - 1}`}.layer -> o-N.bottom`].map((wire) =>
      wire.replaceAll('-N', `-${i}`),
    ),
  );
  const ends = { 'box-a': { type: 'objects/primitive', version: 1 }, 'sepia-a': { type: 'filter/sepia', version: 1 } };
  return twins({ ...nodes, ...ends }, [...wires, `o-${count - 1}.layer -> sepia-a.inputImage`, 'sepia-a.layer -> screen-a.layer']);
}

describe('a layer stays a texture', () => {
  const found = new Set<string>();

  function expectReason(pair: Twins, wire: string, reason: keyof typeof SEPARATE_REASONS): void {
    expect(reasonsOf(pair)).toMatchObject({ [wire]: reason });
    found.add(reason);
  }

  test('where its reader reads other pixels, or reads it through a function that may', () => {
    expectReason(chain(['filter/sepia', 'filter/gaussian-blur']), 'e-0.pass0 → e-1.pass0', 'elsewhere');
    const passed =
      'vec4 at(sampler2D image) { return IMG_NORM_PIXEL(image, isf_FragNormCoord); }\nvoid main() { gl_FragColor = at(inputImage); }';
    expectReason(around('', passed), 'pattern-a.pass0 → own-a.pass0', 'elsewhere');
  });

  test('where one of two readers in the fused pass reads other pixels', () => {
    const nodes = { 'lut-a': { type: 'operator/color-lut', version: 1 }, 'mask-a': { type: 'operator/mask', version: 1 } };
    const wires = [
      'pattern-a.layer -> lut-a.inputImage',
      'other-a.layer -> lut-a.table',
      'lut-a.layer -> mask-a.inputImage',
      'other-a.layer -> mask-a.mask',
      'mask-a.layer -> screen-a.layer',
    ];
    const pair = twins(nodes, wires);
    expectReason(pair, 'other-a.pass0 → lut-a.pass0', 'elsewhere');
    // A color table makes large steps of small ones.
    expectReason(pair, 'pattern-a.pass0 → lut-a.pass0', 'unstable');
    expect(passes(pair.fused).map(({ nodes }) => nodes)).toEqual([undefined, undefined, ['lut-a', 'mask-a']]);
  });

  test('where its reader makes large steps of rounding, and another reader could compute it', () => {
    const nodes = {
      'grey-a': { type: 'filter/grey', version: 1 },
      'post-a': { type: 'filter/posterize', version: 1 },
      'sepia-a': { type: 'filter/sepia', version: 1 },
      'blend-a': { type: 'operator/blend', version: 1 },
    };
    const wires = [
      'pattern-a.layer -> grey-a.inputImage',
      'grey-a.layer -> post-a.inputImage',
      'post-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> blend-a.top',
      'grey-a.layer -> blend-a.bottom',
      'blend-a.layer -> screen-a.layer',
    ];
    const pair = twins(nodes, wires);
    expectReason(pair, 'grey-a.pass0 → post-a.pass0', 'unstable');
    expectReason(pair, 'grey-a.pass0 → blend-a.pass0', 'readers');
    expect(passes(pair.fused).map((pass) => pass.nodes)).toEqual([
      ['pattern-a', 'grey-a'],
      ['post-a', 'sepia-a', 'blend-a'],
    ]);
  });

  test('where two passes that stay separate read it', () => {
    const nodes = {
      'grey-a': { type: 'filter/grey', version: 1 },
      'blur-a': { type: 'filter/gaussian-blur', version: 1 },
      'over-a': { type: 'operator/blend', version: 1 },
    };
    const wires = [
      'pattern-a.layer -> grey-a.inputImage',
      'grey-a.layer -> blur-a.inputImage',
      'blur-a.layer -> over-a.top',
      'grey-a.layer -> over-a.bottom',
      'over-a.layer -> screen-a.layer',
    ];
    expectReason(twins(nodes, wires), 'grey-a.pass0 → over-a.pass0', 'readers');
  });

  test('where several passes could compute it, but it costs more than a texture', () => {
    const two = (effects: readonly string[]) => ({
      ...Object.fromEntries(effects.map((type, i) => [`e-${i}`, { type, version: 1 }])),
      'one-a': { type: 'filter/sepia', version: 1 },
      'two-a': { type: 'filter/sepia', version: 1 },
      'blur-a': { type: 'filter/gaussian-blur', version: 1 },
      'over-a': { type: 'operator/blend', version: 1 },
    });
    const apart = (effects: readonly string[]) => [
      ...effects.map((_, i) => `${i === 0 ? 'pattern-a' : `e-${i - 1}`}.layer -> e-${i}.inputImage`),
      `e-${effects.length - 1}.layer -> one-a.inputImage`,
      `e-${effects.length - 1}.layer -> two-a.inputImage`,
      'one-a.layer -> blur-a.inputImage',
      'blur-a.layer -> over-a.top',
      'two-a.layer -> over-a.bottom',
      'over-a.layer -> screen-a.layer',
    ];
    const cheap = ['filter/grey'];
    const dear = ['filter/grey', 'filter/white-balance', 'filter/vignette'];
    const computed = passes(twins(two(cheap), apart(cheap)).fused);
    expect(computed.map(({ nodes }) => nodes)).toEqual([
      ['pattern-a', 'e-0', 'one-a'],
      undefined,
      ['pattern-a', 'e-0', 'blur-a', 'two-a', 'over-a'],
    ]);
    const stored = twins(two(dear), apart(dear));
    expectReason(stored, 'e-2.pass0 → one-a.pass0', 'cost');
    expectReason(stored, 'e-2.pass0 → two-a.pass0', 'cost');
  });

  test('where one pass would compute it for several pixels that it reads, and that costs more than a texture', () => {
    const at = (x: number) => `IMG_PIXEL(inputImage, gl_FragCoord.xy + vec2(${x}.0, 0.0))`;
    const mean = (count: number) =>
      `void main() { gl_FragColor = (${Array.from({ length: count }, (_, i) => at(i)).join(' + ')}) / ${count}.0; }`;
    const INVERT = `/*{ "ISFVSN": "2", ${INPUTS} }*/\nvoid main() { vec4 c = IMG_THIS_PIXEL(inputImage); gl_FragColor = vec4(1.0 - c.rgb, c.a); }`;
    const pair = (count: number) =>
      twins(
        {
          // Its layer is a texture.
          'pattern-a': { type: 'generator/pattern', version: 1, unfused: true },
          'invert-a': { type: 'filter/invert', version: 1 },
          'mean-a': { type: 'filter/mean', version: 1 },
        },
        ['pattern-a.layer -> invert-a.inputImage', 'invert-a.layer -> mean-a.inputImage', 'mean-a.layer -> screen-a.layer'],
        { 'invert.fs': INVERT, 'mean.fs': `/*{ "ISFVSN": "2", ${INPUTS} }*/\n${mean(count)}` },
      );
    expect(passes(pair(3).fused).map(({ nodes }) => nodes)).toEqual([undefined, ['invert-a', 'mean-a']]);
    expectReason(pair(9), 'invert-a.pass0 → mean-a.pass0', 'cost');
  });

  test('where the sizes differ', () => {
    expectReason(
      around(
        ', "PASSES": [{ "TARGET": "half", "WIDTH": "$WIDTH / 2.0", "HEIGHT": "$HEIGHT / 2.0" }, {}]',
        `void main() { if (PASSINDEX == 0) { ${COPY} } else { gl_FragColor = IMG_THIS_PIXEL(half); } }`,
      ),
      'pattern-a.pass0 → own-a.pass0',
      'size',
    );
  });

  test('where an image of its own size is fitted to the view', () => {
    const nodes = {
      'file-a': { type: 'source/image-file', version: 1 },
      'grey-a': { type: 'filter/grey', version: 1 },
      'over-a': { type: 'operator/blend', version: 1 },
    };
    const wires = [
      'file-a.layer -> grey-a.inputImage',
      'grey-a.layer -> over-a.top',
      'pattern-a.layer -> over-a.bottom',
      'over-a.layer -> screen-a.layer',
    ];
    expectReason(twins(nodes, wires), 'grey-a.pass0 → over-a.pass0', 'fitted');
  });

  test('where its reader reads another pixel, and its own colors depend on the rasterizer or on filtered images', () => {
    const shift = {
      'shift.fs': `/*{ "ISFVSN": "2", ${INPUTS} }*/\nvoid main() { gl_FragColor = IMG_PIXEL(inputImage, gl_FragCoord.xy + 2.0); }`,
    };
    const nodes = { 'shift-a': { type: 'filter/shift', version: 1 }, 'grey-a': { type: 'filter/grey', version: 1 } };
    // The pattern computes with its normalized position.
    const wires = ['pattern-a.layer -> grey-a.inputImage', 'grey-a.layer -> shift-a.inputImage', 'shift-a.layer -> screen-a.layer'];
    const pair = twins(nodes, wires, shift);
    expectReason(pair, 'pattern-a.pass0 → grey-a.pass0', 'moved');
    expect(passes(pair.fused).map(({ nodes }) => nodes)).toEqual([undefined, ['grey-a', 'shift-a']]);
    const filmed = ['video-a.layer -> grey-a.inputImage', 'grey-a.layer -> shift-a.inputImage', 'shift-a.layer -> screen-a.layer'];
    expectReason(
      twins({ ...nodes, 'video-a': { type: 'source/camera-video', version: 1 } }, filmed, shift),
      'grey-a.pass0 → shift-a.pass0',
      'moved',
    );
  });

  const SHIFTED = ['pattern-a.layer -> own-a.inputImage', 'own-a.layer -> shift-a.inputImage', 'shift-a.layer -> screen-a.layer'];
  const shifted = (own: string) =>
    twins({ 'own-a': { type: 'filter/own', version: 1 }, 'shift-a': { type: 'filter/shift', version: 1 } }, SHIFTED, {
      'shift.fs': EXACT_EFFECTS['filter/shift'] ?? '',
      'own.fs': own,
    });

  test('where the pass of another pixel gives its normalized position to a function, whatever its name', () => {
    const own = (name: string) =>
      `/*{ "ISFVSN": "2", ${INPUTS} }*/
vec3 ${name}(vec2 p) { return fract(p.xyx * 91234.5); }
void main() { gl_FragColor = vec4(${name}(isf_FragNormCoord), IMG_THIS_PIXEL(inputImage).a); }`;
    expectReason(shifted(own('noise')), 'own-a.pass0 → shift-a.pass0', 'moved');
    expectReason(shifted(own('color_at')), 'own-a.pass0 → shift-a.pass0', 'moved');
  });

  test('where the pass of another pixel reads a layer of another size, which is filtered', () => {
    const own = `/*{ "ISFVSN": "2", ${INPUTS}, "PASSES": [{ "TARGET": "half", "WIDTH": "$WIDTH / 2" }, {}] }*/
void main() { gl_FragColor = PASSINDEX == 0 ? IMG_THIS_PIXEL(inputImage) : IMG_THIS_PIXEL(half); }`;
    expectReason(shifted(own), 'own-a.pass1 → shift-a.pass0', 'moved');
  });

  test('where neighboring pixels would be read in two steps', () => {
    expectReason(chain(['filter/anisotropic-kuwahara']), 'e-0.pass2 → e-0.pass3', 'neighborhoods');
  });

  test('whose content is kept for the next frame', () => {
    expectReason(
      around(
        ', "PASSES": [{ "TARGET": "sum", "PERSISTENT": true }, {}]',
        `void main() { if (PASSINDEX == 0) { gl_FragColor = IMG_THIS_PIXEL(inputImage) + IMG_THIS_PIXEL(sum); } else { gl_FragColor = IMG_THIS_PIXEL(sum); } }`,
      ),
      'own-a.pass0 → own-a.pass1',
      'kept',
    );
  });

  test('where what its writer reads changes before its reader runs', () => {
    const body = `void main() {
  if (PASSINDEX == 0) gl_FragColor = IMG_THIS_PIXEL(kept);
  else if (PASSINDEX == 1) gl_FragColor = IMG_THIS_PIXEL(inputImage);
  else gl_FragColor = IMG_THIS_PIXEL(before);
}`;
    const pair = around(', "PASSES": [{ "TARGET": "before" }, { "TARGET": "kept", "PERSISTENT": true }, {}]', body);
    expectReason(pair, 'own-a.pass0 → own-a.pass2', 'order');
  });

  test('while the editor shows it', () => {
    expectReason(around('', `void main() { ${COPY} }`, {}, { taps: ['own-a.layer'] }), 'own-a.pass0 → sepia-a.pass0', 'viewed');
  });

  test('where fusion is turned off for a node, or for the subgraph that contains it', () => {
    const sepia = (more: object = {}) => ({ type: 'filter/sepia', version: 1, ...more });
    const wires = ['pattern-a.layer -> one-a.inputImage', 'one-a.layer -> two-a.inputImage', 'two-a.layer -> three-a.inputImage'];
    const pair = twins({ 'one-a': sepia(), 'two-a': sepia({ unfused: true }), 'three-a': sepia() }, [
      ...wires,
      'three-a.layer -> screen-a.layer',
    ]);
    expectReason(pair, 'one-a.pass0 → two-a.pass0', 'switched');
    expectReason(pair, 'two-a.pass0 → three-a.pass0', 'switched');
    expect(passes(pair.fused).map(({ id, nodes }) => nodes ?? [id])).toEqual([['pattern-a', 'one-a'], ['two-a.pass0'], ['three-a.pass0']]);
    const look = {
      nodes: { 'one-a': sepia(), 'two-a': sepia() },
      wires: ['one-a.layer -> two-a.inputImage'],
      exposed: { inputs: [{ name: 'in', node: 'one-a', port: 'inputImage' }], outputs: [{ name: 'out', node: 'two-a', port: 'layer' }] },
    };
    const around = { 'look-a': { type: 'graph/look', version: 1, unfused: true }, 'three-a': sepia() };
    const inside = twins(
      around,
      ['pattern-a.layer -> look-a.in', 'look-a.out -> three-a.inputImage', 'three-a.layer -> screen-a.layer'],
      {},
      {},
      { look },
    );
    expectReason(inside, 'look-a/one-a.pass0 → look-a/two-a.pass0', 'switched');
  });

  test('of a vertex shader, and of loops that the preview limits', () => {
    const vertex = 'void main() { isf_vertShaderInit(); gl_Position.x *= 0.5; }';
    expectReason(around('', `void main() { ${COPY} }`, { 'own.vs': vertex }), 'own-a.pass0 → sepia-a.pass0', 'vertex');
    const endless = `void main() { vec4 sum = vec4(0.0); for (int i = 0; i < 100000; i++) { sum += IMG_THIS_PIXEL(inputImage); } gl_FragColor = sum; }`;
    expectReason(around('', endless, {}, { loopBudget: true }), 'own-a.pass0 → sepia-a.pass0', 'loops');
  });

  test('whose depth is computed of it', () => {
    const nodes = {
      'box-a': { type: 'objects/primitive', version: 1 },
      'scene-a': { type: 'layer/scene', version: 1 },
      'sepia-a': { type: 'filter/sepia', version: 1 },
      'over-a': { type: 'operator/over', version: 1 },
      'fog-a': { type: 'filter/fog', version: 1 },
    };
    const wires = [
      'box-a.objects -> scene-a.objects',
      'scene-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> over-a.top',
      'pattern-a.layer -> over-a.bottom',
      'over-a.layer -> fog-a.inputImage',
      'fog-a.layer -> screen-a.layer',
    ];
    expectReason(twins(nodes, wires), 'sepia-a.pass0 → over-a.layer.depth', 'depth');
  });

  test('where the fused shader would exceed a limit', () => {
    expectReason(chain(Array.from({ length: 40 }, () => 'filter/sepia')), 'e-7.pass0 → e-8.pass0', 'limits');
  });

  test('where more layers would exist at the same time than the passes need one after the other', () => {
    const pair = stackOfScenes(12);
    expectReason(pair, 'o-3.pass0 → o-4.pass0', 'memory');
    expect(totalBytes(pair.fused)).toBeLessThanOrEqual(totalBytes(pair.separate));
    expect(passes(pair.fused).length).toBeLessThan(passes(pair.separate).length);
  });

  test('for no other reason', () => {
    expect([...found, ...OBJECT_REASONS].sort()).toEqual(Object.keys(SEPARATE_REASONS).sort());
  });
});

test('`scrim plan --why` says in words which layer stays a texture, and why', () => {
  const { wires } = chain(['filter/sepia', 'filter/gaussian-blur']);
  expect(describeSeparate(wires)).toContain('e-0.layer → e-1.pass0: the reader reads other pixels than the current one (elsewhere)');
});

describe('passes over layers whose alpha is 0 or 1', () => {
  const overSource = (source: object, options = {}) => {
    const nodes = { 'source-a': source, 'sepia-a': { type: 'filter/sepia', version: 1 }, 'grey-a': { type: 'filter/grey', version: 1 } };
    const wires = ['source-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> grey-a.inputImage', 'grey-a.layer -> screen-a.layer'];
    const { fused } = twins(nodes, wires, {}, options);
    const [shader] = fused.shaders.filter(({ fragment }) => fragment.includes('b1_'));
    return shader?.fragment.match(/scrim_straight\(\w*layer\)/g)?.length ?? 0;
  };
  const camera = { type: 'source/camera-video', version: 1 };
  const image = { type: 'source/image-file', version: 1, params: { file: 'photo' } };

  test('do not divide by it: the camera image, and images without transparency', () => {
    expect(overSource(camera)).toBe(0);
    expect(overSource(image, { opaqueImages: ['photo'] })).toBe(0);
  });

  test('divide by it where it may be another: a color of the author, and other images', () => {
    expect(overSource({ ...camera, params: { withoutImage: 'color' } })).toBe(1);
    expect(overSource(image)).toBe(1);
  });

  const EFFECTS = { 'sepia-a': 'filter/sepia', 'grey-a': 'filter/grey', 'warm-a': 'filter/color-temperature', 'dark-a': 'filter/vignette' };
  const multiplications = (screen: readonly string[]) => {
    const nodes = Object.fromEntries(Object.entries(EFFECTS).map(([id, type]) => [id, { type, version: versionOf(type) }]));
    const wires = [
      'video-a.layer -> sepia-a.inputImage',
      'sepia-a.layer -> grey-a.inputImage',
      'grey-a.layer -> warm-a.inputImage',
      'warm-a.layer -> dark-a.inputImage',
    ];
    const blend = { 'video-a': camera, 'blend-a': { type: 'operator/blend', version: versionOf('operator/blend') } };
    const { fused } = twins({ ...nodes, ...blend }, [...wires, ...screen]);
    return passes(fused).map(({ shader }) => fused.shaders[shader]?.fragment.match(/\* b\d_layer\.a/g)?.length);
  };

  test('multiply by it once, where no reader needs the color of transparent pixels', () => {
    expect(multiplications(['dark-a.layer -> screen-a.layer'])).toEqual([1]);
    const blended = ['warm-a.layer -> blend-a.top', 'dark-a.layer -> blend-a.bottom', 'blend-a.layer -> screen-a.layer'];
    expect(multiplications(blended)).toEqual([2]);
  });
});

test('passes read targets and images of their size where they are, without the matrix that places the camera image', () => {
  const nodes = {
    'blur-a': { type: 'filter/gaussian-blur', version: 1 },
    'sepia-a': { type: 'filter/sepia', version: 1 },
  };
  const wires = ['pattern-a.layer -> blur-a.inputImage', 'blur-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer'];
  const { fused, separate } = twins(nodes, wires);
  const placed = ({ shaders }: Twins['fused']) => shaders.filter(({ fragment }) => fragment.includes('scrim_place(')).length;
  expect(placed(separate)).toBeGreaterThan(0);
  expect(placed(fused)).toBe(0);
  const filtered = ['source-a.layer -> sepia-a.inputImage', 'sepia-a.layer -> screen-a.layer'];
  const over = (type: string) => twins({ 'source-a': { type, version: 1 }, 'sepia-a': nodes['sepia-a'] }, filtered).fused;
  // The pass that fits the image to the view places it.
  expect(passes(over('source/image-file')).map(({ id }) => id)).toEqual(['sepia-a.pass0', 'sepia-a.layer.screen0']);
  expect(placed(over('source/image-file'))).toBe(1);
  expect(placed(over('source/camera-video'))).toBe(1);
});
