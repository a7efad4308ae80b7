import type { ShaderAbove } from '../../../export/compiler/compile.ts';
import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { countsAbove } from '../../../export/glsl/link/link-above.ts';
import type { FromPreview, ToPreview } from '../../preview-protocol.ts';
import type { CompileAnswer } from '../compile/messages.ts';
import type { Editor } from '../editor/editor.ts';

/** Has the driver of the preview find the mistakes that stand above those for which there is no program. */
export interface ShaderTrials {
  takeAnswer(answer: CompileAnswer): void;
  takeErrors(message: Extract<FromPreview, { kind: 'trial-errors' }>): void;
  /** A preview page is there, which has none. */
  tell(): void;
  /** Another project is open. */
  forget(): void;
}

export function createShaderTrials(editor: Editor, post: (message: ToPreview) => void): ShaderTrials {
  let revision = 0;
  let above: readonly ShaderAbove[] = [];

  const tell = () => {
    if (above.length > 0) post({ kind: 'trials', revision, shaders: above.map(({ shader }) => shader) });
  };
  return {
    takeAnswer: (answer) => {
      ({ revision, above } = answer);
      // Without a program, what the driver said was about a text that is gone. Where it is asked again, its answer takes the place of that.
      if (answer.program === null && above.length === 0) editor.preview.setState({ shaderDiagnostics: [] });
      tell();
    },
    takeErrors: (message) => {
      if (message.revision !== revision || above.length === 0) return;
      const { library } = editor.document.getState();
      const shaderDiagnostics = message.errors.flatMap(({ shaderId, log, stage }) => {
        const tried = above.find(({ shader }) => shader.id === shaderId);
        const said = tried ? driverDiagnostics(tried.shader, log, (file) => library.shader(file), stage) : [];
        return said.filter((diagnostic) => tried !== undefined && countsAbove(diagnostic, tried.before));
      });
      editor.preview.setState({ shaderDiagnostics });
    },
    tell,
    forget: () => {
      above = [];
    },
  };
}
