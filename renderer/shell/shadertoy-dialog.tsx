import { useId, useMemo, useState } from 'react';
import { convertShadertoy } from '../../export/glsl/shadertoy/convert-shadertoy.ts';
import { useEditor } from '../state/editor/editor-context.ts';
import { importShadertoy } from '../state/shaders/import-shadertoy.ts';
import { FormDialog } from '../ui/form-dialog.tsx';
import './shadertoy-dialog.css';

const DEFAULT_NAME = 'Shadertoy';
const SEVERAL_TABS = 'Of several tabs, put a line such as “// Buffer A” before each.';

/** Imports pasted Shadertoy code, and previews the result while typing. */
export function ShadertoyDialog({ onClose }: { readonly onClose: () => void }) {
  const editor = useEditor();
  const id = useId();
  const [source, setSource] = useState('');
  const [name, setName] = useState('');
  const { output, diagnostics } = useMemo(
    () => (source.trim() === '' ? { output: null, diagnostics: [] } : convertShadertoy(source, 'pasted')),
    [source],
  );
  const go = () => {
    if (output !== null && importShadertoy(editor, { source, name: name.trim() || DEFAULT_NAME })) onClose();
  };
  return (
    <FormDialog title="Import Shadertoy" action="Import" ready={output !== null} onGo={go} onClose={onClose} wide>
      <label htmlFor={`${id}-source`}>Code or JSON</label>
      <textarea
        id={`${id}-source`}
        className="field shadertoy-source"
        data-autofocus=""
        spellCheck={false}
        placeholder={
          '// Common\n…\n// Buffer A\n// iChannel0: Buffer A\n…\n// Image\nvoid mainImage(out vec4 fragColor, in vec2 fragCoord) …'
        }
        value={source}
        onChange={(event) => setSource(event.target.value)}
      />
      <p className="dialog-note">{SEVERAL_TABS}</p>
      <label htmlFor={`${id}-name`}>Name</label>
      <input
        id={`${id}-name`}
        className="field"
        spellCheck={false}
        placeholder={output?.title || DEFAULT_NAME}
        value={name}
        onChange={(event) => setName(event.target.value)}
      />
      <div aria-live="polite">
        {output !== null && <p className="dialog-note">{`Credit: ${output.credit}. License: ${output.licence}.`}</p>}
        {diagnostics.map(({ severity, message, fix = '' }) => (
          <p key={message} className={`shadertoy-${severity}`}>
            {message} {fix}
          </p>
        ))}
      </div>
    </FormDialog>
  );
}
