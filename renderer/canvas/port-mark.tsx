import { WIRE_TYPES, type WireType } from '../../nodes/kit/wire-types.ts';
import './port-shape.css';

/** Mark of a wire type beside text: its color and shape. */
export function PortMark({ type }: { readonly type: WireType }) {
  const { color, shape } = WIRE_TYPES[type];
  return <span className="port-mark" data-shape={shape} style={{ ['--port' as string]: color }} aria-hidden="true" />;
}
