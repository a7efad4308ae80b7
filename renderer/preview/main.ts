import { createBrowserClock } from '../../export/runtime/clock.ts';
import { waitForEditor } from './connect.ts';
import { createModelDrawer } from './draw-model.ts';
import { watchFileDrags } from './file-drags.ts';
import { createFrameRender } from './frame-render.ts';
import { createPhotographs } from './photographs.ts';
import { createPreviewController } from './preview-controller.ts';
import { createRephotographs } from './rephotographs.ts';

async function main(): Promise<void> {
  const screen = document.getElementById('room');
  const sensorHint = document.getElementById('sensor-hint');
  if (!screen || !sensorHint) throw new Error('The page has no #room or #sensor-hint.');
  const editor = await waitForEditor(window);
  const controller = createPreviewController({ parent: document.body, screen, sensorHint, clock: createBrowserClock(), send: editor.send });
  window.addEventListener('resize', controller.resized);
  watchFileDrags(window, editor.send);
  const frameRender = createFrameRender(editor.send);
  const photographs = createPhotographs(editor.send);
  const rephotographs = createRephotographs(editor.send);
  const models = createModelDrawer(editor.send);
  editor.listen((message) => {
    if ([frameRender, photographs, rephotographs, models].some((work) => work.receive(message))) return;
    controller.receive(message);
  });
  editor.send({ kind: 'ready' });
}

void main();
