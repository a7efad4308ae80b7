import { getBezierPath, Position } from '@xyflow/react';

/** From an output to an input: leaves to the right, arrives from the left. SVG path data, canvas units. */
export function wirePath(sourceX: number, sourceY: number, targetX: number, targetY: number): string {
  const [path] = getBezierPath({
    sourceX,
    sourceY,
    sourcePosition: Position.Right,
    targetX,
    targetY,
    targetPosition: Position.Left,
    curvature: 0.35,
  });
  return path;
}
