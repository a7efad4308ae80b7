import { useStore } from 'zustand';
import { appCommand } from '../state/commands/app-commands.ts';
import { resetKeybindings } from '../state/commands/keybindings.ts';
import { MENUS } from '../state/commands/menus.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { Button, IconButton } from '../ui/button.tsx';
import { Dialog } from '../ui/dialog.tsx';
import { ShortcutRow } from './shortcut-row.tsx';
import './shortcuts-dialog.css';

type Rows = readonly (readonly [what: string, how: string])[];

/** Keys that only one part of the window has, and that cannot be changed. */
const PARTS: readonly { readonly title: string; readonly rows: Rows }[] = [
  {
    title: 'Palette and lists',
    rows: [
      ['Go to an entry', 'Arrow keys, or letters of its name'],
      ['Choose it', 'Enter'],
      ['Back to the image before', 'Escape'],
      ['Favorite of the palette', 'Ctrl+D'],
    ],
  },
  {
    title: 'Inspector',
    rows: [
      ['Change a slider', 'Arrow keys; Shift for fine steps, Ctrl snaps'],
      ['Move a point of a curve or gradient', 'Arrow keys'],
      ['Remove it', 'Delete'],
    ],
  },
];

const POINTER: Rows = [
  ['Select several', 'Drag on the canvas, or Shift-click'],
  ['Pan', 'Middle button, Space-drag, or two fingers'],
  ['Zoom', 'Wheel or pinch. View > Wheel and trackpad sets what scrolling does'],
  ['Add a node', 'Double-click, or drop a wire on the canvas'],
  ['Insert a node into a wire', 'Drag it onto the wire, or select the wire and press Tab'],
  ['Reroute a wire', 'Double-click it and drag the point; drag the knob beside it to add wires'],
  ['Open a subgraph', 'Double-click it; on its title, that renames it'],
  ['Move a frame and its contents', 'Drag its title bar'],
  ['Disconnect a wire', 'Drag its end off the port'],
  ['Change a number', 'Drag it sideways; Shift for fine steps, Ctrl snaps'],
  ['Bind a number to an expression', 'Type = and the expression: =sin(time) * 2'],
];

export function ShortcutsDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const changed = useStore(editor.preferences, ({ keybindings }) => Object.keys(keybindings).length > 0);
  return (
    <Dialog title="Keyboard and pointer shortcuts" onClose={onClose} wide>
      {/* First in order, so that keyboard users can scroll from the top. */}
      <span className="shortcuts-close">
        <IconButton icon="close" label="Close" onPress={onClose} />
      </span>
      <p>Press a keybinding to change it. {changed && <Button onPress={() => resetKeybindings(editor)}>Reset keybindings</Button>}</p>
      <div className="shortcuts">
        {MENUS.map(({ label, entries }) => (
          <section key={label}>
            <h3>
              {entries.some((id) => id !== 'line' && appCommand(id).where === 'time')
                ? `${label}: over the preview and the timeline`
                : label}
            </h3>
            <dl>{entries.map((id) => id !== 'line' && <ShortcutRow key={id} id={id} />)}</dl>
          </section>
        ))}
      </div>
      <div className="shortcuts shortcuts-pointer">
        {[...PARTS, { title: 'Pointer and touch', rows: POINTER }].map(({ title, rows }) => (
          <section key={title}>
            <h3>{title}</h3>
            <dl>
              {rows.map(([what, how]) => (
                <div key={what}>
                  <dt>{what}</dt>
                  <dd>{how}</dd>
                </div>
              ))}
            </dl>
          </section>
        ))}
      </div>
    </Dialog>
  );
}
