import { languages } from 'monaco-editor/editor';
import { BUILTIN_FUNCTIONS } from '../../export/glsl/language/builtin-docs.ts';
import { ISF_FUNCTIONS, ISF_VARIABLES, TECHNIQUE_DOCS } from '../../export/glsl/language/vocabulary.ts';
import { KEYWORDS, TYPES } from '../../export/glsl/syntax/words.ts';

export const GLSL_LANGUAGE = 'scrim-glsl';

/** Highlighted words of the technique interface. Members of its structs are common words, so only capitalized names count. */
const TECHNIQUE_WORDS = [...TECHNIQUE_DOCS.keys()].filter((word) => /^[A-Z]/.test(word));

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

/** Token rules for highlighting: the JSON header in the first comment, then GLSL ES 3.00 with the names of ISF. */
const TOKENS: languages.IMonarchLanguage = {
  defaultToken: '',
  keywords: [...KEYWORDS, 'flat', 'smooth', 'layout'].filter((word) => !TYPES.has(word)),
  types: [...TYPES],
  functions: [...BUILTIN_FUNCTIONS.keys()],
  host: [...ISF_VARIABLES.keys(), ...ISF_FUNCTIONS.keys(), ...TECHNIQUE_WORDS],
  tokenizer: {
    root: [
      [/\/\*(?=\s*\{?\s*$|\s*\{)/, { token: 'comment', next: '@header' }],
      [/\/\*/, { token: 'comment', next: '@comment' }],
      [/\/\/.*$/, 'comment'],
      [/^\s*#\s*include\s*<[^>]*>/, 'keyword.directive'],
      [/^\s*#\s*\w+/, 'keyword.directive'],
      [
        /[a-zA-Z_]\w*/,
        {
          cases: {
            '@keywords': 'keyword',
            '@types': 'type',
            '@host': 'variable.predefined',
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

/**
 * Registers the language with Monaco.
 *
 * @returns A function that unregisters it.
 */
export function registerGlslLanguage(): () => void {
  languages.register({ id: GLSL_LANGUAGE, extensions: ['.fs', '.vs', '.glsl'] });
  const parts = [
    languages.setLanguageConfiguration(GLSL_LANGUAGE, CONFIGURATION),
    languages.setMonarchTokensProvider(GLSL_LANGUAGE, TOKENS),
  ];
  return () => {
    for (const part of parts) part.dispose();
  };
}
