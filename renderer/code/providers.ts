import { type IPosition, languages } from 'monaco-editor/editor';
import { type Completion, completionsAt } from '../../export/glsl/language/complete.ts';
import { formatShader } from '../../export/glsl/language/format-shader.ts';
import { numberAt } from '../../export/glsl/language/literals.ts';
import { definitionsAt, hoverAt, referencesAt, signatureAt } from '../../export/glsl/language/look-up.ts';
import { renameAt, renameBeside, renameStart } from '../../export/glsl/language/rename.ts';
import { type DocumentOptions, type NeighborFile, readShaderDocument } from '../../export/glsl/language/shader-document.ts';
import { applyEdits } from '../../export/glsl/language/source-text.ts';
import type { Place } from '../../export/glsl/syntax/token.ts';
import { GLSL_LANGUAGE } from './glsl-language.ts';
import { documentOf, editOf, isVertexShader, neighborModel, rangeOf, type ShaderTexts } from './shader-models.ts';

export interface ProviderOptions {
  readonly texts: ShaderTexts;
  /** Called before the edits of a rename, which form one undo step with the new text of the neighboring file. */
  readonly onRename: (beside: NeighborFile | null) => void;
}

/**
 * Registers completion, hover, rename and other providers of `export/glsl/language`.
 *
 * @returns A function that unregisters them.
 */
export function registerProviders({ texts, onRename }: ProviderOptions): () => void {
  const parts = [
    languages.registerCompletionItemProvider(GLSL_LANGUAGE, {
      triggerCharacters: ['.', '#', '"', '$'],
      provideCompletionItems: (model, position) => {
        const word = model.getWordUntilPosition(position);
        const { lineNumber } = position;
        const dollar = model.getValueInRange({ ...lineRange(lineNumber, word.startColumn - 1, word.startColumn) }) === '$' ? 1 : 0;
        const range = lineRange(lineNumber, word.startColumn - dollar, position.column);
        return {
          suggestions: completionsAt(documentOf(model, texts), placeOf(position)).map((item) => ({ ...suggestionOf(item), range })),
        };
      },
    }),
    languages.registerHoverProvider(GLSL_LANGUAGE, {
      provideHover: (model, position) => {
        const document = documentOf(model, texts);
        const found = hoverAt(document, placeOf(position));
        if (found !== null) return { range: rangeOf(found.range), contents: [glslCode(found.code), { value: found.doc }] };
        const number = numberAt(document.source, placeOf(position), document.outline);
        return number && { range: rangeOf(number.range), contents: [{ value: '**Alt**-drag or click to adjust it live.' }] };
      },
    }),
    languages.registerSignatureHelpProvider(GLSL_LANGUAGE, {
      signatureHelpTriggerCharacters: ['(', ','],
      signatureHelpRetriggerCharacters: [')'],
      provideSignatureHelp: (model, position) => {
        const help = signatureAt(documentOf(model, texts), placeOf(position));
        if (help === null) return null;
        const signatures = help.signatures.map(({ label, parameters }) => ({
          label,
          documentation: { value: help.doc },
          parameters: parameters.map((parameter) => ({ label: parameter })),
        }));
        return { value: { signatures, activeSignature: help.active, activeParameter: help.parameter }, dispose: () => {} };
      },
    }),
    languages.registerDefinitionProvider(GLSL_LANGUAGE, {
      provideDefinition: (model, position) => {
        const document = documentOf(model, texts);
        return definitionsAt(document, placeOf(position)).flatMap(({ file, range }) => {
          const uri = file === null ? model.uri : neighborModel(file, document.file, texts)?.uri;
          return uri ? [{ uri, range: rangeOf(range) }] : [];
        });
      },
    }),
    languages.registerReferenceProvider(GLSL_LANGUAGE, {
      provideReferences: (model, position) =>
        referencesAt(documentOf(model, texts), placeOf(position)).map((range) => ({ uri: model.uri, range: rangeOf(range) })),
    }),
    languages.registerDocumentHighlightProvider(GLSL_LANGUAGE, {
      provideDocumentHighlights: (model, position) =>
        referencesAt(documentOf(model, texts), placeOf(position)).map((range) => ({ range: rangeOf(range) })),
    }),
    languages.registerRenameProvider(GLSL_LANGUAGE, {
      resolveRenameLocation: (model, position) => {
        const start = renameStart(documentOf(model, texts), placeOf(position));
        const here = lineRange(position.lineNumber, position.column, position.column);
        return start.ok ? { range: rangeOf(start.range), text: start.name.name } : { range: here, text: '', rejectReason: start.reason };
      },
      provideRenameEdits: (model, position, newName) => {
        const document = documentOf(model, texts);
        const to = newName.trim();
        const rename = renameAt(document, placeOf(position), to, optionsFor(document.file, texts));
        if (!rename.ok) return { edits: [], rejectReason: rename.reason };
        const beside = texts.besideOf(document.file);
        const options = beside && optionsFor(beside.file, texts, document);
        const there =
          beside &&
          options &&
          renameBeside(document, placeOf(position), to, readShaderDocument(beside.source, beside.file, options), options);
        if (there?.ok === false) return { edits: [], rejectReason: there.reason };
        onRename(beside && there && there.edits.length > 0 ? { file: beside.file, source: applyEdits(beside.source, there.edits) } : null);
        const { uri: resource } = model;
        return { edits: rename.edits.map((edit) => ({ resource, textEdit: editOf(edit), versionId: undefined })) };
      },
    }),
    languages.registerDocumentFormattingEditProvider(GLSL_LANGUAGE, {
      displayName: 'Scrim',
      provideDocumentFormattingEdits: (model) => {
        const text = formatShader(model.getValue());
        return text === null ? [] : [{ range: model.getFullModelRange(), text }];
      },
    }),
  ];
  return () => {
    for (const part of parts) part.dispose();
  };
}

