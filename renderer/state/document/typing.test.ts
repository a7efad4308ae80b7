import { describe, expect, test } from '@jest/globals';
import type { Diagnostic } from '../../../nodes/kit/diagnostics.ts';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { graphOf } from '../editor/document.ts';
import { filesOf } from '../files/files.ts';
import { addNodeFromPalette } from '../graph/edit-graph.ts';
import { stillWrong } from '../problems/problems.ts';
import { undo } from './apply.ts';
import { copyChunk, shaderOf } from './edit-shader.ts';
import { createTyping } from './typing.ts';

async function withSepia(type = 'filter/sepia') {
  const { editor, clock } = await openTestEditor();
  const definition = editor.document.getState().library.definition(type);
  const node = definition && addNodeFromPalette(editor, { definition, port: null }, { x: 0, y: 0 }, null);
  if (!node) throw new Error(`${type} was not added.`);
  const text = () => shaderOf(editor.document.getState(), node)?.text ?? '';
  return { editor, clock, node, text, typing: createTyping(editor), steps: () => editor.document.getState().history.past.length };
}

describe('typing a shader', () => {
  test('a pause takes the text over, into a copy of the library’s shader, in one step', async () => {
    const { editor, clock, node, text, typing, steps } = await withSepia();
    const before = filesOf(editor);
    const original = text();
    const stepsBefore = steps();
    typing.type(node, `${original}// a\n`);
    expect(typing.isAhead(node)).toBe(true);
    expect(text()).toBe(original);
    clock.pass(300);
    expect(text()).toBe(`${original}// a\n`);
    expect(Object.keys(editor.document.getState().project.sources)).toEqual(['sepia-2.fs']);
    expect(graphOf(editor.document.getState()).nodes[node]?.type).toBe('filter/sepia-2');
    typing.type(node, `${original}// ab\n`);
    clock.pass(300);
    expect(steps()).toBe(stepsBefore + 1);
    undo(editor);
    expect(filesOf(editor)).toEqual(before);
  });

  test('a chunk is copied into the project and typed there, for all techniques that include it', async () => {
    const { editor, clock, typing, steps } = await withSepia();
    const file = 'chunks/light/strength.glsl';
    const chunk = () => editor.document.getState().library.shader(file);
    const original = chunk();
    expect(original).toContain('lightStrength');
    expect(copyChunk(editor, file)).toBe(true);
    expect(editor.document.getState().project.sources[file]).toBe(original);
    const stepsBefore = steps();
    typing.type(file, `${original}// a\n`);
    expect(typing.isAhead(file)).toBe(true);
    clock.pass(300);
    typing.type(file, `${original}// ab\n`);
    clock.pass(300);
    typing.end();
    expect(chunk()).toBe(`${original}// ab\n`);
    expect(steps()).toBe(stepsBefore + 1);
    undo(editor);
    expect(chunk()).toBe(original);
    undo(editor);
    expect(editor.document.getState().project.sources).toEqual({});
  });

  test('a technique is copied and typed as a filter is', async () => {
    const { editor, clock, node, text, typing } = await withSepia('technique/gooch');
    const original = text();
    typing.type(node, original.replace('"NAME": "highlight"', '"NAME": "shine"').replaceAll('highlight *', 'shine *'));
    clock.pass(300);
    expect(Object.keys(editor.document.getState().project.sources)).toEqual(['gooch-2.glsl']);
    const { library } = editor.document.getState();
    const type = graphOf(editor.document.getState()).nodes[node]?.type ?? '';
    expect(Object.keys(library.definition(type)?.params ?? {})).toEqual(expect.arrayContaining(['coolColor', 'shine']));
  });

  test('a header that is broken while it is typed takes no port and no dial away', async () => {
    const { editor, clock, node, text, typing } = await withSepia();
    typing.type(node, text().replace('"INPUTS"', '"DESCRIPTION2": "x", "INPUTS"'));
    clock.pass(300);
    typing.type(node, text().replace('"INPUTS": [', '"INPUTS": [[['));
    clock.pass(300);
    const { library } = editor.document.getState();
    expect(library.diagnostics.map(({ code }) => code)).toContain('SCR040');
    expect(Object.keys(library.definition('filter/sepia-2')?.inputs ?? {})).toEqual(['inputImage']);
    expect(Object.keys(library.definition('filter/sepia-2')?.params ?? {})).toEqual(['amount']);
  });

  test('a slider in the text is seen at once, and is one step however long it is held', async () => {
    const { editor, node, text, typing, steps } = await withSepia();
    const original = text();
    typing.type(node, `${original}// typed\n`);
    typing.end();
    const before = steps();
    for (const value of ['0.1', '0.2', '0.3']) {
      typing.tune(node, `${original}// ${value}\n`);
      expect(text()).toContain(value);
      // Autosave comes in between.
      filesOf(editor);
    }
    typing.end();
    expect(steps()).toBe(before + 1);
    undo(editor);
    expect(text()).toBe(`${original}// typed\n`);
  });

  test('where the last program was made fast, a key is taken over at once, as one step with the others; a slow one waits as long', async () => {
    const { editor, clock, node, text, typing, steps } = await withSepia();
    const original = text();
    const before = steps();
    editor.compile.setState({ revision: 1, tookMs: 12 });
    for (const letter of ['a', 'ab', 'abc']) {
      typing.type(node, `${original}// ${letter}\n`);
      expect(text()).toBe(`${original}// ${letter}\n`);
    }
    editor.compile.setState({ tookMs: 80 });
    typing.type(node, `${original}// abcd\n`);
    clock.pass(79);
    expect(text()).toBe(`${original}// abc\n`);
    clock.pass(1);
    expect(text()).toBe(`${original}// abcd\n`);
    typing.end();
    expect(steps()).toBe(before + 1);
    undo(editor);
    expect(text()).toBe(original);
  });

  test('a header waits for a rest, however fast programs are made: half a name would take values and wires away', async () => {
    const { editor, clock, node, text, typing } = await withSepia();
    const original = text();
    editor.compile.setState({ revision: 1, tookMs: 1 });
    typing.type(node, original.replace('"amount"', '"am"'));
    expect(text()).toBe(original);
    typing.type(node, original.replace('"amount"', '"amounts"'));
    clock.pass(300);
    expect(text()).toContain('"amounts"');
  });

  test('what is half written is not told of before the keys rest; what is mended is gone at once', async () => {
    const { editor, clock, node, text, typing } = await withSepia();
    const old: Diagnostic = { code: 'SCR041', severity: 'error', file: 'shaders/sepia-2.fs', line: 3, message: 'old' };
    const half: Diagnostic = { ...old, line: 9, message: 'half' };
    typing.type(node, `${text()}//`);
    expect(editor.ui.getState().typing).toBe(true);
    expect(stillWrong([old, half], [old])).toEqual([old]);
    expect(stillWrong([half], [old])).toEqual([]);
    clock.pass(200);
    typing.type(node, `${text()}// a`);
    clock.pass(200);
    expect(editor.ui.getState().typing).toBe(true);
    clock.pass(100);
    expect(editor.ui.getState().typing).toBe(false);
  });

  test('saving takes over what was typed a moment ago', async () => {
    const { editor, node, text, typing } = await withSepia();
    typing.type(node, `${text()}// last words\n`);
    expect(filesOf(editor).sources['sepia-2.fs']).toContain('last words');
    typing.dispose();
    expect(editor.unfinished.size).toBe(0);
  });
});
