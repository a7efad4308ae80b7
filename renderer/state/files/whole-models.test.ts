import { describe, expect, test } from '@jest/globals';
import { readGltf } from '../../../export/gltf/read-gltf.ts';
import { looseModel } from '../../../tests/support/loose-model.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { copySelection, pasteText } from '../clipboard/clipboard.ts';
import type { Editor } from '../editor/editor.ts';
import { addFiles, type DroppedFile, importAsset } from './add-files.ts';

type Files = Readonly<Record<string, Uint8Array<ArrayBuffer>>>;

const PLACE = { x: 0, y: 0 };

function dropped(files: Files): DroppedFile[] {
  return Object.entries(files).map(([name, bytes]) => ({ name, arrayBuffer: async () => bytes.buffer }));
}

function without(files: Files, ...names: string[]): Files {
  return Object.fromEntries(Object.entries(files).filter(([name]) => !names.includes(name)));
}

const toasts = (editor: Editor) => editor.ui.getState().toasts.map(({ text }) => text);
const assets = (editor: Editor) => Object.values(editor.document.getState().project.assets).map(({ path }) => path);

/** An editor, and what its host was given to keep. */
async function editing() {
  const { editor, host } = await openTestEditor();
  const kept = () =>
    host.calls.flatMap(({ method, input }) => (method === 'asset.import' ? [input as { name: string; bytes: Uint8Array }] : []));
  return { editor, host, kept };
}

describe('a model in several files', () => {
  test('is dropped together with them, and is one file and one node of the project', async () => {
    const { editor, kept } = await editing();
    await addFiles(editor, dropped(await looseModel()), PLACE);
    expect(kept().map(({ name }) => name)).toEqual(['tile.glb']);
    expect(assets(editor)).toEqual(['assets/tile.glb']);
    expect(readGltf(kept()[0]?.bytes ?? new Uint8Array()).document.images).toEqual([expect.objectContaining({ mimeType: 'image/png' })]);
    expect(Object.values(editor.document.getState().project.graphs.main?.nodes ?? {}).map(({ type }) => type)).toEqual(['source/model']);
  });

  test('is not brought in without them; which are missing is said, and nothing else is made of the others', async () => {
    const { editor, kept } = await editing();
    const files = await looseModel();
    await addFiles(editor, dropped(without(files, 'paint on wood.png')), PLACE);
    expect(toasts(editor)).toEqual(['tile.gltf is incomplete. It refers to “paint on wood.png”, which is missing.']);
    await addFiles(editor, dropped(without(files, 'tile.bin', 'paint on wood.png')), PLACE);
    expect(toasts(editor)[1]).toBe('tile.gltf is incomplete. It refers to “tile.bin” and “paint on wood.png”, which are missing.');
    expect(kept()).toEqual([]);
  });

  test('is chosen in the inspector with its files', async () => {
    const { editor } = await editing();
    const { 'tile.gltf': model = new Uint8Array(), ...others } = await looseModel();
    expect(await importAsset(editor, dropped({ ...others, 'tile.gltf': model }), 'model')).not.toBeNull();
    expect(assets(editor)).toEqual(['assets/tile.glb']);
  });

  test('whose buffer is too short is refused, and says so', async () => {
    const { editor } = await editing();
    await addFiles(editor, dropped({ ...(await looseModel()), 'tile.bin': new Uint8Array(3) }), PLACE);
    expect(toasts(editor)).toEqual([expect.stringMatching(/^tile\.gltf cannot be decoded: the file is damaged: buffer 0 is too short/)]);
  });
});

describe('a model in several files of a project', () => {
  /** Its node is selected, its files are where the host has them. */
  async function placed(files: Files) {
    const { editor, host } = await editing();
    host.answer('asset.import', () => ({ path: 'assets/models/tile.gltf' }));
    await addFiles(editor, [{ name: 'tile.glb', arrayBuffer: async () => new ArrayBuffer(0) }], PLACE);
    host.answer('asset.read', ({ path }) => ({
      base64: Buffer.from(files[path.slice('assets/models/'.length)] ?? []).toString('base64'),
    }));
    return editor;
  }

  test('is copied to another project with them, as one file', async () => {
    const files = await looseModel();
    const editor = await placed(files);
    await copySelection(editor);
    const other = await editing();
    await pasteText(other.editor, await editor.clipboard.read());
    expect(other.kept().map(({ name }) => name)).toEqual(['tile.glb']);
    expect(readGltf(other.kept()[0]?.bytes ?? new Uint8Array()).document.images).toHaveLength(1);
    expect(assets(other.editor)).toEqual(['assets/tile.glb']);
  });
});
