import { readFile, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { describe, expect, test } from '@jest/globals';
import { centerOf } from '../../tools/lib/center-of.ts';
import { type GraphText, type OpenEditor, saveGraphs, useEditor, useOneEditor } from '../support/open-editor.ts';
import { TINT_SHADER, TINTED } from '../support/tinted.ts';

/** The tinted feed, and a material of the library that nothing shows. */
const GRAPH: GraphText = {
  ...TINTED,
  nodes: { ...TINTED.nodes, 'gooch-aaaa': { type: 'technique/gooch' } },
  places: { ...TINTED.places, 'gooch-aaaa': [260, 160] },
};

/** A ball in one color, which a chunk of the project's own gives. */
const WASHED: GraphText = {
  nodes: {
    'ball-aaaa': { type: 'objects/primitive', params: { shape: 'sphere' } },
    'wash-aaaa': { type: 'technique/wash' },
    'apply-aaaa': { type: 'objects/apply-technique' },
    'scene-aaaa': { type: 'layer/scene' },
    'screen-aaaa': { type: 'output/screen' },
  },
  wires: [
    'ball-aaaa.objects -> apply-aaaa.objects',
    'wash-aaaa.technique -> apply-aaaa.technique',
    'apply-aaaa.objects -> scene-aaaa.objects',
    'scene-aaaa.layer -> screen-aaaa.layer',
  ],
  places: { 'ball-aaaa': [0, 0], 'wash-aaaa': [0, 160], 'apply-aaaa': [240, 0], 'scene-aaaa': [480, 0], 'screen-aaaa': [720, 0] },
  shaders: {
    'wash.glsl':
      '/*{ "DESCRIPTION": "One color." }*/\n#include <paint/wash>\nvec4 surface(const in Surface s) { return vec4(wash(), 1.0); }\n',
    'chunks/paint/wash.glsl': 'vec3 wash() { return vec3(0.1, 0.2, 0.9); }\n',
  },
};

/** The main graph and the shader as they are written, after a save by keys. */
async function saved(open: Pick<OpenEditor, 'page' | 'project'>) {
  const { main } = await saveGraphs(open);
  if (!main) throw new Error('the project has lost its main graph');
  return { ...main, shader: await readFile(join(open.project, 'shaders/tint.fs'), 'utf8') };
}

describe('in one project', () => {
  const open = useOneEditor(GRAPH, {}, async () => {
    await open.editor.settled();
    await open.editor.hold();
  });

  /** The project as it was opened, and the text of its shader. */
  async function start(): Promise<void> {
    const { page, editor } = open;
    await page.locator('.react-flow__pane').click({ position: { x: 20, y: 20 } });
    const close = page.getByRole('button', { name: 'Close the panel' });
    if (await close.isVisible()) await close.click();
    const undo = page.getByRole('button', { name: 'Undo', exact: true });
    while (await undo.isEnabled()) await undo.click();
    await editor.settled();
    await editor.openCode('tint-aaaa');
  }

  describe('the text helps', () => {
    test('completes names, says what a function takes, and explains what the pointer or the caret is on', async () => {
      await start();
      const { page, editor } = open;
      await editor.findInText('vec4 pixel');
      await page.keyboard.press('End');
      await page.keyboard.press('Enter');
      await editor.type('pixel.rgb = pai');
      const suggestions = page.locator('.suggest-widget.visible');
      await suggestions.getByRole('option', { name: /^paint/ }).waitFor();
      await page.keyboard.press('Tab');
      const hints = page.locator('.parameter-hints-widget.visible');
      await hints.getByText('Paints it over.').waitFor();
      await editor.type('pixel.rgb, sha');
      await suggestions.getByRole('option', { name: /^share/ }).waitFor();
      await hints.locator('.parameter.active', { hasText: 'float much' }).waitFor();
      await page.keyboard.press('Tab');
      await page.keyboard.press('End');
      await editor.type(';');
      expect(await editor.lineText()).toBe('  pixel.rgb = paint(pixel.rgb, share);');
      await page.locator('.status-bar').getByText('No problems').waitFor();

      // The members of what stands before a dot, and nothing else.
      await editor.type(' pixel.');
      await suggestions.getByRole('option', { name: /^rgba/ }).waitFor();
      expect(await suggestions.getByRole('option', { name: /^share/ }).count()).toBe(0);
      await page.keyboard.press('Escape');

      await page.locator('.view-line', { hasText: 'vec4(paint' }).getByText('share', { exact: true }).hover();
      const hover = page.locator('.monaco-hover:visible');
      await hover.getByText('How much of the tint.').waitFor();
      expect(await hover.textContent()).toMatch(/Share · float · 0 to 1 · starts at 1/);
    });

    test('marks a mistake where it is: the header’s, the parser’s and the driver’s', async () => {
      await start();
      const { page, editor } = open;
      const mark = page.locator('.monaco-editor .squiggly-error');
      const problems = page.getByRole('list', { name: 'Problems' });
      const broken = async (find: string, typed: string, message: RegExp) => {
        await editor.findInText(find);
        const before = await editor.lineText();
        await editor.type(typed);
        await mark.first().waitFor();
        const line = await editor.lineNumber();
        const text = await editor.lineText();
        await page.getByRole('button', { name: 'Problems' }).click();
        const problem = problems.getByRole('button', { name: message }).first();
        expect(await problem.textContent()).toContain(`shaders/tint.fs:${line}`);
        // It leads to the very place.
        await problem.click();
        await page.locator('.monaco-editor.focused').waitFor();
        expect([await editor.lineNumber(), await editor.lineText()]).toEqual([line, text]);
        // Not farther: the text remembers what other tests have typed.
        do await page.keyboard.press('Control+z');
        while ((await editor.lineText()) !== before);
        await mark.first().waitFor({ state: 'detached' });
      };
      await broken('"MIN"', '} ', /must be an object/);
      await broken('color, vec3', ') ', /missing/);
      await broken('pixel.a)', 'q', /undeclared/);
    });

    test('leads to declarations and to chunks, which are to be read; and back', async () => {
      await start();
      const { page, editor } = open;
      await editor.findInText('paint(pixel');
      await page.keyboard.press('F12');
      const declared = 'vec3 paint(vec3 color, float much) {';
      await page.waitForFunction(() => document.querySelector('.monaco-editor .active-line-number')?.textContent === '9');
      expect(await editor.lineText()).toBe(declared);

      await editor.node('gooch-aaaa').locator('.node-title').click();
      await page.locator('.view-line', { hasText: 'Gooch' }).first().waitFor();
      await editor.findInText('strongestLight(s)');
      await page.keyboard.press('F12');
      await page.getByText('This library chunk is read-only.').waitFor();
      expect(await page.locator('.code-bar code').textContent()).toBe('chunks/light/strongest.glsl');
      const before = await editor.lineText();
      expect(before).toContain('strongestLight');
      await editor.type('x');
      await page
        .getByText(/materials of the library share this chunk/)
        .first()
        .waitFor();
      expect(await editor.lineText()).toBe(before);
      await editor.press('Back to the shader');
      await page.locator('.view-line', { hasText: 'strongestLight(s)' }).waitFor();
    });
  });

  describe('one step each', () => {
    test('an input renamed in the code is renamed in the header, and keeps its wire; undo takes all of it back', async () => {
      await start();
      const { page, editor } = open;
      await editor.findInText('share * 0.50');
      await page.keyboard.press('F2');
      await page.locator('.rename-box input:focus').fill('strength');
      await page.keyboard.press('Enter');
      await page.locator('.view-line', { hasText: 'strength * 0.50' }).waitFor();
      await editor.settled();
      await editor.port('tint-aaaa', 'strength', 'target').waitFor({ state: 'attached' });
      const renamed = await saved(open);
      expect(renamed.wires).toContain('number-aaaa.number -> tint-aaaa.strength');
      expect(renamed.shader).toContain('"NAME": "strength"');
      expect(renamed.shader).not.toContain('share *');

      await editor.node('screen-aaaa').locator('.node-title').click();
      await page.keyboard.press('Control+z');
      await editor.port('tint-aaaa', 'share', 'target').waitFor({ state: 'attached' });
      const undone = await saved(open);
      expect(undone.shader).toBe(TINT_SHADER);
      expect([...undone.wires].sort()).toEqual([...TINTED.wires].sort());
    });

    test('a number dragged with Alt, and a color by sliders, change the picture while they move', async () => {
      await start();
      const { page, editor } = open;
      const before = await editor.rewind();
      await editor.findInText('share * 0.50');
      const number = page.locator('.view-line', { hasText: 'share * ' }).getByText('0.50', { exact: true });
      await number.hover();
      const from = await centerOf(number);
      await page.keyboard.down('Alt');
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      await page.mouse.move(from.x - 60, from.y, { steps: 6 });
      // Still held: the picture has changed already.
      const meanwhile = await editor.imageOtherThan(before);
      await page.mouse.move(from.x - 120, from.y, { steps: 6 });
      await page.mouse.up();
      await page.keyboard.up('Alt');
      await page.locator('.view-line', { hasText: 'share * 0.10' }).waitFor();
      await editor.imageOtherThan(meanwhile);
      expect((await saved(open)).shader).toContain('share * 0.10');
      await editor.node('screen-aaaa').locator('.node-title').click();
      await page.keyboard.press('Control+z');
      await editor.node('tint-aaaa').locator('.node-title').click();
      await page.locator('.view-line', { hasText: 'share * 0.50' }).waitFor();
      await editor.imageSameAs(before, 'drag undone');

      // By keys alone.
      await editor.findInText('vec3(0.1');
      await page.keyboard.press('Alt+Enter');
      const red = page.getByRole('slider', { name: 'Red' });
      await page.waitForFunction(() => document.activeElement?.getAttribute('aria-label') === 'Red');
      await red.press('End');
      await page.locator('.view-line', { hasText: 'vec3(1.0, 0.2, 0.9)' }).waitFor();
      await editor.imageOtherThan(before);
      await page.keyboard.press('Escape');
      await red.waitFor({ state: 'detached' });
      await page.locator('.monaco-editor.focused').waitFor();
      await page.keyboard.press('Control+z');
      await page.locator('.view-line', { hasText: 'vec3(0.1, 0.2, 0.9)' }).waitFor();
      await editor.imageSameAs(before, 'color undone');
    });

    test('the header’s form and its JSON are one: an input added, named, ranged and taken away', async () => {
      await start();
      const { page, editor } = open;
      await editor.press('Header form');
      const form = page.getByRole('region', { name: 'Header' });
      await form.getByRole('button', { name: /^Add input/ }).click();
      await editor.inspector.getByRole('textbox', { name: 'Amount' }).waitFor();
      const name = form.getByRole('textbox', { name: 'Name' });
      await name.fill('glow');
      await name.press('Enter');
      await form.getByRole('textbox', { name: 'Label' }).fill('Glow');
      await form.getByRole('textbox', { name: 'Max' }).fill('4');
      await form.getByRole('textbox', { name: 'Max' }).press('Enter');
      await editor.inspector.getByRole('textbox', { name: 'Glow' }).waitFor();
      expect((await saved(open)).shader).toContain(
        '{ "NAME": "glow", "TYPE": "float", "LABEL": "Glow", "MIN": 0, "MAX": 4, "DEFAULT": 0.5 }\n  ]',
      );
      // What is typed in the JSON shows in the form, and a broken one says so and changes nothing.
      await editor.findInText('Glow", "MIN"');
      await editor.type('er');
      await form
        .getByText(/cannot be read/)
        .or(form.locator('input[value*="er"]'))
        .first()
        .waitFor();
      await page.keyboard.press('Control+z');
      await form.getByRole('button', { name: 'Remove glow' }).click();
      await editor.inspector.getByRole('textbox', { name: 'Glow' }).waitFor({ state: 'detached' });
      expect((await saved(open)).shader).toBe(TINT_SHADER);
      await editor.press('Header form');
    });

    test('Shift+Alt+F lays the text out, and changes nothing else', async () => {
      await start();
      const { page, editor } = open;
      await editor.findInText('vec4 pixel');
      await page.keyboard.press('End');
      await editor.type(' if(pixel.a<0.5){pixel*=2.0 ;}');
      await page.keyboard.press('Shift+Alt+F');
      await page.locator('.view-line', { hasText: 'if (pixel.a < 0.5) { pixel *= 2.0; }' }).waitFor();
      await page.locator('.status-bar').getByText('No problems').waitFor();
    });
  });
});

describe('in projects of their own', () => {
  const openEditor = useEditor();

  async function start(graph: GraphText, node: string): Promise<OpenEditor> {
    const open = await openEditor(graph);
    await open.editor.settled();
    await open.editor.openCode(node);
    return open;
  }

  test('a chunk of the project changes the picture, from outside and here, and its mistakes are marked in it', async () => {
    const { page, editor, project } = await start(WASHED, 'wash-aaaa');
    const chunk = join(project, 'shaders/chunks/paint/wash.glsl');
    const blue = await editor.rewind();
    await editor.findInText('wash()');
    await page.keyboard.press('F12');
    const bar = page.locator('.code-bar');
    await bar.getByText('chunks/paint/wash.glsl').waitFor();
    await bar.getByText(/^Changes apply to every material/).waitFor();
    await page.locator('.monaco-editor.focused').waitFor();
    expect(await editor.lineText()).toBe('vec3 wash() { return vec3(0.1, 0.2, 0.9); }');

    // Another program saves it: it plays, and is read only here.
    await writeFile(chunk, 'vec3 wash() { return vec3(0.9, 0.2, 0.1); }\n');
    await bar.getByText('This chunk was saved by another program').waitFor();
    await page.locator('.view-line', { hasText: 'vec3(0.9, 0.2, 0.1)' }).waitFor();
    const red = await editor.imageOtherThan(blue, 300);
    await editor.findInText('vec3(0.9');
    await editor.type('7');
    expect(await editor.lineText()).toBe('vec3 wash() { return vec3(0.9, 0.2, 0.1); }');

    // Here, it is typed again; a mistake is marked where it is, and the last good one plays on.
    await editor.press('Edit here');
    await bar.getByText(/^Changes apply to every material/).waitFor();
    await editor.findInText('vec3(0.9');
    await editor.type('w');
    await page.locator('.monaco-editor .squiggly-error').first().waitFor();
    await editor.press('Back to the shader');
    await page.locator('.view-line', { hasText: 'vec4(wash()' }).waitFor();
    await page.getByRole('button', { name: 'Problems' }).click();
    const problems = page.getByRole('list', { name: 'Problems' });
    await problems
      .getByRole('button', { name: /chunks\/paint\/wash\.glsl:1/ })
      .first()
      .click();
    await page.locator('.monaco-editor.focused').waitFor();
    expect(await editor.lineText()).toBe('vec3 wash() { return wvec3(0.9, 0.2, 0.1); }');
    await editor.imageSameAs(red, 'broken chunk');
    await editor.findInText('wvec3');
    await page.keyboard.press('Delete');
    await page.locator('.monaco-editor .squiggly-error').first().waitFor({ state: 'detached' });
    await editor.findInText('0.9, 0.2');
    await page.keyboard.press('Delete');
    await editor.type('1');
    await editor.imageOtherThan(red, 300);
  });

  test('a shader of the library is copied with one press, compared with the original, and reverted', async () => {
    const { page, editor } = await start(
      {
        nodes: {
          'video-aaaa': { type: 'source/camera-video' },
          'sepia-aaaa': { type: 'filter/sepia' },
          'screen-aaaa': { type: 'output/screen' },
        },
        wires: ['video-aaaa.layer -> sepia-aaaa.inputImage', 'sepia-aaaa.layer -> screen-aaaa.layer'],
        places: { 'video-aaaa': [0, 0], 'sepia-aaaa': [260, 0], 'screen-aaaa': [520, 0] },
      },
      'sepia-aaaa',
    );
    const before = await editor.rewind();
    await editor.press('Copy into project');
    await page.getByText('shaders/sepia-2.fs').waitFor();
    expect(await page.getByRole('button', { name: 'Revert', exact: true }).isDisabled()).toBe(true);
    await editor.findInText('gl_FragColor');
    await page.keyboard.press('End');
    await editor.type(' gl_FragColor.r = 0.0;');
    await editor.imageOtherThan(before);
    await editor.press('Compare with original');
    await page.locator('.code-compare .line-insert').first().waitFor();
    await editor.press('Stop comparing');
    await page.locator('.code-compare').waitFor({ state: 'detached' });
    await editor.press('Revert');
    await editor.imageSameAs(before, 'reverted');
    expect(await page.getByRole('button', { name: 'Compare with original' }).isDisabled()).toBe(true);
  });

  test('a shader that another program saves plays at once, and is read only here until it is taken back', async () => {
    const { page, editor, project } = await start(TINTED, 'tint-aaaa');
    const blue = await editor.rewind();
    const write = (text: string) => writeFile(join(project, 'shaders/tint.fs'), text);
    const red = TINT_SHADER.replace('vec3(0.1, 0.2, 0.9)', 'vec3(0.9, 0.2, 0.1)');
    await write(red);
    await page.locator('.code-bar-outside').waitFor();
    await page.locator('.view-line', { hasText: 'vec3(0.9, 0.2, 0.1)' }).waitFor();
    const painted = await editor.imageOtherThan(blue);
    expect(await page.locator('.unsaved').count()).toBe(0);

    // Nothing can be typed, by text, form or slider.
    await editor.findInText('0.9, 0.2');
    await editor.type('7');
    await page.keyboard.press('Alt+Enter');
    expect(await editor.lineText()).toBe('  return mix(color, vec3(0.9, 0.2, 0.1), much);');
    expect(await page.locator('.tuner').count()).toBe(0);
    // What says so lies over the text, and takes no press from it.
    await editor.type('7');
    const { x, y } = await centerOf(page.locator('.monaco-editor-overlaymessage', { hasText: 'another program saved this file' }));
    await page.mouse.click(x, y);
    expect(await page.locator('.monaco-editor.focused').count()).toBe(1);

    // A broken one is marked, and the last good one plays on.
    await write(red.replace('much);', 'munch);'));
    await page.locator('.monaco-editor .squiggly-error').first().waitFor();
    await editor.imageSameAs(painted, 'broken outside');
    await write(red);
    await page.locator('.monaco-editor .squiggly-error').first().waitFor({ state: 'detached' });

    await editor.press('Edit here');
    await page.locator('.code-bar-outside').waitFor({ state: 'detached' });
    // Keys go to the text at once.
    expect(await page.locator('.monaco-editor.focused').count()).toBe(1);
    await editor.findInText('vec3(0.9');
    await page.keyboard.press('End');
    await editor.type(' // here');
    await page.locator('.unsaved').waitFor();
    // Now both have changed it: the person is asked.
    await write(`${red}// there\n`);
    await page.getByRole('dialog', { name: 'Project changed on disk' }).waitFor();
  });
});
