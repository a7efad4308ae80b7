import { useRef, useState } from 'react';
import { useStore } from 'zustand';
import type { PreviewTier } from '../preview-protocol.ts';
import { runCommand } from '../state/commands/app-commands.ts';
import { RENDER_SIZE_WORDS } from '../state/commands/command-actions.ts';
import { commandItem, useKeys } from '../state/commands/command-item.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { RENDER_SIZES } from '../state/editor/preferences.ts';
import { chosenSource, type PreviewState } from '../state/editor/preview-state.ts';
import { usePreviewSync } from '../state/preview-sync/preview-sync-context.ts';
import { IconButton } from '../ui/button.tsx';
import { ContextMenu } from '../ui/context-menu.tsx';
import type { MenuItem } from '../ui/menu.tsx';

const TIERS: readonly (readonly [PreviewTier, string])[] = [
  ['ar-camera', 'AR with camera access'],
  ['ar', 'AR without camera access'],
  ['vr', 'VR'],
];

/** Preview menu: screenshot, recording, pixel probe, safe areas, render size and tier. */
export function PreviewMenu() {
  const editor = useEditor();
  const previewSync = usePreviewSync();
  const { preview } = editor;
  const renderSize = useStore(editor.preferences, (state) => state.renderSize);
  const tier = useStore(preview, (state) => state.tier);
  const recording = useStore(preview, (state) => state.recording);
  const sessionRecording = useStore(preview, (state) => state.sessionRecording);
  const isRoom = useStore(preview, (state) => chosenSource(state)?.kind === 'room');
  const probing = useStore(editor.viewer, (viewer) => viewer.probing);
  const probeKeys = useKeys('view.probe');
  const button = useRef<HTMLSpanElement>(null);
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  const record = (on: boolean) => {
    preview.setState({ recording: on });
    previewSync.send({ kind: 'record', on });
  };
  const items: MenuItem[] = [
    { kind: 'action', label: 'Take screenshot', run: () => previewSync.send({ kind: 'screenshot' }) },
    commandItem(editor, 'preview.keep-image'),
    commandItem(editor, 'preview.poster'),
    { kind: 'action', label: recording ? 'Stop recording' : 'Record video', run: () => record(!recording) },
    sessionItem(sessionRecording, () => runCommand(editor, 'play.record')),
    { kind: 'line' },
    commandItem(editor, 'preview.safe-areas'),
    { kind: 'line' },
    ...RENDER_SIZES.map(
      (size): MenuItem => ({
        kind: 'action',
        label: RENDER_SIZE_WORDS[size],
        checked: renderSize === size,
        radio: true,
        run: () => editor.preferences.setState({ renderSize: size }),
      }),
    ),
    ...(isRoom ? tierItems(tier, (next) => preview.setState({ tier: next, deviceKind: null })) : []),
  ];
  return (
    <>
      {sessionRecording === 'recording' && (
        <IconButton icon="stop" label="Stop recording the session" onPress={() => runCommand(editor, 'play.record')} />
      )}
      {recording && <IconButton icon="stop" label="Stop recording" onPress={() => record(false)} />}
      <IconButton icon="probe" label="Pixel probe" keys={probeKeys} pressed={probing} onPress={() => runCommand(editor, 'view.probe')} />
      <span ref={button}>
        <IconButton
          icon="more"
          label="Preview options"
          onPress={() => {
            const box = button.current?.getBoundingClientRect();
            if (box) setAt({ x: box.left, y: box.bottom + 4 });
          }}
        />
      </span>
      {at && <ContextMenu label="Preview options" at={at} items={items} onClose={() => setAt(null)} />}
    </>
  );
}

function sessionItem(state: PreviewState['sessionRecording'], run: () => void): MenuItem {
  const label = { no: 'Record session', recording: 'Stop recording the session', filming: 'Making the images of the session…' }[state];
  return { kind: 'action', label, run, disabled: state === 'filming' };
}

function tierItems(chosen: PreviewTier, choose: (tier: PreviewTier) => void): MenuItem[] {
  return [
    { kind: 'line' },
    ...TIERS.map(([tier, label]): MenuItem => ({ kind: 'action', label, checked: chosen === tier, radio: true, run: () => choose(tier) })),
  ];
}
