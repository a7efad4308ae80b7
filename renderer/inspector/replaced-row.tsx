import { type ParamDefinition, paramWireType } from '../../nodes/kit/definition.ts';
import { PortMark } from '../canvas/port-mark.tsx';

interface ReplacedRowProps {
  readonly name: string;
  readonly param: ParamDefinition;
  /** Label of the input that is connected. */
  readonly input: string;
}

/** A param that the node does not read, because a connected input replaces it. It keeps its value for when the wire is removed. */
export function ReplacedRow({ name, param, input }: ReplacedRowProps) {
  const type = paramWireType(param);
  return (
    <fieldset className="param-row" aria-label={param.label} data-param={name}>
      <span className="param-label" data-tip={param.doc}>
        {type && <PortMark type={type} />}
        <span>{param.label}</span>
      </span>
      <span className="param-bound" data-tip="The node reads this from the wire. Disconnect the input to set it here.">
        From input “{input}”
      </span>
    </fieldset>
  );
}
