import type { ShaderAbove } from '../../../export/compiler/compile.ts';
import { driverDiagnostics } from '../../../export/glsl/driver/driver-diagnostics.ts';
import { countsAbove } from '../../../export/glsl/link/link-above.ts';
import type { FromPreview, ToPreview } from '../../preview-protocol.ts';
import type { CompileAnswer } from '../compile/compiler-link.ts';
import type { Editor } from '../editor/editor.ts';

/** Compiles the text above a syntax error in the preview, to report the errors of the driver in it although there is no program. */
export interface ShaderTrials {
  storeAnswer(answer: CompileAnswer): void;
  storeErrors(message: Extract<FromPreview, { kind: 'trial-errors' }>): void;
  /** Sends the shaders to a preview page that has just loaded. */
  sendAll(): void;
  /** Forgets the shaders when another project is opened. */
  reset(): void;
}

export function createShaderTrials(editor: Editor, post: (message: ToPreview) => void): ShaderTrials {
  let revision = 0;
  let above: readonly ShaderAbove[] = [];

  const sendAll = () => {
    if (above.length > 0) post({ kind: 'trials', revision, shaders: above.map(({ shader }) => shader) });
  };
  return {
    storeAnswer: (answer) => {
      ({ revision, above } = answer);
      // Without a program, earlier errors refer to an older text. New trials replace them with their own.
      if (answer.program === null && above.length === 0) editor.preview.setState({ shaderDiagnostics: [] });
      sendAll();
    },
    storeErrors: (message) => {
      if (message.revision !== revision || above.length === 0) return;
      const { library } = editor.document.getState();
      const shaderDiagnostics = message.errors.flatMap(({ shaderId, log, stage }) => {
        const tried = above.find(({ shader }) => shader.id === shaderId);
        const said = tried ? driverDiagnostics(tried.shader, log, (file) => library.shader(file), stage) : [];
        return said.filter((diagnostic) => tried !== undefined && countsAbove(diagnostic, tried.before));
      });
      editor.preview.setState({ shaderDiagnostics });
    },
    sendAll,
    reset: () => {
      above = [];
    },
  };
}