/** Parse options of a file. `shown` overrides the stored text of its neighbor. */
function optionsFor(file: string, { chunkOf, besideOf }: ShaderTexts, shown?: NeighborFile): DocumentOptions {
  const fragment = isVertexShader(file) ? (shown ?? besideOf(file)) : undefined;
  return { chunkOf, fragment };
}

function placeOf({ lineNumber, column }: IPosition): Place {
  return { line: lineNumber, column };
}

function lineRange(line: number, startColumn: number, endColumn: number) {
  return { startLineNumber: line, endLineNumber: line, startColumn: Math.max(startColumn, 1), endColumn };
}

function glslCode(code: string) {
  return { value: code === '' ? '' : `\`\`\`${GLSL_LANGUAGE}\n${code}\n\`\`\`` };
}

const KINDS: Readonly<Record<Completion['kind'], keyof typeof languages.CompletionItemKind>> = {
  function: 'Function',
  variable: 'Variable',
  parameter: 'Variable',
  struct: 'Struct',
  member: 'Field',
  macro: 'Constant',
  input: 'Property',
  image: 'File',
  builtin: 'Value',
  keyword: 'Keyword',
  type: 'Class',
  directive: 'Keyword',
  key: 'Property',
  value: 'EnumMember',
};

function suggestionOf({ label, kind, detail, doc, insert, rank }: Completion): Omit<languages.CompletionItem, 'range'> {
  const snippet = insert.includes('$0');
  return {
    label,
    kind: languages.CompletionItemKind[KINDS[kind]],
    detail,
    documentation: { value: doc },
    insertText: insert,
    sortText: `${rank} ${label.toLowerCase()}`,
    ...(snippet ? { insertTextRules: languages.CompletionItemInsertTextRule.InsertAsSnippet } : {}),
    // Shows parameter hints once the parentheses of a call are inserted.
    ...(insert.endsWith('($0)') ? { command: { id: 'editor.action.triggerParameterHints', title: '' } } : {}),
  };
}
