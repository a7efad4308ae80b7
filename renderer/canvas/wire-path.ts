import { getBezierPath, Position } from '@xyflow/react';

/** SVG path data of a wire in canvas units: it leaves an output to the right and reaches an input from the left. */
export function wirePath(sourceX: number, sourceY: number, targetX: number, targetY: number): string {
  const [path] = getBezierPath({
    sourceX,
    sourceY,
    sourcePosition: Position.Right,
    targetX,
    targetY,
    targetPosition: Position.Left,
    curvature: CURVATURE,
  });
  return path;
}

const CURVATURE = 0.35;

export interface WireEnds {
  readonly sourceX: number;
  readonly sourceY: number;
  readonly targetX: number;
  readonly targetY: number;
  readonly fromReroute: boolean;
  readonly toReroute: boolean;
}

/** Like `wirePath`, but a wire passes straight through a reroute, so that a backward wire makes no loop there. */
export function stretchPath({ sourceX, sourceY, targetX, targetY, fromReroute, toReroute }: WireEnds): string {
  if (!fromReroute && !toReroute) return wirePath(sourceX, sourceY, targetX, targetY);
  const half = (targetX - sourceX) / 2;
  const reach = half >= 0 ? half : CURVATURE * 25 * Math.sqrt(-2 * half);
  const leaveX = sourceX + (fromReroute ? half : reach);
  const arriveX = targetX - (toReroute ? half : reach);
  return `M${sourceX},${sourceY} C${leaveX},${sourceY} ${arriveX},${targetY} ${targetX},${targetY}`;
}
