import { useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../shell/editor-context.ts';
import { useFeed } from '../shell/feed-context.ts';
import { useKeys } from '../shell/use-keys.ts';
import { runCommand } from '../state/app-commands.ts';
import { chosenSource, type DeviceFrame, type PreviewTier } from '../state/preview.ts';
import { IconButton } from '../ui/button.tsx';
import { ContextMenu } from '../ui/context-menu.tsx';
import type { MenuItem } from '../ui/menu.tsx';

const FRAMES: readonly (readonly [DeviceFrame, string])[] = [
  ['fill', 'As large as there is room'],
  ['phone', 'Phone, upright'],
  ['phone-wide', 'Phone, sideways'],
  ['headset', 'Headset'],
  ['glasses', 'See-through glasses'],
];

const TIERS: readonly (readonly [PreviewTier, string])[] = [
  ['ar-camera', 'AR that gives the camera’s picture'],
  ['ar', 'AR that keeps the camera’s picture'],
  ['vr', 'VR, without the room'],
];

/** Pictures and videos of the preview, and the device that it shows. */
export function StageMenu() {
  const editor = useEditor();
  const feed = useFeed();
  const { preview } = editor;
  const frame = useStore(preview, (state) => state.frame);
  const tier = useStore(preview, (state) => state.tier);
  const recording = useStore(preview, (state) => state.recording);
  const isRoom = useStore(preview, (state) => chosenSource(state)?.kind === 'room');
  const probing = useStore(editor.look, (look) => look.probing);
  const probeKeys = useKeys('view.probe');
  const button = useRef<HTMLSpanElement>(null);
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  const record = (on: boolean) => {
    preview.setState({ recording: on });
    feed.send({ kind: 'record', on });
  };
  const items: MenuItem[] = [
    { kind: 'action', label: 'Take a screenshot', run: () => feed.send({ kind: 'screenshot' }) },
    { kind: 'action', label: recording ? 'Stop recording' : 'Record a video', run: () => record(!recording) },
    { kind: 'line' },
    ...FRAMES.map(
      ([name, label]): MenuItem => ({
        kind: 'action',
        label,
        checked: frame === name,
        run: () => preview.setState({ frame: name, views: name === 'headset' ? 2 : 1 }),
      }),
    ),
    ...(isRoom ? tierItems(tier, (next) => preview.setState({ tier: next })) : []),
  ];
  return (
    <>
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

function tierItems(chosen: PreviewTier, choose: (tier: PreviewTier) => void): MenuItem[] {
  return [
    { kind: 'line' },
    ...TIERS.map(([tier, label]): MenuItem => ({ kind: 'action', label, checked: chosen === tier, run: () => choose(tier) })),
  ];
}
