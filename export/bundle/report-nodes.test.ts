import { expect, test } from '@jest/globals';
import type { Program } from '../program/program.ts';
import { nodeBytes } from './report-nodes.ts';

const operation = (node: string, more: object) => ({ id: node, node, reads: [], writes: [], view: 'once', ...more });
const source = operation('picture-a', { kind: 'source', type: 'source/image-file', assets: { file: 'p' } });
const pass = operation('sepia-a', { kind: 'pass', shader: 1, nodes: ['sepia-a', 'swirl-a'], samplers: [] });

const PROGRAM = {
  operations: [source, pass],
  shaders: [
    { vertex: 'unused', fragment: 'unused' },
    { vertex: '12345', fragment: '1234567' },
  ],
  assets: [{ id: 'p', kind: 'image', path: 'assets/p.png' }],
} as unknown as Program;

test('a node is reported with its code, shaders, operations and assets; fused nodes are one entry', () => {
  const parts = {
    'nodes/source/image-file/runtime.ts': 100,
    'nodes/source/image-file/fit.ts': 20,
    'nodes/source/image-file-b/runtime.ts': 7,
  };
  const assets = [{ source: 'assets/p.png', fileBytes: { before: 5000, after: 4000 } }];
  expect(nodeBytes(PROGRAM, parts, assets)).toEqual([
    { nodes: ['picture-a'], script: 120, shaders: 0, operations: JSON.stringify(source).length, assets: 4000 },
    { nodes: ['sepia-a', 'swirl-a'], script: 0, shaders: 12, operations: JSON.stringify(pass).length, assets: 0 },
  ]);
});
