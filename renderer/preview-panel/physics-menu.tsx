import { useRef, useState } from 'react';
import { useStore } from 'zustand';
import { useEditor } from '../state/editor/editor-context.ts';
import type { PhysicsChoice } from '../state/editor/preview-state.ts';
import { usePreviewSync } from '../state/preview-sync/preview-sync-context.ts';
import { IconButton } from '../ui/button.tsx';
import { ContextMenu } from '../ui/context-menu.tsx';
import type { MenuItem } from '../ui/menu.tsx';

/** Physics menu of the preview, if the program simulates bodies: its own transport, and what is shown of it. */
export function PhysicsMenu() {
  const { preview, compile, selection } = useEditor();
  const previewSync = usePreviewSync();
  const hasWorld = useStore(compile, ({ program }) => program?.operations.some(isWorld) ?? false);
  const physics = useStore(preview, (state) => state.physics);
  const selected = useStore(selection, ({ nodes }) => nodes);
  const button = useRef<HTMLSpanElement>(null);
  const [at, setAt] = useState<{ x: number; y: number } | null>(null);
  if (!hasWorld) return null;
  const choose = (choice: Partial<PhysicsChoice>) => preview.setState({ physics: { ...physics, ...choice } });
  const { paused, showsBodies, showsVoxels } = physics;
  const nodes = [...selected];
  const items: MenuItem[] = [
    { kind: 'action', label: paused ? 'Continue physics' : 'Pause physics', run: () => choose({ paused: !paused }) },
    {
      kind: 'action',
      label: 'Next step of physics',
      run: () => {
        choose({ paused: true });
        previewSync.send({ kind: 'physics', action: 'step' });
      },
    },
    { kind: 'action', label: 'Reset bodies', run: () => previewSync.send({ kind: 'physics', action: 'reset' }) },
    {
      kind: 'action',
      label: nodes.length > 0 ? 'Drop selected bodies again' : 'Drop all bodies again',
      run: () => previewSync.send({ kind: 'physics-drop', nodes }),
    },
    { kind: 'line' },
    { kind: 'action', label: 'Show shapes of bodies', checked: showsBodies, run: () => choose({ showsBodies: !showsBodies }) },
    { kind: 'action', label: 'Show room voxels', checked: showsVoxels, run: () => choose({ showsVoxels: !showsVoxels }) },
  ];
  return (
    <>
      <span ref={button}>
        <IconButton
          icon="weight"
          label="Physics"
          pressed={paused}
          onPress={() => {
            const box = button.current?.getBoundingClientRect();
            if (box) setAt({ x: box.left, y: box.bottom + 4 });
          }}
        />
      </span>
      {at && <ContextMenu label="Physics" at={at} items={items} onClose={() => setAt(null)} />}
    </>
  );
}

const isWorld = (operation: object) => 'type' in operation && operation.type === 'physics/world';
