import { type KeyboardEvent, useEffect, useId, useMemo, useRef, useState } from 'react';
import type { NodeDefinition } from '../../nodes/kit/definition.ts';
import { WIRE_TYPES, type WireType } from '../../nodes/kit/wire-types.ts';
import { uiScale } from '../ui/appearance.ts';
import { IconButton } from '../ui/button.tsx';
import { DocText } from '../ui/doc-text.tsx';
import { Icon } from '../ui/icon.tsx';
import './palette.css';
import { useStore } from 'zustand';
import { showKeybinding } from '../state/commands/show-keybinding.ts';
import type { OpenEnd } from '../state/editor/canvas-state.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { toggleFavorite } from '../state/editor/preferences.ts';
import { mainType } from '../state/graph/node-shape.ts';
import { paletteImageOf } from '../state/graph/palette-images.ts';
import { categoryOf, type ListedEntry, listPalette, type PaletteEntry, searchPalette } from '../state/graph/palette-search.ts';
import { PortMark } from './port-mark.tsx';

interface PaletteProps {
  readonly definitions: readonly NodeDefinition[];
  /** The free end of a wire, if the palette was opened by dropping one. */
  readonly end: OpenEnd | null;
  /** Where the palette opens, in client pixels; clamped to the window. */
  readonly at: { readonly x: number; readonly y: number };
  /** What is searched for at first. */
  readonly query: string;
  /** Label of the category that is listed first. */
  readonly first: string | null;
  /** Placeholder of the search field; null when the choice adds a plain new node. */
  readonly purpose?: string | null;
  /** Called when the pointer or a key rests on an entry, so that the preview shows it. Null: on none. */
  readonly onPoint: (entry: PaletteEntry | null) => void;
  readonly onChoose: (entry: PaletteEntry) => void;
  readonly onClose: () => void;
}

/** Pause at an entry before the preview shows it. */
const REST_MS = 150;

const WIDTH_PX = 560;
const HEIGHT_PX = 372;
const EDGE_PX = 12;

