import { expect, test } from '@jest/globals';
import { readPreparedModel } from './prepared-model.ts';

/** A GLB with a JSON chunk; its header says that the chunk has `length` bytes. */
function glb(json: string, length = json.length): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(20 + json.length);
  const view = new DataView(bytes.buffer);
  for (const [i, word] of [0x46546c67, 2, bytes.length, length, 0x4e4f534a].entries()) view.setUint32(4 * i, word, true);
  bytes.set(new TextEncoder().encode(json), 20);
  return bytes;
}

test('the document of a prepared model is read, and its bytes stay', async () => {
  const bytes = glb('{"extensionsUsed":["KHR_materials_ior"]} ');
  const model = await readPreparedModel(bytes);
  expect(model.gltf.document.extensionsUsed).toEqual(['KHR_materials_ior']);
  expect(model.bytes).toBe(bytes);
});

test('the error page of a host and a truncated file are refused', async () => {
  const page = new TextEncoder().encode('<!doctype html><title>404 Not Found</title>');
  await expect(readPreparedModel(page)).rejects.toThrow('the file is damaged: it is no GLB file. Export it again.');
  await expect(readPreparedModel(glb('{"scenes":[', 400))).rejects.toThrow('its JSON is incomplete');
});
