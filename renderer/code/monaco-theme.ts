import { editor } from 'monaco-editor/editor';
import { isLight } from '../ui/appearance.ts';

/**
 * Applies the theme of the editor to Monaco, also when it changes.
 *
 * @returns A function that stops it.
 */
export function followTheme(): () => void {
  const apply = () => {
    defineTheme(isLight());
    editor.setTheme('scrim');
  };
  apply();
  const watch = new MutationObserver(apply);
  watch.observe(document.documentElement, { attributeFilter: ['data-theme'] });
  return () => watch.disconnect();
}

function defineTheme(light: boolean): void {
  const style = getComputedStyle(document.documentElement);
  const color = (name: string) => style.getPropertyValue(name).trim();
  const ink = (name: string) => color(name).replace('#', '');
  editor.defineTheme('scrim', {
    base: light ? 'vs' : 'vs-dark',
    inherit: true,
    rules: [
      { token: 'keyword', foreground: ink('--code-keyword') },
      { token: 'type', foreground: ink('--code-type') },
      { token: 'support.function', foreground: ink('--code-function') },
      { token: 'variable.predefined', foreground: ink('--code-builtin') },
      { token: 'number', foreground: ink('--code-number') },
      { token: 'comment', foreground: ink('--code-comment') },
      { token: 'header.key', foreground: ink('--code-builtin') },
      { token: 'header.string', foreground: ink('--code-string') },
      { token: 'delimiter', foreground: ink('--text-2') },
    ],
    colors: {
      'editor.background': color('--surface-0'),
      'editor.foreground': color('--text'),
      'editorLineNumber.foreground': color('--text-3'),
      // The number of an empty last line.
      'editorLineNumber.dimmedForeground': color('--text-3'),
      'editorLineNumber.activeForeground': color('--text'),
      'editor.lineHighlightBackground': color('--surface-1'),
      'editor.lineHighlightBorder': '#00000000',
      'editorCursor.foreground': color('--accent'),
      'editorWidget.background': color('--surface-2'),
      'editorWidget.border': color('--line-strong'),
      'editorHoverWidget.background': color('--surface-2'),
      'editorHoverWidget.border': color('--line-strong'),
      'editorSuggestWidget.background': color('--surface-2'),
      'editorSuggestWidget.border': color('--line-strong'),
      'editorSuggestWidget.foreground': color('--text'),
      'editorSuggestWidget.highlightForeground': color('--accent'),
      'editorSuggestWidget.selectedBackground': color('--surface-4'),
      'editorSuggestWidget.selectedForeground': color('--text'),
      'editorSuggestWidget.focusHighlightForeground': color('--accent'),
      'input.background': color('--field'),
      'input.border': color('--line-strong'),
      'textLink.foreground': color('--accent'),
      'peekViewEditor.background': color('--surface-1'),
      'peekViewResult.background': color('--surface-1'),
      'peekViewTitle.background': color('--surface-2'),
      'peekView.border': color('--line-strong'),
      'editorError.foreground': color('--danger'),
      'editorWarning.foreground': color('--warning'),
      focusBorder: color('--accent'),
    },
  });
}
