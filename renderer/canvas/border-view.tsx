import { Handle, type NodeProps, Position } from '@xyflow/react';
import { memo, useState } from 'react';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { graphOf } from '../state/editor/document.ts';
import { useDocument, useEditor } from '../state/editor/editor-context.ts';
import { ROW_HEIGHT } from '../state/graph/node-shape.ts';
import { exposedTitleProblem, type PortSide, renameExposedPort, setPortExposed } from '../state/graph/subgraphs.ts';
import { IconButton } from '../ui/button.tsx';
import './border-view.css';
import { useDetail } from './detail.ts';
import { NameInPlace, renameHandlers } from './name-in-place.tsx';
import { type BorderNode, type BorderPort, borderRowTop, NEW_PORT } from './project-borders.ts';

const TEXTS = {
  inputs: { title: 'Inputs', add: 'Drag to an input to expose it' },
  outputs: { title: 'Outputs', add: 'Drag to an output to expose it' },
} as const;

/** The ports that the instances of the open subgraph have on one side, and a handle that exposes another one. */
export const BorderView = memo(function BorderView({ data: { side, ports }, selected }: NodeProps<BorderNode>) {
  const isInput = side === 'inputs';
  const common = { type: isInput ? 'source' : 'target', position: isInput ? Position.Right : Position.Left } as const;
  if (useDetail() === 'overview') return null;
  const { title, add } = TEXTS[side];
  return (
    <div className={`border border-${side}${selected ? ' border-selected' : ''}`} data-border={side}>
      <div className="border-head">{title}</div>
      {ports.map((port, row) => {
        const { color, shape, label } = WIRE_TYPES[port.type];
        return (
          <div key={port.name}>
            <Handle
              {...common}
              id={port.name}
              className="port"
              isConnectable={false}
              data-shape={shape}
              data-tip={`${port.label} · ${label}`}
              style={{ ['--port' as string]: color, top: borderRowTop(row) + ROW_HEIGHT / 2 }}
            />
            <BorderRow side={side} port={port} row={row} />
          </div>
        );
      })}
      <Handle
        {...common}
        id={NEW_PORT}
        className="port border-add"
        data-tip={add}
        style={{ top: borderRowTop(ports.length) + ROW_HEIGHT / 2 }}
      />
      <span className="border-row border-hint" style={{ top: borderRowTop(ports.length), height: ROW_HEIGHT }}>
        Expose
      </span>
    </div>
  );
});

function BorderRow({ side, port, row }: { readonly side: PortSide; readonly port: BorderPort; readonly row: number }) {
  const editor = useEditor();
  const exposed = useDocument((state) => graphOf(state).exposed[side][row]);
  const [naming, setNaming] = useState(false);
  if (naming) {
    return (
      <span className="border-row border-naming" style={{ top: borderRowTop(row), height: ROW_HEIGHT }}>
        <NameInPlace
          label={`Name of ${port.label}`}
          title={port.label}
          problemOf={(typed) => exposedTitleProblem(editor.document.getState(), port.name, typed)}
          onName={(typed) => void renameExposedPort(editor, side, port.name, typed)}
          onLeave={() => setNaming(false)}
        />
      </span>
    );
  }
  return (
    <span className="border-row" style={{ top: borderRowTop(row), height: ROW_HEIGHT }}>
      <button type="button" className="border-label nodrag" {...renameHandlers(() => setNaming(true))} data-tip="Double-click renames">
        {port.label}
      </button>
      <IconButton
        icon="close"
        label={`Stop exposing ${port.label}`}
        small
        onPress={() => exposed && void setPortExposed(editor, side, exposed, false)}
      />
    </span>
  );
}
