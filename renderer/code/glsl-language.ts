import { languages } from 'monaco-editor/editor';
import { BUILTIN_FUNCTIONS, ISF_WORDS, KEYWORDS, TYPES } from './glsl-words.ts';

export const ISF_LANGUAGE = 'isf';

const CONFIGURATION: languages.LanguageConfiguration = {
  comments: { lineComment: '//', blockComment: ['/*', '*/'] },
  brackets: [
    ['{', '}'],
    ['[', ']'],
    ['(', ')'],
  ],
  autoClosingPairs: [
    { open: '{', close: '}' },
    { open: '[', close: ']' },
    { open: '(', close: ')' },
    { open: '"', close: '"' },
  ],
  indentationRules: { increaseIndentPattern: /[{[(]\s*$/, decreaseIndentPattern: /^\s*[}\])]/ },
};

/** The JSON header in the first comment, then GLSL ES 3.00 with ISF's own names. */
const TOKENS: languages.IMonarchLanguage = {
  defaultToken: '',
  keywords: KEYWORDS,
  types: TYPES,
  functions: BUILTIN_FUNCTIONS,
  isf: Object.keys(ISF_WORDS),
  tokenizer: {
    root: [
      [/\/\*(?=\s*\{?\s*$|\s*\{)/, { token: 'comment', next: '@header' }],
      [/\/\*/, { token: 'comment', next: '@comment' }],
      [/\/\/.*$/, 'comment'],
      [/^\s*#\s*\w+/, 'keyword.directive'],
      [
        /[a-zA-Z_]\w*/,
        {
          cases: {
            '@keywords': 'keyword',
            '@types': 'type',
            '@isf': 'variable.predefined',
            '@functions': 'support.function',
            '@default': 'identifier',
          },
        },
      ],
      [/(\d+\.\d*|\.\d+|\d+)([eE][-+]?\d+)?[fFuU]?/, 'number'],
      [/[{}()[\]]/, '@brackets'],
      [/[-+*/%=<>!&|^~?:;,.]/, 'delimiter'],
    ],
    comment: [
      [/\*\//, { token: 'comment', next: '@pop' }],
      [/[^*]+|\*/, 'comment'],
    ],
    header: [
      [/\*\//, { token: 'comment', next: '@pop' }],
      [/"[^"]*"(?=\s*:)/, 'header.key'],
      [/"[^"]*"/, 'header.string'],
      [/-?\d+(\.\d+)?/, 'number'],
      [/\b(true|false|null)\b/, 'keyword'],
      [/[{}[\]]/, '@brackets'],
      [/./, 'comment'],
    ],
  },
};

/** Makes the language known to Monaco; the returned function takes it back. */
export function registerIsfLanguage(): () => void {
  languages.register({ id: ISF_LANGUAGE, extensions: ['.fs', '.vs'] });
  const parts = [
    languages.setLanguageConfiguration(ISF_LANGUAGE, CONFIGURATION),
    languages.setMonarchTokensProvider(ISF_LANGUAGE, TOKENS),
    languages.registerCompletionItemProvider(ISF_LANGUAGE, { provideCompletionItems: complete }),
    languages.registerHoverProvider(ISF_LANGUAGE, {
      provideHover: (model, position) => {
        const doc = ISF_WORDS[model.getWordAtPosition(position)?.word ?? ''];
        return doc === undefined ? null : { contents: [{ value: doc }] };
      },
    }),
  ];
  return () => {
    for (const part of parts) part.dispose();
  };
}

const complete: languages.CompletionItemProvider['provideCompletionItems'] = (model, position) => {
  const word = model.getWordUntilPosition(position);
  const range = {
    startLineNumber: position.lineNumber,
    endLineNumber: position.lineNumber,
    startColumn: word.startColumn,
    endColumn: word.endColumn,
  };
  const { Keyword, Function: Builtin, Variable, Struct } = languages.CompletionItemKind;
  const of = (words: readonly string[], kind: languages.CompletionItemKind) =>
    words.map((label) => ({ label, kind, insertText: label, range }));
  return {
    suggestions: [
      ...of(KEYWORDS, Keyword),
      ...of(TYPES, Struct),
      ...of(BUILTIN_FUNCTIONS, Builtin),
      ...Object.entries(ISF_WORDS).map(([label, documentation]) => ({ label, kind: Variable, insertText: label, range, documentation })),
    ],
  };
};
