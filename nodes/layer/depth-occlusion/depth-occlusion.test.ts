import { readFileSync } from 'node:fs';
import { describe, expect, test } from '@jest/globals';
import { isfDefinition } from '../../../export/glsl/isf/isf-definition.ts';
import { readIsf } from '../../../export/glsl/isf/read-isf.ts';
import { linkIsf } from '../../../export/glsl/link/link-isf.ts';
import { definition } from './definition.ts';

const FILE = 'layer/depth-occlusion/occlusion.fs';
const { output: shader, diagnostics } = readIsf(readFileSync(new URL('./occlusion.fs', import.meta.url), 'utf8'), FILE);

describe('the shader of depth occlusion', () => {
  test('is one the definition can speak for: same ports, same ranges, same cost', () => {
    expect(diagnostics).toEqual([]);
    if (!shader) throw new Error('The shader cannot be read.');
    const own = isfDefinition(shader, 'depth-occlusion');
    expect(Object.entries(own.inputs).map(([name, port]) => [name, port.type])).toEqual(
      Object.entries(definition.inputs).map(([name, port]) => [name, port.type]),
    );
    expect(own.outputs.layer).toMatchObject({
      domain: definition.outputs.layer.domain,
      depth: definition.outputs.layer.depth,
      encoding: definition.outputs.layer.encoding,
    });
    expect(own.inputs.layer?.encoding).toBe(definition.inputs.layer.encoding);
    for (const [name, { type, default: value, min, max, unit }] of Object.entries(definition.params)) {
      expect(own.params[name]).toMatchObject({ type, default: value, min, max, unit });
    }
    expect(own.lowering).toMatchObject({ access: definition.lowering.access, shader: definition.lowering.shader });
  });

  test('reads the layer, its depth and the room once each', () => {
    if (!shader) throw new Error('The shader cannot be read.');
    const { output: passes } = linkIsf(shader, { node: 'occlusion-test' });
    expect(passes).toHaveLength(1);
    expect(passes?.[0]?.samplers.map((sampler) => sampler.source.kind).sort()).toEqual(['input', 'input-depth', 'room-depth']);
  });
});
