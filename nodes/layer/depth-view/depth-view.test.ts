import { readFileSync } from 'node:fs';
import { expect, test } from '@jest/globals';
import { isfDefinition } from '../../../export/glsl/isf/isf-definition.ts';
import { readIsf } from '../../../export/glsl/isf/read-isf.ts';
import { definition } from './definition.ts';

/** What it looks like is proved on pixels, in `tests/browser/room-depth.test.ts`. */
test('its shader is one the definition can speak for: same ports, same ranges, same cost', () => {
  const { output: shader, diagnostics } = readIsf(
    readFileSync(new URL('./depth-view.fs', import.meta.url), 'utf8'),
    'layer/depth-view/depth-view.fs',
  );
  expect(diagnostics).toEqual([]);
  if (!shader) throw new Error('The shader cannot be read.');
  const own = isfDefinition(shader, 'depth-view');
  const ports = (inputs: Readonly<Record<string, { readonly type: string; readonly required: boolean }>>) =>
    Object.entries(inputs).map(([name, { type, required }]) => [name, type, required]);
  expect(ports(own.inputs)).toEqual(ports(definition.inputs));
  expect(own.outputs.layer).toMatchObject({ depth: false });
  for (const [name, param] of Object.entries(definition.params)) {
    const { type, default: value } = param;
    expect(own.params[name]).toMatchObject({ type, default: value, ...('unit' in param ? { unit: param.unit } : {}) });
  }
  expect(own.lowering).toMatchObject({ access: definition.lowering.access, shader: definition.lowering.shader });
});
