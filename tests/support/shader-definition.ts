import { readFileSync } from 'node:fs';
import { expect } from '@jest/globals';
import { isfDefinition } from '../../export/glsl/isf/isf-definition.ts';
import { readIsf } from '../../export/glsl/isf/read-isf.ts';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';

type Ports = Readonly<Record<string, { readonly type: string; readonly required: boolean }>>;

/** Checks that an explicit definition equals that of its shader’s header: ports, params and cost. */
export function expectSpeaksFor(definition: NodeDefinition, source: URL): void {
  const [, name = ''] = definition.type.split('/');
  const { output: shader, diagnostics } = readIsf(readFileSync(source, 'utf8'), `${definition.type}/${name}.fs`);
  expect(diagnostics).toEqual([]);
  if (!shader) throw new Error('The shader cannot be read.');
  const own = isfDefinition(shader, name);
  const ports = (inputs: Ports) => Object.entries(inputs).map(([id, { type, required }]) => [id, type, required]);
  expect(ports(own.inputs)).toEqual(ports(definition.inputs));
  expect(own.outputs.layer).toMatchObject({ depth: false });
  for (const [id, param] of Object.entries(definition.params)) {
    const { type, default: value } = param;
    expect(own.params[id]).toMatchObject({ type, default: value, ...('unit' in param ? { unit: param.unit } : {}) });
  }
  const { lowering } = definition;
  if (lowering.kind !== 'image') throw new Error(`${definition.type} is drawn by no shader.`);
  expect(own.lowering).toMatchObject({ access: lowering.access, shader: lowering.shader });
}
