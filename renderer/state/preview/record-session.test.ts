import { describe, expect, test } from '@jest/globals';
import { openTestEditor } from '../../../tests/support/test-editor.ts';
import { appCommand, runCommand } from '../commands/app-commands.ts';
import { saveRecordedSession } from './record-session.ts';

const ROOM = { id: 'room/studio', title: 'Studio', kind: 'room', url: null } as const;
const EARLIER = { id: 'project/recording-4', title: 'Recording 4', kind: 'recorded', url: 'http://127.0.0.1:1/4/' } as const;
const RECORDED = { session: '{}', files: [{ path: 'color/000000.jpg', bytes: 1 }], content: Uint8Array.of(7) };

/** An editor over an emulated room, and the messages to its preview. */
async function overRoom() {
  const { editor, host } = await openTestEditor();
  editor.preview.setState({ sources: [ROOM, EARLIER], sourceId: ROOM.id });
  const posted: unknown[] = [];
  editor.transport.post = (message) => posted.push(message);
  const state = () => editor.preview.getState().sessionRecording;
  const texts = () => editor.ui.getState().toasts.map(({ tone, text }) => `${tone}: ${text}`);
  const saves = () => host.calls.filter(({ method }) => method === 'session.save');
  return { editor, host, posted, state, texts, saves };
}

describe('recording a session', () => {
  test('goes on until it is stopped, is saved with the project, and becomes a source', async () => {
    const { editor, host, posted, state, texts, saves } = await overRoom();
    host.answer('session.save', () => ({ id: 'project/recording-5' }));
    host.answer('session.list', () => [ROOM, { ...EARLIER, id: 'project/recording-5', title: 'Recording 5' }]);
    runCommand(editor, 'play.record');
    expect(state()).toBe('recording');
    runCommand(editor, 'play.record');
    expect([state(), appCommand('play.record').enabled(editor)]).toEqual(['filming', false]);
    expect(posted).toEqual([
      { kind: 'record-session', on: true, title: 'Recording 5' },
      { kind: 'record-session', on: false, title: 'Recording 5' },
    ]);
    await saveRecordedSession(editor, { kind: 'session-recorded', recorded: RECORDED, text: '' });
    expect(saves()).toMatchObject([{ input: RECORDED }]);
    expect(texts()).toEqual(['success: Recorded “Recording 5”. Choose it as the preview source to replay it.']);
    expect([state(), editor.preview.getState().sourceId]).toEqual(['no', ROOM.id]);
  });

  test('is offered once there is a source', async () => {
    const { editor } = await overRoom();
    const canRecord = () => appCommand('play.record').enabled(editor);
    expect(canRecord()).toBe(true);
    editor.preview.setState({ sourceId: 'orbit' });
    expect(canRecord()).toBe(true);
    editor.preview.setState({ sources: [], sourceId: null });
    expect(canRecord()).toBe(false);
    editor.preview.setState({ sessionRecording: 'recording' });
    expect(canRecord()).toBe(true);
  });

  test('tells why nothing was recorded, and that it could not be saved', async () => {
    const { editor, host, state, texts, saves } = await overRoom();
    runCommand(editor, 'play.record');
    await saveRecordedSession(editor, { kind: 'session-recorded', recorded: null, text: 'Nothing was recorded.' });
    expect([state(), saves()]).toEqual(['no', []]);
    runCommand(editor, 'play.record');
    host.refuse('session.save', 'SCR062', 'The disk is full.');
    await saveRecordedSession(editor, { kind: 'session-recorded', recorded: RECORDED, text: '' });
    expect(state()).toBe('no');
    expect(texts()).toEqual(['error: Nothing was recorded.', 'error: The disk is full.']);
  });

  test('writes nothing that was not asked for, as of the project before', async () => {
    const { editor, texts, saves } = await overRoom();
    await saveRecordedSession(editor, { kind: 'session-recorded', recorded: RECORDED, text: '' });
    expect([saves(), texts()]).toEqual([[], []]);
  });
});