/** Searches node types by name, and shows docs and ports of the selected one. Arrow keys select, Enter chooses. */
export function Palette({ definitions, end, at, query: asked, first, purpose = null, onPoint, onChoose, onClose }: PaletteProps) {
  const [query, setQuery] = useState(asked);
  const [chosen, setChosen] = useState(0);
  /** Whether the person has pointed at an entry; the palette opens with the first one chosen. */
  const [pointed, setPointed] = useState(false);
  const editor = useEditor();
  const { clock } = editor;
  const favorites = useStore(editor.preferences, (state) => state.favorites);
  // The list stays as it is while the palette is open.
  const [recent] = useState(() => editor.preferences.getState().recentTypes);
  const root = useRef<HTMLDivElement>(null);
  const listId = useId();
  const found = useMemo(() => searchPalette(definitions, query, end), [definitions, query, end]);
  const entries = useMemo(() => listPalette(found, query, favorites, recent, first), [found, query, favorites, recent, first]);
  const current = entries[Math.min(chosen, entries.length - 1)];
  const scale = uiScale();
  const place = {
    left: Math.max(EDGE_PX, Math.min(at.x, window.innerWidth - WIDTH_PX * scale - EDGE_PX)) / scale,
    top: Math.max(EDGE_PX, Math.min(at.y, window.innerHeight - HEIGHT_PX * scale - EDGE_PX)) / scale,
  };

  useEffect(() => {
    const onPointerDown = (event: PointerEvent) => {
      if (event.target instanceof Node && !root.current?.contains(event.target)) onClose();
    };
    window.addEventListener('pointerdown', onPointerDown, true);
    return () => window.removeEventListener('pointerdown', onPointerDown, true);
  }, [onClose]);

  useEffect(() => {
    root.current?.querySelector(`[data-index="${chosen}"]`)?.scrollIntoView({ block: 'nearest' });
  }, [chosen]);

  const resting = pointed ? (current ?? null) : null;
  useEffect(() => clock.after(REST_MS, () => onPoint(resting)), [clock, onPoint, resting]);

  const choose = (index: number) => {
    setChosen(index);
    setPointed(true);
  };
  const toggle = (type: string) => {
    toggleFavorite(editor, type);
    // The entry stays chosen although the favorites above it change.
    const after = listPalette(found, query, editor.preferences.getState().favorites, recent, first);
    const at = after.findIndex((entry) => entry.section === current?.section && entry.definition === current.definition);
    if (at !== -1) setChosen(at);
  };
  const onKeyDown = (event: KeyboardEvent) => {
    const last = entries.length - 1;
    if (event.key === 'ArrowDown') choose(chosen >= last ? 0 : chosen + 1);
    else if (event.key === 'ArrowUp') choose(chosen <= 0 ? last : chosen - 1);
    else if (event.key === 'Enter' && current) onChoose(current);
    else if (event.key.toLowerCase() === 'd' && (event.ctrlKey || event.metaKey) && current) toggle(current.definition.type);
    else if (event.key === 'Escape' || event.key === 'Tab') onClose();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  return (
    <div ref={root} className="palette" style={place} role="dialog" aria-label="Add a node">
      <div className="palette-search">
        <Icon name="search" />
        <input
          // The palette mounts on request, so its search field takes the focus at once.
          ref={(input) => input?.focus()}
          role="combobox"
          aria-expanded="true"
          aria-controls={listId}
          aria-activedescendant={current ? `${listId}-${entries.indexOf(current)}` : undefined}
          aria-label="Search nodes"
          placeholder={purpose ?? (end ? `Nodes for this ${WIRE_TYPES[end.type].label.toLowerCase()} wire` : 'Search nodes')}
          autoComplete="off"
          spellCheck={false}
          value={query}
          onChange={(event) => {
            setQuery(event.target.value);
            choose(0);
          }}
          onKeyDown={onKeyDown}
        />
        {end && <PortMark type={end.type} />}
      </div>
      <div className="palette-body">
        <div id={listId} className="palette-list scroll" role="listbox" aria-label="Node types">
          {entries.map((entry, index) => (
            <Row
              key={`${entry.section} ${entry.definition.type}`}
              id={`${listId}-${index}`}
              entry={entry}
              index={index}
              selected={entry === current}
              heading={query.trim() === '' && entry.section !== entries[index - 1]?.section}
              favorite={favorites.includes(entry.definition.type)}
              onFavor={() => toggle(entry.definition.type)}
              onPoint={() => choose(index)}
              onChoose={() => onChoose(entry)}
            />
          ))}
          {entries.length === 0 && <p className="palette-none">No node matches “{query}”.</p>}
        </div>
        {current && (
          <Preview
            definition={current.definition}
            favorite={favorites.includes(current.definition.type)}
            keys={showKeybinding('Mod+D', editor.mac)}
            onFavor={() => toggle(current.definition.type)}
          />
        )}
      </div>
    </div>
  );
}

interface RowProps {
  readonly id: string;
  readonly entry: ListedEntry;
  readonly index: number;
  readonly selected: boolean;
  readonly heading: boolean;
  readonly favorite: boolean;
  readonly onFavor: () => void;
  readonly onPoint: () => void;
  readonly onChoose: () => void;
}

function Row({ id, entry, index, selected, heading, favorite, onFavor, onPoint, onChoose }: RowProps) {
  const { definition } = entry;
  return (
    <>
      {heading && (
        <div className="palette-category" role="presentation">
          {entry.section}
        </div>
      )}
      {/* The search field handles all keys; rows handle only the pointer. */}
      <div
        id={id}
        className="palette-row"
        role="option"
        aria-selected={selected}
        tabIndex={-1}
        data-index={index}
        onPointerMove={onPoint}
        onPointerUp={onChoose}
      >
        <PaletteMark definition={definition} />
        <span className="palette-title">{definition.title}</span>
        <span className="palette-kind">{categoryOf(definition)}</span>
        {/* For the pointer; the button beside the description and Ctrl+D do the same. */}
        <span
          className="palette-star"
          aria-hidden="true"
          data-on={favorite ? '' : undefined}
          onPointerUp={(event) => {
            event.stopPropagation();
            onFavor();
          }}
        >
          <Icon name="star" size={14} />
        </span>
      </div>
    </>
  );
}

/** What a filter makes of a sample; for other nodes the mark of their main wire type. */
function PaletteMark({ definition }: { readonly definition: NodeDefinition }) {
  const type = mainType(definition);
  const image = paletteImageOf(definition.type);
  if (image) return <PaletteImage {...image} />;
  return <span className="palette-mark">{type && <PortMark type={type} />}</span>;
}

function PaletteImage({ size, position }: { readonly size: string; readonly position: string }) {
  return <span className="palette-image" aria-hidden="true" style={{ backgroundSize: size, backgroundPosition: position }} />;
}

interface PreviewProps {
  readonly definition: NodeDefinition;
  readonly favorite: boolean;
  readonly keys: string;
  readonly onFavor: () => void;
}

function Preview({ definition, favorite, keys, onFavor }: PreviewProps) {
  const image = paletteImageOf(definition.type);
  return (
    <div className="palette-preview scroll">
      <div className="palette-preview-head">
        <h2>{definition.title}</h2>
        <span className="palette-favor" data-on={favorite ? '' : undefined}>
          <IconButton icon="star" label="Favorite" keys={keys} pressed={favorite} small onPress={onFavor} />
        </span>
      </div>
      {image && <PaletteImage {...image} />}
      <DocText text={definition.doc} />
      <Ports title="Inputs" ports={definition.inputs} />
      <Ports title="Outputs" ports={definition.outputs} />
      {definition.credit && <p className="palette-credit">{definition.credit}</p>}
      {definition.licence && <p className="palette-credit">{definition.licence}</p>}
    </div>
  );
}

function Ports({ title, ports }: { readonly title: string; readonly ports: Readonly<Record<string, { type: WireType; label: string }>> }) {
  const entries = Object.entries(ports);
  if (entries.length === 0) return null;
  return (
    <dl className="palette-ports">
      <dt>{title}</dt>
      {entries.map(([name, port]) => (
        <dd key={name}>
          <PortMark type={port.type} />
          {port.label}
        </dd>
      ))}
    </dl>
  );
}
