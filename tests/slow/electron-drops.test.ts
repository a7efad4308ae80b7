import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, beforeAll, expect, test } from '@jest/globals';
import { dropFiles } from '../support/drop-files.ts';
import { dropModel } from '../support/drop-model.ts';
import { EditorDriver } from '../support/editor-driver.ts';
import { describeElectron, findElectron, openFirstLight, playedTwiceAfterFault } from '../support/electron.ts';
import { texturedModel } from '../support/textured-model.ts';

const SHADER = '/*{ "ISFVSN": "2", "INPUTS": [{ "NAME": "inputImage", "TYPE": "image" }] }*/\nvoid main() { gl_FragColor = vec4(1.0); }\n';

describeElectron('files that are dropped in Electron', await findElectron(), (launch) => {
  let base = '';
  beforeAll(async () => {
    base = await mkdtemp(join(tmpdir(), 'scrim-drops-'));
  });
  afterAll(() => rm(base, { recursive: true, force: true }));

  test('become nodes on the canvas; a model stands on the floor of the picture, also in the window of the preview', async () => {
    const [model, shader] = [join(base, 'ball.glb'), join(base, 'white.fs')];
    await writeFile(model, await texturedModel(64));
    await writeFile(shader, SHADER);
    await playedTwiceAfterFault(launch, async (launchWatched) => {
      const { app, page, errors } = await openFirstLight(launchWatched, join(base, 'project'));
      const editor = new EditorDriver(page);
      await editor.settled();
      const place = await editor.emptyPlace();
      await dropFiles(page, [shader], place);
      const box = await editor.node('white').boundingBox();
      expect(Math.hypot((box?.x ?? 0) - place.x, (box?.y ?? 0) - place.y)).toBeLessThan(40);

      const empty = await editor.rewind();
      await dropModel(page, model, empty);
      await page.locator('.canvas').focus();
      await page.keyboard.press('Control+z');
      await editor.node('transform').waitFor({ state: 'detached' });
      await editor.imageSameAs(empty);

      const popup = await editor.popOut();
      await dropModel(popup, model, await new EditorDriver(popup).restingImage());
      await editor.node('transform').waitFor();
      expect(popup.url()).toBe('about:blank');
      expect(app.windows()).toHaveLength(2);
      expect(errors).toEqual([]);
    });
  });
});
