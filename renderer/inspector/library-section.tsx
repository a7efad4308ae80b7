import { type DragEvent, useRef, useState } from 'react';
import { subgraphType } from '../../export/graph/document-names.ts';
import { PortMark } from '../canvas/port-mark.tsx';
import { appCommand } from '../state/commands/app-commands.ts';
import { useKeys } from '../state/commands/command-item.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { titleOfName } from '../state/editor/library.ts';
import { mainType } from '../state/graph/node-shape.ts';
import {
  addFromLibrary,
  librarySubgraphs,
  NODE_TYPE_DRAG,
  removeFromLibrary,
  usesInWords,
  usesOfSubgraph,
} from '../state/graph/subgraph-library.ts';
import { openSubgraph } from '../state/graph/subgraphs.ts';
import { IconButton } from '../ui/button.tsx';
import { ContextMenu } from '../ui/context-menu.tsx';
import type { MenuItem } from '../ui/menu.tsx';
import './library-section.css';

/** Subgraphs in the library of the project, to add as nodes, open, rename and remove. */
export function LibrarySection() {
  const project = useDocument((state) => state.project);
  const names = librarySubgraphs(project);
  const keys = useKeys('graph.subgraph');
  return (
    <section className="inspector-section" aria-label="Library">
      <h3>Project library</h3>
      {names.length === 0 ? (
        <p className="inspector-note">
          The library lists the subgraphs of this project. To create one, select nodes and{' '}
          {keys === undefined ? (
            `choose ${appCommand('graph.subgraph').label}`
          ) : (
            <>
              press <kbd>{keys}</kbd>
            </>
          )}
          .
        </p>
      ) : (
        <ul className="library-list">
          {names.map((name) => (
            <Row key={name} name={name} />
          ))}
        </ul>
      )}
    </section>
  );
}

function Row({ name }: { readonly name: string }) {
  const editor = useEditor();
  const row = useRef<HTMLLIElement>(null);
  const [menuAt, setMenuAt] = useState<{ readonly x: number; readonly y: number } | null>(null);
  const definition = useDocument(({ library }) => library.definition(subgraphType(name)));
  const uses = useDocument(({ project }) => usesOfSubgraph(project, name).reduce((sum, { nodes }) => sum + nodes, 0));
  const where = useDocument(({ project }) => usesInWords(project, name));
  const title = titleOfName(name);
  const type = definition && mainType(definition);
  const items: MenuItem[] = [
    { kind: 'action', label: 'Open', run: () => openSubgraph(editor, name) },
    { kind: 'action', label: 'Rename…', run: () => editor.ui.setState({ dialog: { kind: 'library', name, rename: true } }) },
    { kind: 'line' },
    uses === 0
      ? { kind: 'action', label: 'Remove', run: () => void removeFromLibrary(editor, name) }
      : { kind: 'action', label: 'Remove…', run: () => editor.ui.setState({ dialog: { kind: 'library-remove', name } }) },
  ];
  const onDragStart = (event: DragEvent) => {
    event.dataTransfer.setData(NODE_TYPE_DRAG, subgraphType(name));
    event.dataTransfer.effectAllowed = 'copy';
  };
  return (
    <li
      ref={row}
      className="library-row"
      draggable
      onDragStart={onDragStart}
      onContextMenu={(event) => {
        event.preventDefault();
        setMenuAt({ x: event.clientX, y: event.clientY });
      }}
    >
      {type && <PortMark type={type} />}
      <span className="library-title" data-tip={where === null ? 'Not used.' : `Used by ${where}.`}>
        {title}
      </span>
      <span className="library-uses">{uses === 0 ? 'not used' : `${uses}×`}</span>
      <IconButton
        icon="add"
        label={`Add ${title} to the graph`}
        small
        onPress={() => void addFromLibrary(editor, subgraphType(name), editor.canvas.getState().middle())}
      />
      <IconButton
        icon="more"
        label={`More actions for ${title}`}
        small
        onPress={() => {
          const box = row.current?.getBoundingClientRect();
          setMenuAt({ x: box?.right ?? 0, y: box?.bottom ?? 0 });
        }}
      />
      {menuAt && (
        <ContextMenu
          label={`Actions for ${title}`}
          at={menuAt}
          items={items}
          onClose={() => {
            setMenuAt(null);
            row.current?.querySelector<HTMLElement>('button:last-of-type')?.focus();
          }}
        />
      )}
    </li>
  );
}
