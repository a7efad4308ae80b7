import { ViewportPortal } from '@xyflow/react';
import { useMemo, useState } from 'react';
import { WIRE_TYPES } from '../../nodes/kit/wire-types.ts';
import { createOverviewPaths } from './overview-paths.ts';
import type { CanvasNode } from './project-canvas.ts';
import type { RerouteNode } from './project-reroutes.ts';
import type { CanvasWire } from './project-wires.ts';

interface OverviewWiresProps {
  readonly nodes: readonly CanvasNode[];
  readonly reroutes: readonly RerouteNode[];
  readonly wires: readonly CanvasWire[];
}

/** All wires of an overview, as one path per color. They do not take pointer events. */
export function OverviewWires({ nodes, reroutes, wires }: OverviewWiresProps) {
  const [pathsOf] = useState(createOverviewPaths);
  const paths = useMemo(() => pathsOf([...nodes, ...reroutes], wires), [pathsOf, nodes, reroutes, wires]);
  return (
    <ViewportPortal>
      <svg className="overview-wires" aria-hidden="true">
        {[...paths].map(([type, path]) => (
          <path key={type} d={path} style={{ stroke: WIRE_TYPES[type].color }} />
        ))}
      </svg>
    </ViewportPortal>
  );
}
