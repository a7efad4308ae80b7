import type { Editor } from '../editor/editor.ts';

/** A command of menus, keys and the native menu. */
export interface AppCommand {
  readonly label: string;
  /** Search keywords: synonyms and earlier labels. */
  readonly keywords?: readonly string[];
  /** Default keybindings, as `keybindingOf` writes them. `keybindingsOf` returns the current ones. */
  readonly keys: readonly string[];
  readonly enabled: (editor: Editor) => boolean;
  readonly run: (editor: Editor) => void;
  /** Runs when the key is released: a command that shows something while its key is held. */
  readonly release?: (editor: Editor) => void;
  /** Runs on the copy, cut and paste events of the page, which need no permission. */
  readonly byEvent?: true;
  /** Whether the keys work while a text field has the focus. */
  readonly whileTyping?: true;
  /** Where the keys work. `time`: only while the timeline or the preview has the focus or the pointer. Absent: everywhere. */
  readonly where?: 'time';
}
