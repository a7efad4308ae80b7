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

/** As `wirePath`; at a reroute a wire goes on as it comes, so that one led back does not make a loop there. */
export function stretchPath({ sourceX, sourceY, targetX, targetY, fromReroute, toReroute }: WireEnds): string {
  if (!fromReroute && !toReroute) return wirePath(sourceX, sourceY, targetX, targetY);
  const half = (targetX - sourceX) / 2;
  const reach = half >= 0 ? half : CURVATURE * 25 * Math.sqrt(-2 * half);
  const leaveX = sourceX + (fromReroute ? half : reach);
  const arriveX = targetX - (toReroute ? half : reach);
  return `M${sourceX},${sourceY} C${leaveX},${sourceY} ${arriveX},${targetY} ${targetX},${targetY}`;
}
