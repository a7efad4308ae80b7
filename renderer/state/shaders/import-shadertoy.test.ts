import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { pasteFromClipboard } from '../clipboard/clipboard.ts';
import { undo } from '../document/apply.ts';
import { graphOf } from '../editor/document.ts';
import type { Editor } from '../editor/editor.ts';
import { addFiles } from '../files/add-files.ts';
import { importShadertoy } from './import-shadertoy.ts';

const WAVES = `// Created by Ada Example, 2020
void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy) * sin(iTime); }`;

function nodeTypes(editor: Editor): string[] {
  return Object.values(graphOf(editor.document.getState()).nodes).map(({ type }) => type);
}

function sources(editor: Editor): Readonly<Record<string, string>> {
  return editor.document.getState().project.sources;
}

describe('a source of shadertoy.com', () => {
  test('pasted onto the canvas becomes a shader and a selected node, in one step', async () => {
    const { editor } = await openTestEditor();
    const before = nodeTypes(editor);
    await editor.clipboard.write(WAVES);
    await pasteFromClipboard(editor);
    expect(nodeTypes(editor)).toEqual([...before, 'filter/shadertoy']);
    expect(sources(editor)['shadertoy.fs']).toContain('"CREDIT": "Created by Ada Example, 2020"');
    const [selected = ''] = editor.selection.getState().nodes;
    expect(graphOf(editor.document.getState()).nodes[selected]?.type).toBe('filter/shadertoy');
    // Whose terms it came under is not passed over in silence.
    expect(
      editor.ui
        .getState()
        .toasts.map(({ text }) => text)
        .join(),
    ).toContain('CC BY-NC-SA 3.0');
    undo(editor);
    expect(nodeTypes(editor)).toEqual(before);
    expect(sources(editor)).toEqual({});
  });

  test('twice makes two shaders, under the name that was asked for', async () => {
    const { editor } = await openTestEditor();
    expect(importShadertoy(editor, { source: WAVES, name: 'Wilde Wellen (2)' })).toBe(true);
    expect(importShadertoy(editor, { source: WAVES, name: 'Wilde Wellen (2)' })).toBe(true);
    expect(Object.keys(sources(editor))).toEqual(['wilde-wellen-2.fs', 'wilde-wellen-2-2.fs']);
  });

  test('dropped as a file is converted by what is in it', async () => {
    const { editor } = await openTestEditor();
    const json = JSON.stringify([
      {
        info: { name: 'Deep rings' },
        renderpass: [
          {
            type: 'image',
            name: 'Image',
            inputs: [],
            outputs: [],
            code: WAVES.replace('texture(iChannel0, p / iResolution.xy)', 'vec4(1.0)'),
          },
        ],
      },
    ]);
    const bytes = (text: string) => ({ arrayBuffer: async () => new TextEncoder().encode(text).buffer as ArrayBuffer });
    await addFiles(
      editor,
      [
        { name: 'export.json', ...bytes(json) },
        { name: 'My Waves.glsl', ...bytes(WAVES) },
      ],
      { x: 0, y: 0 },
    );
    expect(Object.keys(sources(editor))).toEqual(['deep-rings.fs', 'my-waves.fs']);
    expect(nodeTypes(editor)).toEqual(expect.arrayContaining(['generator/deep-rings', 'filter/my-waves']));
  });

  test('that cannot be converted changes nothing and says why', async () => {
    const { editor } = await openTestEditor();
    expect(importShadertoy(editor, { source: `// Buffer A\n${WAVES}`, name: 'x' })).toBe(false);
    expect(sources(editor)).toEqual({});
    expect(editor.ui.getState().toasts).toMatchObject([{ tone: 'error', text: 'The Image tab is missing.' }]);
  });

  test('other text is no node', async () => {
    const { editor } = await openTestEditor();
    await editor.clipboard.write('void main() {}');
    await pasteFromClipboard(editor);
    expect(editor.ui.getState().toasts).toMatchObject([{ text: 'The clipboard contains no nodes.' }]);
  });
});
