import { mkdtemp, realpath, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { Document, NodeIO } from '@gltf-transform/core';
import { afterAll, beforeAll, describe, expect, test } from '@jest/globals';
import { BoxGeometry, type BufferGeometry, PlaneGeometry } from 'three';
import { compileProject } from './compile-project.ts';

let root = '';
beforeAll(async () => {
  root = await realpath(await mkdtemp(join(tmpdir(), 'scrim-check-')));
});
afterAll(() => rm(root, { recursive: true, force: true }));

async function glb(geometry: BufferGeometry): Promise<Uint8Array> {
  const doc = new Document();
  doc.createBuffer();
  const positions = Float32Array.from(geometry.getAttribute('position').array);
  const primitive = doc.createPrimitive().setAttribute('POSITION', doc.createAccessor().setType('VEC3').setArray(positions));
  primitive.setIndices(
    doc
      .createAccessor()
      .setType('SCALAR')
      .setArray(Uint16Array.from(geometry.index?.array ?? [])),
  );
  doc.createScene().addChild(doc.createNode().setMesh(doc.createMesh().addPrimitive(primitive)));
  return new NodeIO().writeBinary(doc);
}

/** What checking a project says whose one model is this file, drawn as it is or as a phantom. */
async function check(path: string, bytes: Uint8Array | string, phantom = false) {
  await writeFile(join(root, path), bytes);
  const nodes = {
    'model-a1': { type: 'source/model', version: 1, params: { model: 'thing' } },
    ...(phantom ? { 'phantom-b2': { type: 'objects/phantom', version: 1 } } : {}),
    'scene-c3': { type: 'layer/scene', version: 1 },
    'screen-d4': { type: 'output/screen', version: 1 },
  };
  const wires = [
    ...(phantom
      ? ['model-a1.objects -> phantom-b2.objects', 'phantom-b2.objects -> scene-c3.objects']
      : ['model-a1.objects -> scene-c3.objects']),
    'scene-c3.layer -> screen-d4.layer',
  ];
  const project = {
    format: 'scrim-project',
    version: 1,
    title: 'test',
    assets: { thing: { path, kind: 'model' } },
    graphs: { main: { nodes, wires } },
  };
  const { diagnostics } = await compileProject(root, { project: JSON.stringify(project), layout: null, sources: {} });
  return diagnostics.map(({ code, severity, message }) => `${severity} ${code} ${message}`);
}

describe('models in scrim check', () => {
  test('are fine when they are whole', async () => {
    expect(await check('box.glb', await glb(new BoxGeometry()))).toEqual([]);
    expect(await check('box.glb', await glb(new BoxGeometry()), true)).toEqual([]);
  });

  test('may have holes, unless they stand for a real thing', async () => {
    const sheet = await glb(new PlaneGeometry(1, 1, 2, 2));
    expect(await check('sheet.glb', sheet)).toEqual([]);
    expect(await check('sheet.glb', sheet, true)).toEqual([
      'warning SCR035 The model "sheet.glb" is a phantom, but its surface is not closed: it has 8 edges at holes or borders.',
    ]);
  });

  test('are told apart by what is broken in them', async () => {
    const whole = await glb(new BoxGeometry());
    expect(await check('cut.glb', whole.subarray(0, 500))).toEqual([expect.stringMatching(/^error SCR032 .*incomplete/)]);
    const gltf = (more: object) => JSON.stringify({ asset: { version: '2.0' }, scenes: [{}], ...more });
    expect(await check('loose.gltf', gltf({ buffers: [{ byteLength: 4, uri: 'loose.bin' }] }))).toEqual([
      'error SCR032 loose.gltf cannot be decoded: the file "loose.bin" that it refers to cannot be read (there is no such file). Put it beside the model, or export one .glb file.',
    ]);
    expect(await check('out.gltf', gltf({ buffers: [{ byteLength: 4, uri: '../../etc/passwd' }] }))).toEqual([
      expect.stringMatching(/^error SCR032 out.gltf cannot be decoded: it refers to "..\/..\/etc\/passwd", which is not in the project\./),
    ]);
    expect(await check('odd.gltf', gltf({ extensionsRequired: ['ACME_teapots'] }))).toEqual([
      'error SCR032 odd.gltf cannot be decoded: it needs ACME_teapots, which Scrim cannot decode. Export it without them.',
    ]);
  });
});
