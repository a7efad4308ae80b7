import { memo, useId } from 'react';
import type { Binding, PortAddress } from '../../export/graph/project.ts';
import { type ParamDefinition, paramWireType } from '../../nodes/kit/definition.ts';
import { PortMark } from '../canvas/port-mark.tsx';
import { boundValue } from '../canvas/value-text.ts';
import { useEditor } from '../shell/editor-context.ts';
import { endGesture } from '../state/apply.ts';
import { editParam, resetParam } from '../state/edit-params.ts';
import { IconButton } from '../ui/button.tsx';
import { ParamControl } from './param-control.tsx';
import { SourceLink } from './source-link.tsx';
import { shownUnit } from './units.ts';

interface ParamRowProps {
  readonly node: string;
  readonly name: string;
  readonly param: ParamDefinition;
  readonly binding: Binding | undefined;
  /** What is wired to it. */
  readonly source: PortAddress | undefined;
}

/** One param: its name, what it is bound to, and the way back to its default. */
export const ParamRow = memo(function ParamRow({ node, name, param, binding, source }: ParamRowProps) {
  const editor = useEditor();
  const id = useId();
  const type = paramWireType(param);
  // Fields of a vector are too narrow to say it themselves.
  const unit = param.type.startsWith('vector') && 'unit' in param ? shownUnit(param.unit).suffix : '';
  const changed = source !== undefined || (binding !== undefined && !isDefaultPort(param, binding));
  return (
    <div className="param-row" data-param={name}>
      <label htmlFor={id} className="param-label" data-tip={param.doc}>
        {type && <PortMark type={type} />}
        <span>
          {param.label}
          {unit !== '' && <span className="param-unit"> {unit}</span>}
        </span>
      </label>
      <div className="param-control">
        {source ? (
          <SourceLink from={source} to={{ node, port: name }} />
        ) : binding && ('track' in binding || 'expression' in binding) ? (
          <span className="param-bound">{'track' in binding ? 'Keyframes' : binding.expression}</span>
        ) : (
          <ParamControl
            id={id}
            param={param}
            value={boundValue(param, binding)}
            onEdit={(value) => void editParam(editor, node, name, value)}
            onEnd={() => endGesture(editor)}
          />
        )}
      </div>
      <span className="param-reset">
        {changed && <IconButton icon="reset" label={`Reset ${param.label}`} small onPress={() => void resetParam(editor, node, name)} />}
      </span>
    </div>
  );
});

/** A port that nothing is wired to and that holds the default looks untouched. */
function isDefaultPort(param: ParamDefinition, binding: Binding): boolean {
  return 'port' in binding && JSON.stringify(binding.port) === JSON.stringify(param.default);
}
